//! Newton's method on the position constraints, with step control and a diagnosis.

use super::AnalysisError;
use super::weights::Weights;
use crate::joint::RowUnit;
use crate::space::Space;
use crate::system::compile::Options;
use crate::system::{State, System, Workspace};

/// When Newton's method stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewtonOptions {
    /// Most iterations.
    pub max_iterations: usize,
    /// Residual in units of the row scales that counts as zero.
    pub tolerance: f64,
}

impl Default for NewtonOptions {
    fn default() -> Self {
        // The residual of a position sum of a few terms of unit size is good to some 1e-16; four
        // more digits leave room for long chains.
        Self {
            max_iterations: 50,
            tolerance: 1e-13,
        }
    }
}

impl NewtonOptions {
    /// With the options of a compiled model.
    pub fn of(options: &Options) -> Self {
        Self {
            max_iterations: options.max_iterations,
            ..Self::default()
        }
    }
}

/// What Newton's method did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NewtonReport {
    /// Iterations (factorizations).
    pub iterations: usize,
    /// Residual at the end, in units of the row scales.
    pub residual: f64,
}

/// A residual at which stagnation still counts as success: rounding of large machines.
const STAGNATION: f64 = 1e-10;
/// Largest turn of a body in one iteration [rad]: beyond it the linear model means nothing.
const LARGEST_TURN: f64 = 0.5;

/// Moves `state.q` onto C(q, t) = 0, as little as possible in the metric of the weights
/// (Shabana 3.109 to 3.117; for a machine with freedoms the least-change solution).
pub(super) fn correct_positions<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    state: &mut State,
    weights: &Weights,
    options: &NewtonOptions,
    trial: &mut Vec<f64>,
) -> Result<NewtonReport, AnalysisError> {
    let mut report = NewtonReport::default();
    let mut limited = 0;
    trial.clear();
    trial.extend_from_slice(&state.q);
    system.update_markers(&state.q, &state.v, ws);
    system.evaluate_positions(state.t, ws);
    report.residual = system.violation(ws).0;
    let tolerance = options.tolerance.max(system.rounding(&state.q));
    while report.residual > tolerance {
        // Steps on the way around many turns are not counted as long as they come nearer by what they may.
        let counted = report.iterations - limited;
        if counted >= options.max_iterations || !report.residual.is_finite() {
            return fail(system, ws, state, report);
        }
        ws.factor(&weights.inverse);
        for (r, c) in ws.rhs.iter_mut().zip(&ws.value) {
            *r = -c;
        }
        ws.solve(&weights.blocks, &weights.zero);
        report.iterations += 1;
        let turn = largest_turn(system, &ws.a, system.size + 0.5 * farthest(system, ws));
        if !turn.is_finite() {
            return fail(system, ws, state, report);
        }
        let mut factor = 1.0;
        if turn > LARGEST_TURN {
            factor = LARGEST_TURN / turn;
        }
        let step = std::mem::take(&mut ws.a);
        // Step control: halve until the largest residual falls; a full step may also raise it
        // a little on the way around a bend.
        let mut halvings = 0;
        let reached = loop {
            trial.copy_from_slice(&state.q);
            system.advance(trial, factor, &step);
            system.update_markers(trial, &state.v, ws);
            system.evaluate_positions(state.t, ws);
            let residual = system.violation(ws).0;
            if residual < report.residual || halvings >= 12 {
                break residual;
            }
            halvings += 1;
            factor *= 0.5;
        };
        ws.a = step;
        if turn > LARGEST_TURN && report.residual - reached > 0.5 * LARGEST_TURN {
            limited += 1;
        }
        if reached.is_nan() || reached >= report.residual {
            if report.residual <= tolerance.max(STAGNATION) {
                system.update_markers(&state.q, &state.v, ws);
                system.evaluate_positions(state.t, ws);
                break;
            }
            if reached.is_nan() || reached >= 2.0 * report.residual || report.residual < 1e-6 {
                system.update_markers(&state.q, &state.v, ws);
                system.evaluate_positions(state.t, ws);
                return fail(system, ws, state, report);
            }
        }
        state.q.copy_from_slice(trial);
        report.residual = reached;
    }
    Ok(report)
}

/// The largest residual of a length [m]: bodies far away come in steps of that size.
fn farthest<S: Space>(system: &System<S>, ws: &Workspace<S>) -> f64 {
    let rows = system.row_refs().iter().zip(&ws.value);
    let lengths = rows.filter(|(row, _)| row.label.unit == RowUnit::Length);
    lengths.fold(0.0, |most: f64, (_, c)| most.max(c.abs()))
}

/// Largest turn in a step; a way counts as one on an arm of four times `size`.
fn largest_turn<S: Space>(system: &System<S>, step: &[f64], size: f64) -> f64 {
    let n = S::NV;
    let linear = S::LINEAR;
    let mut worst: f64 = 0.0;
    for b in 0..system.bodies.len() {
        for k in 0..n {
            let x = step[b * n + k].abs();
            let scaled = if k < linear { x / (4.0 * size) } else { x };
            // max() would drop a NaN.
            if scaled.is_nan() {
                return scaled;
            }
            worst = worst.max(scaled);
        }
    }
    worst
}

fn fail<S: Space>(
    system: &System<S>,
    ws: &Workspace<S>,
    state: &State,
    report: NewtonReport,
) -> Result<NewtonReport, AnalysisError> {
    let (_, row) = system.violation(ws);
    if let Some(row) = ws.value.iter().position(|c| !c.is_finite()) {
        return Err(AnalysisError::NotFinite {
            element: system.row_name(row),
            time: state.t,
        });
    }
    Err(AnalysisError::NotAssembled {
        time: state.t,
        iterations: report.iterations,
        worst: system.row_name(row),
        residual: ws.value[row].abs(),
        conflict: conflict(system, ws),
    })
}

/// Names the constraints that contradict each other: least squares leaves residual on dependent rows.
fn conflict<S: Space>(system: &System<S>, ws: &Workspace<S>) -> String {
    let (largest, _) = system.violation(ws);
    let mut names: Vec<&str> = Vec::new();
    for (row, c) in ws.value.iter().enumerate() {
        let name = system.elements[system.row_refs()[row].element]
            .name
            .as_str();
        if c.abs() / system.row_scale(row) > 0.1 * largest && !names.contains(&name) {
            names.push(name);
        }
    }
    if names.len() < 2 {
        return "; the pose may be out of reach: check lengths, or give a better initial estimate"
            .to_owned();
    }
    names.truncate(8);
    format!(
        "; these cannot hold together near the estimate: {}. Check lengths and points, or give a better initial estimate",
        names.join(", ")
    )
}

/// Sets `state.v` to the velocities nearest to it (in the metric) that meet C_q v = -C_t
/// (Shabana 3.118). The workspace must hold the constraints at the positions.
pub(super) fn correct_velocities<S: Space>(
    system: &System<S>,
    ws: &mut Workspace<S>,
    state: &mut State,
    weights: &Weights,
) {
    system.update_markers(&state.q, &state.v, ws);
    system.evaluate_constraints(state.t, ws);
    ws.factor(&weights.inverse);
    let mut rhs = std::mem::take(&mut ws.rhs);
    system.jac_mul(ws, &state.v, &mut rhs);
    for (r, t) in rhs.iter_mut().zip(&ws.time) {
        *r = -(*r + t);
    }
    ws.rhs = rhs;
    ws.solve(&weights.blocks, &weights.zero);
    for (v, d) in state.v.iter_mut().zip(&ws.a) {
        *v += d;
    }
}
