//! Equilibria that are one: a machine can be moved from one pose to the other along neutral motions.

use super::problem::{Problem, step_limit};
use super::search::{distance, weights};
use super::solution::Solution;
use super::stability::neutral_motions;
use crate::analysis::AnalysisError;
use crate::space::Space;
use nalgebra::{DMatrix, DVector};

/// Poses as near as this are one; the last step of a walk lands far closer.
const REACHED: f64 = 1e-6;
/// Steps of a walk: half a radian each, once around and as many again.
const STEPS: usize = 30;

/// Solves for the equilibrium near a pose.
type Settle<'a, S> = dyn Fn(&mut Problem<'_, S>, &[f64]) -> Result<Solution, AnalysisError> + 'a;

/// Is there a way from an equilibrium to a pose that stays in equilibrium? It is looked for step by
/// step along the neutral motions, each step corrected to equilibrium by `settle`.
pub(super) fn connected<S: Space>(
    problem: &mut Problem<'_, S>,
    from: &[f64],
    to: &[f64],
    settle: &Settle<'_, S>,
) -> bool {
    walk(problem, from, to, settle).unwrap_or(false)
}

fn walk<S: Space>(
    problem: &mut Problem<'_, S>,
    from: &[f64],
    to: &[f64],
    settle: &Settle<'_, S>,
) -> Result<bool, AnalysisError> {
    let mut q = from.to_vec();
    let weights = weights(problem);
    let length = |d: &DVector<f64>| d.component_mul(&weights).dot(d).sqrt();
    let mut left = problem.shorter_way(&q, to);
    for _ in 0..STEPS {
        if distance(problem, &q, to) < REACHED {
            return Ok(true);
        }
        let neutral = neutral_motions(problem, &q)?;
        let weighted = DMatrix::from_fn(neutral.nrows(), neutral.ncols(), |i, j| {
            weights[i] * neutral[(i, j)]
        });
        // The weights are positive and the columns orthonormal: the matrix is positive definite.
        let Some(normal) = (neutral.transpose() * &weighted).cholesky() else {
            return Ok(false);
        };
        let step = &neutral * normal.solve(&weighted.tr_mul(&left));
        let factor = step_limit(problem.system, &step);
        problem.shift(&mut q, factor, &step);
        problem.assemble(&mut q)?;
        let settled = settle(problem, &q)?;
        if !settled.converged {
            return Ok(false);
        }
        q = settled.q;
        let next = problem.shorter_way(&q, to);
        // A walk that comes no nearer has met the end of the family.
        if length(&next) > 0.98 * length(&left) {
            return Ok(distance(problem, &q, to) < REACHED);
        }
        left = next;
    }
    Ok(false)
}
