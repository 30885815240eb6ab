//! What a reader should know about the numbers.

use crate::analysis::open_reactions::sentence;
use crate::formulation::{Accelerations, FormulationError, MotionBasis, Terms};
use crate::space::Space;
use crate::system::{State, System, Workspace};
use crate::words::readable;
use nalgebra::DVector;

/// Violations above this (relative to the machine's size) are mentioned.
const VIOLATION: f64 = 1e-8;

/// Accelerations below this are rounding [1/s^2].
const ROUNDING: f64 = 1e-9;

/// The notes of a report.
#[derive(Debug, Default)]
pub(super) struct Notes {
    pub lines: Vec<String>,
}

impl Notes {
    /// The state does not satisfy the constraints.
    pub fn violation<S: Space>(&mut self, system: &System<S>, ws: &Workspace<S>, state: &State) {
        let (worst, row) = system.violation(ws);
        if worst > VIOLATION {
            self.lines.push(format!(
                "the state does not satisfy the constraints: {} is off by {:.3e}",
                system.row_name(row),
                ws.value[row].abs()
            ));
        }
        let mut rate = vec![0.0; system.rows];
        system.jac_mul(ws, &state.v, &mut rate);
        for (rate, time) in rate.iter_mut().zip(&ws.time) {
            *rate += time;
        }
        let speed = state.v.iter().fold(1.0_f64, |most, v| most.max(v.abs()));
        let (worst, row) = system.largest(&rate);
        if worst > VIOLATION * speed {
            self.lines.push(format!(
                "the velocities do not satisfy the constraints: {} is off by {:.3e} per second",
                system.row_name(row),
                rate[row].abs()
            ));
        }
    }

    /// Drivers move.
    pub fn moving(&mut self, time: &DVector<f64>) {
        if time.iter().any(|x| *x != 0.0) {
            self.lines.push(
                "the kinematics depends on time (C_t is not zero): H = T2 - T0 + V is not T + V, and it is not \
                 constant even where all forces have a potential"
                    .to_owned(),
            );
        }
    }

    /// Elements whose multipliers are not unique.
    pub fn redundant(&mut self, elements: &[&str]) {
        if !elements.is_empty() {
            let text = sentence(elements);
            self.lines
                .push(format!("warning: redundant constraints: {text}"));
        }
    }

    /// What the solution is worth.
    pub fn solution(
        &mut self,
        solution: &Result<Accelerations, FormulationError>,
        names: &[String],
    ) {
        match solution {
            Ok(_) => {}
            Err(FormulationError::Massless { coordinates }) => {
                let list: Vec<&str> = coordinates.iter().map(|&k| names[k].as_str()).collect();
                self.lines.push(format!(
                    "no accelerations: neither mass nor constraint holds {}; give these bodies mass and inertia",
                    list.join(", ")
                ));
            }
            Err(e) => self.lines.push(format!("no accelerations: {e}")),
        }
    }

    /// Rows that the accelerations do not meet: redundant ones that ask for different accelerations.
    ///
    /// What counts is the largest acceleration, or the square of the fastest rate, in units of the machine's size: a
    /// machine at rest has nothing but rounding in Q_d.
    pub fn contradiction<S: Space>(
        &mut self,
        system: &System<S>,
        terms: &Terms,
        a: &[f64],
        v: &[f64],
    ) {
        let scaled = |x: &[f64]| {
            let rates = x.iter().zip(&terms.column_scale);
            rates.fold(0.0_f64, |m, (x, s)| m.max((x / s).abs()))
        };
        let natural = scaled(a).max(scaled(v).powi(2)).max(ROUNDING);
        let left = &terms.jacobian * DVector::from_column_slice(a) - &terms.qd;
        let (worst, row) = system.largest(&left.as_slice()[..system.rows]);
        if worst > VIOLATION * natural {
            self.lines.push(format!(
                "warning: redundant constraints contradict each other: the accelerations miss Q_d of {} by {}",
                system.row_name(row),
                readable(left[row].abs())
            ));
        }
    }

    /// What became of the preferred coordinates.
    pub fn partition(&mut self, motion: &MotionBasis, preferred: &[usize], names: &[String]) {
        let Some(split) = &motion.partition else {
            return;
        };
        if !split.refused.is_empty() {
            let list: Vec<&str> = split.refused.iter().map(|&k| names[k].as_str()).collect();
            self.lines.push(format!(
                "not independent at this pose, made dependent: {}",
                list.join(", ")
            ));
        }
        let added: Vec<&str> = split
            .independent
            .iter()
            .filter(|k| !preferred.contains(k))
            .map(|&k| names[k].as_str())
            .collect();
        if !preferred.is_empty() && !added.is_empty() {
            self.lines.push(format!(
                "more coordinates are independent than were named; added: {}",
                added.join(", ")
            ));
        }
    }

    /// No basis could be found.
    pub fn no_basis(&mut self, e: &FormulationError) {
        self.lines.push(format!("no independent coordinates: {e}"));
    }
}
