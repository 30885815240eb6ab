//! Equilibria that are one: a machine can be moved from one pose to the other through poses of equilibrium.

use super::problem::{Problem, step_limit};
use super::search::{Numbers, distance, weights};
use super::solution::Solution;
use super::stability::neutral_directions;
use crate::analysis::AnalysisError;
use crate::space::Space;
use nalgebra::{DMatrix, DVector};

/// Poses as near as this are one; the last step of a walk lands far closer.
const REACHED: f64 = 1e-6;
/// Steps of a walk: half a radian each, once around and as many again, and some for curved ways.
const STEPS: usize = 50;
/// Steps in which a walk must come nearer by a tenth.
const PATIENCE: usize = 10;
/// Part of the way left, along the family, below which the target lies straight across it: to either side is as near.
const ACROSS: f64 = 1e-2;
/// Steps to a side.
const KICKS: usize = 3;
/// Length of a step to a side.
const KICK: f64 = 0.3;

/// Solves for the equilibrium near a pose.
type Settle<'a, S> = dyn Fn(&mut Problem<'_, S>, &[f64]) -> Result<Solution, AnalysisError> + 'a;

/// Is there a way from an equilibrium to a pose that stays in equilibrium? It is looked for step by step along the
/// family of equilibria, each step corrected to equilibrium by `settle`.
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
    let (mut nearest, mut waited, mut kicks) = (f64::INFINITY, 0, 0);
    let mut numbers = Numbers(1);
    for _ in 0..STEPS {
        if distance(problem, &q, to) < REACHED {
            return Ok(true);
        }
        let left = problem.shorter_way(&q, to);
        let way = length(&left);
        if way < 0.9 * nearest {
            (nearest, waited) = (way, 0);
        } else if waited == PATIENCE {
            return Ok(false);
        }
        waited += 1;
        let neutral = neutral_directions(problem, &q)?;
        let weighted = DMatrix::from_fn(neutral.nrows(), neutral.ncols(), |i, j| {
            weights[i] * neutral[(i, j)]
        });
        // The weights are positive and the columns orthonormal: the matrix is positive definite.
        let Some(normal) = (neutral.transpose() * &weighted).cholesky() else {
            return Ok(false);
        };
        let mut step = &neutral * normal.solve(&weighted.tr_mul(&left));
        let along = length(&step);
        if along < ACROSS * way {
            if kicks == KICKS {
                return Ok(false);
            }
            kicks += 1;
            step = &neutral * DVector::from_fn(neutral.ncols(), |_, _| numbers.next());
            step *= KICK / step.amax().max(KICK);
        } else {
            // Where the family bends away from the straight way, the steps stay as long as the way.
            step *= way / along;
        }
        let factor = step_limit(problem.system, &step);
        problem.shift(&mut q, factor, &step);
        problem.assemble(&mut q)?;
        let settled = settle(problem, &q)?;
        if !settled.converged {
            return Ok(false);
        }
        q = settled.q;
    }
    Ok(distance(problem, &q, to) < REACHED)
}
