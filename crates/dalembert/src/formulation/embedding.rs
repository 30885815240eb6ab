//! The embedding technique.

use super::{Accelerations, Basis, FormulationError, MotionBasis, Terms};
use nalgebra::{DMatrix, DVector};

/// Part of the largest (scaled) inertia below which a free motion counts as massless.
const MASSLESS: f64 = 1e-13;

/// The equations of motion in independent coordinates: Mbar u' = Qbar.
#[derive(Clone, Debug)]
pub struct Embedding {
    /// B, the particular solutions' basis.
    pub motion: MotionBasis,
    /// gamma: the accelerations at u' = 0, C_q gamma = Q_d.
    pub gamma: DVector<f64>,
    /// Mbar = B^T M B.
    pub mass: DMatrix<f64>,
    /// Qbar = B^T (Q - M gamma).
    pub force: DVector<f64>,
    /// u'.
    pub acceleration: DVector<f64>,
    /// Accelerations and multipliers of all coordinates.
    pub solution: Accelerations,
}

/// Solves B^T M B u' = B^T (Q - M gamma), then a = B u' + gamma, then C_q^T lambda = Q - M a by least squares
/// (Shabana 4.14 to 4.16, 6.82 to 6.91).
///
/// # Errors
/// A value is not finite, or a free motion has no mass.
pub fn embedding(terms: &Terms, basis: &Basis) -> Result<Embedding, FormulationError> {
    let motion = MotionBasis::new(terms, basis)?;
    let gamma = motion.particular(&terms.qd);
    let b = &motion.b;
    let mass = b.transpose() * &terms.mass * b;
    let force = b.transpose() * (&terms.force - &terms.mass * &gamma);
    let acceleration = solve_inertia(&mass, &force, &motion, &terms.column_scale)?;
    let a = b * &acceleration + &gamma;
    let lambda = motion.rows.multipliers(&(&terms.force - &terms.mass * &a));
    if !a.iter().chain(lambda.iter()).all(|x| x.is_finite()) {
        return Err(FormulationError::NotFinite);
    }
    let solution = Accelerations {
        residual: terms.constraint_residual(&a),
        a: a.as_slice().to_vec(),
        lambda: lambda.as_slice().to_vec(),
    };
    Ok(Embedding {
        motion,
        gamma,
        mass,
        force,
        acceleration,
        solution,
    })
}

/// Inertia of the free motions brought to unit diagonal, and the factors that do it; zero rows stay.
fn unit_diagonal(mass: &DMatrix<f64>) -> (DMatrix<f64>, DVector<f64>) {
    let n = mass.nrows();
    let largest = mass.diagonal().amax();
    let scale = mass.diagonal().map(|d| {
        if d > MASSLESS * MASSLESS * largest {
            1.0 / d.sqrt()
        } else {
            1.0
        }
    });
    let scaled = DMatrix::from_fn(n, n, |i, j| scale[i] * mass[(i, j)] * scale[j]);
    (scaled, scale)
}

/// The coordinates that take part in free motions without mass, ascending.
pub(super) fn massless_motions(
    mass: &DMatrix<f64>,
    motion: &MotionBasis,
    column_scale: &[f64],
) -> Vec<usize> {
    if mass.nrows() == 0 {
        return Vec::new();
    }
    let (scaled, scale) = unit_diagonal(mass);
    let eigen = scaled.symmetric_eigen();
    let mut coordinates = Vec::new();
    for (value, vector) in eigen
        .eigenvalues
        .iter()
        .zip(eigen.eigenvectors.column_iter())
    {
        if *value > MASSLESS {
            continue;
        }
        let direction = &motion.b * vector.component_mul(&scale);
        let size = |k: usize| (direction[k] / column_scale[k]).abs();
        let most = (0..direction.len()).map(size).fold(0.0, f64::max);
        coordinates.extend((0..direction.len()).filter(|&k| size(k) > 1e-6 * most));
    }
    coordinates.sort_unstable();
    coordinates.dedup();
    coordinates
}

fn solve_inertia(
    mass: &DMatrix<f64>,
    force: &DVector<f64>,
    motion: &MotionBasis,
    column_scale: &[f64],
) -> Result<DVector<f64>, FormulationError> {
    if mass.nrows() == 0 {
        return Ok(DVector::zeros(0));
    }
    let coordinates = massless_motions(mass, motion, column_scale);
    if !coordinates.is_empty() {
        return Err(FormulationError::Massless { coordinates });
    }
    let (scaled, scale) = unit_diagonal(mass);
    // The eigenvalues are positive, so only a value that is not finite can stop Cholesky.
    let factors = scaled.cholesky().ok_or(FormulationError::NotFinite)?;
    let step = |rhs: DVector<f64>| {
        factors
            .solve(&rhs.component_mul(&scale))
            .component_mul(&scale)
    };
    let mut u = step(force.clone());
    u += step(force - mass * &u);
    Ok(u)
}
