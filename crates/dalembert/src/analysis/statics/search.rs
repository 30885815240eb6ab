//! Poses from which equilibria are looked for.

use super::problem::{Problem, step_limit};
use crate::analysis::AnalysisError;
use crate::space::Space;
use nalgebra::DVector;
use std::f64::consts::PI;

/// A small generator of repeatable numbers (splitmix64, Steele, Lea and Flood 2014).
#[derive(Clone, Debug)]
pub(super) struct Numbers(pub u64);

impl Numbers {
    /// Evenly spread over -1 to 1.
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        // 53 bits fill a double in [0, 1).
        2.0 * ((z >> 11) as f64 / (1_u64 << 53) as f64) - 1.0
    }
}

/// How much a wanted move counts against a wanted turn. Bodies on pins cannot do both as asked: they
/// turn, and would hardly leave the pose if their moves counted alike. Bodies on slides move.
const MOVE_WEIGHT: f64 = 0.05;

/// How much an auxiliary coordinate counts: it follows the bodies, and where it goes is all the same. Not zero, for
/// those that no body needs.
const FOLLOWER_WEIGHT: f64 = 1e-9;

/// How much each scaled coordinate counts on a way along the free motions.
pub(super) fn weights<S: Space>(problem: &Problem<'_, S>) -> DVector<f64> {
    DVector::from_fn(problem.unit.len(), |k, _| {
        if k >= problem.system.body_nv() {
            FOLLOWER_WEIGHT
        } else if problem.turns(k) {
            1.0
        } else {
            MOVE_WEIGHT * MOVE_WEIGHT
        }
    })
}

/// A pose some way along the free motions from another.
///
/// Each body is asked to turn and move by a target of its own; the free motions follow as far as the
/// constraints let them (by weighted least squares), in short steps that are assembled one by one.
/// Returns the last pose that could be assembled.
pub(super) fn wander<S: Space>(
    problem: &mut Problem<'_, S>,
    from: &[f64],
    target: &DVector<f64>,
) -> Result<Vec<f64>, AnalysisError> {
    let mut q = from.to_vec();
    let mut left = target.clone();
    let weights = weights(problem);
    // Half a radian a step: a whole turn of the fastest body takes some 13.
    for _ in 0..40 {
        problem.evaluate(&q)?;
        let step = problem.nearest_motion(&left, &weights);
        // Also where it is not finite.
        if step.amax().is_nan() || step.amax() < 1e-3 {
            break;
        }
        let factor = step_limit(problem.system, &step);
        let mut next = q.clone();
        problem.shift(&mut next, factor, &step);
        if problem.assemble(&mut next).is_err() {
            break;
        }
        left -= problem.difference(&q, &next);
        q = next;
        if factor == 1.0 {
            break;
        }
    }
    Ok(q)
}

/// Targets of the wandering for one start: turns up to half a turn either way, or moves up to the
/// machine's size. Every other of the first starts
/// turns one body alone, until each had its turn about each axis.
pub(super) fn target<S: Space>(
    problem: &Problem<'_, S>,
    number: usize,
    numbers: &mut Numbers,
) -> DVector<f64> {
    let bodies = problem.system.bodies.len();
    let mut target = DVector::zeros(problem.unit.len());
    let single = number / 2;
    if single < bodies * (S::NV - S::LINEAR) && number.is_multiple_of(2) {
        let (axis, body) = (single / bodies, single % bodies);
        let sign = if single.is_multiple_of(2) { 1.0 } else { -1.0 };
        target[S::NV * body + S::LINEAR + axis] = sign * 0.9 * PI;
        return target;
    }
    for (k, x) in target.iter_mut().enumerate() {
        *x = numbers.next() * if problem.turns(k) { PI } else { 1.0 };
    }
    target
}

/// Difference of two poses: largest displacement relative to the size, or turn modulo whole turns.
pub(super) fn distance<S: Space>(problem: &Problem<'_, S>, a: &[f64], b: &[f64]) -> f64 {
    let way = problem.shorter_way(a, b);
    let turns = problem
        .moves_and_turns(&way)
        .into_iter()
        .map(|[_, turn]| turn);
    let moves = (0..way.len()).filter(|&k| !problem.turns(k));
    moves.map(|k| way[k].abs()).chain(turns).fold(0.0, f64::max)
}
