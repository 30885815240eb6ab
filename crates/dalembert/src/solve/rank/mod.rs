//! Rank decisions: redundant rows, dependent coordinates and free motions.
//!
//! Dense matrices (up to some 800 coordinates) go through [`analyse_rows`]; larger systems take the rank from the
//! pivots of the sparse factorization by [`redundant_rows`].

mod error;
mod null_basis;
mod partition;
mod row_rank;
mod scaled;
mod selection;

pub use error::RankError;
pub use null_basis::{continue_basis, null_basis_lu, null_basis_qr, null_basis_svd};
pub use partition::{Partition, partition, partition_condition};
pub use row_rank::{RedundantRow, RowRank, analyse_rows, independent_rows};

pub(crate) use scaled::Svd;
pub(super) use scaled::{from_faer, to_faer};

use super::factored::Factored;

/// The redundant rows of a large system, from the pivots of its sparse factorization, ascending.
///
/// A row is redundant if the square of the sine of the angle between its gradient and the rows eliminated before it
/// is below the tolerance of the factorization (1e-11: an angle of 3e-6). Rounding leaves a dependent row about
/// `n * 1e-16`, so the two are apart by orders; but an angle below 1e-7 can not be told from zero this way, while
/// singular values resolve 1e-14. Which row of a dependent group is named depends on the order of elimination.
pub fn redundant_rows(factored: &Factored<'_>) -> Vec<usize> {
    let mut rows = [factored.vanished, factored.zero].concat();
    rows.sort_unstable();
    rows
}
