//! From a rough estimate to a consistent pose and consistent velocities.

use super::AnalysisError;
use super::newton::{NewtonOptions, correct_positions, correct_velocities};
use super::weights::Weights;
use crate::space::Space;
use crate::system::{State, System, Workspace};

/// Assembly: moves the estimate as little as possible onto the constraints, drivers and initial
/// conditions at the start. The branch nearest to the estimate is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Assembly {
    /// Newton's options.
    pub newton: NewtonOptions,
}

/// How far the assembly moved a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// Body.
    pub body: String,
    /// Displacement of its centre of mass [m].
    pub distance: f64,
    /// Turn [rad].
    pub turn: f64,
}

/// What the assembly did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AssemblyReport {
    /// Newton iterations.
    pub iterations: usize,
    /// Bodies that were moved by more than rounding, the farthest first.
    pub moved: Vec<Moved>,
    /// Bodies whose given velocities were changed: velocity of the centre of mass [m/s], angular velocity [rad/s].
    pub velocities_changed: Vec<Moved>,
    /// Initial rates that could not all be met: what is left over, in words.
    pub velocity_conflict: Option<String>,
}

impl Assembly {
    /// Assembles a system (with the rows of all phases).
    ///
    /// # Errors
    /// The constraints contradict each other or cannot be reached from the estimate.
    pub fn run<S: Space>(
        &self,
        system: &System<S>,
    ) -> Result<(State, AssemblyReport), AnalysisError> {
        let mut state = system.estimate.clone();
        let mut report = AssemblyReport::default();
        let positions = system.start_positions();
        let mut ws = Workspace::new(&positions);
        let weights = Weights::new(&positions, &system.position_weight);
        let mut trial = Vec::new();
        let newton = match correct_positions(
            &positions,
            &mut ws,
            &mut state,
            &weights,
            &self.newton,
            &mut trial,
        ) {
            // A body of unknown angle turns first, but a turn reaches no farther than its arm: then
            // everything moves alike.
            Err(first @ AnalysisError::NotAssembled { .. }) if uneven(&system.position_weight) => {
                state = system.estimate.clone();
                correct_positions(
                    &positions,
                    &mut ws,
                    &mut state,
                    &Weights::even(&positions),
                    &self.newton,
                    &mut trial,
                )
                .map_err(|_| first)
            }
            other => other,
        }?;
        report.iterations = newton.iterations;
        report.moved = moved(system, &system.estimate.q, &state.q, 1e-9);

        let velocities = system.start_velocities();
        let mut ws = Workspace::new(&velocities);
        let weights = Weights::new(&velocities, &system.velocity_weight);
        // Twice: the second pass removes the rounding that a poor metric leaves.
        correct_velocities(&velocities, &mut ws, &mut state, &weights);
        correct_velocities(&velocities, &mut ws, &mut state, &weights);
        system_velocity_residual(&velocities, &mut ws, &state, &mut report);
        let mut changed = moved(system, &system.estimate.v, &state.v, 1e-9);
        // Velocities that the user did not give are found, not changed.
        changed.retain(|m| {
            system
                .bodies
                .iter()
                .position(|b| b.name == m.body)
                .is_some_and(|b| {
                    let w = &system.velocity_weight[b * S::NV..(b + 1) * S::NV];
                    (w[0] == 1.0 && m.distance > 0.0) || (w[S::NV - 1] == 1.0 && m.turn > 0.0)
                })
        });
        report.velocities_changed = changed;
        if let Some(k) = state.q.iter().chain(&state.v).position(|x| !x.is_finite()) {
            let n = state.q.len();
            let names = system.coordinate_names();
            return Err(AnalysisError::NotFinite {
                element: format!("the assembly of {}", names[k % n]),
                time: state.t,
            });
        }
        Ok((state, report))
    }
}

/// Are some coordinates better known than others?
fn uneven(knowledge: &[f64]) -> bool {
    knowledge.iter().any(|w| *w != knowledge[0])
}

fn system_velocity_residual<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    state: &State,
    report: &mut AssemblyReport,
) {
    system.update_markers(&state.q, &state.v, ws);
    system.evaluate_constraints(state.t, ws);
    let mut rate = vec![0.0; system.rows];
    system.jac_mul(ws, &state.v, &mut rate);
    for (r, t) in rate.iter_mut().zip(&ws.time) {
        *r += t;
    }
    let (worst, row) = system.largest(&rate);
    let speed = state.v.iter().fold(1.0_f64, |a, b| a.max(b.abs()));
    if worst > 1e-8 * speed {
        report.velocity_conflict = Some(format!(
            "the rates cannot all be met: {} is off by {:.3e} per second",
            system.row_name(row),
            rate[row].abs()
        ));
    }
}

fn moved<S: Space>(system: &System<S>, from: &[f64], to: &[f64], tolerance: f64) -> Vec<Moved> {
    let n = S::NV;
    let mut list: Vec<Moved> = system
        .bodies
        .iter()
        .enumerate()
        .map(|(b, body)| {
            let d = |k: usize| to[b * n + k] - from[b * n + k];
            Moved {
                body: body.name.clone(),
                distance: d(0).hypot(d(1)),
                turn: d(n - 1).abs(),
            }
        })
        .filter(|m| m.distance > tolerance * system.size || m.turn > tolerance)
        .collect();
    list.sort_by(|a, b| {
        (b.distance / system.size + b.turn).total_cmp(&(a.distance / system.size + a.turn))
    });
    list
}
