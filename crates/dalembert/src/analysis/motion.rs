//! The equations of motion as an ordinary differential equation.

use super::contact_watch::ContactWatch;
use super::massless;
use super::meeting::Meeting;
use super::recorder::{energies, outside_power};
use super::stiffest::{Stiffest, jumping, stiffest};
use super::{AnalysisError, Dynamics};
use crate::integrate::{Integrator, Ode};
use crate::model::Stabilization;
use crate::space::{Space, Tuple};
use crate::system::{Metric, State, System, Workspace};

/// Residual above which a machine with massless bodies is solved densely: long rows of massless bodies refine slowly, but
/// what they leave is far below the errors of the steps.
const POOR: f64 = 1e-8;

/// The equations of motion as an ordinary differential equation in (q, v, work).
#[derive(Debug)]
pub struct Motion<'a, S: Space> {
    system: &'a System<S>,
    /// The workspace of the last evaluation.
    pub ws: Workspace<S>,
    baumgarte: Option<[f64; 2]>,
    /// The fastest linear and angular speeds so far.
    speed: [f64; 2],
    /// Violation found by the last projection, before it.
    pub drift: f64,
    /// Projections made.
    pub projections: usize,
    rate: Vec<f64>,
    zero: Vec<f64>,
    tolerance: f64,
    meeting: Meeting<S>,
    contacts: ContactWatch,
    /// Masses as the solver sees them, and metric of the projections.
    pub(super) metric: Metric,
}

impl<'a, S: Space> Motion<'a, S> {
    /// The motion of a system.
    pub fn new(system: &'a System<S>, options: &Dynamics) -> Self {
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
            contacts: ContactWatch::new(system),
            metric: system.metric.clone(),
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
        self.metric.factor(system, ws);
        let found = ws.solve_forces(&system.mass);
        if system.massless && found.kept > POOR {
            massless::dense(system, ws)?;
        }
        if ws.a.iter().all(|x| x.is_finite()) {
            return Ok(());
        }
        Err(self.not_finite(t))
    }

    /// Makes sure that masses and constraints determine the accelerations at the last evaluation.
    pub(super) fn check_masses(&mut self) -> Result<(), AnalysisError> {
        if !self.system.massless {
            return Ok(());
        }
        massless::check(self.system, &mut self.ws, &mut self.metric)
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
    pub(super) fn stiffest(&mut self, t: f64, y: &[f64]) -> Option<Stiffest> {
        let state = self.state(t, y);
        stiffest(self.system, &mut self.ws, &state, &mut self.metric)
    }

    /// A force element that jumps at a state, in words.
    pub(super) fn jumping(&mut self, t: f64, y: &[f64]) -> Option<String> {
        let state = self.state(t, y);
        jumping(self.system, &mut self.ws, &state)
    }

    /// Refuses an accepted step, whose markers the workspace holds, in which points met or a contact came to a place where its
    /// equations fail.
    pub(super) fn passed(&mut self, t: f64) -> Result<(), AnalysisError> {
        self.contacts.step(self.system, &self.ws, t)?;
        self.meeting.step(self.system, &self.ws, t)
    }

    /// Why no step is small enough.
    pub(super) fn too_small(
        &mut self,
        integrator: &Integrator,
        step: f64,
        cause: Option<AnalysisError>,
    ) -> AnalysisError {
        if let Some(met @ (AnalysisError::NoDirection { .. } | AnalysisError::Lost { .. })) = cause
        {
            return met;
        }
        let state = self.state(integrator.t(), integrator.y());
        // The step shrinks geometrically on its way to the meeting.
        let horizon = (16.0 * step).max(1e-9 * integrator.t().abs());
        if let Some(met) = self
            .meeting
            .ahead(self.system, &mut self.ws, &state, horizon)
        {
            return met;
        }
        let jump = jumping(self.system, &mut self.ws, &state);
        let detail = match cause {
            Some(error) => error.to_string(),
            None => jump.unwrap_or_else(|| "the forces or the motion are too rough for the tolerance: look for a stiff spring, a jump in a force, or a singular pose near here".to_owned()),
        };
        AnalysisError::StepTooSmall {
            time: integrator.t(),
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
            let markers = self.ws.seen(&f.markers);
            let mut w = vec![S::Twist::zero(); markers.len()];
            f.element.wrenches(t, &markers, &mut w);
            w.iter()
                .any(|w| w.as_slice().iter().any(|x| !x.is_finite()))
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
                let markers = self.ws.seen(&f.markers);
                f.element.report(t, &markers).potential
            })
            .sum();
        kinetic + gravity + elastic
    }
}

impl<S: Space> Ode for Motion<'_, S> {
    type Error = AnalysisError;

    fn dim(&self) -> usize {
        self.system.nq() + self.system.nv() + 1
    }

    fn rhs(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), AnalysisError> {
        self.evaluate(t, y)?;
        let (nq, nv) = (self.system.nq(), self.system.nv());
        let (q, v) = self.split(y);
        self.system.position_rates(q, v, &mut dydt[..nq]);
        dydt[nq..nq + nv].copy_from_slice(&self.ws.a);
        dydt[nq + nv] = outside_power(self.system, &mut self.ws, t);
        Ok(())
    }

    fn scales(&mut self, y: &[f64], scales: &mut [f64]) {
        let system = self.system;
        let (nq, nv) = (system.nq(), system.nv());
        let size = system.size;
        let (q, v) = (&y[..nq], &y[nq..nq + nv]);
        // Speeds are measured against the fastest of their kind so far; a machine at rest against
        // one size a second.
        for v in v[..system.body_nv()].chunks_exact(S::NV) {
            for (k, v) in v.iter().enumerate() {
                let speed = &mut self.speed[usize::from(k >= S::LINEAR)];
                *speed = speed.max(v.abs());
            }
        }
        let (bodies, rest) = (system.bodies.len() * S::NQ, system.body_nv());
        for (i, (scale, q)) in scales.iter_mut().zip(q).enumerate() {
            *scale = if i >= bodies + system.aux {
                // What is remembered does not move in a step.
                f64::INFINITY
            } else if i >= bodies {
                1.0
            } else if i % S::NQ < S::LINEAR {
                size + q.abs()
            } else {
                S::TURN
            };
        }
        for (i, scale) in scales[nq..nq + nv].iter_mut().enumerate() {
            *scale = if i < rest && i % S::NV < S::LINEAR {
                size + self.speed[0]
            } else {
                1.0 + self.speed[1]
            };
        }
        // The work is a monitor: it follows the states and does not govern the step.
        scales[nq + nv] = f64::INFINITY;
    }

    /// Position and velocity projection in the metric of the mass.
    fn project(&mut self, t: f64, y: &mut [f64]) -> Result<bool, AnalysisError> {
        let system = self.system;
        let (nq, nv) = (system.nq(), system.nv());
        // What this changes is no motion: the derivatives stay.
        system.normalize(&mut y[..nq]);
        if self.baumgarte.is_some() || system.rows == 0 {
            return Ok(false);
        }
        let (q, v) = y[..nq + nv].split_at_mut(nq);
        let ws = &mut self.ws;
        system.update_active_markers(q, v, ws);
        // The projection could bring a pose back to the side that it left.
        self.meeting.reversed(system, ws, t)?;
        system.evaluate_positions(t, ws);
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
            self.metric.factor(system, ws);
            for (r, c) in ws.rhs.iter_mut().zip(&ws.value) {
                *r = -c;
            }
            ws.solve(&self.metric.blocks, &self.zero);
            system.advance(q, 1.0, &ws.a);
            system.update_active_markers(q, v, ws);
            system.evaluate_positions(t, ws);
            violation = system.violation(ws).0;
            iterations += 1;
        }
        if !system.velocity_rows().is_empty() {
            system.evaluate_constraints(t, ws);
        }
        self.metric.factor(system, ws);
        system.jac_mul(ws, v, &mut self.rate);
        for (r, (c, t)) in ws.rhs.iter_mut().zip(self.rate.iter().zip(&ws.time)) {
            *r = -(c + t);
        }
        ws.solve(&self.metric.blocks, &self.zero);
        for (x, d) in v.iter_mut().zip(&ws.a) {
            *x += d;
        }
        self.projections += 1;
        Ok(true)
    }
}
