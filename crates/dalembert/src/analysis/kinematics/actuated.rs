//! The forces of a known motion with other actuators.

use super::multipliers::solve_multipliers;
use super::runner::{DENSE, RECHOOSE};
use super::watch::{Watch, scaled_jacobian};
use crate::analysis::AnalysisError;
use crate::analysis::weights::Weights;
use crate::joint::MeasureKind;
use crate::space::Space;
use crate::system::{State, System, Workspace};
use crate::words::listed;

/// The forces of a known motion in a machine with actuators instead of drivers.
pub(super) struct Actuated<'a, S: Space> {
    pub(super) system: &'a System<S>,
    pub(super) ws: Workspace<S>,
    weights: Weights,
    watch: Watch,
    /// Last instant whose efforts are known.
    last: f64,
}

impl<'a, S: Space> Actuated<'a, S> {
    pub(super) fn new(system: &'a System<S>) -> Self {
        Self {
            ws: Workspace::new(system),
            weights: Weights::even(system),
            watch: Watch::none(),
            last: 0.0,
            system,
        }
    }

    /// Looks for a pose, since the last look, in which the actuators have no grip: there their efforts are infinite.
    /// Machines with many coordinates are not watched.
    pub(super) fn look(&mut self, state: &State) -> Result<(), AnalysisError> {
        let (system, ws) = (self.system, &mut self.ws);
        if system.nv() > DENSE {
            return Ok(());
        }
        system.update_markers(&state.q, &state.v, ws);
        system.evaluate_constraints(state.t, ws);
        let c = scaled_jacobian(system, ws);
        let before = self.watch.sign;
        if before == 0.0 || self.watch.rows.len() != c.ncols() {
            self.watch = Watch::new(&c);
        } else {
            self.watch.look(&c);
            if self.watch.smallest < RECHOOSE && c.nrows() > c.ncols() {
                // Other rows may hold what these let go; the sign starts anew.
                self.watch = Watch::new(&c);
            } else if before * self.watch.sign < 0.0 {
                return Err(AnalysisError::Singular {
                    time: state.t,
                    last: self.last,
                    kind: "actuators without a grip",
                    detail: format!(
                        "on the way to this pose {} had no grip on the motion, and the effort that it takes had no bound; end the motion before, or choose other joints",
                        self.names()
                    ),
                });
            }
        }
        Ok(())
    }

    fn names(&self) -> String {
        let names: Vec<&str> = self.system.drivers().map(|e| e.name.as_str()).collect();
        listed(&names)
    }

    pub(super) fn solve(&mut self, state: &State, a: &[f64]) -> Result<(), AnalysisError> {
        if self.watch.sign == 0.0 {
            self.look(state)?;
        }
        let (system, ws) = (self.system, &mut self.ws);
        system.update_markers(&state.q, &state.v, ws);
        system.evaluate_constraints(state.t, ws);
        system.evaluate_forces(state.t, ws);
        ws.factor(&self.weights.inverse);
        ws.a.copy_from_slice(a);
        let missing = solve_multipliers(system, ws, &self.weights);
        // The rows of the actuators do not hold a value: no violation to report.
        for e in system.drivers() {
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
            self.last = state.t;
            return Ok(());
        }
        Err(AnalysisError::Singular {
            time: state.t,
            last: state.t,
            kind: "actuators without a grip",
            detail: format!(
                "{} cannot produce this motion in this pose; choose other joints",
                self.names()
            ),
        })
    }
}
