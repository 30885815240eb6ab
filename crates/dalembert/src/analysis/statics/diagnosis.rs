//! Why there is no equilibrium.

use super::motions::Motions;
use super::problem::Problem;
use super::solution::Solution;
use super::stability::{in_words, principal};
use crate::analysis::AnalysisError;
use crate::space::Space;
use nalgebra::DVector;
use std::f64::consts::PI;

/// Says what remained at the end of the run from the estimate, and why.
pub(super) fn none<S: Space>(
    problem: &mut Problem<'_, S>,
    last: &Solution,
    starts: usize,
) -> AnalysisError {
    let (coordinate, residual) = largest(problem, &last.unbalanced);
    let reason = reason(problem, last, &coordinate).unwrap_or_else(|| {
        format!(
            "{} did not lead to one; give another estimate, or check the loads",
            crate::words::counted(starts, "start")
        )
    });
    AnalysisError::NoEquilibrium {
        coordinate,
        residual,
        reason,
    }
}

/// The coordinate with the largest unbalanced force, and that force in its own unit.
pub(super) fn largest<S: Space>(
    problem: &Problem<'_, S>,
    unbalanced: &DVector<f64>,
) -> (String, f64) {
    let names = problem.system.coordinate_names();
    let k = unbalanced.iamax();
    match names.get(k) {
        Some(name) => (name.clone(), (unbalanced[k] / problem.unit[k]).abs()),
        None => (String::new(), 0.0),
    }
}

fn reason<S: Space>(
    problem: &mut Problem<'_, S>,
    last: &Solution,
    coordinate: &str,
) -> Option<String> {
    problem.evaluate(&last.q).ok()?;
    let motions = Motions::new(problem).ok()?;
    let scale = problem.force_scale();
    let k = problem
        .stiffness(&last.q, &last.lambda, &motions.basis)
        .ok()?;
    let k = motions.basis.transpose() * k;
    let (values, vectors) = principal(problem, &k).ok()?;
    let flat = 1e-7 * scale + 1e-9 * values.amax();
    problem.evaluate(&last.q).ok()?;
    for (j, h) in values.iter().enumerate() {
        let motion = &motions.basis * vectors.column(j);
        let push = motion.dot(&last.unbalanced);
        if h.abs() <= flat && push.abs() > 1e-9 * scale {
            return Some(format!(
                "nothing holds {coordinate}: a constant force acts on a free motion ({})",
                in_words(problem, &motion)
            ));
        }
    }
    let bodies = &problem.system.bodies;
    let way = problem.moves_and_turns(&last.way);
    let turned = |b: usize| way[b][1];
    let most = (0..bodies.len()).max_by(|a, b| turned(*a).total_cmp(&turned(*b)))?;
    if turned(most) > 2.0 * PI {
        return Some(format!(
            "the loads turn {} round and round: no pose balances them",
            bodies[most].name
        ));
    }
    let moved = |b: usize| way[b][0];
    let most = (0..bodies.len()).max_by(|a, b| moved(*a).total_cmp(&moved(*b)))?;
    if moved(most) > 20.0 {
        return Some(format!(
            "the loads drive {} away: nothing holds it",
            bodies[most].name
        ));
    }
    None
}
