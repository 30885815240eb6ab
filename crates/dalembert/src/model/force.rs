//! Force elements.

use super::{AxialVector, Placement, Point, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Axes in which a vector is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Axes {
    /// Ground axes.
    #[default]
    Ground,
    /// The body's own axes: the vector turns with the body.
    Body,
}

/// Kinds of force elements. Every coefficient may be an expression of `t`, parameters and the
/// coordinates and velocities of bodies, joints, traces and force elements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum ForceKind {
    /// A force at a point of one body.
    Force {
        /// Body.
        body: String,
        /// Point in the body frame; default its origin.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        at: Option<Point>,
        /// Components [N]: two (planar) or three (spatial).
        value: Point,
        /// Axes of the components.
        #[serde(default)]
        axes: Axes,
    },
    /// A moment on one body.
    Moment {
        /// Body.
        body: String,
        /// Moment [N m]: a number, counter-clockwise (planar), or its three components (spatial).
        value: AxialVector,
        /// Axes of the components; default "ground" (spatial).
        #[serde(default, skip_serializing_if = "Option::is_none")]
        axes: Option<Axes>,
    },
    /// A motor or piston in a joint: pushes the joint's coordinate, acts on both bodies.
    Actuator {
        /// Joint.
        joint: String,
        /// Moment [N m] or force [N], positive where it increases the coordinate.
        value: Value,
        /// Name of the joint's coordinate; needed where the joint has several.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        coordinate: Option<String>,
    },
    /// Translational spring-damper-actuator between two points; tension positive.
    SpringDamper {
        /// First and second body.
        bodies: [String; 2],
        /// The points in the bodies' frames.
        at: [Point; 2],
        /// Stiffness [N/m].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        stiffness: Option<Value>,
        /// Damping [N s/m].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        damping: Option<Value>,
        /// Length without force [m]; default the length in the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        free_length: Option<Value>,
        /// Actuator force, positive in tension [N].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        force: Option<Value>,
    },
    /// Rotational spring-damper-actuator between two bodies; counts turns.
    TorsionSpring {
        /// First and second body.
        bodies: [String; 2],
        /// The axis about which it turns, in ground axes at the initial estimate; it turns with the first
        /// body; needed in space (spatial).
        #[serde(default, skip_serializing_if = "Option::is_none")]
        axis: Option<Point>,
        /// Stiffness [N m/rad].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        stiffness: Option<Value>,
        /// Damping [N m s/rad].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        damping: Option<Value>,
        /// Relative angle (second minus first) without moment [rad]; default that of the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        free_angle: Option<Value>,
        /// Actuator moment, positive where it reduces the relative angle [N m].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        moment: Option<Value>,
    },
    /// A spring-damper on the coordinate of a joint.
    JointSpring {
        /// Joint.
        joint: String,
        /// Stiffness [N/m] or [N m/rad].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        stiffness: Option<Value>,
        /// Damping [N s/m] or [N m s/rad].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        damping: Option<Value>,
        /// Coordinate without force; default 0.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        free: Option<Value>,
        /// Name of the joint's coordinate; needed where the joint has several.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        coordinate: Option<String>,
    },
    /// A bushing: stiffness and damping on the relative pose in the first body's joint frame: on x, y and angle
    /// (planar), or on x, y, z and the turns about them (spatial).
    Bushing {
        /// Where.
        #[serde(flatten)]
        placement: Placement,
        /// Stiffness: 3 numbers (diagonal) or 3 rows of 3 (planar); 6 numbers or 6 rows of 6 (spatial).
        stiffness: Matrix,
        /// Damping: 3 numbers (diagonal) or 3 rows of 3 (planar); 6 numbers or 6 rows of 6 (spatial); default none.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        damping: Option<Matrix>,
    },
    /// Attraction of a body's centre of mass by a fixed point: m mu / r^2.
    PointGravity {
        /// Body.
        body: String,
        /// Gravitational parameter [m^3/s^2].
        mu: Value,
        /// Attracting point in ground axes; default the origin.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        center: Option<Point>,
    },
}

/// A matrix as a user writes it: its diagonal, or its rows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Matrix {
    /// The diagonal.
    Diagonal(Vec<Value>),
    /// The rows.
    Rows(Vec<Vec<Value>>),
}

/// A force element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Force {
    /// Name, unique in the model.
    pub name: String,
    /// Kind.
    #[serde(flatten)]
    pub kind: ForceKind,
}
