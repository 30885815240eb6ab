//! Orientation in space: sets of coordinates and the conversions between them.
//!
//! Inside, an orientation is a unit quaternion (Euler parameters, scalar first): `A` maps body components to ground
//! components, its columns are the body axes. `omega` is the angular velocity in ground axes, `omegabar` in body axes.
//! Every set of coordinates x has a matrix Gbar with omegabar = Gbar dx/dt, and G = A Gbar with omega = G dx/dt
//! (Shabana 7.72, 7.81, 8.22, 8.24, 8.32).

mod axis;
mod axis_angle;
mod cosines;
mod error;
mod euler;
mod euler_parameters;
mod rates;
mod rodriguez;
mod set;

pub use axis::Axis;
pub use axis_angle::AxisAngle;
pub use cosines::{from_axes, from_matrix, from_points, rotation_of, triad};
pub use error::OrientationError;
pub use euler::{EulerAngles, EulerSequence};
pub use euler_parameters::EulerParameters;
pub use rates::{CoordinateCondition, OrientationRates};
pub use rodriguez::RodriguezParameters;
pub use set::{OrientationSet, SetCoordinates};

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

/// An orientation: the rotation that takes ground axes to body axes.
pub type Rotation = UnitQuaternion<f64>;

/// Orientation of the second frame seen from the first: A1^T A2 (Shabana 8.48).
pub fn relative(first: &Rotation, second: &Rotation) -> Rotation {
    first.conjugate() * second
}

/// Cross-product matrix: skew(a) b = a x b.
pub fn skew(a: &Vector3<f64>) -> Matrix3<f64> {
    a.cross_matrix()
}
