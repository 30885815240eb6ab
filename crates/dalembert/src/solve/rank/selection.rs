//! Choice of independent rows in the given order, and the others in terms of them.

use nalgebra::{DMatrix, DVector};

/// Rows chosen as independent, with what is needed to express others by them.
pub(super) struct Selection {
    /// The rows that are kept, in the order of choice.
    pub kept: Vec<usize>,
    /// Orthonormal basis of the span of the kept rows, one column each.
    basis: Vec<DVector<f64>>,
    /// `kept[k] = sum over j <= k of lower[k][j] basis[j]`
    lower: Vec<Vec<f64>>,
}

impl Selection {
    /// Keeps each row, in order, whose part outside the span of the kept rows has a norm above `tol`.
    ///
    /// Rows have norm one or zero.
    pub fn in_order(matrix: &DMatrix<f64>, order: impl Iterator<Item = usize>, tol: f64) -> Self {
        let mut selection = Self {
            kept: Vec::new(),
            basis: Vec::new(),
            lower: Vec::new(),
        };
        for row in order {
            if selection.basis.len() == matrix.ncols() {
                break;
            }
            let (mut coefficients, rest) = selection.split(matrix.row(row).transpose());
            let norm = rest.norm();
            if norm > tol {
                coefficients.push(norm);
                selection.kept.push(row);
                selection.lower.push(coefficients);
                selection.basis.push(rest / norm);
            }
        }
        selection
    }

    /// Keeps `rank` rows: the earliest ones where that is robust, else the best ones.
    ///
    /// Returns the selection, and whether the order decided.
    pub fn of_rank(matrix: &DMatrix<f64>, rank: usize, tol: f64) -> (Self, bool) {
        let mut limit = tol;
        let mut raise = None;
        while (1e-15..0.5).contains(&limit) {
            let selection = Self::in_order(matrix, 0..matrix.nrows(), limit);
            if selection.kept.len() == rank {
                return (selection, true);
            }
            let too_many = selection.kept.len() > rank;
            if *raise.get_or_insert(too_many) != too_many {
                break;
            }
            limit *= if too_many { 4.0 } else { 0.25 };
        }
        let mut rows = pivoted(matrix, rank);
        rows.sort_unstable();
        (Self::in_order(matrix, rows.into_iter(), 0.0), false)
    }

    /// Splits a vector into its coefficients in the basis and the rest outside of it.
    fn split(&self, mut rest: DVector<f64>) -> (Vec<f64>, DVector<f64>) {
        let mut coefficients = vec![0.0; self.basis.len()];
        // Twice is enough for orthogonality to rounding.
        for _ in 0..2 {
            for (coefficient, direction) in coefficients.iter_mut().zip(&self.basis) {
                let part = direction.dot(&rest);
                *coefficient += part;
                rest.axpy(-part, direction, 1.0);
            }
        }
        (coefficients, rest)
    }

    /// A vector as a combination of the kept rows: one coefficient for each.
    pub fn express(&self, vector: DVector<f64>) -> Vec<f64> {
        let (mut c, _) = self.split(vector);
        for k in (0..c.len()).rev() {
            c[k] /= self.lower[k][k];
            for j in 0..k {
                c[j] -= c[k] * self.lower[k][j];
            }
        }
        c
    }
}

/// The `rank` rows that Gram-Schmidt with pivoting takes first.
fn pivoted(matrix: &DMatrix<f64>, rank: usize) -> Vec<usize> {
    let mut rest = matrix.clone();
    let mut chosen = Vec::new();
    while chosen.len() < rank {
        let norms = rest.row_iter().map(|row| row.norm()).enumerate();
        let best = norms
            .filter(|(row, _)| !chosen.contains(row))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((row, norm)) = best.filter(|(_, norm)| *norm > 0.0) else {
            break;
        };
        let direction = rest.row(row) / norm;
        let parts = &rest * direction.transpose();
        rest -= parts * direction;
        chosen.push(row);
    }
    chosen
}
