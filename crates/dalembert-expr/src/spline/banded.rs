//! Banded systems of equations, open and cyclic.

/// Half of the band: a row has entries at most this far from the diagonal.
const HALF: usize = 4;
const WIDTH: usize = 2 * HALF + 1;

/// A banded matrix, factored without exchanging rows.
///
/// The collocation matrices of B-splines are totally positive, for which elimination without
/// pivoting is as stable as can be (C. de Boor and A. Pinkus, Numer. Math. 27, 1977).
pub(super) struct Banded {
    rows: Vec<[f64; WIDTH]>,
}

impl Banded {
    pub(super) fn new(size: usize) -> Self {
        Self {
            rows: vec![[0.0; WIDTH]; size],
        }
    }

    fn size(&self) -> usize {
        self.rows.len()
    }

    /// Sets an entry of the band; false where it lies outside.
    pub(super) fn set(&mut self, row: usize, column: usize, value: f64) -> bool {
        let place = (column + HALF).checked_sub(row).filter(|k| *k < WIDTH);
        if let Some(k) = place {
            self.rows[row][k] = value;
        }
        place.is_some()
    }

    /// Replaces the matrix by its triangular factors.
    pub(super) fn factor(&mut self) {
        for pivot in 0..self.size() {
            let upper = self.rows[pivot];
            for below in 1..=HALF.min(self.size() - 1 - pivot) {
                let row = &mut self.rows[pivot + below];
                let factor = row[HALF - below] / upper[HALF];
                row[HALF - below] = factor;
                if factor != 0.0 {
                    for k in 1..=HALF {
                        row[HALF - below + k] -= factor * upper[HALF + k];
                    }
                }
            }
        }
    }

    /// Solves for one right-hand side, in place, with the factors.
    pub(super) fn solve(&self, b: &mut [f64]) {
        let size = self.size();
        for i in 0..size {
            for below in 1..=HALF.min(i) {
                b[i] -= self.rows[i][HALF - below] * b[i - below];
            }
        }
        for i in (0..size).rev() {
            for above in 1..=HALF.min(size - 1 - i) {
                b[i] -= self.rows[i][HALF + above] * b[i + above];
            }
            b[i] /= self.rows[i][HALF];
        }
    }
}

/// Solves a cyclic system with `half` entries on either side of the diagonal, at most 2.
///
/// `entry(i, k)` is the entry of row i, `k - half` columns right of the diagonal, around the
/// corner. The last `half` unknowns are eliminated apart: without them the matrix is banded.
pub(super) fn solve_cyclic(
    half: usize,
    entry: impl Fn(usize, usize) -> f64,
    b: &[f64],
) -> Vec<f64> {
    let size = b.len();
    let inner = size - half;
    let mut band = Banded::new(inner);
    // Columns of the last unknowns in the inner rows, and the last rows in full.
    let mut columns = vec![vec![0.0; inner]; half];
    let mut rows = vec![vec![0.0; size]; half];
    for i in 0..size {
        for k in 0..=2 * half {
            let j = (i + k + size - half) % size;
            let value = entry(i, k);
            if i >= inner {
                rows[i - inner][j] += value;
            } else if j >= inner {
                columns[j - inner][i] += value;
            } else {
                // Without the corners every column lies in the band.
                band.set(i, j, value);
            }
        }
    }
    band.factor();
    let mut x = b[..inner].to_vec();
    band.solve(&mut x);
    for column in &mut columns {
        band.solve(column);
    }
    // The small system of the last unknowns.
    let dot = |row: &[f64], v: &[f64]| -> f64 { row.iter().zip(v).map(|(a, b)| a * b).sum() };
    let mut small = [[0.0; 2]; 2];
    let mut right = [0.0; 2];
    for (r, row) in rows.iter().enumerate() {
        right[r] = b[inner + r] - dot(&row[..inner], &x);
        for (c, column) in columns.iter().enumerate() {
            small[r][c] = row[inner + c] - dot(&row[..inner], column);
        }
    }
    let last = match half {
        1 => vec![right[0] / small[0][0]],
        _ => {
            let [[a, b], [c, d]] = small;
            let determinant = a * d - b * c;
            vec![
                (right[0] * d - b * right[1]) / determinant,
                (a * right[1] - right[0] * c) / determinant,
            ]
        }
    };
    for (column, value) in columns.iter().zip(&last) {
        for (x, c) in x.iter_mut().zip(column) {
            *x -= c * value;
        }
    }
    x.extend(last);
    x
}
