//! The way of the drivers, searched for singular poses.

use super::super::AnalysisError;
use super::super::newton::{NewtonOptions, correct_positions};
use super::super::weights::Weights;
use super::ranked::Ranked;
use super::singular_pose::{SingularKind, SingularPose};
use super::sweep_result::{DriverSweep, SweepOptions};
use crate::formulation::column_scale;
use crate::space::Space;
use crate::system::{Role, State, System, Workspace};

/// Sines of angles below this count as a singular pose: Newton's method leaves about 1e-7 there.
const SINGULAR: f64 = 1e-5;
/// Pivot ratios above this belong to rows that carry information (Newton leaves 1e-13).
const INFORMATIVE: f64 = 1e-9;

/// A pose on the way, with the sine of the angle of every row to those before it.
#[derive(Clone)]
struct Sample {
    state: State,
    sines: Vec<f64>,
}

/// Follows the drivers of a system (with the rows of all phases) from an assembled state and finds
/// the poses at which they lose their hold: the smallest angle between a row's gradient and the
/// other rows goes through zero, or no pose exists any more.
///
/// # Errors
/// An element gives values that are not finite at the start.
pub fn driver_singularities<S: Space>(
    system: &System<S>,
    start: &State,
    options: &SweepOptions,
) -> Result<DriverSweep, AnalysisError> {
    let driven = system.running();
    let mut sweep = Sweep {
        ws: Workspace::new(&driven),
        weights: Weights::even(&driven),
        driven: &driven,
        trial: Vec::new(),
    };
    let mut result = DriverSweep {
        reached: start.t,
        ..DriverSweep::default()
    };
    if !driven.is_driven() || options.steps == 0 {
        result.stopped = Some("the machine has no driver".to_owned());
        return Ok(result);
    }
    let mut samples = vec![sweep.pose(start.clone())?];
    let dt = (options.end - start.t) / options.steps as f64;
    let mut failure = None;
    for k in 1..=options.steps {
        let t = start.t + dt * k as f64;
        match sweep.advance(&samples, t, dt) {
            Ok(sample) => samples.push(sample),
            Err(stop) => {
                failure = Some(stop);
                break;
            }
        }
    }
    let rows = informative(&samples);
    let mut times = Vec::new();
    for k in 0..samples.len() {
        let here = smallest(&samples[k], &rows);
        let left = k.checked_sub(1).map(|j| smallest(&samples[j], &rows));
        let right = samples.get(k + 1).map(|s| smallest(s, &rows));
        let low = left.is_none_or(|l| here < l) && right.is_none_or(|r| here <= r);
        // The ends are searched for themselves: the start as it is, the end by its failure.
        if low && left.is_some() && right.is_some() {
            times.extend(sweep.refine(&samples[k - 1], &samples[k], &samples[k + 1], &rows));
        } else if left.is_none() && here < SINGULAR {
            times.push(samples[k].state.clone());
        }
    }
    for state in times {
        sweep.report(system, state, &rows, options, false, &mut result)?;
    }
    if let Some((last, error)) = failure.map(|stop| *stop) {
        let time = last.t;
        result.reached = time;
        let found = sweep.report(system, last, &rows, options, true, &mut result)?;
        result.stopped = Some(if found {
            format!("the drivers cannot be followed beyond t = {time:.6} s")
        } else {
            error.to_string()
        });
    } else if let Some(last) = samples.last() {
        result.reached = last.state.t;
        if smallest(last, &rows) < SINGULAR && samples.len() > 1 {
            let state = last.state.clone();
            sweep.report(system, state, &rows, options, false, &mut result)?;
        }
    }
    Ok(result)
}

/// Rows that carry information at most of the poses.
fn informative(samples: &[Sample]) -> Vec<usize> {
    let rows = samples.first().map_or(0, |s| s.sines.len());
    (0..rows)
        .filter(|&row| {
            let good = samples
                .iter()
                .filter(|s| s.sines[row] > INFORMATIVE.sqrt())
                .count();
            2 * good > samples.len()
        })
        .collect()
}

fn smallest(sample: &Sample, rows: &[usize]) -> f64 {
    rows.iter()
        .fold(1.0, |m, &row| f64::min(m, sample.sines[row]))
}

struct Sweep<'a, S: Space> {
    driven: &'a System<S>,
    ws: Workspace<S>,
    weights: Weights,
    trial: Vec<f64>,
}

impl<S: Space> Sweep<'_, S> {
    /// Brings a guess onto the rows at its time.
    fn pose(&mut self, mut state: State) -> Result<Sample, AnalysisError> {
        correct_positions(
            self.driven,
            &mut self.ws,
            &mut state,
            &self.weights,
            &NewtonOptions::default(),
            &mut self.trial,
        )?;
        self.driven.update_markers(&state.q, &state.v, &mut self.ws);
        self.driven.evaluate_constraints(state.t, &mut self.ws);
        let factored = self.ws.factor(&self.weights.inverse);
        let sines = factored
            .pivot_ratio
            .iter()
            .map(|r| r.max(0.0).sqrt())
            .collect();
        Ok(Sample { state, sines })
    }

    /// The pose at a later time, in smaller steps where one is too far; where none is small enough
    /// the last pose before the way ends, and why.
    fn advance(
        &mut self,
        samples: &[Sample],
        t: f64,
        dt: f64,
    ) -> Result<Sample, Box<(State, AnalysisError)>> {
        let mut error = match self.next(samples, t) {
            Ok(sample) => return Ok(sample),
            Err(error) => error,
        };
        // The way in small steps starts with the last two poses, for the direction.
        let from = samples.len().saturating_sub(2);
        let mut way: Vec<Sample> = samples[from..].to_vec();
        let mut target = t;
        while let Some(last) = way.last().map(|s| s.state.t) {
            target = last + 0.5 * (target - last);
            if (target - last).abs() <= 1e-11 * dt.abs() || target == last {
                break;
            }
            match self.next(&way, target) {
                Ok(sample) => way.push(sample),
                Err(_) => continue,
            }
            match self.next(&way, t) {
                Ok(sample) => return Ok(sample),
                Err(e) => error = e,
            }
            target = t;
        }
        let last = way.pop().map(|s| s.state).unwrap_or_default();
        Err(Box::new((last, error)))
    }

    /// The pose at a later time: along the last step, else from the last pose.
    fn next(&mut self, samples: &[Sample], t: f64) -> Result<Sample, AnalysisError> {
        let at = |q: Vec<f64>, v: &[f64]| State {
            t,
            q,
            v: v.to_vec(),
        };
        let (last, before) = match samples {
            [.., a, b] => (&b.state, Some(&a.state)),
            [a] => (&a.state, None),
            [] => return self.pose(State::default()),
        };
        if let Some(before) = before {
            let ahead = (t - last.t) / (last.t - before.t);
            // A far extrapolation could land on another branch.
            if ahead <= 2.0 {
                let step = self.driven.difference(&before.q, &last.q);
                let mut q = last.q.clone();
                self.driven.advance(&mut q, ahead, &step);
                if let Ok(sample) = self.pose(at(q, &last.v)) {
                    return Ok(sample);
                }
            }
        }
        self.pose(at(last.q.clone(), &last.v))
    }

    /// A pose between two others.
    fn between(&mut self, a: &Sample, b: &Sample, t: f64) -> Result<Sample, AnalysisError> {
        let part = (t - a.state.t) / (b.state.t - a.state.t);
        let step = self.driven.difference(&a.state.q, &b.state.q);
        let mut state = a.state.clone();
        state.t = t;
        self.driven.advance(&mut state.q, part, &step);
        self.pose(state)
    }

    /// The time between two poses at which the sine is smallest, if it is zero there.
    ///
    /// Near the pose Newton's method is inexact, so the zero is found from both sides: straight
    /// lines through points at a small distance, whose common zero is accurate to its square.
    fn refine(
        &mut self,
        left: &Sample,
        middle: &Sample,
        right: &Sample,
        rows: &[usize],
    ) -> Option<State> {
        let span = right.state.t - left.state.t;
        let value = |sweep: &mut Self, t: f64| {
            let (a, b) = if t <= middle.state.t {
                (left, middle)
            } else {
                (middle, right)
            };
            sweep
                .between(a, b, t)
                .ok()
                .map(|s| (smallest(&s, rows), s.state))
        };
        let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut a, mut b) = (left.state.t, right.state.t);
        let mut best = (smallest(middle, rows), middle.state.clone());
        while b - a > 1e-7 * span {
            let (x, y) = (b - ratio * (b - a), a + ratio * (b - a));
            let (fx, fy) = (value(self, x)?, value(self, y)?);
            if fx.0 < fy.0 {
                b = y;
            } else {
                a = x;
            }
            for f in [fx, fy] {
                if f.0 < best.0 {
                    best = f;
                }
            }
        }
        let h = 1e-4 * span;
        let center = best.1.t;
        let mut zeros = Vec::new();
        for side in [-1.0, 1.0] {
            let (near, far) = (center + side * h, center + 2.0 * side * h);
            let inside = |t: f64| t >= left.state.t && t <= right.state.t;
            if !inside(near) || !inside(far) {
                continue;
            }
            let (Some(n), Some(f)) = (value(self, near), value(self, far)) else {
                continue;
            };
            if f.0 > n.0 && n.0 > 0.0 {
                zeros.push(near - n.0 * (far - near) / (f.0 - n.0));
            }
        }
        // A near miss has a smooth minimum: its lines cross zero far from each other.
        if let [x, y] = zeros[..]
            && (x - y).abs() < 0.1 * h
        {
            best.1.t = 0.5 * (x + y);
            return Some(best.1);
        }
        (best.0 < SINGULAR).then_some(best.1)
    }

    /// Names what happens at a pose, if it is singular; false where it is not.
    fn report(
        &mut self,
        system: &System<S>,
        state: State,
        rows: &[usize],
        options: &SweepOptions,
        end: bool,
        result: &mut DriverSweep,
    ) -> Result<bool, AnalysisError> {
        self.driven.update_markers(&state.q, &state.v, &mut self.ws);
        self.driven.evaluate_constraints(state.t, &mut self.ws);
        let factored = self.ws.factor(&self.weights.inverse);
        let sine = rows.iter().fold(1.0, |m: f64, &row| {
            m.min(factored.pivot_ratio[row].max(0.0).sqrt())
        });
        // Where the way ends, the last pose is only as near as Newton's tolerance lets it come.
        let least = if end { 1e-3 } else { 1e-4 };
        if sine > least {
            return Ok(false);
        }
        let mut pose = SingularPose {
            time: state.t,
            kind: SingularKind::DeadCentre,
            drivers: Vec::new(),
            bodies: Vec::new(),
            end,
            smallest: sine,
        };
        let tolerance = (30.0 * sine).max(1e-6);
        let ranked = Ranked::new(self.driven, &state, tolerance, options.dense_limit)?;
        if ranked.dense.is_some() {
            let undriven = system.undriven();
            let free = Ranked::new(&undriven, &state, tolerance, options.dense_limit)?;
            let regular = rows
                .iter()
                .filter(|&&row| self.role_of(row) != Role::Driver)
                .count();
            if free.rank < regular {
                pose.kind = SingularKind::Bifurcation;
            }
        }
        self.name_drivers(&ranked, &mut pose);
        self.name_bodies(&ranked, &mut pose);
        result.poses.push(pose);
        Ok(true)
    }

    fn role_of(&self, row: usize) -> Role {
        self.driven.elements[self.driven.row_refs()[row].element].role
    }

    /// Drivers among the dependent rows and the rows that these follow from; all of them where that
    /// is not known.
    fn name_drivers(&self, ranked: &Ranked<S>, pose: &mut SingularPose) {
        let dependent = ranked.redundant.iter();
        let mut rows: Vec<usize> = dependent
            .flat_map(|(row, others)| others.iter().map(|(other, _)| *other).chain([*row]))
            .filter(|&row| self.role_of(row) == Role::Driver)
            .collect();
        if rows.is_empty() {
            rows = (0..self.driven.rows)
                .filter(|&row| self.role_of(row) == Role::Driver)
                .collect();
        }
        rows.sort_unstable();
        for row in rows {
            let name = &self.driven.elements[self.driven.row_refs()[row].element].name;
            if !pose.drivers.contains(name) {
                pose.drivers.push(name.clone());
            }
        }
    }

    /// Bodies that move although the drivers stand still.
    fn name_bodies(&self, ranked: &Ranked<S>, pose: &mut SingularPose) {
        let Some(dense) = &ranked.dense else { return };
        let scale = column_scale(self.driven);
        for (b, body) in self.driven.bodies.iter().enumerate() {
            let moves = (S::NV * b..S::NV * (b + 1)).any(|k| {
                let row = dense.null_space.row(k);
                row.iter().any(|x| (x / scale[k]).abs() > 1e-3)
            });
            if moves {
                pose.bodies.push(body.name.clone());
            }
        }
    }
}
