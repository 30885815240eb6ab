//! Dependent and independent coordinates by Gaussian elimination with full pivoting.

use super::error::RankError;
use super::scaled::{Scaled, Svd};
use nalgebra::DMatrix;

/// Pivots below this part of the first one end the elimination.
const ZERO_PIVOT: f64 = 1e-9;

/// A preferred coordinate becomes dependent where all others leave only pivots below this part of the first one.
const POOR_PIVOT: f64 = 1e-6;

/// A split of the coordinates: the dependent ones follow from the independent ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Partition {
    /// Dependent coordinates (columns), ascending; as many as the rank.
    pub dependent: Vec<usize>,
    /// Independent coordinates (columns), ascending.
    pub independent: Vec<usize>,
    /// Independent rows, which determine the dependent coordinates, ascending.
    pub rows: Vec<usize>,
    /// Preferred coordinates that had to become dependent, ascending.
    pub refused: Vec<usize>,
    /// Condition number of the scaled block of rows and dependent coordinates; large: choose anew.
    pub condition: f64,
}

/// Splits coordinates by full pivoting on the scaled matrix (Shabana 2.5, 6.5).
///
/// Coordinates of `preferred_independent` stay independent as long as the others can carry the pivots.
pub fn partition(
    c: &DMatrix<f64>,
    column_scale: &[f64],
    preferred_independent: &[usize],
) -> Result<Partition, RankError> {
    let scaled = Scaled::new(c, column_scale)?;
    let (m, n) = c.shape();
    let mut work = scaled.matrix.clone();
    let mut allowed: Vec<bool> = (0..n)
        .map(|column| !preferred_independent.contains(&column))
        .collect();
    let mut free_row = vec![true; m];
    let (mut rows, mut dependent) = (Vec::new(), Vec::new());
    let mut first = work.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let mut second_phase = false;
    loop {
        let mut best = (0.0, 0, 0);
        for column in (0..n).filter(|&column| allowed[column]) {
            for row in (0..m).filter(|&row| free_row[row]) {
                let size = work[(row, column)].abs();
                if size > best.0 {
                    best = (size, row, column);
                }
            }
        }
        let (size, row, column) = best;
        let least = if second_phase { ZERO_PIVOT } else { POOR_PIVOT };
        if size <= least * first || size == 0.0 {
            if second_phase {
                break;
            }
            second_phase = true;
            for (column, allowed) in allowed.iter_mut().enumerate() {
                *allowed = !dependent.contains(&column);
            }
            continue;
        }
        first = first.max(size);
        free_row[row] = false;
        allowed[column] = false;
        rows.push(row);
        dependent.push(column);
        let pivot_row = work.row(row) / work[(row, column)];
        for other in (0..m).filter(|&other| free_row[other]) {
            let factor = work[(other, column)];
            for k in 0..n {
                work[(other, k)] -= factor * pivot_row[k];
            }
        }
    }
    rows.sort_unstable();
    dependent.sort_unstable();
    let independent = (0..n)
        .filter(|column| dependent.binary_search(column).is_err())
        .collect();
    let mut refused: Vec<usize> = preferred_independent
        .iter()
        .copied()
        .filter(|column| dependent.binary_search(column).is_ok())
        .collect();
    refused.sort_unstable();
    refused.dedup();
    let condition = condition(&scaled, &rows, &dependent)?;
    Ok(Partition {
        dependent,
        independent,
        rows,
        refused,
        condition,
    })
}

/// Condition number of a partition at another pose; infinite where its rows do not determine its coordinates.
pub fn partition_condition(
    c: &DMatrix<f64>,
    column_scale: &[f64],
    partition: &Partition,
) -> Result<f64, RankError> {
    condition(
        &Scaled::new(c, column_scale)?,
        &partition.rows,
        &partition.dependent,
    )
}

fn condition(scaled: &Scaled, rows: &[usize], columns: &[usize]) -> Result<f64, RankError> {
    if rows.is_empty() {
        return Ok(1.0);
    }
    let block = scaled.matrix.select_rows(rows).select_columns(columns);
    let values = Svd::new(&block)?.values;
    let smallest = values.last().copied().unwrap_or(0.0);
    Ok(if smallest > 0.0 {
        values[0] / smallest
    } else {
        f64::INFINITY
    })
}
