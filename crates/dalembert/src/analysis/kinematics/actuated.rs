//! The forces of a known motion with other actuators.

use super::multipliers::solve_multipliers;
use crate::analysis::AnalysisError;
use crate::analysis::weights::Weights;
use crate::space::Planar;
use crate::system::{Role, State, System, Workspace};

/// The forces of a known motion in a machine with actuators instead of drivers.
pub(super) struct Actuated<'a> {
    pub(super) system: &'a System<Planar>,
    pub(super) ws: Workspace<Planar>,
    weights: Weights,
}

impl<'a> Actuated<'a> {
    pub(super) fn new(system: &'a System<Planar>) -> Self {
        Self {
            ws: Workspace::new(system),
            weights: Weights::even(system),
            system,
        }
    }

    pub(super) fn solve(&mut self, state: &State, a: &[f64]) -> Result<(), AnalysisError> {
        let (system, ws) = (self.system, &mut self.ws);
        system.update_markers(&state.q, &state.v, ws);
        system.evaluate_constraints(state.t, ws);
        system.evaluate_forces(state.t, ws);
        ws.factor(&self.weights.inverse);
        ws.a.copy_from_slice(a);
        let missing = solve_multipliers(system, ws, &self.weights);
        // The rows of the actuators do not hold a value: no violation to report.
        for e in system.elements.iter().filter(|e| e.role == Role::Driver) {
            ws.value[e.rows.clone()].fill(0.0);
            let rate: f64 = e
                .coordinates
                .iter()
                .map(|c| {
                    let (i, j) = (e.markers[c.measure.first], e.markers[c.measure.second]);
                    c.measure.kind.evaluate(&ws.markers[i], &ws.markers[j]).rate
                })
                .sum();
            // The recorder takes the power of a driver from C_t = -(rate).
            ws.time[e.rows.clone()].fill(-rate);
        }
        if missing <= 1e-8 {
            return Ok(());
        }
        let names: Vec<&str> = system
            .elements
            .iter()
            .filter(|e| e.role == Role::Driver)
            .map(|e| e.name.as_str())
            .collect();
        Err(AnalysisError::Singular {
            time: state.t,
            last: state.t,
            kind: "actuators without a grip",
            detail: format!(
                "{} cannot produce this motion in this pose; choose other joints",
                names.join(", ")
            ),
        })
    }
}
