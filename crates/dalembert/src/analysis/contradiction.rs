//! Redundant rows that part ways on the way.

use super::AnalysisError;
use super::mobility::conflicts;
use super::weights::Weights;
use crate::space::Space;
use crate::system::{State, System, Workspace};

/// Parts of the time left at which the rows are looked at, the nearest first.
const AHEAD: [f64; 4] = [1e-3, 1e-2, 1e-1, 1.0];

/// The error behind a run that stopped after a good state, where it is a contradiction: rows that depend on each other
/// in this pose, several drivers among them, ask for different motions from here on.
pub(super) fn contradiction<S: Space>(
    system: &System<S>,
    good: &State,
    end: f64,
) -> Option<AnalysisError> {
    if !dependent(system, good) {
        return None;
    }
    AHEAD.into_iter().find_map(|part| {
        let h = part * (end - good.t);
        let mut ahead = good.clone();
        ahead.t += h;
        system.advance(&mut ahead.q, h, &good.v);
        conflicts(system, &ahead)
            .ok()?
            .into_iter()
            .find_map(|found| {
                let all = [&found.elements[..], &found.through].concat();
                let among = |e: &crate::system::ElementData<S>| all.contains(&e.name);
                // In the order of the model.
                let names = system.elements.iter().filter(|e| among(e));
                let names: Vec<&str> = names.map(|e| e.name.as_str()).collect();
                // One driver alone is at a dead centre, where its rows depend on the joints' in this pose only.
                let driven = system.drivers().filter(|e| among(e)).count() > 1;
                let own = system.with_elements(|e| among(e) || !e.aux.is_empty());
                (driven && dependent(&own, good)).then(|| AnalysisError::Contradiction {
                    time: good.t,
                    elements: crate::words::listed(&names),
                })
            })
    })
}

/// Are the rows dependent at a state?
fn dependent<S: Space>(system: &System<S>, state: &State) -> bool {
    let mut ws = Workspace::new(system);
    system.update_markers(&state.q, &state.v, &mut ws);
    system.evaluate_constraints(state.t, &mut ws);
    let weights = Weights::even(system);
    !ws.factor(&weights.inverse).vanished.is_empty()
}
