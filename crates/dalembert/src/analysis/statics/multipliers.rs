//! Route 2: Newton's method on the n + n_c equations C_q^T lambda = Q_e, C = 0 (Shabana 6.171, 6.179).

use super::motions::Motions;
use super::problem::{Problem, step_limit};
use super::reduced::least_squares;
use super::solution::Solution;
use crate::analysis::AnalysisError;
use crate::space::Space;
use nalgebra::{DMatrix, DVector};

/// Singular values below this part of the largest count as zero: redundant rows, neutral motions.
const SINGULAR: f64 = 1e-11;
/// Most steps after the tolerance is met that only remove rounding.
const POLISHING: usize = 6;

/// Residuals of both kinds: unbalanced forces over the force unit, then rows in their units.
fn residual<S: Space>(
    problem: &mut Problem<'_, S>,
    q: &[f64],
    lambda: &DVector<f64>,
    unit: f64,
) -> Result<DVector<f64>, AnalysisError> {
    problem.evaluate(q)?;
    let f = problem.unbalanced(lambda);
    let (n, m) = (f.len(), lambda.len());
    Ok(DVector::from_fn(n + m, |k, _| {
        if k < n {
            f[k] / unit
        } else {
            problem.ws.value[k - n] / problem.row_unit[k - n]
        }
    }))
}

/// Solves from a pose; the multipliers start by least squares.
pub(super) fn solve<S: Space>(
    problem: &mut Problem<'_, S>,
    start: &[f64],
    tolerance: f64,
    max_iterations: usize,
) -> Result<Solution, AnalysisError> {
    let mut q = start.to_vec();
    problem.evaluate(&q)?;
    let mut lambda = Motions::new(problem)?.multipliers(&problem.forces());
    let (n, m) = (problem.unit.len(), lambda.len());
    let mut way = DVector::zeros(n);
    let everything = DMatrix::identity(n, n);
    let mut scale = problem.force_scale();
    // Where no force acts at the start, the stiffness gives the unit of forces.
    let mut unit = scale;
    if unit == 0.0 {
        let k = problem.stiffness(&q, &lambda, &everything)?;
        unit = if k.amax() > 0.0 { k.amax() } else { 1.0 };
    }
    let mut r = residual(problem, &q, &lambda, unit)?;
    let (mut iterations, mut polished, mut tiny_step) = (0, 0, false);
    loop {
        let size = r.norm();
        let met = size * unit <= tolerance * scale || tiny_step;
        if size == 0.0 || (met && polished >= POLISHING) || iterations >= max_iterations {
            return finish(problem, q, way, scale, iterations, met || size == 0.0);
        }
        let k = problem.stiffness(&q, &lambda, &everything)?;
        problem.evaluate(&q)?;
        let c = problem.jacobian();
        let mut matrix = DMatrix::zeros(n + m, n + m);
        // d(residual): -K dq - C_q^T dlambda, and C_q dq. The multipliers count in force units.
        matrix.view_mut((0, 0), (n, n)).copy_from(&(-k / unit));
        matrix.view_mut((0, n), (n, m)).copy_from(&-c.transpose());
        matrix.view_mut((n, 0), (m, n)).copy_from(&c);
        let step = least_squares(problem, &matrix, &-&r, SINGULAR)?;
        let answers = (&matrix * &step + &r).norm() <= 1e-3 * size;
        let dq = step.rows(0, n).into_owned();
        let dl = step.rows(n, m) * unit;
        iterations += 1;
        let mut factor = step_limit(problem.system, &dq);
        let full = factor == 1.0;
        let next = loop {
            let mut trial = q.clone();
            problem.shift(&mut trial, factor, &dq);
            let multipliers = &lambda + &dl * factor;
            if let Ok(reached) = residual(problem, &trial, &multipliers, unit) {
                let wanted = if met { 0.5 } else { 1.0 };
                if reached.norm() < wanted * size {
                    break Some((trial, multipliers, reached));
                }
            }
            if met || factor < 1e-4 {
                break None;
            }
            factor *= 0.5;
        };
        let Some(next) = next else {
            return finish(problem, q, way, scale, iterations, met);
        };
        tiny_step = full && answers && dq.amax() <= 1e-10;
        way += problem.difference(&q, &next.0);
        (q, lambda, r) = next;
        scale = scale.max(problem.force_scale());
        polished += usize::from(met);
    }
}

/// The multipliers are reported by least squares as in the other route: with redundant constraints
/// Newton's method would leave whichever it came to.
fn finish<S: Space>(
    problem: &mut Problem<'_, S>,
    q: Vec<f64>,
    way: DVector<f64>,
    scale: f64,
    iterations: usize,
    converged: bool,
) -> Result<Solution, AnalysisError> {
    problem.evaluate(&q)?;
    let motions = Motions::new(problem)?;
    let force = problem.forces();
    let unbalanced = &motions.basis * (motions.basis.transpose() * &force);
    let size = unbalanced.norm();
    Ok(Solution {
        lambda: motions.multipliers(&force),
        residual: if scale > 0.0 { size / scale } else { size },
        unbalanced,
        scale,
        q,
        way,
        iterations,
        converged,
    })
}
