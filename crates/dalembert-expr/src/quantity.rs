//! What is known of the dimension of an expression.

use crate::Dim;
use std::fmt;

/// What is known of the dimension of an expression.
///
/// A number without a unit is in SI and takes the dimension that its place asks for. Products and
/// quotients with such a number stay free: in `150 * t` the 150 may well be rad/s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Takes any dimension, in SI.
    #[default]
    Free,
    /// Has this dimension.
    Known(Dim),
}

impl Quantity {
    /// The common quantity of terms of a sum, or the two dimensions that do not agree.
    pub(crate) fn join(self, other: Self) -> Result<Self, (Dim, Dim)> {
        match (self, other) {
            (Self::Known(a), Self::Known(b)) if a != b => Err((a, b)),
            (Self::Free, known) | (known, _) => Ok(known),
        }
    }

    /// The dimension, where it is known.
    pub fn known(self) -> Option<Dim> {
        match self {
            Self::Free => None,
            Self::Known(dim) => Some(dim),
        }
    }

    /// The quantity in words, for messages.
    pub fn describe(self) -> String {
        match self {
            Self::Free => "any quantity in SI".to_owned(),
            Self::Known(dim) => dim.describe(),
        }
    }
}

impl From<Dim> for Quantity {
    fn from(dim: Dim) -> Self {
        Self::Known(dim)
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Free => f.pad("SI"),
            Self::Known(dim) => dim.fmt(f),
        }
    }
}
