//! Kinematics of driven machines: positions, velocities, accelerations, and the forces that the
//! motion takes.

mod actuated;
mod multipliers;
mod runner;
mod watch;

use super::contact_watch::ContactWatch;
use super::contradiction::contradiction;
use super::least_reactions::LeastReactions;
use super::meeting::Meeting;
use super::newton::NewtonOptions;
use super::open_reactions::{OpenReactions, at_time};
use super::pulling::pulling;
use super::recorder::{Extra, Recorder, Recording};
use super::{AnalysisError, Assembly, AssemblyReport};
use crate::results::Results;
use crate::space::Space;
use crate::system::System;
use crate::system::compile::Options;
use actuated::Actuated;
use runner::{DENSE, Runner};

/// Kinematic analysis (Shabana 3.7, 3.8) at given instants.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Kinematics {
    /// Instants, ascending; the first is the start.
    pub instants: Vec<f64>,
    /// Newton's options.
    pub newton: NewtonOptions,
    /// What is written.
    pub recording: Recording,
}

/// A kinematic run: what was computed, and why it ended early if it did.
#[derive(Clone, Debug)]
pub struct KinematicsRun {
    /// Channels up to the last good instant.
    pub results: Results,
    /// What the assembly did.
    pub assembly: AssemblyReport,
    /// Why the run ended before the last instant.
    pub stopped: Option<AnalysisError>,
}

/// Refuses rows that hold for velocities only: the positions then follow from the way, not from the time.
fn refuse_rolling<S: Space>(system: &System<S>) -> Result<(), AnalysisError> {
    let rolling = system.elements.iter();
    let rolling = rolling.filter(|e| !e.element.velocity_rows().is_empty());
    let names: Vec<&str> = rolling.map(|e| e.name.as_str()).collect();
    if names.is_empty() {
        return Ok(());
    }
    Err(AnalysisError::Nonholonomic {
        elements: crate::words::listed(&names),
    })
}

impl Kinematics {
    /// With the options of a compiled model.
    pub fn new(options: &Options) -> Self {
        Self {
            instants: options.instants(),
            newton: NewtonOptions::of(options),
            recording: options.recording,
        }
    }

    /// Runs the analysis.
    ///
    /// # Errors
    /// The machine cannot be assembled, or is not driven in every freedom. A singular pose on the
    /// way ends the run with what was computed before it (`stopped`).
    pub fn run<S: Space>(&self, system: &System<S>) -> Result<KinematicsRun, AnalysisError> {
        self.run_with(system, None)
    }

    /// The same motion, with the forces of a machine whose drivers are replaced by actuators.
    pub(super) fn run_actuated<S: Space>(
        &self,
        system: &System<S>,
        actuated: &System<S>,
    ) -> Result<KinematicsRun, AnalysisError> {
        self.run_with(system, Some(actuated))
    }

    fn run_with<S: Space>(
        &self,
        system: &System<S>,
        actuated: Option<&System<S>>,
    ) -> Result<KinematicsRun, AnalysisError> {
        let (mut state, assembly) = Assembly {
            newton: self.newton,
        }
        .run(system)?;
        let mut notes: Vec<String> = super::missing_mass(system).into_iter().collect();
        let running = system.running();
        refuse_rolling(&running)?;
        let mut runner = Runner::new(&running, self.newton);
        runner.start(&mut state)?;
        let mut recorder = Recorder::new(true).writing(self.recording);
        let mut forces = actuated.map(Actuated::new);
        let mut least = LeastReactions::new(actuated.unwrap_or(&running));
        let mut open = OpenReactions::default();
        let meeting = Meeting::new(&running);
        let mut contacts = ContactWatch::new(&running);
        let mut stopped = None;
        for (k, &t) in self.instants.iter().enumerate() {
            let from = state.t;
            let reached = if k > 0 {
                runner.advance(&mut state, t, &mut |pose| {
                    forces.as_mut().map_or(Ok(()), |forces| forces.look(pose))
                })
            } else {
                Ok(())
            };
            if let Err(error) = reached {
                // The way to a meeting ends one shortest interval before it.
                let horizon = 2e-3 * (t - from);
                let met = meeting.ahead(&running, &mut runner.ws, &state, horizon);
                let other = || contradiction(&running, &state, t);
                stopped = Some(met.or_else(other).unwrap_or(error));
                break;
            }
            let met = meeting.check(&running, &runner.ws, t);
            if let Err(error) = met.and_then(|()| contacts.step(&running, &runner.ws, t)) {
                stopped = Some(error);
                break;
            }
            if let Some(forces) = &mut forces {
                if let Err(error) = forces.solve(&state, &runner.ws.a) {
                    stopped = Some(error);
                    break;
                }
                least.settle(forces.system, &mut forces.ws);
                open.pose(&least.not_unique(forces.system), || at_time(t));
                recorder.record(forces.system, &forces.ws, &state, Extra::default());
            } else {
                runner.forces(&state);
                least.settle(&running, &mut runner.ws);
                open.pose(&least.not_unique(&running), || at_time(t));
                recorder.record(&running, &runner.ws, &state, Extra::default());
            }
        }
        let (iterations, substeps) = (runner.iterations, runner.substeps);
        let mut results = recorder.into_results(&system.name, "kinematics");
        notes.extend(open.notes());
        notes.extend(pulling(&running, &results));
        if running.nv() > DENSE {
            notes.push(format!(
                "warning: not checked for singular poses between the instants: the machine has more than {DENSE} coordinates"
            ));
        }
        notes.append(&mut results.notes);
        results.notes = notes;
        let instants = results.len();
        results
            .statistics
            .insert("instants".to_owned(), instants as f64);
        results
            .statistics
            .insert("newton iterations".to_owned(), iterations as f64);
        results
            .statistics
            .insert("substeps".to_owned(), substeps as f64);
        Ok(KinematicsRun {
            results,
            assembly,
            stopped,
        })
    }
}
