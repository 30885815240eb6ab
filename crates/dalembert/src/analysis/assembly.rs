//! From a rough estimate to a consistent pose and consistent velocities.

use super::aligned::align;
use super::newton::{NewtonOptions, correct_positions, correct_velocities};
use super::sides::right_sides;
use super::weights::Weights;
use super::{AnalysisError, ChangedRate};
use crate::formulation::column_scale;
use crate::joint::RowUnit;
use crate::space::{Space, Tuple, norm};
use crate::system::Phase;
use crate::system::{State, System, Workspace};
use std::f64::consts::PI;

/// Part of the fastest rate up to which a rate counts as met.
const RATE: f64 = 1e-8;

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
    /// Stated rates that could not stay.
    pub rates_changed: Vec<ChangedRate>,
    /// Rates of constraints and drivers that could not all be met: what is left over, in words.
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
        let mut report = AssemblyReport::default();
        let positions = system.start_positions();
        let mut ws = Workspace::new(&positions);
        let weights = Weights::new(&positions, &system.position_weight);
        let mut trial = Vec::new();
        let mut solve = |start: &mut State, weights: &Weights| {
            let found = correct_positions(
                &positions,
                &mut ws,
                start,
                weights,
                &self.newton,
                &mut trial,
            )?;
            right_sides(&positions, &mut ws, start)?;
            Ok(found)
        };
        let mut estimate = system.estimate.clone();
        move_apart(&positions, &mut estimate.q);
        let mut state = estimate.clone();
        let mut newton = solve(&mut state, &weights);
        if matches!(
            newton,
            Err(AnalysisError::NotAssembled { .. } | AnalysisError::WrongSide { .. })
        ) {
            let mut start = estimate.clone();
            if align(&positions, &mut Workspace::new(&positions), &mut start.q)
                && let Ok(found) = solve(&mut start, &weights)
            {
                (state, newton) = (start, Ok(found));
            }
        }
        if misplaced(&newton) {
            // Bodies that turned where they should have come nearer: they move first, and turn hardly.
            let mut start = estimate.clone();
            let moving = Weights::moving(&positions, &system.position_weight);
            if let Ok(found) = solve(&mut start, &moving) {
                (state, newton) = (start, Ok(found));
            }
        }
        if misplaced(&newton) || matches!(newton, Err(AnalysisError::NotAssembled { .. })) {
            // A body of unknown angle turns first, but a turn reaches no farther than its arm: then everything moves
            // alike. And where bodies stand in a line, or surfaces at right angles, no small motion is better than its
            // opposite: then from beside it.
            let even = Weights::even(&positions);
            for attempt in 0..=ATTEMPTS {
                if attempt == 0 && !uneven(&system.position_weight) {
                    continue;
                }
                let mut start = estimate.clone();
                beside(system, &mut start.q, attempt);
                if let Ok(found) = solve(&mut start, &even) {
                    (state, newton) = (start, Ok(found));
                    break;
                }
            }
        }
        let newton = newton?;
        report.iterations = newton.iterations;
        report.moved = moved(system, &system.estimate.q, &state.q, 1e-9);

        self.velocities(system, &mut state, &mut report)?;
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

    /// The velocities nearest to the stated ones that meet the rows of the start; where these
    /// contradict each other, the rows that always hold go first.
    fn velocities<S: Space>(
        &self,
        system: &System<S>,
        state: &mut State,
        report: &mut AssemblyReport,
    ) -> Result<(), AnalysisError> {
        let mut broken = Vec::new();
        let all = system.start_velocities();
        let mut ws = Workspace::new(&all);
        let weights = Weights::new(&all, &system.velocity_weight);
        settle_velocities(&all, &mut ws, state, &weights);
        let mut left = rates_left(&all, &mut ws, state);
        // Stated rates that nothing can follow are fast as well.
        let stated = all.largest(&ws.time).0;
        let speed = fastest(&all, &state.v).max(fastest(&all, &system.estimate.v));
        let zero = RATE * speed.max(stated);
        if all.largest(&left).0 > zero {
            let running = system.running();
            let mut ws = Workspace::new(&running);
            let weights = Weights::new(&running, &system.velocity_weight);
            settle_velocities(&running, &mut ws, state, &weights);
        }
        left = rates_left(&all, &mut ws, state);
        for (row, r) in left.iter().enumerate() {
            let e = &all.elements[all.row_refs()[row].element];
            if r.abs() / all.row_scale(row) <= zero {
                continue;
            }
            if e.phase == Phase::StartVelocity {
                // The row reads measure' - stated = 0, so that C_t = -stated.
                let stated = -ws.time[row];
                broken.push(ChangedRate {
                    what: format!("the {}", e.name),
                    stated: vec![stated],
                    found: vec![stated + r],
                    unit: match all.row_refs()[row].label.unit {
                        RowUnit::Length => "m/s",
                        RowUnit::Angle => "rad/s",
                        RowUnit::Other => "",
                    },
                });
            } else if report.velocity_conflict.is_none() {
                report.velocity_conflict = Some(format!(
                    "the constraints and drivers contradict each other in their rates: {} is off by {:.3e} per second",
                    all.row_name(row),
                    r.abs()
                ));
            }
        }
        changed_velocities(system, &state.v, zero, report);
        if broken.is_empty() {
            return Ok(());
        }
        let conflicts: Vec<String> = broken.iter().map(ChangedRate::conflict).collect();
        Err(AnalysisError::InitialRates {
            time: state.t,
            conflicts: conflicts.join("; "),
        })
    }
}

/// Did surfaces come together at places where they cannot touch?
fn misplaced<T>(found: &Result<T, AnalysisError>) -> bool {
    matches!(
        found,
        Err(AnalysisError::WrongSurface { .. }
            | AnalysisError::SurfacePole { .. }
            | AnalysisError::CrossingSurfaces { .. })
    )
}

/// Moves bodies out of each other's centres where any direction is as good as another: along gravity.
fn move_apart<S: Space>(system: &System<S>, q: &mut [f64]) {
    let mut ws = Workspace::new(system);
    system.update_markers(q, &vec![0.0; system.nv()], &mut ws);
    let mut down = system.gravity.clone();
    let length = norm(&down);
    if length > 0.0 {
        down.iter_mut().for_each(|g| *g /= length);
    } else {
        down[S::LINEAR - 1] = -1.0;
    }
    let mut step = vec![0.0; system.nv()];
    for e in &system.elements {
        let Some(distance) = e.element.apart() else {
            continue;
        };
        let [one, two] = [e.markers[0], e.markers[1]];
        let [p, r] = [one, two].map(|m| S::point(&ws.markers[m]));
        let between: Vec<f64> = p.iter().zip(&r).map(|(p, r)| r - p).collect();
        if norm(&between) > COINCIDENT * distance {
            continue;
        }
        // The second body falls, or the first where the second is the ground.
        let falling = system.markers[two].body.or(system.markers[one].body);
        if let Some(b) = falling {
            for (k, d) in down.iter().enumerate() {
                step[b * S::NV + k] = distance * d;
            }
        }
    }
    if step.iter().any(|x| *x != 0.0) {
        system.advance(q, 1.0, &step);
    }
}

/// Part of the distance at which centres have no direction from one to the other.
const COINCIDENT: f64 = 1e-6;

/// Passes of the velocities: each leaves a ten-thousandth of what the one before left.
const PASSES: usize = 4;

/// Meets the rows of a system with the stated velocities as they are, as far as they can stay.
///
/// What is stated counts more than what is not, but not infinitely more: each pass starts from what is stated beside what
/// the last one found for the rest.
fn settle_velocities<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    state: &mut State,
    weights: &Weights,
) {
    for _ in 0..PASSES {
        state_rates(system, state);
        correct_velocities(system, ws, state, weights);
    }
    // The last pass removes the rounding that a poor metric leaves.
    correct_velocities(system, ws, state, weights);
}

/// Brings stated velocities back where there are others that nobody stated.
fn state_rates<S: Space>(system: &System<S>, state: &mut State) {
    let stated = system.velocity_weight.iter().zip(&system.estimate.v);
    for (v, (weight, estimate)) in state.v.iter_mut().zip(stated) {
        if *weight == 1.0 {
            *v = *estimate;
        }
    }
}

/// Estimates beside the user's that are tried, the nearest first.
const ATTEMPTS: usize = 6;

/// Turns the bodies of an estimate a little, each by another angle and to alternating sides.
fn beside<S: Space>(system: &System<S>, q: &mut [f64], attempt: usize) {
    let mut step = vec![0.0; system.nv()];
    let size = 0.05 * attempt as f64;
    for b in 0..system.bodies.len() {
        for k in S::LINEAR..S::NV {
            let place = b * S::NV + k + 7 * attempt;
            // No special angles: golden parts of a turn repeat nowhere.
            step[b * S::NV + k] = size * (place as f64 * 0.618_033_988_749_895 * 2.0 * PI).cos();
        }
    }
    system.advance(q, 1.0, &step);
}

/// Are some coordinates better known than others?
fn uneven(knowledge: &[f64]) -> bool {
    knowledge.iter().any(|w| *w != knowledge[0])
}

/// Velocities of bodies that were stated and could not stay; those that were not are found, not changed.
fn changed_velocities<S: Space>(
    system: &System<S>,
    found: &[f64],
    zero: f64,
    report: &mut AssemblyReport,
) {
    let n = S::NV;
    let linear = S::LINEAR;
    for (b, body) in system.bodies.iter().enumerate() {
        let own = |x: &[f64], part: std::ops::Range<usize>| {
            x[b * n + part.start..b * n + part.end].to_vec()
        };
        let parts = [
            (
                0..linear,
                "velocity",
                " (centre of mass)",
                "m/s",
                system.size,
            ),
            (linear..n, "angular velocity", "", "rad/s", 1.0),
        ];
        for (part, quantity, point, unit, scale) in parts {
            let given = own(&system.velocity_weight, part.clone());
            let (stated, found) = (own(&system.estimate.v, part.clone()), own(found, part));
            let difference = stated.iter().zip(&found);
            let difference = difference.fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
            if given[0] == 1.0 && difference > zero * scale {
                report.rates_changed.push(ChangedRate {
                    what: format!("the {quantity} of {}{point}", body.name),
                    stated,
                    found,
                    unit,
                });
            }
        }
    }
}

/// What is left of the rates of the rows: C_q v + C_t. The workspace then holds the rows.
fn rates_left<S: Space>(system: &System<S>, ws: &mut Workspace<S>, state: &State) -> Vec<f64> {
    system.update_markers(&state.q, &state.v, ws);
    system.evaluate_constraints(state.t, ws);
    let mut rate = vec![0.0; system.rows];
    system.jac_mul(ws, &state.v, &mut rate);
    for (r, t) in rate.iter_mut().zip(&ws.time) {
        *r += t;
    }
    rate
}

/// The fastest rate of a state, lengths relative to the machine's size [1/s].
fn fastest<S: Space>(system: &System<S>, v: &[f64]) -> f64 {
    let scale = column_scale(system);
    let rates = v.iter().zip(&scale);
    rates.fold(0.0, |m, (v, s)| m.max((v / s).abs()))
}

fn moved<S: Space>(system: &System<S>, from: &[f64], to: &[f64], tolerance: f64) -> Vec<Moved> {
    let mut step = S::Twist::zero();
    let mut list: Vec<Moved> = system
        .bodies
        .iter()
        .enumerate()
        .map(|(b, body)| {
            let own = b * S::NQ..(b + 1) * S::NQ;
            S::difference(&from[own.clone()], &to[own], step.as_mut_slice());
            let (linear, angular) = step.as_slice().split_at(S::LINEAR);
            Moved {
                body: body.name.clone(),
                distance: norm(linear),
                turn: norm(angular),
            }
        })
        .filter(|m| m.distance > tolerance * system.size || m.turn > tolerance)
        .collect();
    list.sort_by(|a, b| {
        (b.distance / system.size + b.turn).total_cmp(&(a.distance / system.size + a.turn))
    });
    list
}
