//! Why a rank decision could not be made.

use thiserror::Error;

/// Why a rank decision or a basis of motions could not be computed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum RankError {
    /// The matrix has an entry that is not a finite number.
    #[error("entry ({row}, {column}) of the matrix is not finite")]
    NotFinite {
        /// Row of the first such entry.
        row: usize,
        /// Its column.
        column: usize,
    },
    /// There must be one scale for each column.
    #[error("{found} column scales for {expected} columns")]
    ScaleCount {
        /// Columns of the matrix.
        expected: usize,
        /// Scales that were given.
        found: usize,
    },
    /// Column scales must be positive and finite.
    #[error("the scale of column {column} is not a positive number")]
    Scale {
        /// The column.
        column: usize,
    },
    /// The singular values could not be found.
    #[error("the singular values did not converge")]
    NoConvergence,
    /// The dependent coordinates of a partition are not determined by its rows at this pose.
    #[error("the dependent coordinates of the partition are not determined by its rows")]
    SingularPartition,
}
