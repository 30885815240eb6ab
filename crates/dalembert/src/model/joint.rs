//! Joints between two bodies.

use super::{Placement, Point, Surface, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Side of a directed line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// To the left of the direction.
    Left,
    /// To the right of the direction.
    Right,
}

/// Profile of a cam in the cam's joint frame, by the surface parameter `phi` [rad].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum CamProfile {
    /// Polar radius as an expression of `phi`.
    Polar {
        /// Radius r(phi) [m].
        radius: Value,
    },
    /// Both coordinates as expressions of `phi`.
    Cartesian {
        /// x(phi) [m].
        x: Value,
        /// y(phi) [m].
        y: Value,
    },
}

/// What follows the cam.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum CamFollower {
    /// A point of the second body.
    KnifeEdge,
    /// A roller about the point of the second body.
    Roller {
        /// Radius of the roller [m].
        radius: Value,
    },
    /// A straight face through the point of the second body, along its joint x axis.
    Flat,
}

/// A curve in space by its parameter `u`, a plain number.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpaceCurve {
    /// x(u) [m], an expression of `u`.
    pub x: Value,
    /// y(u) [m], an expression of `u`.
    pub y: Value,
    /// z(u) [m], an expression of `u`.
    pub z: Value,
}

/// Kinds of joints. Axes: in space the joint's axis is the z axis of its frames, in the plane a slide runs along the
/// x axis.
///
/// The reaction of a joint is what it exerts on its second body, at the joint's point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum JointKind {
    /// A pin: the two points coincide, and in space the two joint z axes. Coordinate: angle.
    Revolute {
        /// Where; in space `axis` or `axes` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// A slide along the joint's x axis (planar) or z axis (spatial) of the first body. Coordinate: displacement.
    /// One of `angles` and `direction` (planar), or of `axis` and `axes` (spatial) is needed.
    Prismatic {
        /// Where; `angles` or `direction` (planar), `axis` or `axes` (spatial) is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// No relative motion; without directions the relative orientation of the initial estimate is kept.
    Weld {
        /// Where.
        #[serde(flatten)]
        placement: Placement,
    },
    /// A massless rod: the two points keep their distance.
    Distance {
        /// Where; `at` is needed.
        #[serde(flatten)]
        placement: Placement,
        /// Length; default the distance in the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        length: Option<Value>,
    },
    /// A pin of the second body in a slot of the first, along the first's joint x axis (planar).
    /// One of `angles` and `direction` is needed.
    PinSlot {
        /// Where; `angles` or `direction` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// A pair of spur gears; their relative angles to the carrier stay in the ratio of the radii (planar).
    Gear {
        /// The two gears.
        bodies: [String; 2],
        /// The body that carries both axes; default ground.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        carrier: Option<String>,
        /// Pitch radii (or numbers of teeth) of the two gears.
        radii: [Value; 2],
        /// Does one gear mesh inside the other?
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        internal: bool,
    },
    /// A pinion (first body, its centre at the joint's point) on a rack (second body, along its joint x axis) (planar).
    Rack {
        /// Where; `angles` or `direction` is needed.
        #[serde(flatten)]
        placement: Placement,
        /// Pitch radius of the pinion [m].
        radius: Value,
        /// Side of the directed rack on which the pinion lies; default as in the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        side: Option<Side>,
    },
    /// A cam (first body) and its follower (second body), held in contact (planar).
    Cam {
        /// Where: the origin of the profile on the cam, the follower's point (and face direction).
        #[serde(flatten)]
        placement: Placement,
        /// Profile.
        profile: CamProfile,
        /// Follower.
        follower: CamFollower,
        /// Estimate of the surface parameter at the start [rad]; default the nearest point of the profile.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        phi: Option<Value>,
    },
    /// A circle of the second body (centre at its point) rolls without slip on a line of the first body (its joint x axis) (planar).
    RollingOnLine {
        /// Where; `angles` or `direction` is needed.
        #[serde(flatten)]
        placement: Placement,
        /// Radius [m].
        radius: Value,
        /// Side of the directed line on which the circle lies; default as in the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        side: Option<Side>,
    },
    /// A circle of the second body rolls without slip on a circle of the first (planar).
    RollingOnCircle {
        /// Where: the two centres; `at` is needed.
        #[serde(flatten)]
        placement: Placement,
        /// Radii of the first and of the second circle [m].
        radii: [Value; 2],
        /// Does one circle roll inside the other?
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        internal: bool,
    },
    /// A ball joint: the two points coincide (spatial).
    Spherical {
        /// Where.
        #[serde(flatten)]
        placement: Placement,
    },
    /// A sleeve: turns about and slides along the common joint z axis (spatial). Coordinates: angle, displacement.
    Cylindrical {
        /// Where; `axis` or `axes` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// A cross: the two points coincide, and an axis of the first body stays at right angles to an axis of the
    /// second (spatial). Coordinates: angle_1 about the first axis, angle_2 about the second.
    Universal {
        /// Where; `axes` (the first axis in the first body's frame, the second axis in the second body's), or `axis`
        /// (the first axis) together with `second_axis` is needed.
        #[serde(flatten)]
        placement: Placement,
        /// Direction of the axis that is fixed on the second body, in ground axes at the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        second_axis: Option<Point>,
    },
    /// A constant-velocity joint between two shafts along the joint z axes: the two points coincide, and both
    /// shafts turn by the same angle at every bend (spatial).
    ConstantVelocity {
        /// Where; `axis` or `axes` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// A screw along the common joint z axis: every turn moves it on by its pitch (spatial). Coordinate: angle.
    Screw {
        /// Where; `axis` or `axes` is needed.
        #[serde(flatten)]
        placement: Placement,
        /// Displacement of the second body along the axis in one turn [m]; negative for a left-handed screw.
        pitch: Value,
    },
    /// Two faces that slide on each other: the joint z axes, across the faces, stay parallel, and the second point
    /// stays in the first body's joint x-y plane (spatial).
    Planar {
        /// Where; `axis` or `axes` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// The point of the second body stays on a line of the first, its joint z axis (spatial). Coordinate: displacement.
    PointOnLine {
        /// Where; `axis` or `axes` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// The point of the second body stays in a plane of the first, across its joint z axis (spatial).
    PointOnPlane {
        /// Where; `axis` or `axes` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// The point of the second body stays on a curve of the first (spatial).
    PointOnCurve {
        /// Where: the origin of the curve on the first body, the point on the second.
        #[serde(flatten)]
        placement: Placement,
        /// The curve in the first body's joint frame.
        curve: SpaceCurve,
        /// Estimate of the curve parameter at the start; default 0.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        u: Option<Value>,
    },
    /// The joint z axes of the two bodies stay parallel; the points do not matter (spatial).
    ParallelAxes {
        /// Where; `axis` or `axes` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// The joint z axes of the two bodies stay at right angles; the points do not matter (spatial).
    PerpendicularAxes {
        /// Where; `axes`, or `axis` (of the first body) together with `second_axis` is needed.
        #[serde(flatten)]
        placement: Placement,
        /// Direction of the second body's axis, in ground axes at the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        second_axis: Option<Point>,
    },
    /// A wheel or a disc (second body, its centre at the joint's point, its axle the second axis) that rolls without
    /// slipping on a plane of the first body (through the joint's point, across the first axis) (spatial).
    RollingDisc {
        /// Where; `at` (a point of the plane, the centre) and `axes` (across the plane, the axle), or `axis` (across the
        /// plane) together with `second_axis` (the axle) are needed.
        #[serde(flatten)]
        placement: Placement,
        /// Direction of the axle, in ground axes at the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        second_axis: Option<Point>,
        /// Radius of the wheel [m].
        radius: Value,
        /// Radius of the round profile of the rim, within `radius` [m]; default 0, a thin disc.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rounding: Option<Value>,
    },
    /// A ball (second body, its centre at the joint's point) that rolls without slipping on a plane of the first body
    /// (through the joint's point, across the axis) (spatial).
    RollingBall {
        /// Where; `at` (a point of the plane, the centre), and `axis` or `axes` (the first counts) are needed.
        #[serde(flatten)]
        placement: Placement,
        /// Radius of the ball [m].
        radius: Value,
    },
    /// A skate or a blade: the point of the second body moves on the first, but not sideways, along the joint z axis of
    /// the second body (spatial).
    KnifeEdge {
        /// Where; `axis` or `axes` (the second counts) is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// Surfaces of two bodies that touch in a point and slide on each other (spatial). The contact holds both ways: the
    /// results say where it would have to pull.
    SurfaceContact {
        /// The two bodies; `at` is the origin of each surface's frame, default the origin of the body; its axes are those of
        /// the body, or have their z axis along `axis` or `axes`.
        #[serde(flatten)]
        placement: Placement,
        /// The surface of the first and of the second body.
        surfaces: [Surface; 2],
        /// Estimates [a, b] of the parameters of each surface at the start; default where the surfaces come nearest.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        parameters: Option<[[Value; 2]; 2]>,
    },
    /// The point of the second body stays on a surface of the first (spatial).
    PointOnSurface {
        /// Where: the origin of the surface's frame on the first body, the point on the second.
        #[serde(flatten)]
        placement: Placement,
        /// The surface.
        surface: Surface,
        /// Estimate [a, b] of the surface's parameters at the start; default the nearest point.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        parameters: Option<[Value; 2]>,
    },
    /// Gears on two joints with an angle: the second angle changes by `ratio` times the change of the first; axes in any
    /// directions (spatial).
    GearPair {
        /// The two joints.
        joints: [String; 2],
        /// Turns of the second angle for one turn of the first; negative where they turn against each other.
        ratio: Value,
    },
    /// A pinion on one joint and a rack on another: the displacement of the rack changes by `radius` times the change of
    /// the pinion's angle (spatial).
    RackPair {
        /// The joint of the pinion (with an angle) and the joint of the rack (with a displacement).
        joints: [String; 2],
        /// Pitch radius of the pinion [m]; negative where the displacement falls while the angle grows.
        radius: Value,
    },
}

impl JointKind {
    /// Where the joint sits; gears, gear pairs and rack pairs have no place of their own.
    pub fn placement(&self) -> Option<&Placement> {
        match self {
            Self::Revolute { placement }
            | Self::Prismatic { placement }
            | Self::Weld { placement }
            | Self::Distance { placement, .. }
            | Self::PinSlot { placement }
            | Self::Rack { placement, .. }
            | Self::Cam { placement, .. }
            | Self::RollingOnLine { placement, .. }
            | Self::RollingOnCircle { placement, .. }
            | Self::Spherical { placement }
            | Self::Cylindrical { placement }
            | Self::Universal { placement, .. }
            | Self::ConstantVelocity { placement }
            | Self::Screw { placement, .. }
            | Self::Planar { placement }
            | Self::PointOnLine { placement }
            | Self::PointOnPlane { placement }
            | Self::PointOnCurve { placement, .. }
            | Self::ParallelAxes { placement }
            | Self::PerpendicularAxes { placement, .. }
            | Self::RollingDisc { placement, .. }
            | Self::RollingBall { placement, .. }
            | Self::KnifeEdge { placement }
            | Self::SurfaceContact { placement, .. }
            | Self::PointOnSurface { placement, .. } => Some(placement),
            Self::Gear { .. } | Self::GearPair { .. } | Self::RackPair { .. } => None,
        }
    }
}

/// A joint between two bodies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Joint {
    /// Name, unique in the model.
    pub name: String,
    /// Kind and where it sits.
    #[serde(flatten)]
    pub kind: JointKind,
}
