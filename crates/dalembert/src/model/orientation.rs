//! How a spatial body, shape or trace is turned.

use super::Value;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Axes about which Euler angles turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum EulerAxes {
    /// Each turn is about an axis of the turning frame as the turns before it have left it.
    #[default]
    Body,
    /// Each turn is about an axis that stays where it is: one of those from which the frame is turned.
    Space,
}

/// An orientation in space: how a frame is turned from the axes in which it is given (spatial).
///
/// These are the ground axes for a body, and the axes of the body for a shape, a trace or a tensor
/// of inertia. It is written in one of seven ways.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum Orientation {
    /// Three Euler angles.
    Euler {
        /// The axes of the three turns in their order, like "zxz" or "xyz"; neighbours differ.
        euler: String,
        /// The angles of the three turns [rad].
        angles: [Value; 3],
        /// Are the turns about axes of the turning frame ("body") or about axes that stay ("space")? Default "body".
        #[serde(default, skip_serializing_if = "Option::is_none")]
        axes: Option<EulerAxes>,
    },
    /// One turn about an axis.
    AxisAngle {
        /// Direction of the axis, of any length.
        axis: [Value; 3],
        /// Angle of the turn [rad], by the rule of the right hand.
        angle: Value,
    },
    /// Four Euler parameters (a unit quaternion).
    EulerParameters {
        /// The parameters: the cosine of half the angle, then the axis times the sine of half the angle.
        euler_parameters: [Value; 4],
    },
    /// Three Rodriguez parameters.
    Rodriguez {
        /// The parameters: the axis times the tangent of half the angle.
        rodriguez: [Value; 3],
    },
    /// The matrix of direction cosines.
    Matrix {
        /// Rows of the matrix A, whose columns are the turned axes.
        matrix: [[Value; 3]; 3],
    },
    /// The frame of three points.
    Points {
        /// The origin, a point on the x axis, and a point on the side of +y.
        points: [[Value; 3]; 3],
    },
    /// Directions of at least two of the turned axes.
    Axes {
        /// Direction of the x axis, of any length.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        x: Option<[Value; 3]>,
        /// Direction of the y axis, of any length.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        y: Option<[Value; 3]>,
        /// Direction of the z axis, of any length.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        z: Option<[Value; 3]>,
    },
}
