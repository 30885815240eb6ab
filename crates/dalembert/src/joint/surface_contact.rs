//! Contact of two surfaces in a point.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, ContactForce, RowLabel, RowUnit,
};
use crate::space::{Spatial, join};
use crate::surface::{Field, Partials, Surface};
use nalgebra::Vector3;

/// Two surfaces that touch (Shabana 8.55, 8.58): five rows in the four surface parameters (a, b of each) as auxiliary
/// coordinates,
///   r_1 + A_1 u_1 - r_2 - A_2 u_2 = 0,   t_1a.n_2 = t_1b.n_2 = 0.
/// Where they touch along a line, the point on the line is open; `held` then keeps one parameter.
#[derive(Clone, Debug)]
pub struct SurfaceContact {
    /// The surfaces of the first and of the second marker.
    pub surfaces: [Surface; 2],
    /// A parameter that is kept at a value.
    pub held: Option<(usize, f64)>,
}

/// A surface at its parameters, in ground axes.
struct Touching {
    point: Field,
    tangents: [Field; 2],
    normal: Field,
}

impl SurfaceContact {
    fn touching(&self, k: usize, input: &ConstraintInput<'_, Spatial>) -> Touching {
        let axes = &input.markers[k].axes;
        let partials: Partials = self.surfaces[k].partials(&input.s[2 * k..2 * k + 2]);
        Touching {
            point: Field::point(&partials).turned(axes),
            tangents: [0, 1].map(|along| Field::tangent(&partials, along).turned(axes)),
            normal: self.surfaces[k].normal(&partials).turned(axes),
        }
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
            label("tangency along a", RowUnit::Other),
            label("tangency along b", RowUnit::Other),
        ];
        if self.held.is_some() {
            labels.push(label("point of the line", RowUnit::Other));
        }
        labels
    }

    fn auxiliaries(&self) -> Vec<RowLabel> {
        ["a1", "b1", "a2", "b2"]
            .map(|text| RowLabel {
                text: text.to_owned(),
                unit: RowUnit::Other,
            })
            .to_vec()
    }

    fn contact(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        multipliers: &[f64],
    ) -> Option<ContactForce> {
        let first = self.touching(0, input);
        // C = (first) - (second): the multipliers are the force on the second body.
        let force = Vector3::from_column_slice(&multipliers[..3]);
        Some(ContactForce {
            normal: force.dot(&first.normal.value.normalize()),
            point: input.markers[0].point + first.point.value,
        })
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        out: &mut ConstraintOutput<'_, Spatial>,
    ) {
        let (m1, m2) = (&input.markers[0], &input.markers[1]);
        let (one, two) = (self.touching(0, input), self.touching(1, input));
        let (s1, s2) = input.s_rate.split_at(2);
        let d = m1.point + one.point.value - m2.point - two.point.value;
        let bias = one.point.bias(s1, &m1.omega) - two.point.bias(s2, &m2.omega);
        for k in 0..3 {
            let mut e = Vector3::zeros();
            e[k] = 1.0;
            out.value[k] = d[k];
            out.gradient[2 * k] = join(&e, &one.point.value.cross(&e));
            out.gradient[2 * k + 1] = join(&-e, &-two.point.value.cross(&e));
            for m in 0..2 {
                out.auxiliary[4 * k + m] = one.point.by[m][k];
                out.auxiliary[4 * k + 2 + m] = -two.point.by[m][k];
            }
            out.bias[k] = bias[k];
        }
        let n = &two.normal;
        let (n1, n2) = (n.rate(s2, &m2.omega), n.bias(s2, &m2.omega));
        for (k, t) in one.tangents.iter().enumerate() {
            let row = 3 + k;
            let turn = t.value.cross(&n.value);
            out.value[row] = t.value.dot(&n.value);
            out.gradient[2 * row] = join(&Vector3::zeros(), &turn);
            out.gradient[2 * row + 1] = join(&Vector3::zeros(), &-turn);
            for m in 0..2 {
                out.auxiliary[4 * row + m] = t.by[m].dot(&n.value);
                out.auxiliary[4 * row + 2 + m] = t.value.dot(&n.by[m]);
            }
            let (t1, t2) = (t.rate(s1, &m1.omega), t.bias(s1, &m1.omega));
            out.bias[row] = t2.dot(&n.value) + 2.0 * t1.dot(&n1) + t.value.dot(&n2);
        }
        if let Some((place, value)) = self.held {
            out.value[5] = input.s[place] - value;
            out.auxiliary[20 + place] = 1.0;
        }
    }
}
