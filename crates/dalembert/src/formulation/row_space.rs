//! The independent rows of a Jacobian and least-squares solutions by them.

use super::FormulationError;
use crate::solve::analyse_rows;
use nalgebra::{DMatrix, DVector};

/// Singular values below this part of the largest one count as zero. Positions are known to some 1e-10 of the
/// machine's size at worst, which turns dependent gradients by as much.
pub(super) const RANK_TOLERANCE: f64 = 1e-9;

/// Independent rows of C_q, scaled, as Q R of their transpose.
#[derive(Clone, Debug)]
pub struct RowSpace {
    /// The independent rows, ascending.
    pub independent: Vec<usize>,
    /// Is the multiplier of each row uniquely determined?
    pub unique: Vec<bool>,
    column_scale: Vec<f64>,
    /// Norm of every row after column scaling; one for a zero row.
    row_norm: DVector<f64>,
    /// Orthonormal basis of the row combinations that vanish, scaled rows.
    left_null: DMatrix<f64>,
    q: DMatrix<f64>,
    r: DMatrix<f64>,
}

impl RowSpace {
    /// Finds the independent rows.
    ///
    /// # Errors
    /// An entry is not finite.
    pub fn new(c: &DMatrix<f64>, column_scale: &[f64]) -> Result<Self, FormulationError> {
        let rank = analyse_rows(c, column_scale, RANK_TOLERANCE)?;
        let mut scaled = c.clone();
        for (mut column, scale) in scaled.column_iter_mut().zip(column_scale) {
            column *= *scale;
        }
        let row_norm = DVector::from_iterator(
            c.nrows(),
            scaled
                .row_iter()
                .map(|r| r.norm())
                .map(|n| if n > 0.0 { n } else { 1.0 }),
        );
        for (mut row, norm) in scaled.row_iter_mut().zip(row_norm.iter()) {
            row /= *norm;
        }
        let mut left = rank.left_null_space;
        for (mut row, norm) in left.row_iter_mut().zip(row_norm.iter()) {
            row *= *norm;
        }
        let (q, r) = orthonormal(&scaled.select_rows(&rank.independent).transpose());
        Ok(Self {
            independent: rank.independent,
            unique: rank.unique,
            column_scale: column_scale.to_vec(),
            row_norm,
            left_null: orthonormal(&left).0,
            q,
            r,
        })
    }

    /// The shortest x (in scaled coordinates) with C_q x = rhs on the independent rows.
    pub fn particular(&self, rhs: &DVector<f64>) -> DVector<f64> {
        let scaled = DVector::from_iterator(
            self.independent.len(),
            self.independent.iter().map(|&i| rhs[i] / self.row_norm[i]),
        );
        // R is regular: its rows were chosen as independent.
        let y = self
            .r
            .transpose()
            .solve_lower_triangular(&scaled)
            .unwrap_or(scaled);
        self.scaled(&(&self.q * y))
    }

    /// lambda with C_q^T lambda = rhs by least squares, of least norm where rows are redundant.
    pub fn multipliers(&self, rhs: &DVector<f64>) -> DVector<f64> {
        let y = self.q.transpose() * self.scaled(rhs);
        let y = self.r.solve_upper_triangular(&y).unwrap_or(y);
        let mut all = DVector::zeros(self.row_norm.len());
        for (k, &row) in self.independent.iter().enumerate() {
            all[row] = y[k];
        }
        self.least(all)
    }

    /// Multipliers of the independent rows (user's units), spread to least norm over all rows.
    pub fn spread(&self, lambda: &DVector<f64>) -> DVector<f64> {
        let mut all = DVector::zeros(self.row_norm.len());
        for (k, &row) in self.independent.iter().enumerate() {
            all[row] = lambda[k] * self.row_norm[row];
        }
        self.least(all)
    }

    fn least(&self, mut scaled: DVector<f64>) -> DVector<f64> {
        scaled -= &self.left_null * (self.left_null.transpose() * &scaled);
        scaled.component_div(&self.row_norm)
    }

    fn scaled(&self, x: &DVector<f64>) -> DVector<f64> {
        DVector::from_iterator(
            x.len(),
            x.iter().zip(&self.column_scale).map(|(x, s)| x * s),
        )
    }
}

/// Thin Q R; an empty matrix has an empty Q.
fn orthonormal(a: &DMatrix<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
    if a.ncols() == 0 || a.nrows() == 0 {
        return (a.clone(), DMatrix::zeros(a.ncols(), a.ncols()));
    }
    a.clone().qr().unpack()
}
