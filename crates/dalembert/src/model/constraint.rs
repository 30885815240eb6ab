//! Constraints that are not joints.

use super::{Quantity, Value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One term of a coupler: factor times a quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Term {
    /// Factor; in SI units.
    pub factor: Value,
    /// Quantity.
    #[serde(flatten)]
    pub quantity: Quantity,
}

/// Kinds of constraints.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum ConstraintKind {
    /// A quantity keeps a constant value; default its value in the initial estimate.
    Fixed {
        /// What is fixed.
        quantity: Quantity,
        /// At which value.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        value: Option<Value>,
    },
    /// A weighted sum of quantities stays constant: gears, racks, ropes and pulleys.
    Coupler {
        /// The terms.
        terms: Vec<Term>,
        /// Value of the sum; default its value in the initial estimate.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        value: Option<Value>,
    },
    /// An expression of `t`, parameters, positions and velocities of elements, linear in the velocities, stays zero: it
    /// holds velocities only (nonholonomic).
    Velocity {
        /// The expression.
        expression: Value,
    },
    /// An expression of `t`, parameters and positions of elements stays zero.
    Expression {
        /// The expression.
        expression: Value,
    },
}

/// A constraint that is not a joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Constraint {
    /// Name, unique in the model.
    pub name: String,
    /// Kind.
    #[serde(flatten)]
    pub kind: ConstraintKind,
}
