//! What can be wrong with the points of a table.

/// Why points do not make a table.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SplineError {
    /// Not as many values as arguments.
    #[error("x has length {x}, but y has length {y}: every point needs both")]
    Lengths {
        /// Number of arguments.
        x: usize,
        /// Number of values.
        y: usize,
    },
    /// Not enough points.
    #[error("there are too few points ({given}): this interpolation needs {least}")]
    TooFew {
        /// Number of points.
        given: usize,
        /// Least number of points.
        least: usize,
    },
    /// A number that is not finite.
    #[error("point {point} is not finite")]
    NotFinite {
        /// Number of the point, from 1.
        point: usize,
    },
    /// Arguments that do not increase.
    #[error("the arguments must increase, but that of point {point} does not")]
    NotIncreasing {
        /// Number of the point, from 1.
        point: usize,
    },
    /// A periodic table that does not close.
    #[error("a periodic table must end with its first value {first}, not with {last}")]
    NotPeriodic {
        /// First value.
        first: f64,
        /// Last value.
        last: f64,
    },
    /// Points so unevenly spaced, or so large, that no finite curve comes out.
    #[error("no smooth curve with finite coefficients goes through these points")]
    Unsolvable,
}
