//! Elimination of the dependent accelerations.

use super::augmented_dense::singular;
use super::dense_solve::solve;
use super::{Accelerations, Basis, FormulationError, MotionBasis, Terms};
use nalgebra::{DMatrix, DVector};

/// Solves [M B, C_q^T] [u'; lambda] = Q - M gamma for independent accelerations and multipliers together
/// (Shabana 4.6 to 4.8); n unknowns, not symmetric.
///
/// # Errors
/// A value is not finite, or the masses do not determine the accelerations.
pub fn elimination(terms: &Terms, basis: &Basis) -> Result<Accelerations, FormulationError> {
    let motion = MotionBasis::new(terms, basis)?;
    let gamma = motion.particular(&terms.qd);
    let c = terms.jacobian.select_rows(&motion.rows.independent);
    let (n, free) = motion.b.shape();
    let mut k = DMatrix::zeros(n, n);
    k.view_mut((0, 0), (n, free))
        .copy_from(&(&terms.mass * &motion.b));
    k.view_mut((0, free), (n, n - free))
        .copy_from(&c.transpose());
    let right: DVector<f64> = &terms.force - &terms.mass * &gamma;
    let Some(x) = solve(&k, &right) else {
        return Err(singular(terms));
    };
    let a = &motion.b * x.rows(0, free) + gamma;
    let lambda = motion.rows.spread(&x.rows(free, n - free).into_owned());
    Ok(Accelerations {
        residual: terms.constraint_residual(&a),
        a: a.as_slice().to_vec(),
        lambda: lambda.as_slice().to_vec(),
    })
}
