//! A matrix in comparable units, and its singular value decomposition.

use super::error::RankError;
use faer::Mat;
use nalgebra::DMatrix;

/// Rows below this part of the typical (median) norm are zero rows.
const ZERO_ROW: f64 = 1e-10;

/// A matrix after column scaling, with each row brought to unit norm.
#[derive(Clone, Debug)]
pub(super) struct Scaled {
    pub matrix: DMatrix<f64>,
    /// Norm of each row before it was brought to one; one for a zero row, whose entries are set to zero.
    pub norm: Vec<f64>,
    /// Whether a row is zero.
    pub zero: Vec<bool>,
}

impl Scaled {
    /// Multiplies the columns by their scales, then divides each row by its norm.
    pub fn new(c: &DMatrix<f64>, column_scale: &[f64]) -> Result<Self, RankError> {
        if column_scale.len() != c.ncols() {
            return Err(RankError::ScaleCount {
                expected: c.ncols(),
                found: column_scale.len(),
            });
        }
        if let Some(column) = column_scale
            .iter()
            .position(|s| !(s.is_finite() && *s > 0.0))
        {
            return Err(RankError::Scale { column });
        }
        let mut matrix = c.clone();
        for (mut column, &scale) in matrix.column_iter_mut().zip(column_scale) {
            column *= scale;
        }
        for (column, values) in matrix.column_iter().enumerate() {
            if let Some(row) = values.iter().position(|value| !value.is_finite()) {
                return Err(RankError::NotFinite { row, column });
            }
        }
        // Dividing by the largest entry first keeps the squares in range.
        let mut norm: Vec<f64> = matrix
            .row_iter()
            .map(|row| {
                let largest = row.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
                if largest > 0.0 {
                    largest
                        * row
                            .iter()
                            .map(|x| (x / largest).powi(2))
                            .sum::<f64>()
                            .sqrt()
                } else {
                    0.0
                }
            })
            .collect();
        let mut sorted: Vec<f64> = norm.iter().copied().filter(|norm| *norm > 0.0).collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let typical = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
        let zero: Vec<bool> = norm
            .iter()
            .map(|norm| *norm <= ZERO_ROW * typical)
            .collect();
        for (i, mut row) in matrix.row_iter_mut().enumerate() {
            if zero[i] {
                row.fill(0.0);
                norm[i] = 1.0;
            } else {
                row /= norm[i];
            }
        }
        Ok(Self { matrix, norm, zero })
    }
}

/// Singular value decomposition with square U and V; singular values descend.
pub(crate) struct Svd {
    pub u: DMatrix<f64>,
    pub values: Vec<f64>,
    pub v: DMatrix<f64>,
}

impl Svd {
    /// Decomposes a finite matrix.
    pub fn new(matrix: &DMatrix<f64>) -> Result<Self, RankError> {
        let (m, n) = matrix.shape();
        if m == 0 || n == 0 {
            return Ok(Self {
                u: DMatrix::identity(m, m),
                values: Vec::new(),
                v: DMatrix::identity(n, n),
            });
        }
        let svd = to_faer(matrix)
            .svd()
            .map_err(|_| RankError::NoConvergence)?;
        let values = (0..m.min(n)).map(|i| svd.S()[i]).collect();
        Ok(Self {
            u: from_faer(svd.U()),
            values,
            v: from_faer(svd.V()),
        })
    }

    /// Number of singular values above a part of the largest one.
    pub fn rank(&self, tol: f64) -> usize {
        let largest = self.values.first().copied().unwrap_or(0.0);
        self.values
            .iter()
            .filter(|value| **value > tol * largest)
            .count()
    }
}

/// The same matrix for faer.
pub(in crate::solve) fn to_faer(matrix: &DMatrix<f64>) -> Mat<f64> {
    Mat::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)])
}

/// The same matrix for nalgebra.
pub(in crate::solve) fn from_faer(matrix: faer::MatRef<'_, f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shabana_example_2_20_singular_values_and_vectors() {
        // Shabana, Computational Dynamics, example 2.20 (the printed Q1(1,1) = -.5515 has two digits exchanged).
        let a = DMatrix::from_row_slice(3, 2, &[2.0, 1.0, 1.0, 0.0, 1.0, 0.0]);
        let svd = Svd::new(&a).unwrap();
        assert!((svd.values[0] - 2.588_737_553_078_029).abs() < 1e-14);
        assert!((svd.values[1] - 0.546_294_683_557_853_9).abs() < 1e-14);
        // Largest first: the book's columns in the opposite order.
        let q1 = [
            [0.856_890_099_623_580_1, 0.364_512_933_355_656_7],
            [-0.515_499_134_011_969_8, 0.605_912_800_175_449_8],
        ];
        for (k, column) in q1.iter().enumerate() {
            let sign = (svd.u[(0, k)] * column[0]).signum();
            assert!((svd.u[(0, k)] * sign - column[0]).abs() < 1e-14);
            assert!((svd.u[(1, k)] * sign - column[1]).abs() < 1e-14);
            assert!((svd.u[(2, k)] * sign - column[1]).abs() < 1e-14);
        }
    }

    #[test]
    fn hilbert_matrices_have_their_known_condition() {
        // Shabana, Computational Dynamics, section 2.6; condition numbers recomputed with rational arithmetic.
        for (n, condition) in [
            (3, 524.056_777_586_062_7),
            (5, 476_607.250_241_933_8),
            (8, 15_257_575_563.722_723),
        ] {
            let svd = Svd::new(&DMatrix::from_fn(n, n, |i, j| 1.0 / (i + j + 1) as f64)).unwrap();
            let found = svd.values[0] / svd.values[n - 1];
            // The smallest singular value carries the rounding of the largest one.
            assert!(
                (found / condition - 1.0).abs() < 1e-15 * condition + 1e-14,
                "{n}: {found:e}"
            );
        }
    }
}
