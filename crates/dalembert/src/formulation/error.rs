//! Why a formulation gave no accelerations.

use crate::solve::RankError;
use thiserror::Error;

/// Why a formulation gave no accelerations.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FormulationError {
    /// A rank decision failed.
    #[error(transparent)]
    Rank(#[from] RankError),
    /// Some motions have neither mass nor constraint.
    #[error("motions of {} have neither mass nor constraint", crate::words::counted(coordinates.len(), "coordinate"))]
    Massless {
        /// The coordinates that take part in these motions, ascending.
        coordinates: Vec<usize>,
    },
    /// Singular values and pivots disagree on the rank: the pose is too near to a singular one.
    #[error(
        "the rank of the constraints is doubtful at this pose: {rank} by singular values, {pivots} by pivots"
    )]
    DoubtfulRank {
        /// Rank by singular values.
        rank: usize,
        /// Rank by pivots.
        pivots: usize,
    },
    /// The equations are singular to working precision.
    #[error("the equations of motion are singular to working precision")]
    Singular,
    /// A value is not finite.
    #[error("the equations have a value that is not finite")]
    NotFinite,
}
