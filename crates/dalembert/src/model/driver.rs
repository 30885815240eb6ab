//! Drivers: quantities that follow given functions of time.

use super::{Point, Quantity, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A motion over time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Motion {
    /// The value itself as an expression of `t`.
    Value {
        /// f(t).
        value: Value,
    },
    /// The rate as an expression of `t`, integrated from the start of the run.
    Rate {
        /// df/dt.
        rate: Value,
        /// Value at the start of the run; default the quantity's value in the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        start: Option<Value>,
    },
}

/// What a driver prescribes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum DriverKind {
    /// One scalar quantity.
    Scalar {
        /// What is driven: kind "coordinate", "angle", "displacement", "joint-coordinate", "relative-angle" or "distance".
        #[serde(flatten)]
        quantity: Quantity,
        /// How it moves.
        #[serde(flatten)]
        motion: Motion,
    },
    /// The path of a point (kind "path"), in ground axes; relative to a point of another body where one is named.
    Path {
        /// The word "path".
        kind: PathTag,
        /// Body.
        body: String,
        /// Point in the body frame; default its origin.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        at: Option<Point>,
        /// Body from whose point the path is measured; default the ground.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        from: Option<String>,
        /// Point in that body's frame; default its origin.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        from_at: Option<Point>,
        /// x(t); free where left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        x: Option<Value>,
        /// y(t); free where left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        y: Option<Value>,
        /// z(t); free where left out (spatial).
        #[serde(default, skip_serializing_if = "Option::is_none")]
        z: Option<Value>,
    },
}

/// The word "path".
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PathTag {
    /// "path".
    Path,
}

/// A driver: prescribes a motion with whatever force that takes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Driver {
    /// Name, unique in the model.
    pub name: String,
    /// What it prescribes.
    #[serde(flatten)]
    pub kind: DriverKind,
}
