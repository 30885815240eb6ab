//! What is known of the dimension of an expression.

use crate::Dim;
use std::fmt;

/// What is known of the dimension of an expression.
///
/// A number without a unit is in SI and takes the dimension that its place asks for. Products and
/// quotients with such a number stay free: in `150 * t` the 150 may well be rad/s. Only a constant
/// that is divided by such a number, `length / 2`, has a likely dimension: its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Takes any dimension, in SI.
    #[default]
    Free,
    /// Takes any dimension, but has this one if the numbers that divide in it are plain.
    Likely(Dim),
    /// Has this dimension.
    Known(Dim),
}

/// Two dimensions that do not agree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Clash {
    /// Both are sure.
    Sure(Dim, Dim),
    /// One of them, or both, would be another one if a bare number had a unit.
    Doubtful(Dim, Dim),
}

impl Quantity {
    /// The common quantity of terms of a sum, and the two dimensions that do not agree.
    ///
    /// After a doubtful clash the sure quantity stands.
    pub(crate) fn join(self, other: Self) -> (Self, Option<Clash>) {
        use Quantity::{Free, Known, Likely};
        match (self, other) {
            (Known(a), Known(b)) if a != b => (Free, Some(Clash::Sure(a, b))),
            (Known(a), Likely(b)) if a != b => (self, Some(Clash::Doubtful(a, b))),
            (Likely(a), Known(b)) if a != b => (other, Some(Clash::Doubtful(a, b))),
            (Likely(a), Likely(b)) if a != b => (Free, Some(Clash::Doubtful(a, b))),
            (Known(_), _) | (_, Free) => (self, None),
            _ => (other, None),
        }
    }

    /// The dimension, where it is known for sure.
    pub fn known(self) -> Option<Dim> {
        match self {
            Self::Free | Self::Likely(_) => None,
            Self::Known(dim) => Some(dim),
        }
    }

    /// The dimension, where it is known or likely.
    pub fn likely(self) -> Option<Dim> {
        match self {
            Self::Free => None,
            Self::Likely(dim) | Self::Known(dim) => Some(dim),
        }
    }

    /// The quantity of a function of both: likely where one of them is only that, free where one
    /// of them is.
    pub(crate) fn combine(self, other: Self, of: impl FnOnce(Dim, Dim) -> Dim) -> Self {
        match (self, other) {
            (Self::Known(a), Self::Known(b)) => Self::Known(of(a, b)),
            (Self::Free, _) | (_, Self::Free) => Self::Free,
            (Self::Known(a) | Self::Likely(a), Self::Known(b) | Self::Likely(b)) => {
                Self::Likely(of(a, b))
            }
        }
    }

    /// The quantity in words, for messages.
    pub fn describe(self) -> String {
        match self {
            Self::Free => "any quantity in SI".to_owned(),
            Self::Likely(dim) | Self::Known(dim) => dim.describe(),
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
            Self::Likely(dim) | Self::Known(dim) => dim.fmt(f),
        }
    }
}
