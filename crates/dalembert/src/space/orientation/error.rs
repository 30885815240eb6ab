//! What can be wrong with an orientation that someone gives.

use thiserror::Error;

/// An orientation that is not one.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum OrientationError {
    /// A number is not finite.
    #[error("an orientation has a number that is not finite")]
    NotFinite,
    /// Four Euler parameters whose norm is not one.
    #[error("the Euler parameters have the norm {norm:.6}, it must be 1")]
    NotUnit {
        /// Their norm.
        norm: f64,
    },
    /// A vector that should give a direction has no length.
    #[error("{what} has zero length")]
    ZeroVector {
        /// Which.
        what: &'static str,
    },
    /// Axes that are not at right angles.
    #[error(
        "the axes {first} and {second} are not at right angles: they are off by {degrees:.4} degrees"
    )]
    NotOrthogonal {
        /// Letter of one axis.
        first: char,
        /// Letter of the other.
        second: char,
        /// Deviation from 90 degrees.
        degrees: f64,
    },
    /// Columns of a direction cosine matrix that are not unit vectors.
    #[error("column {letter} of the direction cosines has the length {length:.6}, it must be 1")]
    NotNormal {
        /// Letter of the axis.
        letter: char,
        /// Its length.
        length: f64,
    },
    /// Axes that form a left-handed frame.
    #[error("the axes are left-handed: z must be x cross y")]
    LeftHanded,
    /// Three points on a line.
    #[error("the three points lie on a line")]
    Collinear,
    /// A name of a sequence that is none.
    #[error("'{name}' is not a sequence of Euler angles")]
    UnknownSequence {
        /// What was given.
        name: String,
    },
}
