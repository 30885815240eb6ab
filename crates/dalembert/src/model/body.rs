//! Rigid bodies.

use super::{Axes, AxialVector, Inertia, Orientation, Point, Shape, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A coordinate of a body frame that the assembly must not move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum HeldCoordinate {
    /// Ground x of the origin.
    X,
    /// Ground y of the origin.
    Y,
    /// Ground z of the origin (spatial).
    Z,
    /// Angle of the body (planar).
    Angle,
    /// The whole orientation of the body (spatial).
    Orientation,
}

/// A rigid body.
///
/// Mass properties are given (`mass`, `inertia` about the centre of mass, `center`) or summed from
/// the shapes that carry mass. `position`, `angle` (planar) or `orientation` (spatial) and the
/// velocities are estimates of the body frame at the start; the assembly moves them as little as possible.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Name, unique in the model.
    pub name: String,
    /// Mass [kg].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Value>,
    /// Moment of inertia about the centre of mass [kg m^2] (planar); the moments [Ixx, Iyy, Izz], or three
    /// rows of the tensor itself with the minus signs off its diagonal (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<Inertia>,
    /// Point of the body frame about which `inertia` is given [m]; default the centre of mass (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia_at: Option<Point>,
    /// Axes of `inertia`, seen from the body frame; default the axes of the body frame (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia_orientation: Option<Orientation>,
    /// Centre of mass in the body frame [m]; default the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub center: Option<Point>,
    /// Estimate of the origin of the body frame in ground axes [m]; default the origin of the ground.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<Point>,
    /// Estimate of the angle [rad], counter-clockwise; default 0 (planar).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<Value>,
    /// Estimate of the orientation of the body frame, from ground axes; default not turned (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<Orientation>,
    /// Estimate of the velocity of the origin in ground axes [m/s]; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub velocity: Option<Point>,
    /// Estimate of the angular velocity [rad/s]: a number (planar), or its three components (spatial);
    /// default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angular_velocity: Option<AxialVector>,
    /// Axes of the components of `angular_velocity`; default "ground" (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angular_velocity_axes: Option<Axes>,
    /// Coordinates of the frame that the assembly must not move: "x", "y", "angle" (planar), "x", "y", "z",
    /// "orientation" (spatial).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub hold: Vec<HeldCoordinate>,
    /// Is the body a part of the ground, at the given pose?
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub fixed: bool,
    /// Shapes: one, or a list.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub shape: Vec<Shape>,
}

impl HeldCoordinate {
    /// The name as users write it.
    pub fn label(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::Angle => "angle",
            Self::Orientation => "orientation",
        }
    }
}
