//! What the names of an expression mean.

use crate::Quantity;
use std::fmt::Debug;
use std::sync::Arc;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resolved {
    /// A value that is known now, in SI.
    Constant {
        /// Value.
        value: f64,
        /// Dimension.
        dim: Quantity,
    },
    /// A value that the caller gives at every evaluation.
    Slot {
        /// The caller's own number for it.
        index: usize,
        /// Dimension.
        dim: Quantity,
    },
}

/// A name that a scope does not know.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct UnknownName {
    /// Names that may have been meant, the likeliest first.
    pub suggestions: Vec<String>,
    /// Anything else that helps, one sentence.
    pub note: Option<String>,
}

/// A smooth function of one variable, such as a table.
pub trait Function: Send + Sync + Debug {
    /// Value, first, second and third derivative at `x`.
    fn jet(&self, x: f64) -> [f64; 4];

    /// Dimensions of the argument and of the value.
    fn dims(&self) -> (Quantity, Quantity);
}

/// Gives names their meaning.
pub trait Scope {
    /// The meaning of a name: `["t"]`, `["crank", "angle"]`.
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName>;

    /// The function (a table) of this name.
    fn function(&self, name: &str) -> Option<Arc<dyn Function>>;
}

/// A scope without any name: for plain numbers with units.
#[derive(Clone, Copy, Debug, Default)]
pub struct EmptyScope;

impl Scope for EmptyScope {
    fn variable(&self, _path: &[&str]) -> Result<Resolved, UnknownName> {
        Err(UnknownName::default())
    }

    fn function(&self, _name: &str) -> Option<Arc<dyn Function>> {
        None
    }
}
