//! The joint catalogue, and the constraint elements that joints are made of.
//!
//! Scalar [`Measure`]s between two markers (relative coordinates, distance, angle) are stated once
//! with gradient and second derivative. Most joints, all drivers, couplers, gears and racks are
//! weighted sums of measures that follow a function of time ([`MeasureRows`]). Contacts of curves
//! ([`Cam`], [`RollingOnCircle`]) carry a surface parameter of their own.

mod cam;
mod contact_fault;
mod contact_force;
mod expression_rows;
mod guarded;
mod knife_edge;
mod measure;
mod measure_rows;
mod planar_measure;
mod point_on_curve;
mod point_on_surface;
mod regularity;
mod rolling;
mod rolling_on_plane;
mod spatial_measure;
mod sphere_contact;
mod surface_contact;
mod time_function;
mod velocity_rows;

pub use cam::{Cam, Follower, Profile};
pub use contact_fault::ContactFault;
pub use contact_force::ContactForce;
pub use expression_rows::ExpressionRows;
pub use guarded::{Guarded, Lost};
pub use knife_edge::KnifeEdge;
pub use measure::{Measure, MeasureKind, Measured};
pub use measure_rows::{MeasureRow, MeasureRows, MeasureTerm, SumOfMeasures, sum_of};
pub use planar_measure::PlanarMeasure;
pub use point_on_curve::PointOnCurve;
pub use point_on_surface::PointOnSurface;
pub use regularity::Regularity;
pub use rolling::RollingOnCircle;
pub use rolling_on_plane::RollingOnPlane;
pub use spatial_measure::SpatialMeasure;
pub use sphere_contact::SphereContact;
pub use surface_contact::SurfaceContact;
pub use time_function::{RateIntegral, TimeFunction};
pub use velocity_rows::VelocityRows;

use crate::space::Space;
use crate::surface::Sheet;
use std::fmt::Debug;
use std::ops::Range;

/// Unit of a constraint row: decides its scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowUnit {
    /// The residual is a length [m].
    Length,
    /// The residual is an angle [rad].
    Angle,
    /// Anything else: the residual is scaled by its gradient at the estimate.
    Other,
}

impl RowUnit {
    /// Its SI symbol; empty for others.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Length => "m",
            Self::Angle => "rad",
            Self::Other => "",
        }
    }
}

/// Label and unit of one constraint row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowLabel {
    /// What the row holds, for messages: "x", "angle", "across the slide".
    pub text: String,
    /// Its unit.
    pub unit: RowUnit,
}

/// What a constraint element sees.
#[derive(Debug)]
pub struct ConstraintInput<'a, S: Space> {
    /// Time [s].
    pub t: f64,
    /// The element's markers, in its own order.
    pub markers: &'a [S::Marker],
    /// Its auxiliary coordinates.
    pub s: &'a [f64],
    /// Their rates.
    pub s_rate: &'a [f64],
}

/// What a constraint element answers; every slice has the element's own size and comes zeroed.
#[derive(Debug)]
pub struct ConstraintOutput<'a, S: Space> {
    /// C, per row.
    pub value: &'a mut [f64],
    /// dC/d(twist of marker), rows x markers, row-major.
    pub gradient: &'a mut [S::Twist],
    /// dC/ds, rows x auxiliaries, row-major.
    pub auxiliary: &'a mut [f64],
    /// dC/dt at fixed coordinates, per row.
    pub time: &'a mut [f64],
    /// d2C/dt2 where the accelerations of markers and auxiliaries vanish, per row.
    pub bias: &'a mut [f64],
}

/// A set of constraint rows C(markers, s, t) = 0.
pub trait ConstraintElement<S: Space>: Debug + Send + Sync {
    /// Labels of the rows; their number is the number of rows.
    fn labels(&self) -> Vec<RowLabel>;
    /// Labels of the auxiliary coordinates and their units.
    fn auxiliaries(&self) -> Vec<RowLabel> {
        Vec::new()
    }
    /// Which of its rows hold for velocities only, a.v + b = 0 (nonholonomic): C is zero there, its gradient by the twists
    /// is a, C_t is b, and the bias is the derivative of the row where the accelerations vanish.
    fn velocity_rows(&self) -> Range<usize> {
        0..0
    }
    /// Residual and derivatives at a state.
    fn evaluate(&self, input: &ConstraintInput<'_, S>, out: &mut ConstraintOutput<'_, S>);
    /// Distances among its rows: the points of each must stay apart.
    fn distances(&self) -> Vec<Measure<S>> {
        Vec::new()
    }
    /// Shows the vectors that must not vanish, at a state of its markers.
    fn guarded(&self, _markers: &[S::Marker], _see: &mut dyn FnMut(Guarded)) {}
    /// Sums of cosines that are one where the element stands as it is meant; its rows may also hold where one of them is
    /// zero or negative.
    fn alike(&self) -> &[SumOfMeasures<S>] {
        &[]
    }
    /// How far its surfaces reach from their markers [m]; zero for elements without surfaces.
    fn reach(&self) -> f64 {
        0.0
    }
    /// Of surfaces that touch the cosine between the first normal and the opposite of the second: one where they touch from
    /// outside, less than zero where the bodies lie on the same side. None for other elements.
    fn facing(&self, _input: &ConstraintInput<'_, S>) -> Option<f64> {
        None
    }
    /// How regular the contact of surfaces is; none for other elements.
    fn regularity(&self, _input: &ConstraintInput<'_, S>) -> Option<Regularity> {
        None
    }
    /// Why its surfaces do not touch as they should where its rows hold; none where they do, and for other elements.
    fn fault(&self, _input: &ConstraintInput<'_, S>) -> Option<ContactFault> {
        None
    }
    /// The distance of points that may start at the same place, because any direction is as good as another [m].
    fn apart(&self) -> Option<f64> {
        None
    }
    /// Its auxiliary coordinates as results give them, by name: of surfaces the parameters a and b. `last` are the values of
    /// the instant before, or nothing; angles are given on the turn that is nearest to them.
    fn parameters(&self, s: &[f64], _last: &[f64]) -> Vec<(String, f64)> {
        let labels = self.auxiliaries().into_iter();
        labels.map(|l| l.text).zip(s.iter().copied()).collect()
    }
    /// Its surfaces around the points with these auxiliary coordinates, as far as a size [m], in the frames of the markers
    /// with these numbers: for the picture.
    fn sheets(&self, _s: &[f64], _size: f64) -> Vec<(usize, Sheet)> {
        Vec::new()
    }
    /// Does a contact hold where it would have to pull, by intention?
    fn holds_both_ways(&self) -> bool {
        false
    }
    /// The force of a contact whose rows have these multipliers; none for other elements.
    fn contact(
        &self,
        _input: &ConstraintInput<'_, S>,
        _multipliers: &[f64],
    ) -> Option<ContactForce> {
        None
    }
    /// Closed curve that the element gives to the body of its first marker, in the marker's axes, for
    /// the picture [m]; empty for most.
    fn outline(&self) -> Vec<[f64; 2]> {
        Vec::new()
    }
}
