//! Points whose motion is wanted.

use super::{Orientation, Point, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A point of a body whose motion is written and drawn; its name can be used in expressions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Trace {
    /// Name, unique in the model.
    pub name: String,
    /// Body.
    pub body: String,
    /// Point in the body frame; default its origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<Point>,
    /// Angle of the trace's axes in the body frame [rad]; default 0 (planar).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<Value>,
    /// Orientation of the trace's axes, seen from the body frame; default not turned (spatial).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<Orientation>,
    /// Body from which the motion is also observed; the relative and Coriolis parts are then written too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub relative_to: Option<String>,
}
