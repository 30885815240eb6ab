//! Space: seven position coordinates and six velocity coordinates a body.

use super::orientation::{Axis, OrientationSet, rotation_of, skew};
use super::{AttitudeLabel, PoseCoordinate, Screw, Space};
use crate::joint::{Guarded, Lost, SpatialMeasure};
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3, Vector6};
use smallvec::SmallVec;
use std::f64::consts::PI;

/// Spatial motion of the centre of mass.
///
/// q = (r, b): position in ground axes [m], Euler parameters with the scalar first.
/// v = (r', omegabar): velocity in ground axes [m/s], angular velocity in BODY axes [rad/s] (Tokad 42: the mass block is
/// constant).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Spatial;

/// A frame fixed in a spatial body, from the centre of mass, in body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialFrame {
    /// Origin [m].
    pub at: Vector3<f64>,
    /// Its axes as columns, in body axes.
    pub axes: Matrix3<f64>,
}

/// Pose of a spatial body in ground axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialPose {
    /// Centre of mass [m].
    pub point: Vector3<f64>,
    /// Body axes as columns: A.
    pub axes: Matrix3<f64>,
}

/// Pose and velocity of a spatial frame in ground axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialMarker {
    /// Point [m].
    pub point: Vector3<f64>,
    /// Axes of the frame as columns.
    pub axes: Matrix3<f64>,
    /// Axes of its body as columns: A.
    pub body: Matrix3<f64>,
    /// From the body's centre of mass to the point [m].
    pub arm: Vector3<f64>,
    /// Velocity of the point [m/s].
    pub velocity: Vector3<f64>,
    /// Angular velocity [rad/s].
    pub omega: Vector3<f64>,
    /// Angle that was measured to this marker last, counting turns [rad].
    pub turn: f64,
}

impl Default for SpatialFrame {
    fn default() -> Self {
        Self {
            at: Vector3::zeros(),
            axes: Matrix3::identity(),
        }
    }
}

impl Default for SpatialPose {
    fn default() -> Self {
        Self {
            point: Vector3::zeros(),
            axes: Matrix3::identity(),
        }
    }
}

impl Default for SpatialMarker {
    fn default() -> Self {
        Spatial::ground_marker(&SpatialFrame::default())
    }
}

/// Linear and angular parts of a twist or a wrench.
fn parts(x: &Vector6<f64>) -> (Vector3<f64>, Vector3<f64>) {
    (
        Vector3::new(x[0], x[1], x[2]),
        Vector3::new(x[3], x[4], x[5]),
    )
}

/// A twist or a wrench of its two parts.
pub fn join(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(
        linear.x, linear.y, linear.z, angular.x, angular.y, angular.z,
    )
}

/// Turn that is left to half a turn at which a rotation vector is given up [rad].
const NEAR_HALF_TURN: f64 = 1e-3;

/// Rotation vector of the second marker in the axes of the first.
fn rotation_vector(first: &SpatialMarker, second: &SpatialMarker) -> Vector3<f64> {
    rotation_of(&first.axes.tr_mul(&second.axes)).scaled_axis()
}

impl Space for Spatial {
    const NQ: usize = 7;
    const NV: usize = 6;
    const LINEAR: usize = 3;
    const ANGULAR: &'static [usize] = &[0, 1, 2];
    const TURN: f64 = 0.5;
    const GYROSCOPIC: bool = true;
    const POSITION_NAMES: &'static [&'static str] = &["x", "y", "z", "b0", "b1", "b2", "b3"];
    const VELOCITY_NAMES: &'static [&'static str] = &[
        "x",
        "y",
        "z",
        "turn about x",
        "turn about y",
        "turn about z",
    ];
    type Twist = Vector6<f64>;
    type Frame = SpatialFrame;
    type Pose = SpatialPose;
    type Marker = SpatialMarker;
    type Measure = SpatialMeasure;

    /// The Euler parameters need not have unit norm: the stages of an integrator leave the sphere a little.
    fn pose(q: &[f64]) -> SpatialPose {
        let b = UnitQuaternion::from_quaternion(Quaternion::new(q[3], q[4], q[5], q[6]));
        SpatialPose {
            point: Vector3::new(q[0], q[1], q[2]),
            axes: *b.to_rotation_matrix().matrix(),
        }
    }

    fn marker(frame: &SpatialFrame, pose: &SpatialPose, v: &[f64]) -> SpatialMarker {
        let arm = pose.axes * frame.at;
        let omega = pose.axes * Vector3::new(v[3], v[4], v[5]);
        SpatialMarker {
            point: pose.point + arm,
            axes: pose.axes * frame.axes,
            body: pose.axes,
            arm,
            velocity: Vector3::new(v[0], v[1], v[2]) + omega.cross(&arm),
            omega,
            turn: 0.0,
        }
    }

    fn arm(frame: &SpatialFrame) -> f64 {
        frame.at.norm()
    }

    fn ground_marker(frame: &SpatialFrame) -> SpatialMarker {
        SpatialMarker {
            point: frame.at,
            axes: frame.axes,
            body: Matrix3::identity(),
            arm: frame.at,
            velocity: Vector3::zeros(),
            omega: Vector3::zeros(),
            turn: 0.0,
        }
    }

    fn twist(m: &SpatialMarker) -> Vector6<f64> {
        join(&m.velocity, &m.omega)
    }

    // Shabana 7.64: the normal acceleration omega x (omega x u); alpha = A d(omegabar)/dt has no part of its own.
    fn bias(m: &SpatialMarker) -> Vector6<f64> {
        join(&m.omega.cross(&m.omega.cross(&m.arm)), &Vector3::zeros())
    }

    fn pull(m: &SpatialMarker, w: &Vector6<f64>) -> Vector6<f64> {
        let (force, moment) = parts(w);
        join(&force, &m.body.tr_mul(&(moment + m.arm.cross(&force))))
    }

    fn push(m: &SpatialMarker, v: &Vector6<f64>) -> Vector6<f64> {
        let (linear, angular) = parts(v);
        let omega = m.body * angular;
        join(&(linear + omega.cross(&m.arm)), &omega)
    }

    fn axes(m: &SpatialMarker) -> Matrix3<f64> {
        m.axes
    }

    fn attitude_labels(set: OrientationSet) -> Vec<AttitudeLabel> {
        let names = set.names().into_iter().enumerate();
        names
            .map(|(k, name)| AttitudeLabel {
                unit: if set.is_angle(k) { "rad" } else { "" },
                meaning: format!("orientation, {name} of {set}"),
                name,
            })
            .collect()
    }

    fn attitude(
        m: &SpatialMarker,
        set: OrientationSet,
        before: Option<&[f64]>,
    ) -> SmallVec<[f64; 9]> {
        let now = set.coordinates(&rotation_of(&m.axes)).values;
        match before {
            Some(before) => set.near(now, before),
            None => now,
        }
    }

    fn regularity(m: &SpatialMarker, set: OrientationSet) -> f64 {
        set.regularity(&rotation_of(&m.axes))
    }

    fn relative(first: &SpatialMarker, second: &SpatialMarker) -> SpatialMarker {
        Self::ground_marker(&SpatialFrame {
            at: Vector3::zeros(),
            axes: first.axes.tr_mul(&second.axes),
        })
    }

    /// Rotation vector p of R = A1^T A2: p' = J^-1 w with w = A1^T (omega2 - omega1),
    /// J^-1 = I - skew(p)/2 + c skew(p)^2, c = (1 - (t/2) cot(t/2)) / t^2, t = |p| < pi.
    fn pose_coordinates(
        first: &SpatialMarker,
        second: &SpatialMarker,
    ) -> SmallVec<[PoseCoordinate<Vector6<f64>>; 6]> {
        let mut list: SmallVec<[PoseCoordinate<Vector6<f64>>; 6]> = Axis::ALL
            .into_iter()
            .map(|axis| SpatialMeasure::Along(axis).evaluate(first, second).into())
            .collect();
        let p = rotation_vector(first, second);
        let half = 0.5 * p.norm();
        let c = if half < 1e-3 {
            // The next term is below rounding.
            (1.0 + half * half / 15.0) / 12.0
        } else {
            (1.0 - half / half.tan()) / (4.0 * half * half)
        };
        let s = skew(&p);
        let inverse = Matrix3::identity() - 0.5 * s + c * s * s;
        let gradient = inverse * first.axes.transpose();
        let relative = second.omega - first.omega;
        for (k, value) in p.iter().enumerate() {
            let row = gradient.row(k).transpose();
            list.push(PoseCoordinate {
                value: *value,
                rate: row.dot(&relative),
                first: join(&Vector3::zeros(), &-row),
                second: join(&Vector3::zeros(), &row),
            });
        }
        list
    }

    /// The axis of the turn, as long as the part of half a turn that is left.
    fn turn_guard(first: &SpatialMarker, second: &SpatialMarker) -> Option<Guarded> {
        let p = rotation_vector(first, second);
        let angle = p.norm();
        // Without a turn every axis is as good, and far from half a turn.
        let axis = p.try_normalize(0.0).unwrap_or_else(Vector3::x);
        let relative = first.axes.tr_mul(&(second.omega - first.omega));
        Some(Guarded {
            vector: axis * (1.0 - angle / PI),
            rate: -axis * axis.dot(&relative) / PI,
            limit: NEAR_HALF_TURN / PI,
            lost: Lost::RotationVector,
        })
    }

    fn point(m: &SpatialMarker) -> [f64; 3] {
        m.point.into()
    }

    fn at_origin(m: &SpatialMarker, h: &Vector6<f64>) -> Vector6<f64> {
        let (linear, angular) = parts(h);
        join(&linear, &(m.body * angular + m.point.cross(&linear)))
    }

    /// Of the two signs of the Euler parameters the one with a positive scalar part.
    fn own_position(m: &SpatialMarker, out: &mut [f64]) {
        let turn = Rotation3::from_matrix_unchecked(m.axes);
        let b = UnitQuaternion::from_rotation_matrix(&turn);
        let sign = if b.w < 0.0 { -1.0 } else { 1.0 };
        out[..3].copy_from_slice(m.point.as_slice());
        out[3..7].copy_from_slice(&[b.w, b.i, b.j, b.k].map(|x| sign * x));
    }

    fn own_velocity(m: &SpatialMarker) -> Vector6<f64> {
        join(&m.velocity, &m.axes.tr_mul(&m.omega))
    }

    fn from_own(frame: &SpatialFrame, m: &SpatialMarker, own: &Vector6<f64>) -> Vector6<f64> {
        let (linear, angular) = parts(own);
        let omega = m.axes * angular;
        join(&(linear - omega.cross(&m.arm)), &(frame.axes * angular))
    }

    fn screw(m: &SpatialMarker, v: &Vector6<f64>) -> Option<Screw> {
        let (linear, angular) = parts(v);
        Screw::new(&m.point, &linear, &(m.body * angular))
    }

    fn rate(q: &[f64], v: &[f64], out: &mut [f64]) {
        out[..3].copy_from_slice(&v[..3]);
        // b' = Gbar^T omegabar / 4 (Shabana 8.26): half the product of b and (0, omegabar).
        let b = Quaternion::new(q[3], q[4], q[5], q[6]);
        let d = 0.5 * (b * Quaternion::new(0.0, v[3], v[4], v[5]));
        out[3..7].copy_from_slice(&[d.w, d.i, d.j, d.k]);
    }

    fn advance(q: &mut [f64], step: &[f64]) {
        for (q, s) in q[..3].iter_mut().zip(step) {
            *q += s;
        }
        let b = Quaternion::new(q[3], q[4], q[5], q[6]);
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(step[3], step[4], step[5]));
        let b = b * turn.quaternion();
        q[3..7].copy_from_slice(&[b.w, b.i, b.j, b.k]);
        Self::normalize(q);
    }

    fn difference(from: &[f64], to: &[f64], out: &mut [f64]) {
        for k in 0..3 {
            out[k] = to[k] - from[k];
        }
        let unit =
            |q: &[f64]| UnitQuaternion::from_quaternion(Quaternion::new(q[3], q[4], q[5], q[6]));
        let turn = (unit(from).conjugate() * unit(to)).scaled_axis();
        out[3..6].copy_from_slice(turn.as_slice());
    }

    /// Euler parameters count no turns.
    fn reach(q: &[f64]) -> [f64; 2] {
        [q[0].hypot(q[1]).hypot(q[2]), 0.0]
    }

    fn normalize(q: &mut [f64]) {
        let norm = q[3..7].iter().map(|b| b * b).sum::<f64>().sqrt();
        for b in &mut q[3..7] {
            *b /= norm;
        }
    }

    fn set_turn(marker: &mut SpatialMarker, turn: f64) {
        marker.turn = turn;
    }

    fn turn(marker: &SpatialMarker) -> f64 {
        marker.turn
    }

    // Shabana 7.105 with a central frame: -omegabar x (Ibar omegabar).
    fn gyroscopic(mass: &[f64], v: &[f64]) -> Vector6<f64> {
        let w = Vector3::new(v[3], v[4], v[5]);
        let inertia = Matrix3::from_fn(|i, j| mass[(3 + i) * 6 + 3 + j]);
        join(&Vector3::zeros(), &-w.cross(&(inertia * w)))
    }
}
