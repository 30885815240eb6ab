//! A circle that rolls without slip on a circle.

use super::{ConstraintElement, ConstraintInput, ConstraintOutput, RowLabel, RowUnit};
use crate::space::Planar;
use nalgebra::{Vector2, Vector3};

/// Rolling of the second body's circle (radius r) on the first body's circle (radius R).
///
/// Auxiliary coordinate psi: ground angle of the line of centres, from first to second, never
/// wrapped. Rows:
///   r_a + D e(psi) - r_b = 0            (D = R + r outside; D = R - r inside)
///   R (psi - th_a) + r (psi - th_b) = c (outside; inside with -r): equal arcs.
/// Inside with r > R: the second circle is a ring around the first; D is then negative and the same
/// equations hold.
#[derive(Clone, Debug)]
pub struct RollingOnCircle {
    /// Radius of the first circle [m].
    pub first: f64,
    /// Radius of the second circle [m], negative where the contact is internal.
    pub second: f64,
    /// Constant of the arcs.
    pub constant: f64,
}

impl ConstraintElement<Planar> for RollingOnCircle {
    fn labels(&self) -> Vec<RowLabel> {
        ["contact x", "contact y", "no slip"]
            .map(|text| RowLabel {
                text: text.to_owned(),
                unit: RowUnit::Length,
            })
            .to_vec()
    }

    fn auxiliaries(&self) -> Vec<RowLabel> {
        vec![RowLabel {
            text: "psi".to_owned(),
            unit: RowUnit::Angle,
        }]
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Planar>,
        out: &mut ConstraintOutput<'_, Planar>,
    ) {
        let (a, b) = (&input.markers[0], &input.markers[1]);
        let (psi, rate) = (input.s[0], input.s_rate[0]);
        let (sin, cos) = psi.sin_cos();
        let distance = self.first + self.second;
        let e = Vector2::new(cos, sin);
        let c = a.point + distance * e - b.point;
        for (k, (value, (tangent, normal))) in c
            .iter()
            .zip([-sin, cos].into_iter().zip([cos, sin]))
            .enumerate()
        {
            out.value[k] = *value;
            let mut unit = Vector3::zeros();
            unit[k] = 1.0;
            out.gradient[2 * k] = unit;
            out.gradient[2 * k + 1] = -unit;
            out.auxiliary[k] = distance * tangent;
            out.bias[k] = -distance * rate * rate * normal;
        }
        out.value[2] = self.first * (psi - a.angle) + self.second * (psi - b.angle) - self.constant;
        out.gradient[4] = Vector3::new(0.0, 0.0, -self.first);
        out.gradient[5] = Vector3::new(0.0, 0.0, -self.second);
        out.auxiliary[2] = distance;
    }
}
