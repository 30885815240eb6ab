//! Bases of the free motions: `C B = 0`.

use super::error::RankError;
use super::partition::Partition;
use super::row_rank::independent_rows;
use super::scaled::{Scaled, Svd, from_faer, to_faer};
use nalgebra::DMatrix;

/// The basis whose coordinates are the independent coordinates themselves (Shabana 6.5).
///
/// Rows stand in the order of the coordinates, columns in that of `partition.independent`: the rows of the
/// independent coordinates are the identity, those of the dependent ones are `-C_qd^-1 C_qi`.
pub fn null_basis_lu(
    c: &DMatrix<f64>,
    column_scale: &[f64],
    partition: &Partition,
) -> Result<DMatrix<f64>, RankError> {
    let scaled = Scaled::new(c, column_scale)?;
    if partition.rows.is_empty() {
        return Ok(DMatrix::identity(c.ncols(), c.ncols()));
    }
    let rows = scaled.matrix.select_rows(&partition.rows);
    let dependent = rows.select_columns(&partition.dependent);
    let right = -rows.select_columns(&partition.independent);
    let part = dependent
        .full_piv_lu()
        .solve(&right)
        .ok_or(RankError::SingularPartition)?;
    if part.iter().any(|value| !value.is_finite()) {
        return Err(RankError::SingularPartition);
    }
    let mut basis = DMatrix::zeros(c.ncols(), partition.independent.len());
    for (k, &column) in partition.independent.iter().enumerate() {
        basis[(column, k)] = 1.0;
        for (i, &row) in partition.dependent.iter().enumerate() {
            basis[(row, k)] = part[(i, k)] * column_scale[row] / column_scale[column];
        }
    }
    Ok(basis)
}

/// A basis by Householder QR of `C^T` (Shabana 6.8), from independent rows only.
///
/// Its columns are orthonormal once divided by the column scales.
pub fn null_basis_qr(
    c: &DMatrix<f64>,
    column_scale: &[f64],
    tol: f64,
) -> Result<DMatrix<f64>, RankError> {
    let rows = independent_rows(c, column_scale, tol)?;
    let scaled = Scaled::new(c, column_scale)?;
    let n = c.ncols();
    let q = if rows.is_empty() {
        DMatrix::identity(n, n)
    } else {
        let transposed = scaled.matrix.select_rows(&rows).transpose();
        from_faer(to_faer(&transposed).qr().compute_Q().as_ref())
    };
    Ok(unscale(
        q.columns(rows.len(), n - rows.len()).into_owned(),
        column_scale,
    ))
}

/// A basis by singular value decomposition (Shabana 6.9).
///
/// Its columns are orthonormal once divided by the column scales.
pub fn null_basis_svd(
    c: &DMatrix<f64>,
    column_scale: &[f64],
    tol: f64,
) -> Result<DMatrix<f64>, RankError> {
    let svd = Svd::new(&Scaled::new(c, column_scale)?.matrix)?;
    let rank = svd.rank(tol);
    Ok(unscale(
        svd.v.columns(rank, c.ncols() - rank).into_owned(),
        column_scale,
    ))
}

/// The new basis turned so that it comes as near as possible to the previous one (orthogonal Procrustes problem).
///
/// Quasi-velocities stay continuous along a motion this way. Where the number of motions changed there is nothing to
/// be continuous with, and the new basis is returned as it is. Give both bases divided by the column scales if these
/// differ from one.
pub fn continue_basis(
    previous: &DMatrix<f64>,
    new: &DMatrix<f64>,
) -> Result<DMatrix<f64>, RankError> {
    if previous.shape() != new.shape() {
        return Ok(new.clone());
    }
    let overlap = new.transpose() * previous;
    if let Some(at) = overlap.iter().position(|value| !value.is_finite()) {
        return Err(RankError::NotFinite {
            row: at % overlap.nrows(),
            column: at / overlap.nrows(),
        });
    }
    let svd = Svd::new(&overlap)?;
    Ok(new * (svd.u * svd.v.transpose()))
}

fn unscale(mut basis: DMatrix<f64>, column_scale: &[f64]) -> DMatrix<f64> {
    for (mut row, scale) in basis.row_iter_mut().zip(column_scale) {
        row *= *scale;
    }
    basis
}
