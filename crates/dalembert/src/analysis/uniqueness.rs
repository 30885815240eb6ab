//! Notes on reactions that the equations do not determine.

use super::Mobility;
use crate::space::Planar;
use crate::system::{State, System};

/// Machines with more coordinates than this are not ranked before every run.
const LIMIT: usize = 300;

/// What a user must know of the reactions of a machine with redundant constraints.
pub(super) fn notes(system: &System<Planar>, state: &State) -> Vec<String> {
    if system.nv() > LIMIT {
        return Vec::new();
    }
    // Where no rank decision is possible the run itself reports why.
    let Ok(report) = Mobility::default().run(system, state) else {
        return Vec::new();
    };
    if report.reactions_not_unique.is_empty() {
        return Vec::new();
    }
    vec![format!(
        "warning: redundant constraints: the reactions of {} are not unique; the least ones are given",
        report.reactions_not_unique.join(", ")
    )]
}
