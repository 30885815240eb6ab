//! The motions that the constraints leave free, and the multipliers that belong to a load.

use super::problem::Problem;
use crate::analysis::AnalysisError;
use crate::solve::rank::Svd;
use nalgebra::{DMatrix, DVector};

/// Singular values below this part of the largest count as zero. Poses are assembled to 1e-13, so a
/// dependent row leaves about that much; a mechanism 1e-9 away from a dead centre is in it.
const RANK_TOLERANCE: f64 = 1e-9;

/// Free motions of a pose: orthonormal in scaled coordinates (Shabana 6.9).
#[derive(Debug)]
pub(super) struct Motions {
    /// The basis B, one motion a column.
    pub basis: DMatrix<f64>,
    /// Number of independent rows.
    pub rank: usize,
    left: DMatrix<f64>,
    values: Vec<f64>,
    right: DMatrix<f64>,
}

impl Motions {
    /// At the evaluated pose of a problem.
    pub fn new(problem: &Problem<'_>) -> Result<Self, AnalysisError> {
        Self::of(problem, &problem.jacobian())
    }

    /// Of a scaled Jacobian.
    pub fn of(problem: &Problem<'_>, jacobian: &DMatrix<f64>) -> Result<Self, AnalysisError> {
        let svd = Svd::new(jacobian).map_err(|e| problem.rank_error(e))?;
        let rank = svd.rank(RANK_TOLERANCE);
        let n = jacobian.ncols();
        Ok(Self {
            basis: svd.v.columns(rank, n - rank).into_owned(),
            rank,
            left: svd.u,
            right: svd.v.columns(0, rank).into_owned(),
            values: svd.values,
        })
    }

    /// The least multipliers, in scaled units, that carry what they can of a scaled force:
    /// C_q^T lambda = Q_e by least squares.
    pub fn multipliers(&self, force: &DVector<f64>) -> DVector<f64> {
        let mut part = self.right.transpose() * force;
        for (x, s) in part.iter_mut().zip(&self.values) {
            *x /= s;
        }
        self.left.columns(0, self.rank) * part
    }
}
