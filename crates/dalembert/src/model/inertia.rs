//! Inertia of a body about its centre of mass.

use super::Value;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Inertia as a user writes it [kg m^2]: one number in the plane, three or nine in space.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Inertia {
    /// Planar: the moment of inertia about the axis across the plane.
    Moment(Value),
    /// Spatial: the moments Ixx, Iyy, Izz; the products are zero.
    Moments([Value; 3]),
    /// Spatial: the rows of the tensor itself; entries off the diagonal carry their minus sign.
    Tensor([[Value; 3]; 3]),
}

impl<T: Into<Value>> From<T> for Inertia {
    fn from(moment: T) -> Self {
        Self::Moment(moment.into())
    }
}
