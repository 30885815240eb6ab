//! Which rows of a constraint Jacobian carry information, and which motions they leave free.

use super::error::RankError;
use super::scaled::{Scaled, Svd};
use super::selection::Selection;
use nalgebra::DMatrix;

/// A row that follows from others.
#[derive(Clone, Debug, PartialEq)]
pub struct RedundantRow {
    /// The row.
    pub row: usize,
    /// The rows that it follows from and their coefficients: `C[row] = sum of coefficient * C[other]`.
    ///
    /// Empty for a row without gradient.
    pub depends_on: Vec<(usize, f64)>,
}

/// What the rows of a matrix say together.
#[derive(Clone, Debug, PartialEq)]
pub struct RowRank {
    /// Number of independent rows.
    pub rank: usize,
    /// The rows that were kept as independent, ascending; as many as the rank.
    pub independent: Vec<usize>,
    /// The other rows, ascending.
    pub redundant: Vec<RedundantRow>,
    /// Whether the multiplier of each row is uniquely determined: its component is zero in every left null vector.
    pub unique: Vec<bool>,
    /// Singular values of the scaled matrix, descending.
    pub singular_values: Vec<f64>,
    /// Free motions in the user's coordinates, one a column; orthonormal once divided by the column scales.
    pub null_space: DMatrix<f64>,
    /// Combinations of the given rows that vanish, one a column of unit length.
    pub left_null_space: DMatrix<f64>,
    /// Largest singular value that counts as zero over the smallest that does not; near one, the rank is doubtful.
    pub gap: f64,
    /// Largest singular value over the smallest that does not count as zero; one for rank zero.
    pub condition: f64,
    /// Whether the independent rows are the earliest ones; otherwise that choice was not robust and the best were kept.
    pub in_order: bool,
}

/// Finds rank, redundant rows and null spaces of a matrix by singular values.
///
/// Columns are multiplied by their scale (the typical size of the coordinate), then each row is brought to unit norm;
/// rows far below the typical norm are zero rows. A singular value counts as zero up to `tol` times the largest.
/// Later rows are called redundant rather than earlier ones. Shabana 2.8, 6.9.
pub fn analyse_rows(
    c: &DMatrix<f64>,
    column_scale: &[f64],
    tol: f64,
) -> Result<RowRank, RankError> {
    let scaled = Scaled::new(c, column_scale)?;
    let svd = Svd::new(&scaled.matrix)?;
    let rank = svd.rank(tol);
    let (selection, in_order) = Selection::of_rank(&scaled.matrix, rank, tol);
    let last = rank.checked_sub(1).map(|at| svd.values[at]);
    let next = svd.values.get(rank).copied().unwrap_or(0.0);

    let (m, n) = c.shape();
    let left = svd.u.columns(rank, m - rank).into_owned();
    // Rounding turns null vectors by about 1e-16 over the smallest singular value that counts.
    let silent = (1e-13 / last.unwrap_or(1.0)).max(1e-9);
    let unique = left.row_iter().map(|row| row.norm() <= silent).collect();
    let mut left_null_space = left;
    for (mut row, norm) in left_null_space.row_iter_mut().zip(&scaled.norm) {
        row /= *norm;
    }
    for mut column in left_null_space.column_iter_mut() {
        column.normalize_mut();
    }
    let mut null_space = svd.v.columns(rank, n - rank).into_owned();
    for (mut row, scale) in null_space.row_iter_mut().zip(column_scale) {
        row *= *scale;
    }

    let mut independent = selection.kept.clone();
    independent.sort_unstable();
    let redundant = (0..m)
        .filter(|row| independent.binary_search(row).is_err())
        .map(|row| RedundantRow {
            row,
            depends_on: dependence(&scaled, &selection, row, tol),
        })
        .collect();
    Ok(RowRank {
        rank,
        independent,
        redundant,
        unique,
        null_space,
        left_null_space,
        gap: last.map_or(0.0, |last| next / last),
        condition: last.map_or(1.0, |last| svd.values[0] / last),
        singular_values: svd.values,
        in_order,
    })
}

/// The independent rows of a matrix, ascending; earlier rows are preferred.
pub fn independent_rows(
    c: &DMatrix<f64>,
    column_scale: &[f64],
    tol: f64,
) -> Result<Vec<usize>, RankError> {
    let scaled = Scaled::new(c, column_scale)?;
    let rank = Svd::new(&scaled.matrix)?.rank(tol);
    let mut kept = Selection::of_rank(&scaled.matrix, rank, tol).0.kept;
    kept.sort_unstable();
    Ok(kept)
}

/// A redundant row in terms of the kept ones, in the user's units, without coefficients that are only rounding.
fn dependence(scaled: &Scaled, selection: &Selection, row: usize, tol: f64) -> Vec<(usize, f64)> {
    if scaled.zero[row] {
        return Vec::new();
    }
    let coefficients = selection.express(scaled.matrix.row(row).transpose());
    let largest = coefficients
        .iter()
        .fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let mut list: Vec<(usize, f64)> = selection
        .kept
        .iter()
        .zip(&coefficients)
        .filter(|(_, coefficient)| coefficient.abs() > tol.max(1e-9) * largest)
        .map(|(&other, coefficient)| (other, coefficient * scaled.norm[row] / scaled.norm[other]))
        .collect();
    list.sort_unstable_by_key(|(other, _)| *other);
    list
}
