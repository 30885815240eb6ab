//! Vectors of rotation: angular velocities and moments.

use super::Value;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An angular velocity or a moment: one number in the plane, three components in space.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum AxialVector {
    /// Planar: about the axis across the plane, counter-clockwise.
    Planar(Value),
    /// Spatial: the components.
    Spatial([Value; 3]),
}

impl Default for AxialVector {
    fn default() -> Self {
        Self::Planar(Value::default())
    }
}

impl<T: Into<Value>> From<T> for AxialVector {
    fn from(value: T) -> Self {
        Self::Planar(value.into())
    }
}
