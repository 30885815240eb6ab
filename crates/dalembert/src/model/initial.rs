//! Initial conditions that hold exactly.

use super::{Quantity, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A value, a rate, or both, that a quantity has exactly at the start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Initial {
    /// What.
    #[serde(flatten)]
    pub quantity: Quantity,
    /// Value at the start.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<Value>,
    /// Rate at the start.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rate: Option<Value>,
}
