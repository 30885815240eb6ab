//! Scalar quantities of a machine that can be driven, fixed at the start, or pushed by an actuator.

use super::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A coordinate of a point of a body, or the angle of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CoordinateName {
    /// Ground x of the point.
    X,
    /// Ground y of the point.
    Y,
    /// Ground z of the point (spatial).
    Z,
    /// Angle of the body, counter-clockwise, never wrapped (planar).
    Angle,
}

/// A scalar quantity of a machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Quantity {
    /// A ground coordinate of a point of a body, or the body's angle (planar).
    Coordinate {
        /// Body.
        body: String,
        /// Point in the body frame; default its origin.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        at: Option<Point>,
        /// Which.
        coordinate: CoordinateName,
    },
    /// The angle of a joint: of its second body seen from the first, counting turns.
    Angle {
        /// Joint.
        joint: String,
    },
    /// The displacement of a joint along its axis.
    Displacement {
        /// Joint.
        joint: String,
    },
    /// One of the coordinates of a joint that has several of a kind, like the two angles of a universal joint.
    JointCoordinate {
        /// Joint.
        joint: String,
        /// Name of the coordinate, like "angle_1".
        coordinate: String,
    },
    /// The angle of the second body minus the angle of the first; in space about an axis of the first body.
    RelativeAngle {
        /// First and second body.
        bodies: [String; 2],
        /// The axis about which the angle is measured, in ground axes at the initial estimate; it turns
        /// with the first body; needed in space (spatial).
        #[serde(default, skip_serializing_if = "Option::is_none")]
        axis: Option<Point>,
    },
    /// The distance of two points.
    Distance {
        /// First and second body.
        bodies: [String; 2],
        /// The points in the bodies' frames.
        at: [Point; 2],
    },
}
