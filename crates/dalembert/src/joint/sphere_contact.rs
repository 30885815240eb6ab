//! Contact of two spheres.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, ContactForce, Measure, MeasureRow,
    MeasureRows, RowLabel, SpatialMeasure,
};
use crate::space::Spatial;
use crate::surface::{Sheet, Surface, SurfaceShape};
use smallvec::smallvec;

/// Two spheres about the points of the markers that touch: |d| = R1 + R2, or |R1 - R2| where one lies inside the other.
#[derive(Clone, Debug)]
pub struct SphereContact {
    rows: MeasureRows<Spatial>,
    /// Radius of the first sphere, negative where it lies around the second or the second around it.
    first: f64,
    inside: bool,
    /// Of the centres.
    distance: f64,
}

impl SphereContact {
    /// Spheres that touch from outside, or one inside the other.
    pub fn new(radii: [f64; 2], inside: bool) -> Self {
        let [first, second] = radii;
        let distance = if inside {
            (first - second).abs()
        } else {
            first + second
        };
        let measure = Measure {
            kind: SpatialMeasure::Distance,
            first: 0,
            second: 1,
        };
        let row = MeasureRow::minus(measure, distance, "contact");
        Self {
            rows: MeasureRows::new(2, smallvec![row]),
            // From the first centre towards the second the contact lies at the radius, or on the far side of a ball in a bowl.
            first: if inside && first < second {
                -first
            } else {
                first
            },
            inside,
            distance,
        }
    }
}

impl ConstraintElement<Spatial> for SphereContact {
    fn labels(&self) -> Vec<RowLabel> {
        self.rows.labels()
    }

    fn distances(&self) -> Vec<Measure<Spatial>> {
        self.rows.distances()
    }

    fn sheets(&self, _: &[f64], size: f64) -> Vec<(usize, Sheet)> {
        let first = self.first.abs();
        let second = (self.distance - self.first).abs();
        let sphere = |radius| Surface {
            shape: SurfaceShape::Sphere(radius),
            inside: false,
        };
        let sheet = |radius| sphere(radius).sheet(&[0.0, 0.0, 1.0], size);
        let sheets = [first, second].into_iter().enumerate();
        sheets.filter_map(|(k, r)| Some((k, sheet(r)?))).collect()
    }

    fn reach(&self) -> f64 {
        self.first.abs().max((self.distance - self.first).abs())
    }

    fn apart(&self) -> Option<f64> {
        Some(self.distance)
    }

    fn contact(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        multipliers: &[f64],
    ) -> Option<ContactForce> {
        let d = input.markers[1].point - input.markers[0].point;
        // The row is |d| with a minus: its multiplier pushes the spheres apart.
        let sign = if self.inside { -1.0 } else { 1.0 };
        Some(ContactForce {
            normal: sign * multipliers[0],
            point: input.markers[0].point + self.first * d.normalize(),
        })
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        out: &mut ConstraintOutput<'_, Spatial>,
    ) {
        self.rows.evaluate(input, out);
    }
}
