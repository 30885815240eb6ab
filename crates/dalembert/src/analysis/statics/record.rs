//! Equilibria as results.

use super::problem::Problem;
use super::{Equilibrium, Stability};
use crate::analysis::AnalysisError;
use crate::analysis::open_reactions::OpenReactions;
use crate::analysis::pulling::pulling_at_rest;
use crate::analysis::recorder::{Extra, Recorder, Recording};
use crate::results::{Channel, Results};
use crate::space::Space;
use crate::system::System;

/// One instant for each equilibrium.
pub(super) fn record<S: Space>(
    problem: &mut Problem<'_, S>,
    equilibria: &[Equilibrium],
    recording: Recording,
) -> Result<Results, AnalysisError> {
    let mut recorder = Recorder::new(true).writing(recording);
    let mut open = OpenReactions::default();
    let system = problem.system;
    for (k, e) in equilibria.iter().enumerate() {
        problem.evaluate(&e.q)?;
        problem.ws.a.fill(0.0);
        problem.ws.lambda.copy_from_slice(&e.multipliers);
        let state = crate::system::State {
            t: problem.time(),
            q: e.q.clone(),
            v: vec![0.0; system.nv()],
        };
        recorder.record(system, &problem.ws, &state, Extra::default());
        open.pose(&problem.not_unique(), || {
            format!("at equilibrium {}", k + 1)
        });
    }
    let mut results = recorder.into_results(&system.name, "statics");
    let mut put = |name: &str, unit: &str, meaning: &str, value: &dyn Fn(usize) -> f64| {
        results.channels.push(Channel {
            name: format!("equilibrium.{name}"),
            unit: unit.to_owned(),
            meaning: meaning.to_owned(),
            values: (0..equilibria.len()).map(value).collect(),
            gaps: false,
        });
    };
    put("number", "", "number of the equilibrium, from 1", &|k| {
        (k + 1) as f64
    });
    put(
        "stability",
        "",
        "1 stable, 0 neutral, -1 unstable",
        &|k| match equilibria[k].stability {
            Stability::Stable => 1.0,
            Stability::Neutral => 0.0,
            Stability::Unstable => -1.0,
        },
    );
    put(
        "distance",
        "",
        "distance from the estimate: displacement relative to the size, or turn [rad]",
        &|k| equilibria[k].distance,
    );
    let first = &equilibria[0];
    results
        .statistics
        .insert("iterations".to_owned(), first.iterations as f64);
    results
        .statistics
        .insert("residual".to_owned(), first.residual);
    results.notes.extend(open.notes());
    results.notes.extend(pulling_at_rest(system, &results));
    results.notes.extend(flutter(system, equilibria));
    Ok(results)
}

/// Which equilibria are not judged by their stiffness alone.
fn flutter<S: Space>(system: &System<S>, equilibria: &[Equilibrium]) -> Option<String> {
    let numbers: Vec<String> = (1..)
        .zip(equilibria)
        .filter(|(_, e)| !e.conservative)
        .map(|(number, _)| number.to_string())
        .collect();
    let (which, whose) = match numbers.as_slice() {
        [] => return None,
        [one] => (format!("equilibrium {one}"), "its"),
        [most @ .., last] => (
            format!("equilibria {} and {last}", most.join(", ")),
            "their",
        ),
    };
    // The reactions of such constraints do no work in a motion, yet bend the balance as a force without potential does.
    let why = if system.velocity_rows().is_empty() {
        "forces without potential act"
    } else {
        "rolling or blades, or forces without potential, make the stiffness unsymmetric"
    };
    Some(format!(
        "{which}: {why}; {whose} stiffness alone does not exclude flutter"
    ))
}
