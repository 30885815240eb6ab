//! Joints between two bodies.

use super::{Point, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where a joint sits on its two bodies.
///
/// Points: `at` (one in each body's frame), or `point` (one in ground axes at the initial
/// estimate). Directions: `angles` (of the joint's x axis in each body's frame), or `direction`
/// (of the joint's x axis in ground axes at the initial estimate).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Placement {
    /// First and second body; "ground" is the fixed one.
    pub bodies: [String; 2],
    /// The joint's point in each body's frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<[Point; 2]>,
    /// The joint's point in ground axes at the initial estimate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<Point>,
    /// Angle of the joint's x axis in each body's frame [rad].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angles: Option<[Value; 2]>,
    /// Direction of the joint's x axis in ground axes at the initial estimate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction: Option<Point>,
}

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

/// Kinds of planar joints.
///
/// The reaction of a joint is what it exerts on its second body, at the joint's point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum JointKind {
    /// A pin: the two points coincide. Coordinate: angle.
    Revolute {
        /// Where.
        #[serde(flatten)]
        placement: Placement,
    },
    /// A slide along the joint's x axis of the first body. Coordinate: displacement.
    /// One of `angles` and `direction` is needed.
    Prismatic {
        /// Where; `angles` or `direction` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// No relative motion; without `angles` the relative angle of the initial estimate is kept.
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
    /// A pin of the second body in a slot of the first, along the first's joint x axis.
    /// One of `angles` and `direction` is needed.
    PinSlot {
        /// Where; `angles` or `direction` is needed.
        #[serde(flatten)]
        placement: Placement,
    },
    /// A pair of spur gears; their relative angles to the carrier stay in the ratio of the radii.
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
    /// A pinion (first body, its centre at the joint's point) on a rack (second body, along its joint x axis).
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
    /// A cam (first body) and its follower (second body), held in contact.
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
    /// A circle of the second body (centre at its point) rolls without slip on a line of the first body (its joint x axis).
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
    /// A circle of the second body rolls without slip on a circle of the first.
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
