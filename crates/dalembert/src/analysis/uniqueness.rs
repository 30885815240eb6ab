//! Notes on what a user should know before trusting forces: masses that are missing, reactions that
//! the equations do not determine.

use super::Mobility;
use crate::space::Planar;
use crate::system::{State, System};

/// Machines with more coordinates than this are not ranked before every run.
const LIMIT: usize = 300;

/// What a user must know of the forces of a machine.
pub(super) fn notes(system: &System<Planar>, state: &State) -> Vec<String> {
    let mut notes = Vec::new();
    let without: Vec<&str> = system
        .bodies
        .iter()
        .enumerate()
        .filter(|(b, _)| system.mass[9 * b] == 0.0)
        .map(|(_, body)| body.name.as_str())
        .collect();
    if !without.is_empty() {
        notes.push(format!(
            "warning: no mass is given for {}: neither gravity nor inertia loads the machine there",
            without.join(", ")
        ));
    }
    notes.extend(not_unique(system, state));
    notes
}

fn not_unique(system: &System<Planar>, state: &State) -> Option<String> {
    if system.nv() > LIMIT {
        return None;
    }
    // Where no rank decision is possible the run itself reports why.
    let report = Mobility::default().run(system, state).ok()?;
    if report.reactions_not_unique.is_empty() {
        return None;
    }
    Some(format!(
        "warning: redundant constraints: the reactions of {} are not unique; one possible set is given",
        report.reactions_not_unique.join(", ")
    ))
}
