//! Scalar quantities of a machine that can be driven, fixed at the start, or pushed by an actuator.

use super::{CoordinateName, Point};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A scalar quantity of a machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Quantity {
    /// A ground coordinate of a point of a body, or the body's angle.
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
    /// The angle of the second body minus the angle of the first.
    RelativeAngle {
        /// First and second body.
        bodies: [String; 2],
    },
    /// The distance of two points.
    Distance {
        /// First and second body.
        bodies: [String; 2],
        /// The points in the bodies' frames.
        at: [Point; 2],
    },
}
