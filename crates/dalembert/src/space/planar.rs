//! The plane: three coordinates a body.

use super::orientation::OrientationSet;
use super::{AttitudeLabel, PoseCoordinate, Screw, Space};
use crate::joint::PlanarMeasure;
use nalgebra::{Matrix3, Vector2, Vector3};
use smallvec::{SmallVec, smallvec};

/// Planar motion: q = v-layout = (x, y, angle) of the centre of mass, ground axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Planar;

/// A frame fixed in a planar body, from the centre of mass, in body axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlanarFrame {
    /// Origin [m].
    pub at: Vector2<f64>,
    /// Angle of its x axis [rad].
    pub angle: f64,
}

/// Pose of a planar body in ground axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlanarPose {
    /// Centre of mass [m].
    pub point: Vector2<f64>,
    /// Angle, never wrapped [rad].
    pub angle: f64,
    /// Unit x axis.
    pub ex: Vector2<f64>,
}

/// Pose and velocity of a planar frame in ground axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlanarMarker {
    /// Point [m].
    pub point: Vector2<f64>,
    /// Angle of the x axis, never wrapped [rad].
    pub angle: f64,
    /// Unit x axis.
    pub ex: Vector2<f64>,
    /// From the body's centre of mass to the point [m].
    pub arm: Vector2<f64>,
    /// Velocity of the point [m/s].
    pub velocity: Vector2<f64>,
    /// Angular velocity [rad/s].
    pub omega: f64,
}

impl PlanarMarker {
    /// Unit y axis.
    pub fn ey(&self) -> Vector2<f64> {
        perpendicular(&self.ex)
    }
}

/// A vector turned by +90 degrees: k x a.
pub fn perpendicular(a: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-a.y, a.x)
}

impl Space for Planar {
    const NQ: usize = 3;
    const NV: usize = 3;
    const LINEAR: usize = 2;
    const ANGULAR: &'static [usize] = &[2];
    const TURN: f64 = 1.0;
    const GYROSCOPIC: bool = false;
    const POSITION_NAMES: &'static [&'static str] = &["x", "y", "angle"];
    const VELOCITY_NAMES: &'static [&'static str] = &["x", "y", "angle"];
    type Twist = Vector3<f64>;
    type Frame = PlanarFrame;
    type Pose = PlanarPose;
    type Marker = PlanarMarker;
    type Measure = PlanarMeasure;

    fn pose(q: &[f64]) -> PlanarPose {
        let (s, c) = q[2].sin_cos();
        PlanarPose {
            point: Vector2::new(q[0], q[1]),
            angle: q[2],
            ex: Vector2::new(c, s),
        }
    }

    fn marker(frame: &PlanarFrame, pose: &PlanarPose, v: &[f64]) -> PlanarMarker {
        let arm = frame.at.x * pose.ex + frame.at.y * perpendicular(&pose.ex);
        let ex = if frame.angle == 0.0 {
            pose.ex
        } else {
            let (s, c) = (pose.angle + frame.angle).sin_cos();
            Vector2::new(c, s)
        };
        PlanarMarker {
            point: pose.point + arm,
            angle: pose.angle + frame.angle,
            ex,
            arm,
            velocity: Vector2::new(v[0], v[1]) + v[2] * perpendicular(&arm),
            omega: v[2],
        }
    }

    fn arm(frame: &PlanarFrame) -> f64 {
        frame.at.norm()
    }

    fn ground_marker(frame: &PlanarFrame) -> PlanarMarker {
        let (s, c) = frame.angle.sin_cos();
        PlanarMarker {
            point: frame.at,
            angle: frame.angle,
            ex: Vector2::new(c, s),
            arm: frame.at,
            velocity: Vector2::zeros(),
            omega: 0.0,
        }
    }

    fn twist(m: &PlanarMarker) -> Vector3<f64> {
        Vector3::new(m.velocity.x, m.velocity.y, m.omega)
    }

    // Shabana 3.50: the normal acceleration -omega^2 u.
    fn bias(m: &PlanarMarker) -> Vector3<f64> {
        let w2 = m.omega * m.omega;
        Vector3::new(-w2 * m.arm.x, -w2 * m.arm.y, 0.0)
    }

    fn pull(m: &PlanarMarker, w: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(w.x, w.y, w.z + m.arm.x * w.y - m.arm.y * w.x)
    }

    fn push(m: &PlanarMarker, v: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(v.x - v.z * m.arm.y, v.y + v.z * m.arm.x, v.z)
    }

    fn axes(m: &PlanarMarker) -> Matrix3<f64> {
        let (x, y) = (m.ex, m.ey());
        Matrix3::new(x.x, y.x, 0.0, x.y, y.y, 0.0, 0.0, 0.0, 1.0)
    }

    fn attitude_labels(_: OrientationSet) -> Vec<AttitudeLabel> {
        vec![AttitudeLabel {
            name: "angle".to_owned(),
            unit: "rad",
            meaning: "angle, counter-clockwise, counting turns".to_owned(),
        }]
    }

    fn attitude(m: &PlanarMarker, _: OrientationSet, _: Option<&[f64]>) -> SmallVec<[f64; 9]> {
        smallvec![m.angle]
    }

    fn regularity(_: &PlanarMarker, _: OrientationSet) -> f64 {
        1.0
    }

    fn relative(first: &PlanarMarker, second: &PlanarMarker) -> PlanarMarker {
        Self::ground_marker(&PlanarFrame {
            at: Vector2::zeros(),
            angle: second.angle - first.angle,
        })
    }

    fn pose_coordinates(
        first: &PlanarMarker,
        second: &PlanarMarker,
    ) -> SmallVec<[PoseCoordinate<Vector3<f64>>; 6]> {
        use PlanarMeasure::{AlongX, AlongY, Angle};
        let measures = [AlongX, AlongY, Angle].into_iter();
        measures
            .map(|kind| PoseCoordinate::from(kind.evaluate(first, second)))
            .collect()
    }

    fn point(m: &PlanarMarker) -> [f64; 3] {
        [m.point.x, m.point.y, 0.0]
    }

    fn at_origin(m: &PlanarMarker, h: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(h.x, h.y, h.z + m.point.x * h.y - m.point.y * h.x)
    }

    fn own_position(m: &PlanarMarker, out: &mut [f64]) {
        out.copy_from_slice(&[m.point.x, m.point.y, m.angle]);
    }

    fn own_velocity(m: &PlanarMarker) -> Vector3<f64> {
        Self::twist(m)
    }

    fn from_own(_: &PlanarFrame, m: &PlanarMarker, own: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(own.x + own.z * m.arm.y, own.y - own.z * m.arm.x, own.z)
    }

    /// Every turn in the plane is about its normal.
    fn screw(_: &PlanarMarker, _: &Vector3<f64>) -> Option<Screw> {
        None
    }

    fn rate(_: &[f64], v: &[f64], out: &mut [f64]) {
        out.copy_from_slice(v);
    }

    fn advance(q: &mut [f64], step: &[f64]) {
        for (q, s) in q.iter_mut().zip(step) {
            *q += s;
        }
    }

    fn difference(from: &[f64], to: &[f64], out: &mut [f64]) {
        for ((out, from), to) in out.iter_mut().zip(from).zip(to) {
            *out = to - from;
        }
    }

    fn reach(q: &[f64]) -> [f64; 2] {
        [q[0].hypot(q[1]), q[2].abs()]
    }

    fn normalize(_: &mut [f64]) {}

    fn set_turn(_: &mut PlanarMarker, _: f64) {}

    fn turn(_: &PlanarMarker) -> f64 {
        0.0
    }

    fn gyroscopic(_: &[f64], _: &[f64]) -> Vector3<f64> {
        Vector3::zeros()
    }
}
