//! Route 1: Newton's method on B^T Q_e = 0 in the free motions (Shabana 6.176).

use super::motions::Motions;
use super::problem::{Problem, step_limit};
use super::solution::{Goal, Solution};
use crate::analysis::AnalysisError;
use crate::solve::rank::Svd;
use nalgebra::{DMatrix, DVector};

/// Curvatures below this part of the largest are treated as flat.
const FLAT: f64 = 1e-9;
/// Most steps after the tolerance is met that only remove rounding.
const POLISHING: usize = 6;

/// What is known at a pose on the constraints.
struct Point {
    q: Vec<f64>,
    motions: Motions,
    lambda: DVector<f64>,
    /// Unbalanced force in the free motions.
    residual: DVector<f64>,
    scale: f64,
}

impl Point {
    fn new(problem: &mut Problem<'_>, q: Vec<f64>) -> Result<Self, AnalysisError> {
        problem.evaluate(&q)?;
        let motions = Motions::new(problem)?;
        let force = problem.forces();
        Ok(Self {
            lambda: motions.multipliers(&force),
            residual: motions.basis.transpose() * force,
            scale: problem.force_scale(),
            motions,
            q,
        })
    }

    /// The unbalanced force in scaled coordinates.
    fn unbalanced(&self) -> DVector<f64> {
        &self.motions.basis * &self.residual
    }
}

/// Solves from a pose on the constraints.
///
/// [`Goal::Rest`] follows the forces downhill, so that it ends where the machine comes to rest;
/// [`Goal::Any`] takes Newton's steps to whichever equilibrium is near.
pub(super) fn solve(
    problem: &mut Problem<'_>,
    start: &[f64],
    goal: Goal,
    tolerance: f64,
    max_iterations: usize,
) -> Result<Solution, AnalysisError> {
    let mut at = Point::new(problem, start.to_vec())?;
    let mut scale = at.scale;
    let (mut iterations, mut polished, mut tiny_step) = (0, 0, false);
    loop {
        let size = at.residual.norm();
        let met = size <= tolerance * scale || tiny_step;
        if size == 0.0 || (met && polished >= POLISHING) || iterations >= max_iterations {
            return Ok(finish(at, scale, iterations, met || size == 0.0));
        }
        let k = problem.stiffness(&at.q, &at.lambda, &at.motions.basis)?;
        let k = at.motions.basis.transpose() * k;
        let step = match goal {
            _ if met => newton(problem, &k, &at.residual)?,
            Goal::Any => newton(problem, &k, &at.residual)?,
            Goal::Rest => downhill(problem, &k, &at.residual, scale)?,
        };
        // A singular stiffness that cannot answer the force gives a small step as well.
        let answers = (&k * &step - &at.residual).norm() <= 1e-3 * size;
        let step = &at.motions.basis * step;
        iterations += 1;
        let mut factor = step_limit(problem.system, &step);
        let full = factor == 1.0;
        let next = loop {
            let next = try_step(problem, &at, factor, &step);
            match next {
                Ok(p) if accepted(goal, met, &at, &p, &step) => break Some(p),
                // A pose out of reach or a force without value: a shorter step may do.
                _ if factor < 1e-4 => break None,
                _ => factor *= 0.5,
            }
            if met {
                // Polishing takes whole steps or none.
                break None;
            }
        };
        match next {
            Some(next) => {
                // A whole Newton step that does not move anything: the residual is rounding, also
                // where no force gives it a scale (a spring at its free length).
                tiny_step = full && answers && step.amax() <= 1e-10 && next.residual.norm() <= size;
                at = next;
                scale = scale.max(at.scale);
                polished += usize::from(met);
            }
            None => return Ok(finish(at, scale, iterations, met)),
        }
    }
}

fn finish(at: Point, scale: f64, iterations: usize, converged: bool) -> Solution {
    let size = at.residual.norm();
    Solution {
        unbalanced: at.unbalanced(),
        residual: if scale > 0.0 { size / scale } else { size },
        q: at.q,
        lambda: at.lambda,
        scale,
        iterations,
        converged,
    }
}

fn try_step(
    problem: &mut Problem<'_>,
    at: &Point,
    factor: f64,
    step: &DVector<f64>,
) -> Result<Point, AnalysisError> {
    let mut q = at.q.clone();
    problem.shift(&mut q, factor, step);
    problem.assemble(&mut q)?;
    Point::new(problem, q)
}

fn accepted(goal: Goal, met: bool, at: &Point, next: &Point, step: &DVector<f64>) -> bool {
    let (old, new) = (at.residual.norm(), next.residual.norm());
    if met {
        return new < 0.5 * old;
    }
    match goal {
        Goal::Any => new < old,
        // The forces must still do work along the step, or at its end oppose it less than they
        // drove it at its start: then more work was done than undone, without knowing a potential.
        Goal::Rest => {
            let work = at.unbalanced().dot(step);
            let end = next.unbalanced().dot(step);
            new < old || end >= -0.7 * work
        }
    }
}

/// Newton's step: K y = R, the least one where K is singular.
fn newton(
    problem: &Problem<'_>,
    k: &DMatrix<f64>,
    residual: &DVector<f64>,
) -> Result<DVector<f64>, AnalysisError> {
    least_squares(problem, k, residual, FLAT)
}

/// Solves a square or rectangular system by least squares; singular values below a part of the
/// largest count as zero.
pub(super) fn least_squares(
    problem: &Problem<'_>,
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    tolerance: f64,
) -> Result<DVector<f64>, AnalysisError> {
    let svd = Svd::new(a).map_err(|e| problem.rank_error(e))?;
    let rank = svd.rank(tolerance);
    let mut part = svd.u.columns(0, rank).transpose() * b;
    for (x, s) in part.iter_mut().zip(&svd.values) {
        *x /= s;
    }
    Ok(svd.v.columns(0, rank) * part)
}

/// A step along which the forces do work, of Newton's length in every principal direction of the
/// stiffness: it leaves saddles and maxima, and is Newton's own step where the pose is stable.
fn downhill(
    problem: &Problem<'_>,
    k: &DMatrix<f64>,
    residual: &DVector<f64>,
    scale: f64,
) -> Result<DVector<f64>, AnalysisError> {
    let (values, vectors) = super::stability::principal(problem, k)?;
    let largest = values.amax();
    let floor = FLAT * largest.max(scale);
    if values.iter().all(|h| *h > floor) {
        let step = newton(problem, k, residual)?;
        if step.dot(residual) > 0.0 {
            return Ok(step);
        }
    }
    let mut step = DVector::zeros(residual.len());
    for (j, h) in values.iter().enumerate() {
        let push = vectors.column(j).dot(residual);
        // Rounding in a flat direction moves nothing.
        if h.abs() <= floor && push.abs() <= 1e-12 * scale {
            continue;
        }
        let curvature = h.abs().max(floor).max(f64::MIN_POSITIVE);
        step.axpy(push / curvature, &vectors.column(j), 1.0);
    }
    Ok(step)
}
