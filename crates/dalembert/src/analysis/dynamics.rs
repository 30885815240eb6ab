//! Forward dynamics: the augmented formulation in absolute coordinates, integrated with error
//! control; positions and velocities projected.

use super::least_reactions::LeastReactions;
use super::meeting::Meeting;
use super::newton::NewtonOptions;
use super::open_reactions::{OpenReactions, at_time};
use super::pace::{Limits, Pace};
use super::recorder::{Extra, Recorder, energies, outside_power};
use super::stiffest::{Stiffest, stiffest};
use super::{AnalysisError, Assembly, AssemblyReport};
use crate::integrate::{Dopri5, Ode, StepError};
use crate::model::Stabilization;
use crate::results::Results;
use crate::space::Planar;
use crate::system::compile::Options;
use crate::system::{State, System, Workspace};

/// Forward dynamics (Shabana 6.7, 6.11, 6.12).
#[derive(Clone, Debug, PartialEq)]
pub struct Dynamics {
    /// Instants of the results, ascending; the first is the start.
    pub instants: Vec<f64>,
    /// Error tolerance of a step.
    pub tolerance: f64,
    /// Largest step [s].
    pub max_step: f64,
    /// Most steps.
    pub max_steps: usize,
    /// How the constraints are kept.
    pub stabilization: Stabilization,
    /// Baumgarte's alpha and beta [1/s].
    pub baumgarte: [f64; 2],
    /// Newton's options of the assembly.
    pub newton: NewtonOptions,
}

/// What a run did.
#[derive(Clone, Debug)]
pub struct DynamicsReport {
    /// Channels up to the last good instant.
    pub results: Results,
    /// What the assembly did.
    pub assembly: AssemblyReport,
    /// Why the run ended before the last instant.
    pub stopped: Option<AnalysisError>,
    /// State at the end.
    pub state: State,
}

impl Dynamics {
    /// With the options of a compiled model.
    pub fn new(options: &Options) -> Self {
        Self {
            instants: options.instants(),
            tolerance: options.tolerance,
            max_step: options.max_step,
            max_steps: options.max_steps,
            stabilization: options.stabilization,
            baumgarte: options.baumgarte,
            newton: NewtonOptions::of(options),
        }
    }

    /// Runs the simulation; `progress` is told the time reached now and then, and stops the run by
    /// returning false.
    ///
    /// # Errors
    /// The machine cannot be assembled, or its accelerations cannot be computed at the start.
    pub fn run(
        &self,
        system: &System<Planar>,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<DynamicsReport, AnalysisError> {
        let (mut state, assembly) = Assembly {
            newton: self.newton,
        }
        .run(system)?;
        let mut notes: Vec<String> = super::missing_mass::note(system).into_iter().collect();
        let running = system.running();
        let mut motion = Motion::new(&running, self);
        let (nq, nv) = (running.nq(), running.nv());
        let mut y = vec![0.0; nq + nv + 1];
        y[..nq].copy_from_slice(&state.q);
        y[nq..nq + nv].copy_from_slice(&state.v);
        let start = *self.instants.first().unwrap_or(&state.t);
        let end = self.instants.last().copied().unwrap_or(start);
        let mut pace = Pace::new(start, end, self.max_steps);
        if let Some(least) = pace.too_many(self.max_step) {
            return Err(AnalysisError::OutOfSteps {
                time: start,
                steps: 0,
                detail: format!(
                    "max_step = {:e} s takes at least {least:.1e} steps until {end} s, and {} are allowed; give a larger max_step, simulate fewer seconds, or allow more steps (analysis.max_steps)",
                    self.max_step, self.max_steps
                ),
            });
        }
        motion.evaluate(start, &y)?;
        running.update_markers(&state.q, &state.v, &mut motion.ws);
        motion.meeting.step(&running, &motion.ws, start)?;
        let start_energy = motion.energy(start, &y);
        let mut integrator = Dopri5::start(&mut motion, start, &y, self.tolerance, self.max_step)?;
        let mut recorder = Recorder::new(true);
        let mut least = LeastReactions::new(&running);
        let mut open = OpenReactions::default();
        let (mut steps, mut rejected) = (0_usize, 0_usize);
        let mut stopped = None;
        let mut drift: f64 = 0.0;
        'instants: for &t in &self.instants {
            while integrator.t < t {
                if steps.is_multiple_of(64) && !progress(integrator.t) {
                    break 'instants;
                }
                if pace.over(integrator.t, steps, &integrator.stiffness) {
                    stopped = Some(self.out_of_steps(&pace, &integrator, steps, &mut motion));
                    break 'instants;
                }
                match integrator.step(&mut motion, end) {
                    Ok(report) => {
                        steps += 1;
                        rejected += report.rejected;
                        drift = drift.max(motion.drift);
                        if let Err(error) = motion.passed(integrator.t) {
                            stopped = Some(error);
                            break 'instants;
                        }
                    }
                    Err(StepError::TooSmall { step, cause }) => {
                        stopped = Some(motion.too_small(&integrator, step, cause));
                        break 'instants;
                    }
                }
            }
            if integrator.t == t {
                y.copy_from_slice(&integrator.y);
            } else {
                integrator.interpolate(t, &mut y);
                if let Err(error) = motion.project(t, &mut y) {
                    stopped = Some(error);
                    break;
                }
            }
            if let Err(error) = motion.evaluate(t, &y) {
                stopped = Some(error);
                break;
            }
            state.t = t;
            state.q.copy_from_slice(&y[..nq]);
            state.v.copy_from_slice(&y[nq..nq + nv]);
            running.update_markers(&state.q, &state.v, &mut motion.ws);
            let extra = Extra {
                work: y[nq + nv],
                start_energy: Some(start_energy),
            };
            least.settle(&running, &mut motion.ws);
            open.pose(&least.not_unique(&running), || at_time(t));
            recorder.record(&running, &motion.ws, &state, extra);
        }
        let mut results = recorder.into_results(&system.name, "simulate");
        notes.extend(open.notes());
        if stopped.is_none() && integrator.stiffness.since.is_some() {
            let fastest = motion.stiffest(integrator.t, &integrator.y);
            notes.extend(Pace::note(steps, &integrator.stiffness, fastest.as_ref()));
        }
        results.notes = notes;
        for (name, value) in [
            ("steps", steps as f64),
            ("rejected steps", rejected as f64),
            ("right sides", integrator.evaluations as f64),
            ("projections", motion.projections as f64),
            ("largest drift before projection", drift),
        ] {
            results.statistics.insert(name.to_owned(), value);
        }
        Ok(DynamicsReport {
            results,
            assembly,
            stopped,
            state,
        })
    }
}

impl Dynamics {
    /// Why a run ends before its last instant for want of steps.
    fn out_of_steps(
        &self,
        pace: &Pace,
        integrator: &Dopri5,
        steps: usize,
        motion: &mut Motion<'_>,
    ) -> AnalysisError {
        let limits = Limits {
            max_step: self.max_step,
            baumgarte: self.stabilization == Stabilization::Baumgarte,
        };
        let fastest = motion.stiffest(integrator.t, &integrator.y);
        let (t, stiffness) = (integrator.t, &integrator.stiffness);
        AnalysisError::OutOfSteps {
            time: t,
            steps,
            detail: pace.reason(t, steps, &limits, stiffness, fastest.as_ref()),
        }
    }
}

/// The equations of motion as an ordinary differential equation in (q, v, work).
#[derive(Debug)]
pub struct Motion<'a> {
    system: &'a System<Planar>,
    /// The workspace of the last evaluation.
    pub ws: Workspace<Planar>,
    baumgarte: Option<[f64; 2]>,
    speed: [f64; 2],
    /// Violation found by the last projection, before it.
    pub drift: f64,
    /// Projections made.
    pub projections: usize,
    rate: Vec<f64>,
    zero: Vec<f64>,
    tolerance: f64,
    meeting: Meeting,
}

impl<'a> Motion<'a> {
    /// The motion of a system.
    pub fn new(system: &'a System<Planar>, options: &Dynamics) -> Self {
        Self {
            system,
            ws: Workspace::new(system),
            baumgarte: (options.stabilization == Stabilization::Baumgarte)
                .then_some(options.baumgarte),
            speed: [0.0; 2],
            drift: 0.0,
            projections: 0,
            rate: vec![0.0; system.rows],
            zero: vec![0.0; system.nv()],
            meeting: Meeting::new(system),
            tolerance: (1e-3 * options.tolerance).clamp(1e-14, 1e-11),
        }
    }

    fn split<'y>(&self, y: &'y [f64]) -> (&'y [f64], &'y [f64]) {
        let (nq, nv) = (self.system.nq(), self.system.nv());
        (&y[..nq], &y[nq..nq + nv])
    }

    /// Accelerations and multipliers at a state, in the workspace (Shabana 6.141).
    ///
    /// # Errors
    /// Something is not finite, or masses are missing.
    pub fn evaluate(&mut self, t: f64, y: &[f64]) -> Result<(), AnalysisError> {
        let (q, v) = self.split(y);
        let (system, ws) = (self.system, &mut self.ws);
        system.update_active_markers(q, v, ws);
        self.meeting.check(system, ws, t)?;
        system.evaluate_constraints(t, ws);
        system.evaluate_forces(t, ws);
        ws.rhs.copy_from_slice(&ws.qd);
        if let Some([alpha, beta]) = self.baumgarte {
            // C'' + 2 alpha C' + beta^2 C = 0.
            system.jac_mul(ws, v, &mut self.rate);
            for (k, r) in ws.rhs.iter_mut().enumerate() {
                *r -= 2.0 * alpha * (self.rate[k] + ws.time[k]) + beta * beta * ws.value[k];
            }
        }
        if system.massless {
            super::massless::solve(system, ws)?;
        } else {
            ws.factor(&system.mass_inverse);
            ws.solve_forces(&system.mass);
        }
        if ws.a.iter().all(|x| x.is_finite()) {
            return Ok(());
        }
        Err(self.not_finite(t))
    }

    /// The state in a vector of the integrator.
    fn state(&self, t: f64, y: &[f64]) -> State {
        let (q, v) = self.split(y);
        State {
            t,
            q: q.to_vec(),
            v: v.to_vec(),
        }
    }

    /// The force element with the fastest motion at a state.
    fn stiffest(&mut self, t: f64, y: &[f64]) -> Option<Stiffest> {
        let state = self.state(t, y);
        stiffest(self.system, &mut self.ws, &state)
    }

    /// Refuses an accepted step, whose markers the workspace holds, in which points met.
    fn passed(&mut self, t: f64) -> Result<(), AnalysisError> {
        self.meeting.step(self.system, &self.ws, t)
    }

    /// Why no step is small enough.
    fn too_small(
        &mut self,
        integrator: &Dopri5,
        step: f64,
        cause: Option<AnalysisError>,
    ) -> AnalysisError {
        if let Some(met @ AnalysisError::NoDirection { .. }) = cause {
            return met;
        }
        let state = self.state(integrator.t, &integrator.y);
        // The step shrinks geometrically on its way to the meeting.
        let horizon = (16.0 * step).max(1e-9 * integrator.t.abs());
        if let Some(met) = self
            .meeting
            .ahead(self.system, &mut self.ws, &state, horizon)
        {
            return met;
        }
        let detail = match cause {
            Some(error) => error.to_string(),
            None => "the forces or the motion are too rough for the tolerance: look for a stiff spring, a jump in a force, or a singular pose near here".to_owned(),
        };
        AnalysisError::StepTooSmall {
            time: integrator.t,
            step,
            detail,
        }
    }

    fn not_finite(&self, t: f64) -> AnalysisError {
        let system = self.system;
        if let Some(row) = self.ws.qd.iter().position(|x| !x.is_finite()) {
            return AnalysisError::NotFinite {
                element: system.row_name(row),
                time: t,
            };
        }
        let guilty = system.forces.iter().find(|f| {
            let markers: Vec<_> = f.markers.iter().map(|&m| self.ws.markers[m]).collect();
            let mut w = vec![nalgebra::Vector3::zeros(); markers.len()];
            f.element.wrenches(t, &markers, &mut w);
            w.iter().any(|w| w.iter().any(|x| !x.is_finite()))
        });
        let element = match guilty {
            Some(f) => format!("force '{}' ({})", f.name, f.kind),
            None => "the system of equations".to_owned(),
        };
        AnalysisError::NotFinite { element, time: t }
    }

    /// Kinetic and potential energy at the state of the workspace, which must hold all markers.
    pub fn energy(&self, t: f64, y: &[f64]) -> f64 {
        let (_, v) = self.split(y);
        let (kinetic, gravity) = energies(self.system, &self.ws, v);
        let elastic: f64 = self
            .system
            .forces
            .iter()
            .map(|f| {
                let markers: Vec<_> = f.markers.iter().map(|&m| self.ws.markers[m]).collect();
                f.element.report(t, &markers).potential
            })
            .sum();
        kinetic + gravity + elastic
    }
}

impl Ode for Motion<'_> {
    type Error = AnalysisError;

    fn dim(&self) -> usize {
        self.system.nq() + self.system.nv() + 1
    }

    fn rhs(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), AnalysisError> {
        self.evaluate(t, y)?;
        let (nq, nv) = (self.system.nq(), self.system.nv());
        dydt[..nq].copy_from_slice(&y[nq..nq + nv]);
        dydt[nq..nq + nv].copy_from_slice(&self.ws.a);
        dydt[nq + nv] = outside_power(self.system, &self.ws, t);
        Ok(())
    }

    fn scales(&mut self, y: &[f64], scales: &mut [f64]) {
        let (nq, nv, bodies) = (self.system.nq(), self.system.nv(), self.system.bodies.len());
        let size = self.system.size;
        let (q, v) = self.split(y);
        // Speeds are measured against the fastest of their kind so far; a machine at rest against
        // one size a second.
        for b in 0..bodies {
            self.speed[0] = self.speed[0].max(v[3 * b].abs()).max(v[3 * b + 1].abs());
            self.speed[1] = self.speed[1].max(v[3 * b + 2].abs());
        }
        for i in 0..nq {
            let angle = i >= 3 * bodies || i % 3 == 2;
            scales[i] = if angle { 1.0 } else { size + q[i].abs() };
            scales[nq + i] = if angle {
                1.0 + self.speed[1]
            } else {
                size + self.speed[0]
            };
        }
        // The work is a monitor: it follows the states and does not govern the step.
        scales[nq + nv] = f64::INFINITY;
    }

    /// Position and velocity projection in the metric of the mass.
    fn project(&mut self, t: f64, y: &mut [f64]) -> Result<bool, AnalysisError> {
        if self.baumgarte.is_some() || self.system.rows == 0 {
            return Ok(false);
        }
        let system = self.system;
        let (nq, nv) = (system.nq(), system.nv());
        let (q, v) = y[..nq + nv].split_at_mut(nq);
        let ws = &mut self.ws;
        system.update_active_markers(q, v, ws);
        system.evaluate_constraints(t, ws);
        let (mut violation, _) = system.violation(ws);
        self.drift = violation;
        let tolerance = self.tolerance.max(system.rounding(q));
        let mut iterations = 0;
        while violation > tolerance {
            if iterations == 8 || !violation.is_finite() {
                // Rounding of a large machine ends the improvement; anything larger is a failure.
                if violation < tolerance.max(1e-10) {
                    break;
                }
                let (_, row) = system.violation(ws);
                return Err(AnalysisError::NotAssembled {
                    time: t,
                    iterations,
                    worst: system.row_name(row),
                    residual: ws.value[row].abs(),
                    conflict: "; the projection did not converge".to_owned(),
                });
            }
            super::massless::factor(system, ws);
            for (r, c) in ws.rhs.iter_mut().zip(&ws.value) {
                *r = -c;
            }
            super::massless::solve_with(system, ws, &self.zero)?;
            for (x, d) in q.iter_mut().zip(&ws.a) {
                *x += d;
            }
            system.update_active_markers(q, v, ws);
            system.evaluate_constraints(t, ws);
            violation = system.violation(ws).0;
            iterations += 1;
        }
        super::massless::factor(system, ws);
        system.jac_mul(ws, v, &mut self.rate);
        for (r, (c, t)) in ws.rhs.iter_mut().zip(self.rate.iter().zip(&ws.time)) {
            *r = -(c + t);
        }
        super::massless::solve_with(system, ws, &self.zero)?;
        for (x, d) in v.iter_mut().zip(&ws.a) {
            *x += d;
        }
        self.projections += 1;
        Ok(true)
    }
}
