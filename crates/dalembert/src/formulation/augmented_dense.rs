//! The augmented formulation as one dense matrix.

use super::dense_solve::solve;
use super::embedding::massless_motions;
use super::{Accelerations, Basis, FormulationError, MotionBasis, RowSpace, Terms};
use nalgebra::{DMatrix, DVector};

/// Solves [M C_q^T; C_q 0] [a; lambda] = [Q; Q_d] with the independent rows by LU with full pivoting (Shabana 6.141).
/// The matrix is symmetric but indefinite, so Cholesky must not be used on it.
///
/// # Errors
/// A value is not finite, or the masses do not determine the accelerations.
pub fn augmented_dense(terms: &Terms) -> Result<Accelerations, FormulationError> {
    terms.check()?;
    let rows = RowSpace::new(&terms.jacobian, &terms.column_scale)?;
    let c = terms.jacobian.select_rows(&rows.independent);
    let (n, m) = (terms.mass.nrows(), c.nrows());
    let mut k = DMatrix::zeros(n + m, n + m);
    k.view_mut((0, 0), (n, n)).copy_from(&terms.mass);
    k.view_mut((n, 0), (m, n)).copy_from(&c);
    k.view_mut((0, n), (n, m)).copy_from(&c.transpose());
    let mut right = DVector::zeros(n + m);
    right.rows_mut(0, n).copy_from(&terms.force);
    right
        .rows_mut(n, m)
        .copy_from(&terms.qd.select_rows(&rows.independent));
    let Some(x) = solve(&k, &right) else {
        return Err(singular(terms));
    };
    let a = x.rows(0, n).into_owned();
    let lambda = rows.spread(&x.rows(n, m).into_owned());
    Ok(Accelerations {
        residual: terms.constraint_residual(&a),
        a: a.as_slice().to_vec(),
        lambda: lambda.as_slice().to_vec(),
    })
}

/// Why a square system of the equations of motion is singular although its rows are independent.
pub(super) fn singular(terms: &Terms) -> FormulationError {
    let motion = match MotionBasis::new(terms, &Basis::default()) {
        Ok(motion) => motion,
        Err(e) => return e,
    };
    let mass = motion.b.transpose() * &terms.mass * &motion.b;
    let coordinates = massless_motions(&mass, &motion, &terms.column_scale);
    if coordinates.is_empty() {
        FormulationError::Singular
    } else {
        FormulationError::Massless { coordinates }
    }
}
