//! Route 1: Newton's method on B^T Q_e = 0 in the free motions (Shabana 6.176).

use super::motions::Motions;
use super::problem::{Problem, step_limit};
use super::solution::{Goal, Solution};
use crate::analysis::AnalysisError;
use crate::solve::rank::Svd;
use crate::space::Space;
use faer::Mat;
use faer::linalg::solvers::DenseSolveCore;
use nalgebra::{DMatrix, DVector};

/// Curvatures below this part of the largest are treated as flat.
const FLAT: f64 = 1e-9;
/// Most steps after the tolerance is met that only remove rounding.
const POLISHING: usize = 6;

/// What is known at a pose on the constraints.
struct Point {
    q: Vec<f64>,
    /// From the start.
    way: DVector<f64>,
    lambda: DVector<f64>,
    /// Unbalanced force in the free motions, in scaled coordinates.
    unbalanced: DVector<f64>,
    scale: f64,
}

impl Point {
    fn new<S: Space>(
        problem: &mut Problem<'_, S>,
        q: Vec<f64>,
        way: DVector<f64>,
    ) -> Result<Self, AnalysisError> {
        problem.evaluate(&q)?;
        let (lambda, unbalanced) = match problem.balance() {
            Some(found) => found,
            None => {
                let motions = Motions::new(problem)?;
                let force = problem.forces();
                let unbalanced = &motions.basis * motions.basis.tr_mul(&force);
                (motions.multipliers(&force), unbalanced)
            }
        };
        Ok(Self {
            scale: problem.force_scale(),
            lambda,
            unbalanced,
            q,
            way,
        })
    }
}

/// Solves from a pose on the constraints.
///
/// [`Goal::Rest`] follows the forces downhill, so that it ends where the machine comes to rest;
/// [`Goal::Any`] takes Newton's steps to whichever equilibrium is near.
pub(super) fn solve<S: Space>(
    problem: &mut Problem<'_, S>,
    start: &[f64],
    goal: Goal,
    tolerance: f64,
    max_iterations: usize,
) -> Result<Solution, AnalysisError> {
    let mut at = Point::new(problem, start.to_vec(), DVector::zeros(problem.unit.len()))?;
    let mut scale = at.scale;
    let (mut iterations, mut polished, mut tiny_step) = (0, 0, false);
    loop {
        let size = at.unbalanced.norm();
        let met = size <= tolerance * scale || tiny_step;
        if size == 0.0 || (met && polished >= POLISHING) || iterations >= max_iterations {
            return Ok(finish(at, scale, iterations, met || size == 0.0));
        }
        problem.evaluate(&at.q)?;
        let basis = Motions::new(problem)?.basis;
        let residual = basis.tr_mul(&at.unbalanced);
        let k = problem.stiffness(&at.q, &at.lambda, &basis)?;
        let k = basis.transpose() * k;
        let step = match goal {
            _ if met => newton(problem, &k, &residual)?,
            Goal::Any => newton(problem, &k, &residual)?,
            Goal::Rest => downhill(problem, &k, &residual, scale)?,
        };
        // A singular stiffness that cannot answer the force gives a small step as well.
        let answers = (&k * &step - &residual).norm() <= 1e-3 * residual.norm();
        let step = &basis * step;
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
                tiny_step =
                    full && answers && step.amax() <= 1e-10 && next.unbalanced.norm() <= size;
                at = next;
                scale = scale.max(at.scale);
                polished += usize::from(met);
            }
            None => return Ok(finish(at, scale, iterations, met)),
        }
    }
}

fn finish(at: Point, scale: f64, iterations: usize, converged: bool) -> Solution {
    let size = at.unbalanced.norm();
    Solution {
        unbalanced: at.unbalanced,
        residual: if scale > 0.0 { size / scale } else { size },
        q: at.q,
        way: at.way,
        lambda: at.lambda,
        scale,
        iterations,
        converged,
    }
}

fn try_step<S: Space>(
    problem: &mut Problem<'_, S>,
    at: &Point,
    factor: f64,
    step: &DVector<f64>,
) -> Result<Point, AnalysisError> {
    let mut q = at.q.clone();
    problem.shift(&mut q, factor, step);
    problem.assemble(&mut q)?;
    let way = &at.way + problem.difference(&at.q, &q);
    Point::new(problem, q, way)
}

fn accepted(goal: Goal, met: bool, at: &Point, next: &Point, step: &DVector<f64>) -> bool {
    let (old, new) = (at.unbalanced.norm(), next.unbalanced.norm());
    if met {
        return new < 0.5 * old;
    }
    match goal {
        Goal::Any => new < old,
        // The forces must still do work along the step, or at its end oppose it less than they
        // drove it at its start: then more work was done than undone, without knowing a potential.
        Goal::Rest => {
            let work = at.unbalanced.dot(step);
            let end = next.unbalanced.dot(step);
            new < old || end >= -0.7 * work
        }
    }
}

/// Newton's step: K y = R, the least one where K is singular.
fn newton<S: Space>(
    problem: &Problem<'_, S>,
    k: &DMatrix<f64>,
    residual: &DVector<f64>,
) -> Result<DVector<f64>, AnalysisError> {
    least_squares(problem, k, residual, FLAT)
}

/// Solves a square or rectangular system by least squares; singular values below a part of the
/// largest count as zero.
pub(super) fn least_squares<S: Space>(
    problem: &Problem<'_, S>,
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    tolerance: f64,
) -> Result<DVector<f64>, AnalysisError> {
    if let Some(x) = regular(a, b, tolerance) {
        return Ok(x);
    }
    let svd = Svd::new(a).map_err(|e| problem.rank_error(e))?;
    let rank = svd.rank(tolerance);
    let mut part = svd.u.columns(0, rank).transpose() * b;
    for (x, s) in part.iter_mut().zip(&svd.values) {
        *x /= s;
    }
    Ok(svd.v.columns(0, rank) * part)
}

/// Solves a square system by elimination, several times faster than by singular values, where the
/// smallest of these, which is not below 1 / |A^-1|, is far from zero.
fn regular(a: &DMatrix<f64>, b: &DVector<f64>, tolerance: f64) -> Option<DVector<f64>> {
    let n = a.nrows();
    if n == 0 || n != a.ncols() || a.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let inverse = Mat::from_fn(n, n, |i, j| a[(i, j)])
        .partial_piv_lu()
        .inverse();
    let inverse = DMatrix::from_fn(n, n, |i, j| inverse[(i, j)]);
    // A comparison that is false for NaN.
    let far = inverse.norm() * a.norm() < 0.1 / tolerance;
    if !far {
        return None;
    }
    let mut x = &inverse * b;
    // The inverse has lost some digits; once is enough for those.
    x += &inverse * (b - a * &x);
    Some(x)
}

/// A step along which the forces do work, of Newton's length in every principal direction of the
/// stiffness: it leaves saddles and maxima, and is Newton's own step where the pose is stable.
fn downhill<S: Space>(
    problem: &Problem<'_, S>,
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
