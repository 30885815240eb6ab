//! Poses, twists, wrenches and inertias: the only place, with the joint catalogue, that knows
//! the dimension.
//!
//! Twist = (linear, angular), wrench = (force, moment), linear first. Planar: 3 components, spatial: 6.

pub mod orientation;
mod planar;
mod screw;
mod spatial;
mod tuple;

pub use planar::{Planar, PlanarFrame, PlanarMarker, PlanarPose, perpendicular};
pub use screw::Screw;
pub use spatial::{Spatial, SpatialFrame, SpatialMarker, SpatialPose, join};
pub use tuple::Tuple;

use crate::joint::{Guarded, MeasureKind};
use nalgebra::{Matrix3, Vector3};
use orientation::OrientationSet;
use smallvec::SmallVec;
use std::fmt::Debug;
use std::hash::Hash;

/// Euclidean length of a row of components, which neither overflows nor underflows.
pub fn norm(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m: f64, x| m.hypot(*x))
}

/// Name and unit of a number that says how a frame stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AttitudeLabel {
    /// Name, like "angle".
    pub name: String,
    /// SI unit; empty for pure numbers.
    pub unit: &'static str,
    /// What it is.
    pub meaning: String,
}

/// Linear and angular part of a twist or a wrench as vectors of space; the plane is that of x and y.
pub fn spread<S: Space>(x: &S::Twist) -> [Vector3<f64>; 2] {
    let mut parts = [Vector3::zeros(); 2];
    let (linear, angular) = x.as_slice().split_at(S::LINEAR);
    parts[0].as_mut_slice()[..S::LINEAR].copy_from_slice(linear);
    for (k, x) in S::ANGULAR.iter().zip(angular) {
        parts[1][*k] = *x;
    }
    parts
}

/// The inverse of [`spread`]; what the plane has no component for is left out.
pub fn gather<S: Space>([linear, angular]: [Vector3<f64>; 2]) -> S::Twist {
    let mut x = S::Twist::zero();
    let (own_linear, own_angular) = x.as_mut_slice().split_at_mut(S::LINEAR);
    own_linear.copy_from_slice(&linear.as_slice()[..S::LINEAR]);
    for (x, k) in own_angular.iter_mut().zip(S::ANGULAR) {
        *x = angular[*k];
    }
    x
}

/// A coordinate of the pose of one marker seen from another.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseCoordinate<T> {
    /// Value.
    pub value: f64,
    /// Rate.
    pub rate: f64,
    /// Gradient with respect to the twist of the first marker.
    pub first: T,
    /// Gradient with respect to the twist of the second marker.
    pub second: T,
}

/// What a dimension must say about itself, for the assembly to be written once.
///
/// Coordinates of a body: `NQ` positions and `NV` velocities, of its centre of mass.
pub trait Space: Copy + Debug + Default + Eq + Hash + Send + Sync + 'static {
    /// Position coordinates of a body.
    const NQ: usize;
    /// Velocity coordinates of a body.
    const NV: usize;
    /// Linear components among the velocity coordinates of a body; they come first, the angular ones follow.
    const LINEAR: usize;
    /// Which of the three angular components of space the angular velocity coordinates are.
    const ANGULAR: &'static [usize];
    /// Change of a position coordinate that counts as a turn by 1 rad.
    const TURN: f64;
    /// Has a turning body inertia forces of its own ([`Space::gyroscopic`])?
    const GYROSCOPIC: bool;
    /// Names of the position coordinates of a body.
    const POSITION_NAMES: &'static [&'static str];
    /// Names of the velocity coordinates of a body.
    const VELOCITY_NAMES: &'static [&'static str];
    /// Twist or wrench: linear components first.
    type Twist: Tuple;
    /// A frame fixed in a body, measured from the centre of mass in body axes (ground: from the origin).
    type Frame: Copy + Debug + Default + PartialEq + Send + Sync;
    /// Where a body is and how it stands, with what all its frames share (sines and cosines).
    type Pose: Copy + Debug + Default + Send + Sync;
    /// A frame's pose and velocity in ground axes at one instant.
    type Marker: Copy + Debug + Default + Send + Sync;

    /// Scalars that are measured between two markers.
    type Measure: MeasureKind<Self>;

    /// Pose of a body with coordinates `q` (NQ).
    fn pose(q: &[f64]) -> Self::Pose;
    /// Pose and velocity of a frame on a body with velocities `v` (NV).
    fn marker(frame: &Self::Frame, pose: &Self::Pose, v: &[f64]) -> Self::Marker;
    /// Distance of a frame from its body's centre of mass (ground: from the origin) [m].
    fn arm(frame: &Self::Frame) -> f64;
    /// Pose of a frame on the ground.
    fn ground_marker(frame: &Self::Frame) -> Self::Marker;
    /// Twist of a marker: velocity of its point, angular velocity, in ground axes.
    fn twist(marker: &Self::Marker) -> Self::Twist;
    /// Acceleration of the marker (point, angular) where the body's own accelerations vanish.
    fn bias(marker: &Self::Marker) -> Self::Twist;
    /// Carries a wrench (or a gradient with respect to the twist) at a marker to the body's
    /// velocity coordinates: K^T of Tokad (13), the moment of a force at its arm.
    fn pull(marker: &Self::Marker, wrench: &Self::Twist) -> Self::Twist;
    /// Carries velocity coordinates of the body to the twist at a marker: the transpose of `pull`.
    fn push(marker: &Self::Marker, velocity: &Self::Twist) -> Self::Twist;
    /// Axes of a marker as columns, in ground axes; the plane is that of x and y.
    fn axes(marker: &Self::Marker) -> Matrix3<f64>;
    /// What an attitude is written as, one label for each number of [`Space::attitude`].
    fn attitude_labels(set: OrientationSet) -> Vec<AttitudeLabel>;
    /// How a marker stands, in the coordinates of a set (in the plane: its angle, counting turns) near the numbers
    /// `before`, where there are any.
    fn attitude(
        marker: &Self::Marker,
        set: OrientationSet,
        before: Option<&[f64]>,
    ) -> SmallVec<[f64; 9]>;
    /// How far a marker is from where a set of coordinates is singular, one at most; always one in the plane.
    fn regularity(marker: &Self::Marker, set: OrientationSet) -> f64;
    /// A marker at the ground's origin that stands as the second does seen from the first.
    fn relative(first: &Self::Marker, second: &Self::Marker) -> Self::Marker;
    /// The pose of the second marker in the axes of the first: displacements, then the angle or the rotation vector.
    fn pose_coordinates(
        first: &Self::Marker,
        second: &Self::Marker,
    ) -> SmallVec<[PoseCoordinate<Self::Twist>; 6]>;
    /// A vector that vanishes where the rotation vector of the second marker in the axes of the first changes its sign, at
    /// half a turn; none where turns are counted.
    fn turn_guard(_first: &Self::Marker, _second: &Self::Marker) -> Option<Guarded> {
        None
    }
    /// Point of a marker in ground axes [m]; z is zero in the plane.
    fn point(marker: &Self::Marker) -> [f64; 3];
    /// Carries a momentum or force of a body's velocity coordinates, at its centre of mass, to the ground's origin and
    /// axes.
    fn at_origin(center: &Self::Marker, momentum: &Self::Twist) -> Self::Twist;
    /// Position coordinates (NQ) that a body would have if the marker were its frame.
    fn own_position(marker: &Self::Marker, out: &mut [f64]);
    /// Velocity coordinates that a body would have if the marker were its frame: linear in ground axes, angular in the
    /// axes in which the space counts them.
    fn own_velocity(marker: &Self::Marker) -> Self::Twist;
    /// The way back: the body's velocity coordinates from those of its frame `frame`, whose marker is `marker`. Linear in
    /// `own`; with `own` at rest the body's accelerations lose [`Space::bias`] of the marker.
    fn from_own(frame: &Self::Frame, marker: &Self::Marker, own: &Self::Twist) -> Self::Twist;
    /// Axis of the motion of a body with velocity coordinates `v`; none where all axes are alike, or nothing moves.
    fn screw(center: &Self::Marker, v: &Self::Twist) -> Option<Screw>;
    /// Rates q' (NQ) of a body with velocities `v` (NV).
    fn rate(q: &[f64], v: &[f64], out: &mut [f64]);
    /// Moves a body by a step in its velocity coordinates: the point that is reached in unit time with constant
    /// velocities `step`.
    fn advance(q: &mut [f64], step: &[f64]);
    /// The smallest step (NV) that `advance` needs from one pose of a body to another.
    fn difference(from: &[f64], to: &[f64], out: &mut [f64]);
    /// Distance of a body's centre from the origin [m], and the angle that its coordinates count [rad].
    fn reach(q: &[f64]) -> [f64; 2];
    /// Brings redundant coordinates of a body back to their own condition.
    fn normalize(q: &mut [f64]);
    /// Tells the second marker of an angle that counts turns which turn it was on last: the angle itself [rad]. Nothing
    /// where poses count turns.
    fn set_turn(marker: &mut Self::Marker, turn: f64);
    /// What a marker was told of its turn [rad]; zero where poses count turns.
    fn turn(marker: &Self::Marker) -> f64;
    /// Q_v of a body with the mass block `mass` (NV x NV, row-major): the inertia forces of its own rotation.
    fn gyroscopic(mass: &[f64], v: &[f64]) -> Self::Twist;
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector6;

    #[test]
    fn spread_and_gather_are_inverse() {
        let twist = Vector6::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
        assert_eq!(gather::<Spatial>(spread::<Spatial>(&twist)), twist);
        let twist = Vector3::new(1.0, 2.0, 3.0);
        let parts = spread::<Planar>(&twist);
        assert_eq!(parts[0], Vector3::new(1.0, 2.0, 0.0));
        assert_eq!(parts[1], Vector3::new(0.0, 0.0, 3.0));
        assert_eq!(gather::<Planar>(parts), twist);
    }
}
