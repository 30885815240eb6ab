//! Dense square systems with rows and columns of different units.

use nalgebra::{DMatrix, DVector};

/// Pivots below this part of the first one count as zero.
const ZERO_PIVOT: f64 = 1e-14;

/// Solves a square system by LU with full pivoting after bringing rows and columns to like sizes, with one step of
/// refinement; none where the matrix is singular.
pub(super) fn solve(a: &DMatrix<f64>, b: &DVector<f64>) -> Option<DVector<f64>> {
    let n = a.nrows();
    if n == 0 {
        return Some(DVector::zeros(0));
    }
    let mut row = DVector::repeat(n, 1.0);
    let mut column = DVector::repeat(n, 1.0);
    // Ruiz's iteration: rows and columns by the square root of their largest entry.
    for _ in 0..6 {
        let scaled = |i: usize, j: usize| (row[i] * a[(i, j)] * column[j]).abs();
        let largest = |x: f64| if x > 0.0 { 1.0 / x.sqrt() } else { 1.0 };
        let by_row: Vec<f64> = (0..n)
            .map(|i| largest((0..n).map(|j| scaled(i, j)).fold(0.0, f64::max)))
            .collect();
        let by_column: Vec<f64> = (0..n)
            .map(|j| largest((0..n).map(|i| scaled(i, j)).fold(0.0, f64::max)))
            .collect();
        for k in 0..n {
            row[k] *= by_row[k];
            column[k] *= by_column[k];
        }
    }
    let scaled = DMatrix::from_fn(n, n, |i, j| row[i] * a[(i, j)] * column[j]);
    let lu = scaled.full_piv_lu();
    let pivots = lu.u().diagonal();
    let (most, least) = (pivots.amax(), pivots.amin());
    if !(most.is_finite() && least > ZERO_PIVOT * most) {
        return None;
    }
    let step = |rhs: &DVector<f64>| {
        lu.solve(&rhs.component_mul(&row))
            .map(|y| y.component_mul(&column))
    };
    let mut x = step(b)?;
    x += step(&(b - a * &x))?;
    x.iter().all(|value| value.is_finite()).then_some(x)
}
