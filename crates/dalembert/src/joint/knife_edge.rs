//! A skate, a keel, a blade: a point that does not move sideways.

use super::{ConstraintElement, ConstraintInput, ConstraintOutput, RowLabel, RowUnit};
use crate::space::{Spatial, join};
use std::ops::Range;

/// The point of the second marker moves on the first marker's body, but not along f, the z axis of the second:
/// f.(v_b - v_a(P)) = 0, with v_a(P) the velocity of the first body's material point there. A velocity row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KnifeEdge;

impl ConstraintElement<Spatial> for KnifeEdge {
    fn labels(&self) -> Vec<RowLabel> {
        vec![RowLabel {
            text: "sideways".to_owned(),
            unit: RowUnit::Length,
        }]
    }

    fn velocity_rows(&self) -> Range<usize> {
        0..1
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        out: &mut ConstraintOutput<'_, Spatial>,
    ) {
        let (a, b) = (&input.markers[0], &input.markers[1]);
        let f = b.axes.column(2).into_owned();
        let d = b.point - a.point;
        let relative = b.velocity - a.velocity - a.omega.cross(&d);
        out.gradient[0] = join(&-f, &-d.cross(&f));
        out.gradient[1] = join(&f, &nalgebra::Vector3::zeros());
        out.bias[0] =
            b.omega.cross(&f).dot(&relative) - f.dot(&a.omega.cross(&(b.velocity - a.velocity)));
    }
}
