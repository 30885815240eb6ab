//! Inverse dynamics: the forces that a given motion takes.

use super::AnalysisError;
use super::kinematics::{Kinematics, KinematicsRun};
use super::newton::NewtonOptions;
use super::recorder::Recording;
use crate::joint::{MeasureRow, MeasureRows, TimeFunction};
use crate::space::Space;
use crate::system::{ElementData, Role, System};
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

/// Inverse dynamics (Shabana 6.13): the drivers give the motion, their multipliers are the driving
/// forces. With `actuators` the same motion is produced at other joints: the reactions differ.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inverse {
    /// Instants, ascending.
    pub instants: Vec<f64>,
    /// Newton's options.
    pub newton: NewtonOptions,
    /// What is written.
    pub recording: Recording,
    /// Joints that have the actuators; empty: the drivers themselves.
    pub actuators: Vec<String>,
}

impl Inverse {
    /// Runs the analysis.
    ///
    /// # Errors
    /// As for the kinematic analysis; and where the actuators cannot produce the motion.
    pub fn run<S: Space>(&self, system: &System<S>) -> Result<KinematicsRun, AnalysisError> {
        let kinematics = Kinematics {
            instants: self.instants.clone(),
            newton: self.newton,
            recording: self.recording,
        };
        let mut run = if self.actuators.is_empty() {
            kinematics.run(system)?
        } else {
            let actuated = actuated(system, &self.actuators)?;
            kinematics.run_actuated(system, &actuated)?
        };
        run.results.analysis = "inverse".to_owned();
        Ok(run)
    }
}

/// The running system with its drivers replaced by unit rows along the coordinates of joints: their
/// multipliers are the actuators' efforts.
fn actuated<S: Space>(system: &System<S>, joints: &[String]) -> Result<System<S>, AnalysisError> {
    let running = system.running();
    let needed = running.drivers().map(|e| e.rows.len()).sum();
    if needed != joints.len() {
        return Err(AnalysisError::ActuatorCount {
            given: joints.len(),
            needed,
        });
    }
    let mut actuators = Vec::new();
    for name in joints {
        let joint = running
            .elements
            .iter()
            .find(|e| e.role == Role::Joint && e.name == *name)
            .ok_or_else(|| bad_joint(&running, name, "there is no such joint"))?;
        let [coordinate] = joint.coordinates.as_slice() else {
            return Err(bad_joint(
                &running,
                name,
                "it does not have exactly one coordinate",
            ));
        };
        // The value of the row is never used, only its gradient.
        let row = MeasureRow::follow(coordinate.measure, TimeFunction::Constant(0.0), "actuator");
        actuators.push(ElementData {
            name: format!("actuator {name}"),
            role: Role::Driver,
            kind: "actuator".to_owned(),
            path: joint.path.clone(),
            element: Arc::new(MeasureRows::new(joint.markers.len(), smallvec![row])),
            coordinates: smallvec![coordinate.clone()],
            auxiliary_start: SmallVec::new(),
            ..joint.clone()
        });
    }
    Ok(running.replace_elements(|e| e.role != Role::Driver, actuators))
}

fn bad_joint<S: Space>(system: &System<S>, name: &str, what: &str) -> AnalysisError {
    let usable: Vec<&str> = system
        .elements
        .iter()
        .filter(|e| e.role == Role::Joint && e.coordinates.len() == 1)
        .map(|e| e.name.as_str())
        .collect();
    let hint = dalembert_expr::nearest(name, usable.iter().copied())
        .first()
        .map_or_else(
            || {
                format!(
                    "{what}; joints that can have an actuator: {}",
                    usable.join(", ")
                )
            },
            |n| format!("{what}; did you mean '{n}'?"),
        );
    AnalysisError::BadName {
        what: "joint",
        name: name.to_owned(),
        detail: hint,
    }
}
