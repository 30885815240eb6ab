//! Rigid bodies.

use super::{Point, Shape, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A coordinate of a planar body frame or point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CoordinateName {
    /// Ground x of the point.
    X,
    /// Ground y of the point.
    Y,
    /// Angle of the body, counter-clockwise, never wrapped.
    Angle,
}

/// A rigid body.
///
/// Mass properties are given (`mass`, `inertia` about the centre of mass, `center`) or summed from
/// the shapes that carry mass. `position`, `angle` and the velocities are estimates of the body
/// frame at the start; the assembly moves them as little as possible.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Name, unique in the model.
    pub name: String,
    /// Mass [kg].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Value>,
    /// Moment of inertia about the centre of mass [kg m^2].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<Value>,
    /// Centre of mass in the body frame [m]; default the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub center: Option<Point>,
    /// Estimate of the origin of the body frame in ground axes [m]; default (0, 0).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<Point>,
    /// Estimate of the angle [rad]; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<Value>,
    /// Estimate of the velocity of the origin in ground axes [m/s]; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub velocity: Option<Point>,
    /// Estimate of the angular velocity [rad/s]; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angular_velocity: Option<Value>,
    /// Coordinates of the frame that the assembly must not move.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub hold: Vec<CoordinateName>,
    /// Is the body a part of the ground, at the given pose?
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub fixed: bool,
    /// Shapes: one, or a list.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub shape: Vec<Shape>,
}

impl CoordinateName {
    /// The name as users write it.
    pub fn label(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Angle => "angle",
        }
    }
}
