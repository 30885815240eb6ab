//! Linear algebra on our patterns: saddle systems and rank decisions.

mod auxiliary;
mod factored;
mod general;
mod kernel;
mod ldl;
mod order;
mod pattern;
mod products;
pub mod rank;
mod refine;
mod residual;
mod saddle;
mod shape;
mod work;

pub use factored::Factored;
pub use general::{FreeMotion, GeneralSolution, SingularKkt, solve_general};
pub use pattern::Pattern;
pub use rank::{
    Partition, RankError, RedundantRow, RowRank, analyse_rows, continue_basis, independent_rows,
    null_basis_lu, null_basis_qr, null_basis_svd, partition, partition_condition, redundant_rows,
};
pub use residual::{Residual, Rhs};
pub use saddle::{DEPENDENT_PIVOT, Saddle};
pub use shape::{ElementShape, SaddleShape};
