//! The amalgamated formulation.

use super::augmented_dense::singular;
use super::dense_solve::solve;
use super::{Accelerations, Basis, FormulationError, MotionBasis, Terms};
use nalgebra::{DMatrix, DVector};

/// Solves for accelerations, constraint forces Q_c and independent accelerations together (Shabana 4.17 to 4.20):
/// [M I 0; I 0 -B; 0 -B^T 0] [a; -Q_c; u'] = [Q; gamma; 0], 2 n + n_dof unknowns, symmetric indefinite. The multipliers
/// follow from C_q^T lambda = -Q_c by least squares.
///
/// # Errors
/// A value is not finite, or the masses do not determine the accelerations.
pub fn amalgamated(terms: &Terms, basis: &Basis) -> Result<Accelerations, FormulationError> {
    let motion = MotionBasis::new(terms, basis)?;
    let gamma = motion.particular(&terms.qd);
    let (n, free) = motion.b.shape();
    let size = 2 * n + free;
    let mut k = DMatrix::zeros(size, size);
    k.view_mut((0, 0), (n, n)).copy_from(&terms.mass);
    for i in 0..n {
        k[(i, n + i)] = 1.0;
        k[(n + i, i)] = 1.0;
    }
    k.view_mut((n, 2 * n), (n, free)).copy_from(&-&motion.b);
    k.view_mut((2 * n, n), (free, n))
        .copy_from(&-motion.b.transpose());
    let mut right = DVector::zeros(size);
    right.rows_mut(0, n).copy_from(&terms.force);
    right.rows_mut(n, n).copy_from(&gamma);
    let Some(x) = solve(&k, &right) else {
        return Err(singular(terms));
    };
    let a = x.rows(0, n).into_owned();
    let lambda = motion.rows.multipliers(&x.rows(n, n).into_owned());
    Ok(Accelerations {
        residual: terms.constraint_residual(&a),
        a: a.as_slice().to_vec(),
        lambda: lambda.as_slice().to_vec(),
    })
}
