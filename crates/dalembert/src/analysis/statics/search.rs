//! Poses from which equilibria are looked for.

use super::problem::{Problem, step_limit};
use crate::analysis::AnalysisError;
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

/// How much each scaled coordinate counts on a way along the free motions.
pub(super) fn weights(problem: &Problem<'_>) -> DVector<f64> {
    let bodies = problem.system.bodies.len();
    DVector::from_fn(problem.unit.len(), |k, _| {
        let turn = k >= 3 * bodies || k % 3 == 2;
        if turn { 1.0 } else { MOVE_WEIGHT * MOVE_WEIGHT }
    })
}

/// A pose some way along the free motions from another.
///
/// Each body is asked to turn and move by a target of its own; the free motions follow as far as the
/// constraints let them (by weighted least squares), in short steps that are assembled one by one.
/// Returns the last pose that could be assembled.
pub(super) fn wander(
    problem: &mut Problem<'_>,
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
        for k in 0..left.len() {
            left[k] -= (next[k] - q[k]) / problem.unit[k];
        }
        q = next;
        if factor == 1.0 {
            break;
        }
    }
    Ok(q)
}

/// Targets of the wandering for one start: turns up to half a turn either way, or moves up to the
/// machine's size. Every other of the first starts
/// turns one body alone, until each had its turn.
pub(super) fn target(problem: &Problem<'_>, number: usize, numbers: &mut Numbers) -> DVector<f64> {
    let bodies = problem.system.bodies.len();
    let mut target = DVector::zeros(problem.unit.len());
    let body = number / 2;
    if body < bodies && number.is_multiple_of(2) {
        let sign = if body.is_multiple_of(2) { 1.0 } else { -1.0 };
        target[3 * body + 2] = sign * 0.9 * PI;
        return target;
    }
    for (k, x) in target.iter_mut().enumerate() {
        let turn = k >= 3 * bodies || k % 3 == 2;
        *x = numbers.next() * if turn { PI } else { 1.0 };
    }
    target
}

/// Difference of two poses: largest displacement relative to the size, or turn modulo whole turns.
pub(super) fn distance(problem: &Problem<'_>, a: &[f64], b: &[f64]) -> f64 {
    let bodies = problem.system.bodies.len();
    let mut worst: f64 = 0.0;
    for k in 0..3 * bodies {
        let d = (a[k] - b[k]) / problem.unit[k];
        let d = if k % 3 == 2 {
            d - 2.0 * PI * (d / (2.0 * PI)).round()
        } else {
            d
        };
        worst = worst.max(d.abs());
    }
    worst
}
