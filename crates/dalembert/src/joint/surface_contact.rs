//! Contact of two surfaces in a point.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, ContactFault, ContactForce, Regularity,
    RowLabel, RowUnit,
};
use crate::space::{Spatial, join};
use crate::surface::{Around, Field, Placed, Sheet, Surface};
use nalgebra::{Matrix3, Vector3};
use smallvec::SmallVec;

/// Two surfaces that touch (Shabana 8.55, 8.58), with the coordinates of both points as auxiliary coordinates:
///   r_1 + A_1 u_1 - r_2 - A_2 u_2 = 0,   t_a.n = t_b.n = 0,
/// where t are the tangents of the first surface, n the normal of the second, or the other way round where the first has
/// no tangents. Of two spheres or ellipsoids neither has; there n_1 + m n_2 = 0 with m as one coordinate more. Unit vectors
/// w of such surfaces have rows (w.w - 1)/2 = 0.
/// Where surfaces touch along a line, the point on the line is open; `held` then keeps one coordinate.
#[derive(Clone, Debug)]
pub struct SurfaceContact {
    /// The surfaces of the first and of the second marker.
    surfaces: [Surface; 2],
    /// A coordinate that is kept at a value.
    held: Option<(usize, f64)>,
    /// The parameters a near which results give them.
    near: [f64; 2],
    /// The sides of the axes on which the surfaces are swept.
    sense: [f64; 2],
}

/// Coordinates of both surfaces, and the ratio of the normals.
const MOST: usize = 7;

impl SurfaceContact {
    /// A contact that starts at coordinates of both surfaces, near parameters a.
    pub fn new(
        surfaces: [Surface; 2],
        start: [&[f64]; 2],
        near: [f64; 2],
        held: Option<(usize, f64)>,
    ) -> Self {
        let sense = [0, 1].map(|k| surfaces[k].sense(start[k]));
        Self {
            surfaces,
            held,
            near,
            sense,
        }
    }

    /// The auxiliary coordinates with which a contact starts, from those of the points: the ratio of the normals belongs
    /// to them where neither surface has tangents.
    pub fn start(surfaces: &[Surface; 2], points: [&[f64]; 2]) -> SmallVec<[f64; 1]> {
        let mut start: SmallVec<[f64; 1]> = points.concat().into();
        if surfaces.iter().all(Surface::is_round) {
            let [one, two] = [0, 1].map(|k| surfaces[k].around(points[k]).normal.value.norm());
            start.push(one / two);
        }
        start
    }

    /// Is m among the coordinates?
    fn has_ratio(&self) -> bool {
        self.surfaces.iter().all(Surface::is_round)
    }

    /// Where the coordinates of the second surface begin and end.
    fn places(&self) -> (usize, usize) {
        let first = self.surfaces[0].count();
        (first, first + self.surfaces[1].count())
    }

    fn coordinates<'a>(&self, s: &'a [f64]) -> [&'a [f64]; 2] {
        let (middle, end) = self.places();
        [&s[..middle], &s[middle..end]]
    }

    fn placed<'a>(&'a self, input: &ConstraintInput<'a, Spatial>, k: usize) -> Placed<'a> {
        Placed {
            surface: &self.surfaces[k],
            marker: &input.markers[k],
        }
    }

    /// Curvatures of both surfaces in ground axes; none at poles.
    fn curvatures(&self, input: &ConstraintInput<'_, Spatial>) -> Option<[Matrix3<f64>; 2]> {
        let s = self.coordinates(input.s);
        let of = |k: usize| self.placed(input, k).curvature(s[k]);
        Some([of(0)?, of(1)?])
    }

    /// The surfaces in ground axes.
    fn around(&self, input: &ConstraintInput<'_, Spatial>) -> [Around; 2] {
        let s = self.coordinates(input.s);
        [0, 1].map(|k| {
            let axes = &input.markers[k].axes;
            let own = self.surfaces[k].around(s[k]);
            Around {
                point: own.point.turned(axes),
                normal: own.normal.turned(axes),
                tangents: own.tangents.map(|t| t.map(|t| t.turned(axes))),
            }
        })
    }
}

impl ConstraintElement<Spatial> for SurfaceContact {
    fn labels(&self) -> Vec<RowLabel> {
        let label = |text: &str, unit| RowLabel {
            text: text.to_owned(),
            unit,
        };
        let mut labels = vec![
            label("contact x", RowUnit::Length),
            label("contact y", RowUnit::Length),
            label("contact z", RowUnit::Length),
        ];
        let tangency: &[&str] = if self.has_ratio() {
            &["normals x", "normals y", "normals z"]
        } else {
            &["tangency along a", "tangency along b"]
        };
        labels.extend(tangency.iter().map(|text| label(text, RowUnit::Other)));
        for (surface, text) in self.surfaces.iter().zip(["length of w1", "length of w2"]) {
            if surface.is_round() {
                labels.push(label(text, RowUnit::Angle));
            }
        }
        if self.held.is_some() {
            labels.push(label("point of the line", RowUnit::Other));
        }
        labels
    }

    fn auxiliaries(&self) -> Vec<RowLabel> {
        let mut names: Vec<String> = Vec::new();
        for (surface, number) in self.surfaces.iter().zip([1, 2]) {
            let own = surface.coordinate_names().iter();
            names.extend(own.map(|name| format!("{name}{number}")));
        }
        if self.has_ratio() {
            names.push("m".to_owned());
        }
        let labels = names.into_iter().map(|text| RowLabel {
            text,
            unit: RowUnit::Other,
        });
        labels.collect()
    }

    fn parameters(&self, s: &[f64], last: &[f64]) -> Vec<(String, f64)> {
        let s = self.coordinates(s);
        let of = |k: usize| {
            let near = last.get(2 * k).copied().unwrap_or(self.near[k]);
            let [a, b] = self.surfaces[k].parameters(s[k], near);
            [(format!("a{}", k + 1), a), (format!("b{}", k + 1), b)]
        };
        [of(0), of(1)].concat()
    }

    fn contact(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        multipliers: &[f64],
    ) -> Option<ContactForce> {
        let [first, _] = self.around(input);
        // C = (first) - (second): the multipliers are the force on the second body.
        let force = Vector3::from_column_slice(&multipliers[..3]);
        Some(ContactForce {
            normal: force.dot(&first.normal.value.normalize()),
            point: input.markers[0].point + first.point.value,
        })
    }

    fn sheets(&self, s: &[f64], size: f64) -> Vec<(usize, Sheet)> {
        let s = self.coordinates(s);
        let sheets = (0..2).filter_map(|k| Some((k, self.surfaces[k].sheet(s[k], size)?)));
        sheets.collect()
    }

    fn reach(&self) -> f64 {
        self.surfaces[0].reach().max(self.surfaces[1].reach())
    }

    fn facing(&self, input: &ConstraintInput<'_, Spatial>) -> Option<f64> {
        let s = self.coordinates(input.s);
        if (0..2).any(|k| self.surfaces[k].sense(s[k]) != self.sense[k]) {
            return Some(-1.0);
        }
        let [one, two] = self.around(input).map(|x| x.normal.value);
        Some(-one.dot(&two) / (one.norm() * two.norm()))
    }

    fn regularity(&self, input: &ConstraintInput<'_, Spatial>) -> Option<Regularity> {
        let s = self.coordinates(input.s);
        let relative = match (self.held, self.curvatures(input)) {
            (None, Some([one, two])) => Some(Regularity::principal(&(one + two))),
            _ => None,
        };
        Some(Regularity {
            normals: [0, 1].map(|k| self.surfaces[k].regularity(s[k])),
            relative,
        })
    }

    fn fault(&self, input: &ConstraintInput<'_, Spatial>) -> Option<ContactFault> {
        let s = self.coordinates(input.s);
        let pole = (0..2).find(|k| self.placed(input, *k).is_pole(s[*k]));
        if let Some(k) = pole {
            return Some(ContactFault::Pole(k));
        }
        let curvatures = self.curvatures(input)?;
        Regularity::crossing(&curvatures).map(ContactFault::Crossing)
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        out: &mut ConstraintOutput<'_, Spatial>,
    ) {
        let (m1, m2) = (&input.markers[0], &input.markers[1]);
        let [one, two] = self.around(input);
        let (middle, end) = self.places();
        let count = input.s.len();
        debug_assert!(count <= MOST);
        let (s1, s2) = (&input.s_rate[..middle], &input.s_rate[middle..end]);
        let d = m1.point + one.point.value - m2.point - two.point.value;
        let bias = one.point.bias(s1, &m1.omega) - two.point.bias(s2, &m2.omega);
        for k in 0..3 {
            let mut e = Vector3::zeros();
            e[k] = 1.0;
            out.value[k] = d[k];
            out.gradient[2 * k] = join(&e, &one.point.value.cross(&e));
            out.gradient[2 * k + 1] = join(&-e, &-two.point.value.cross(&e));
            for m in 0..middle {
                out.auxiliary[count * k + m] = one.point.by[m][k];
            }
            for m in middle..end {
                out.auxiliary[count * k + m] = -two.point.by[m - middle][k];
            }
            out.bias[k] = bias[k];
        }
        let mut row = 3;
        let (rates, omegas) = ([s1, s2], [&m1.omega, &m2.omega]);
        // Tangents of one surface against the normal of the other.
        let mut tangency = |own: usize, tangents: &[Field; 2]| {
            let other = 1 - own;
            let n = if other == 0 { &one.normal } else { &two.normal };
            let first = [0, middle];
            let counts = [middle, end - middle];
            let n1 = n.rate(rates[other], omegas[other]);
            let n2 = n.bias(rates[other], omegas[other]);
            for t in tangents {
                let turn = t.value.cross(&n.value);
                out.value[row] = t.value.dot(&n.value);
                out.gradient[2 * row + own] = join(&Vector3::zeros(), &turn);
                out.gradient[2 * row + other] = join(&Vector3::zeros(), &-turn);
                for m in 0..counts[own] {
                    out.auxiliary[count * row + first[own] + m] = t.by[m].dot(&n.value);
                }
                for m in 0..counts[other] {
                    out.auxiliary[count * row + first[other] + m] = t.value.dot(&n.by[m]);
                }
                let t1 = t.rate(rates[own], omegas[own]);
                let t2 = t.bias(rates[own], omegas[own]);
                out.bias[row] = t2.dot(&n.value) + 2.0 * t1.dot(&n1) + t.value.dot(&n2);
                row += 1;
            }
        };
        if let Some(tangents) = &one.tangents {
            tangency(0, tangents);
        } else if let Some(tangents) = &two.tangents {
            tangency(1, tangents);
        } else {
            let (m, rate) = (input.s[end], input.s_rate[end]);
            let (n1, n2) = (&one.normal, &two.normal);
            let sum = n1.value + m * n2.value;
            let bias = n1.bias(s1, &m1.omega)
                + m * n2.bias(s2, &m2.omega)
                + 2.0 * rate * n2.rate(s2, &m2.omega);
            for k in 0..3 {
                let mut e = Vector3::zeros();
                e[k] = 1.0;
                out.value[row] = sum[k];
                out.gradient[2 * row] = join(&Vector3::zeros(), &n1.value.cross(&e));
                out.gradient[2 * row + 1] = join(&Vector3::zeros(), &(m * n2.value.cross(&e)));
                for j in 0..middle {
                    out.auxiliary[count * row + j] = n1.by[j][k];
                }
                for j in middle..end {
                    out.auxiliary[count * row + j] = m * n2.by[j - middle][k];
                }
                out.auxiliary[count * row + end] = n2.value[k];
                out.bias[row] = bias[k];
                row += 1;
            }
        }
        for (surface, first) in self.surfaces.iter().zip([0, middle]) {
            if surface.is_round() {
                let own = first..first + 3;
                unit_row(
                    &input.s[own.clone()],
                    &input.s_rate[own.clone()],
                    &mut out.value[row],
                    &mut out.auxiliary[count * row..][own],
                    &mut out.bias[row],
                );
                row += 1;
            }
        }
        if let Some((place, value)) = self.held {
            out.value[row] = input.s[place] - value;
            out.auxiliary[count * row + place] = 1.0;
        }
    }
}

/// The row (w.w - 1)/2 of a unit vector: value, slopes by w, and second derivative at zero accelerations.
pub(super) fn unit_row(
    w: &[f64],
    rate: &[f64],
    value: &mut f64,
    slopes: &mut [f64],
    bias: &mut f64,
) {
    *value = 0.5 * (w.iter().map(|x| x * x).sum::<f64>() - 1.0);
    slopes.copy_from_slice(w);
    *bias = rate.iter().map(|x| x * x).sum();
}
