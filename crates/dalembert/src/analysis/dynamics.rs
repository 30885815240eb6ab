//! Forward dynamics: the augmented formulation in absolute coordinates, integrated with error
//! control; positions and velocities projected.

use super::balance::unbalanced;
use super::conserved::conserved;
use super::contradiction::contradiction;
use super::least_reactions::LeastReactions;
use super::massless;
use super::newton::NewtonOptions;
use super::open_reactions::{OpenReactions, at_time};
use super::pace::{Limits, Pace};
use super::pulling::pulling;
use super::recorder::{Extra, Recorder, Recording};
use super::{AnalysisError, Assembly, AssemblyReport, Motion};
use crate::integrate::{Integrator, Ode, StepError};
use crate::model::{Method, Stabilization};
use crate::results::Results;
use crate::space::Space;
use crate::system::compile::Options;
use crate::system::{State, System};

/// Forward dynamics (Shabana 6.7, 6.11, 6.12).
#[derive(Clone, Debug, PartialEq)]
pub struct Dynamics {
    /// Instants of the results, ascending; the first is the start.
    pub instants: Vec<f64>,
    /// Error tolerance of a step.
    pub tolerance: f64,
    /// Method of the integration.
    pub integrator: Method,
    /// Largest step [s]; the step itself for methods with steps of one size.
    pub max_step: f64,
    /// Most steps.
    pub max_steps: usize,
    /// How the constraints are kept.
    pub stabilization: Stabilization,
    /// Baumgarte's alpha and beta [1/s].
    pub baumgarte: [f64; 2],
    /// Newton's options of the assembly.
    pub newton: NewtonOptions,
    /// What is written.
    pub recording: Recording,
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
            integrator: options.integrator,
            max_step: options.max_step,
            max_steps: options.max_steps,
            stabilization: options.stabilization,
            baumgarte: options.baumgarte,
            newton: NewtonOptions::of(options),
            recording: options.recording,
        }
    }

    /// Runs the simulation; `progress` is told the time reached now and then, and stops the run by
    /// returning false.
    ///
    /// # Errors
    /// The machine cannot be assembled, or its accelerations cannot be computed at the start.
    pub fn run<S: Space>(
        &self,
        system: &System<S>,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<DynamicsReport, AnalysisError> {
        let (mut state, assembly) = Assembly {
            newton: self.newton,
        }
        .run(system)?;
        let mut notes: Vec<String> = super::missing_mass(system).into_iter().collect();
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
        motion.check_masses()?;
        running.update_markers(&state.q, &state.v, &mut motion.ws);
        motion.passed(start)?;
        let start_energy = motion.energy(start, &y);
        let mut integrator = Integrator::start(
            self.integrator,
            &mut motion,
            start,
            &y,
            self.tolerance,
            self.max_step,
        )?;
        let mut recorder = Recorder::new(true).writing(self.recording);
        let mut least = LeastReactions::new(&running);
        let mut open = OpenReactions::default();
        let (mut steps, mut rejected) = (0_usize, 0_usize);
        let mut stopped = None;
        let mut drift: f64 = 0.0;
        'instants: for &t in &self.instants {
            while integrator.t() < t {
                if steps.is_multiple_of(64) && !progress(integrator.t()) {
                    break 'instants;
                }
                if pace.over(integrator.t(), steps, &integrator.stiffness()) {
                    stopped = Some(self.out_of_steps(&pace, &integrator, steps, &mut motion));
                    break 'instants;
                }
                if pace.crawls(integrator.t(), steps)
                    && let Some(detail) = motion.jumping(integrator.t(), integrator.y())
                {
                    stopped = Some(AnalysisError::OutOfSteps {
                        time: integrator.t(),
                        steps,
                        detail,
                    });
                    break 'instants;
                }
                match integrator.step(&mut motion, end) {
                    Ok(report) => {
                        steps += 1;
                        rejected += report.rejected;
                        drift = drift.max(motion.drift);
                        if let Err(error) = motion.passed(integrator.t()) {
                            stopped = Some(error);
                            break 'instants;
                        }
                    }
                    Err(StepError::TooSmall { step, cause }) => {
                        stopped = Some(motion.too_small(&integrator, step, cause));
                        break 'instants;
                    }
                    Err(StepError::Fixed { step, cause }) => {
                        stopped = Some(AnalysisError::StepFailed {
                            time: integrator.t(),
                            step,
                            detail: cause.to_string(),
                        });
                        break 'instants;
                    }
                }
            }
            if integrator.t() == t {
                y.copy_from_slice(integrator.y());
            } else {
                let inside = integrator.interpolate(&mut motion, t, &mut y);
                if let Err(error) = inside.and_then(|()| motion.project(t, &mut y)) {
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
        if matches!(
            stopped,
            Some(AnalysisError::StepTooSmall { .. } | AnalysisError::NotAssembled { .. })
        ) {
            stopped = contradiction(&running, &state, end).or(stopped);
        }
        let mut results = recorder.into_results(&system.name, "simulate");
        notes.extend(open.notes());
        notes.extend(pulling(&running, &results));
        notes.extend(unbalanced(&results));
        if stopped.is_none() && integrator.stiffness().since.is_some() {
            let fastest = motion.stiffest(integrator.t(), integrator.y());
            notes.extend(Pace::note(steps, &integrator.stiffness(), fastest.as_ref()));
        }
        notes.append(&mut results.notes);
        results.notes = notes;
        results
            .notes
            .extend(massless::note(&running, &motion.metric));
        let kept = conserved(&results);
        results.notes.extend(kept);
        for (name, value) in [
            ("steps", steps as f64),
            ("rejected steps", rejected as f64),
            ("right sides", integrator.evaluations() as f64),
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
    fn out_of_steps<S: Space>(
        &self,
        pace: &Pace,
        integrator: &Integrator,
        steps: usize,
        motion: &mut Motion<'_, S>,
    ) -> AnalysisError {
        let limits = Limits {
            max_step: self.max_step,
            baumgarte: self.stabilization == Stabilization::Baumgarte,
        };
        if let Some(detail) = motion.jumping(integrator.t(), integrator.y()) {
            return AnalysisError::OutOfSteps {
                time: integrator.t(),
                steps,
                detail,
            };
        }
        let fastest = motion.stiffest(integrator.t(), integrator.y());
        let (t, stiffness) = (integrator.t(), &integrator.stiffness());
        AnalysisError::OutOfSteps {
            time: t,
            steps,
            detail: pace.reason(t, steps, &limits, stiffness, fastest.as_ref()),
        }
    }
}
