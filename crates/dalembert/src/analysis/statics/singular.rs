//! Equilibria at poses where constraints depend on each other.
//!
//! Close to such a pose rows of the Jacobian are all but dependent. The constraints hold there to the accuracy of the
//! assembly, and reactions beyond measure seem to carry what is left of the load: the search stops beside the pose.

use super::motions::Motions;
use super::problem::Problem;
use super::reduced::least_squares;
use super::solution::Solution;
use crate::analysis::AnalysisError;
use crate::space::Space;
use nalgebra::DVector;

/// Singular values below this part of the largest make a pose suspect. Constraints met to 1e-13 leave a pose 3e-7 from
/// one at which they touch to second order, with a singular value of that order.
const SUSPECT: f64 = 1e-6;
/// Farther away, in units of the size and in radians, lies another equilibrium: constraints that touch to fourth order,
/// met to 1e-13, leave some 1e-3.
const NEAR: f64 = 1e-2;
/// Most steps of Newton's method, which starts close to its end.
const STEPS: usize = 20;
/// Stiffnesses below this part of the largest are flat.
const FLAT: f64 = 1e-9;

/// The equilibrium at the pose of dependent constraints next to which a solution stopped; none if it did not.
pub(super) fn beside<S: Space>(
    problem: &mut Problem<'_, S>,
    solution: &Solution,
    tolerance: f64,
) -> Result<Option<Solution>, AnalysisError> {
    problem.evaluate(&solution.q)?;
    if !suspect(problem)? {
        return Ok(None);
    }
    let mut q = solution.q.clone();
    let mut moved = DVector::zeros(problem.unit.len());
    let mut scale = solution.scale;
    for done in 1..=STEPS {
        let motions = Motions::within(problem, &problem.jacobian(), SUSPECT)?;
        let force = problem.forces();
        let residual = motions.basis.tr_mul(&force);
        let lambda = motions.multipliers(&force);
        scale = scale.max(problem.force_scale());
        if residual.norm() <= tolerance * scale && !suspect(problem)? {
            return Ok(Some(Solution {
                unbalanced: &motions.basis * &residual,
                residual: if scale > 0.0 {
                    residual.norm() / scale
                } else {
                    residual.norm()
                },
                way: &solution.way + moved,
                iterations: solution.iterations + done,
                lambda,
                scale,
                q,
                converged: true,
            }));
        }
        let k = problem.stiffness(&q, &lambda, &motions.basis)?;
        let k = motions.basis.tr_mul(&k);
        let step = &motions.basis * least_squares(problem, &k, &residual, FLAT)?;
        let mut next = q.clone();
        problem.shift(&mut next, 1.0, &step);
        problem.assemble(&mut next)?;
        moved += problem.difference(&q, &next);
        q = next;
        // Also where it is not finite.
        let near = moved.amax() <= NEAR;
        if !near {
            break;
        }
        problem.evaluate(&q)?;
    }
    Ok(None)
}

/// Are rows at the evaluated pose dependent or not by a hair?
fn suspect<S: Space>(problem: &Problem<'_, S>) -> Result<bool, AnalysisError> {
    let jacobian = problem.jacobian();
    let coarse = Motions::within(problem, &jacobian, SUSPECT)?;
    Ok(coarse.basis.ncols() != Motions::of(problem, &jacobian)?.basis.ncols())
}
