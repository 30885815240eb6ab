//! A point, or a ball about it, that stays on a surface.

use super::surface_contact::unit_row;
use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, ContactFault, ContactForce, Regularity,
    RowLabel, RowUnit,
};
use crate::space::{Spatial, SpatialMarker, join};
use crate::surface::{Field, Placed, Sheet, Surface, SurfaceShape};
use nalgebra::{Matrix3, Vector3};

/// The point c of one marker keeps the distance R from the surface of another: r + A (u(s) + R n(s)) - c = 0, with n the
/// unit normal out of the surface's body and s the coordinates of a point of it as auxiliary coordinates; (w.w - 1)/2 = 0
/// where they are a unit vector w. With R = 0 the point lies on the surface, with R > 0 a ball of that radius touches it.
#[derive(Clone, Debug)]
pub struct PointOnSurface {
    /// The surface.
    surface: Surface,
    /// R [m].
    distance: f64,
    /// Does the surface belong to the second marker, the point to the first?
    reversed: bool,
    /// The parameter a near which results give it.
    near: f64,
    /// The side of the axis on which the surface is swept.
    sense: f64,
}

impl PointOnSurface {
    /// A contact at a distance that starts at coordinates of the surface, near a parameter a; `reversed` says that the
    /// surface belongs to the second marker, the point to the first.
    pub fn new(surface: Surface, distance: f64, reversed: bool, start: &[f64], near: f64) -> Self {
        let sense = surface.sense(start);
        Self {
            surface,
            distance,
            reversed,
            near,
            sense,
        }
    }

    /// Numbers of the markers of the surface and of the point.
    fn order(&self) -> [usize; 2] {
        if self.reversed { [1, 0] } else { [0, 1] }
    }

    /// Curvatures of the surface and of the ball in the axes of the surface; none for points, and at poles.
    fn curvatures(&self, s: &[f64]) -> Option<[Matrix3<f64>; 2]> {
        if self.distance == 0.0 {
            return None;
        }
        let own = self.surface.curvature(s)?;
        let n = self.surface.around(s).normal.value;
        let n = n.try_normalize(f64::MIN_POSITIVE)?;
        let ball = (n * n.transpose() - Matrix3::identity()) / self.distance;
        Some([own, ball])
    }

    /// The way to the point's place from the frame of the surface, and the normal, in ground axes.
    fn fields(&self, marker: &SpatialMarker, s: &[f64]) -> [Field; 2] {
        let around = self.surface.around(s);
        let normal = around.normal.unit();
        let offset = around.point.plus(self.distance, &normal);
        [offset.turned(&marker.axes), normal.turned(&marker.axes)]
    }
}

impl ConstraintElement<Spatial> for PointOnSurface {
    fn labels(&self) -> Vec<RowLabel> {
        let label = |text: &str, unit| RowLabel {
            text: text.to_owned(),
            unit,
        };
        let mut labels = ["contact x", "contact y", "contact z"]
            .map(|text| label(text, RowUnit::Length))
            .to_vec();
        if self.surface.is_round() {
            labels.push(label("length of w", RowUnit::Angle));
        }
        labels
    }

    fn auxiliaries(&self) -> Vec<RowLabel> {
        let names = self.surface.coordinate_names().iter();
        let labels = names.map(|text| RowLabel {
            text: (*text).to_owned(),
            unit: RowUnit::Other,
        });
        labels.collect()
    }

    fn parameters(&self, s: &[f64], last: &[f64]) -> Vec<(String, f64)> {
        let near = last.first().copied().unwrap_or(self.near);
        let [a, b] = self.surface.parameters(s, near);
        vec![("a".to_owned(), a), ("b".to_owned(), b)]
    }

    fn sheets(&self, s: &[f64], size: f64) -> Vec<(usize, Sheet)> {
        let [base, other] = self.order();
        let own = self.surface.sheet(s, size).map(|sheet| (base, sheet));
        let ball = (self.distance > 0.0).then_some(Surface {
            shape: SurfaceShape::Sphere(self.distance),
            inside: false,
        });
        let ball = ball.and_then(|b| Some((other, b.sheet(&[0.0, 0.0, 1.0], size)?)));
        own.into_iter().chain(ball).collect()
    }

    fn holds_both_ways(&self) -> bool {
        self.distance == 0.0
    }

    fn reach(&self) -> f64 {
        self.surface.reach().max(self.distance)
    }

    fn facing(&self, input: &ConstraintInput<'_, Spatial>) -> Option<f64> {
        // The distance is counted along the normal: only a normal that has turned round is on the wrong side.
        Some(self.surface.sense(input.s) * self.sense)
    }

    fn regularity(&self, input: &ConstraintInput<'_, Spatial>) -> Option<Regularity> {
        let relative = self.curvatures(input.s);
        let relative = relative.map(|[own, ball]| Regularity::principal(&(own + ball)));
        Some(Regularity {
            normals: [self.surface.regularity(input.s), None],
            relative,
        })
    }

    fn fault(&self, input: &ConstraintInput<'_, Spatial>) -> Option<ContactFault> {
        let [base, _] = self.order();
        let placed = Placed {
            surface: &self.surface,
            marker: &input.markers[base],
        };
        if placed.is_pole(input.s) {
            return Some(ContactFault::Pole(base));
        }
        let [own, ball] = Regularity::crossing(&self.curvatures(input.s)?)?;
        let both = if self.reversed {
            [ball, own]
        } else {
            [own, ball]
        };
        Some(ContactFault::Crossing(both))
    }

    fn contact(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        multipliers: &[f64],
    ) -> Option<ContactForce> {
        let [base, _] = self.order();
        let marker = &input.markers[base];
        let [offset, normal] = self.fields(marker, input.s);
        // C = (surface) - (point): the multipliers are the force on the point's body.
        let force = Vector3::from_column_slice(&multipliers[..3]);
        Some(ContactForce {
            normal: force.dot(&normal.value),
            point: marker.point + offset.value - self.distance * normal.value,
        })
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        out: &mut ConstraintOutput<'_, Spatial>,
    ) {
        let [base, other] = self.order();
        let (marker, point) = (&input.markers[base], &input.markers[other]);
        let [f, _] = self.fields(marker, input.s);
        let bias = f.bias(input.s_rate, &marker.omega);
        let count = input.s.len();
        for k in 0..3 {
            let mut e = Vector3::zeros();
            e[k] = 1.0;
            out.value[k] = marker.point[k] + f.value[k] - point.point[k];
            out.gradient[2 * k + base] = join(&e, &f.value.cross(&e));
            out.gradient[2 * k + other] = join(&-e, &Vector3::zeros());
            for m in 0..count {
                out.auxiliary[count * k + m] = f.by[m][k];
            }
            out.bias[k] = bias[k];
        }
        if self.surface.is_round() {
            unit_row(
                input.s,
                input.s_rate,
                &mut out.value[3],
                &mut out.auxiliary[3 * count..],
                &mut out.bias[3],
            );
        }
    }
}
