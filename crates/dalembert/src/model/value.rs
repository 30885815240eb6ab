//! A number as a user writes it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A number in SI units, or a text: a number with a unit ("30 deg") or an expression.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// A number in SI units (angles in radians).
    Number(f64),
    /// A number with a unit, or an expression of parameters, `t` and quantities of elements.
    Text(String),
}

/// The components of a point or a vector: 2 in planar models, 3 in spatial ones.
pub type Point = Vec<Value>;

impl Default for Value {
    fn default() -> Self {
        Self::Number(0.0)
    }
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for Value {
    fn from(value: &str) -> Self {
        Self::Text(value.to_owned())
    }
}

impl From<String> for Value {
    fn from(value: String) -> Self {
        Self::Text(value)
    }
}
