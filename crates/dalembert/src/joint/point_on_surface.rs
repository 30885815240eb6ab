//! A point, or a ball about it, that stays on a surface.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, ContactForce, RowLabel, RowUnit,
};
use crate::space::{Spatial, SpatialMarker, join};
use crate::surface::{Field, Surface};
use nalgebra::Vector3;

/// The point c of one marker keeps the distance R from the surface of another: r + A (u(s) + R n(s)) - c = 0, with n the
/// unit normal out of the surface's body and s its two parameters as auxiliary coordinates. With R = 0 the point lies on
/// the surface, with R > 0 a ball of that radius touches it.
#[derive(Clone, Debug)]
pub struct PointOnSurface {
    /// The surface.
    pub surface: Surface,
    /// R [m].
    pub distance: f64,
    /// Does the surface belong to the second marker, the point to the first?
    pub reversed: bool,
}

impl PointOnSurface {
    /// Numbers of the markers of the surface and of the point.
    fn order(&self) -> [usize; 2] {
        if self.reversed { [1, 0] } else { [0, 1] }
    }

    /// The way to the point's place from the frame of the surface, and the normal, in ground axes.
    fn fields(&self, marker: &SpatialMarker, s: &[f64]) -> [Field; 2] {
        let partials = self.surface.partials(s);
        let normal = self.surface.normal(&partials).unit();
        let offset = Field::point(&partials).plus(self.distance, &normal);
        [offset.turned(&marker.axes), normal.turned(&marker.axes)]
    }
}

impl ConstraintElement<Spatial> for PointOnSurface {
    fn labels(&self) -> Vec<RowLabel> {
        ["contact x", "contact y", "contact z"]
            .map(|text| RowLabel {
                text: text.to_owned(),
                unit: RowUnit::Length,
            })
            .to_vec()
    }

    fn auxiliaries(&self) -> Vec<RowLabel> {
        ["a", "b"]
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
        let [base, _] = self.order();
        let marker = &input.markers[base];
        let [offset, normal] = self.fields(marker, input.s);
        // C = (surface) - (point): the multipliers are the force on the point's body.
        let force = Vector3::from_column_slice(multipliers);
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
        for k in 0..3 {
            let mut e = Vector3::zeros();
            e[k] = 1.0;
            out.value[k] = marker.point[k] + f.value[k] - point.point[k];
            out.gradient[2 * k + base] = join(&e, &f.value.cross(&e));
            out.gradient[2 * k + other] = join(&-e, &Vector3::zeros());
            for m in 0..2 {
                out.auxiliary[2 * k + m] = f.by[m][k];
            }
            out.bias[k] = bias[k];
        }
    }
}
