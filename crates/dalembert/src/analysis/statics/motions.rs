//! The motions that the constraints leave free, and the multipliers that belong to a load.

use super::problem::Problem;
use crate::analysis::AnalysisError;
use crate::solve::rank::Svd;
use crate::space::Space;
use faer::Mat;
use nalgebra::{DMatrix, DVector};

/// Singular values below this part of the largest count as zero. Poses are assembled to 1e-13, so a
/// dependent row leaves about that much; a mechanism 1e-9 away from a dead centre is in it.
const RANK_TOLERANCE: f64 = 1e-9;

/// Free motions of a pose: orthonormal in scaled coordinates (Shabana 6.8, 6.9).
#[derive(Debug)]
pub(super) struct Motions {
    /// The basis B, one motion a column.
    pub basis: DMatrix<f64>,
    row_space: RowSpace,
}

/// What solves C_q^T lambda = Q_e.
#[derive(Debug)]
enum RowSpace {
    /// Independent rows: C_q^T = Q R, with the inverse of R.
    Regular {
        q: DMatrix<f64>,
        inverse: DMatrix<f64>,
    },
    /// Singular values above zero and their vectors.
    Singular {
        left: DMatrix<f64>,
        values: DVector<f64>,
        right: DMatrix<f64>,
    },
}

impl Motions {
    /// At the evaluated pose of a problem.
    pub fn new<S: Space>(problem: &Problem<'_, S>) -> Result<Self, AnalysisError> {
        Self::of(problem, &problem.jacobian())
    }

    /// Of a scaled Jacobian.
    pub fn of<S: Space>(
        problem: &Problem<'_, S>,
        jacobian: &DMatrix<f64>,
    ) -> Result<Self, AnalysisError> {
        Self::within(problem, jacobian, RANK_TOLERANCE)
    }

    /// Where singular values below a part of the largest count as zero.
    pub fn within<S: Space>(
        problem: &Problem<'_, S>,
        jacobian: &DMatrix<f64>,
        tolerance: f64,
    ) -> Result<Self, AnalysisError> {
        if let Some(regular) = Self::regular(jacobian, tolerance) {
            return Ok(regular);
        }
        let svd = Svd::new(jacobian).map_err(|e| problem.rank_error(e))?;
        let rank = svd.rank(tolerance);
        let n = jacobian.ncols();
        Ok(Self {
            basis: svd.v.columns(rank, n - rank).into_owned(),
            row_space: RowSpace::Singular {
                left: svd.u.columns(0, rank).into_owned(),
                right: svd.v.columns(0, rank).into_owned(),
                values: DVector::from_column_slice(&svd.values[..rank]),
            },
        })
    }

    /// By Householder's method, several times faster than singular values, where the rows are
    /// independent beyond doubt: the smallest singular value is not below 1 / |R^-1|.
    fn regular(jacobian: &DMatrix<f64>, tolerance: f64) -> Option<Self> {
        let (m, n) = jacobian.shape();
        if m == 0 || m > n || jacobian.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let qr = Mat::from_fn(n, m, |i, j| jacobian[(j, i)]).qr();
        let r = qr.thin_R();
        let r = DMatrix::from_fn(m, m, |i, j| if i <= j { r[(i, j)] } else { 0.0 });
        let inverse = r.solve_upper_triangular(&DMatrix::identity(m, m))?;
        let smallest = 1.0 / inverse.norm();
        // A comparison that is false for NaN.
        let independent = smallest > 10.0 * tolerance * r.norm();
        if !independent {
            return None;
        }
        let q = qr.compute_Q();
        Some(Self {
            basis: DMatrix::from_fn(n, n - m, |i, j| q[(i, m + j)]),
            row_space: RowSpace::Regular {
                q: DMatrix::from_fn(n, m, |i, j| q[(i, j)]),
                inverse,
            },
        })
    }

    /// The least multipliers, in scaled units, that carry what they can of a scaled force:
    /// C_q^T lambda = Q_e by least squares.
    pub fn multipliers(&self, force: &DVector<f64>) -> DVector<f64> {
        match &self.row_space {
            RowSpace::Regular { q, inverse } => inverse * q.tr_mul(force),
            RowSpace::Singular {
                left,
                values,
                right,
            } => left * right.tr_mul(force).component_div(values),
        }
    }
}
