//! Points whose distance must not become zero: a direction is taken from one to the other.

use super::AnalysisError;
use crate::joint::Measure;
use crate::space::{Planar, PlanarMarker};
use crate::system::{State, System, Workspace};
use nalgebra::Vector2;

/// Distance, relative to the machine's size, at which the points of a constraint have met: the
/// direction has lost half of its digits there.
const CONSTRAINT: f64 = 1e-8;
/// The same for a force, whose direction only has to be that of the force.
const FORCE: f64 = 1e-12;
/// Distance from the way between two states at which the points of a force met in between.
const PASSED: f64 = 1e-9;

/// The elements of a system that act along the line between two points.
#[derive(Clone, Debug)]
pub(super) struct Meeting {
    /// Elements and their pairs of markers.
    constraints: Vec<(usize, [usize; 2])>,
    forces: Vec<(usize, [usize; 2])>,
    /// From the first to the second point of each force at the last state.
    last: Vec<Vector2<f64>>,
}

impl Meeting {
    /// Collects the pairs of points of a system.
    pub fn new(system: &System<Planar>) -> Self {
        let pairs = |markers: &[usize], list: Vec<Measure>| -> Vec<[usize; 2]> {
            let pair = |m: &Measure| [markers[m.first], markers[m.second]];
            list.iter().map(pair).collect()
        };
        let mut found = Self {
            constraints: Vec::new(),
            forces: Vec::new(),
            last: Vec::new(),
        };
        for (k, e) in system.elements.iter().enumerate() {
            let own = pairs(&e.markers, e.element.distances());
            found.constraints.extend(own.into_iter().map(|p| (k, p)));
        }
        for (k, f) in system.forces.iter().enumerate() {
            let own = pairs(&f.markers, f.element.distances());
            found.forces.extend(own.into_iter().map(|p| (k, p)));
        }
        found
    }

    /// Refuses a state at which points have met; the workspace holds its markers.
    ///
    /// # Errors
    /// [`AnalysisError::NoDirection`].
    pub fn check(
        &self,
        system: &System<Planar>,
        ws: &Workspace<Planar>,
        t: f64,
    ) -> Result<(), AnalysisError> {
        for (number, pair) in &self.constraints {
            if between(ws, *pair).norm() <= CONSTRAINT * system.size {
                return Err(of_constraint(system, *number, t));
            }
        }
        for (number, pair) in &self.forces {
            if between(ws, *pair).norm() <= FORCE * system.size && pulls(system, ws, *number, t) {
                return Err(of_force(system, *number, t));
            }
        }
        Ok(())
    }

    /// Refuses a step between whose ends the points of a force have passed each other; keeps the
    /// markers of the workspace as those of the last state.
    ///
    /// # Errors
    /// [`AnalysisError::NoDirection`].
    pub fn step(
        &mut self,
        system: &System<Planar>,
        ws: &Workspace<Planar>,
        t: f64,
    ) -> Result<(), AnalysisError> {
        for (k, (number, pair)) in self.forces.iter().enumerate() {
            let now = between(ws, *pair);
            let Some(before) = self.last.get_mut(k) else {
                self.last.push(now);
                continue;
            };
            let way = now - *before;
            // The foot of the perpendicular from zero lies between the ends.
            let passed = before.dot(&way) < 0.0
                && now.dot(&way) > 0.0
                && before.perp(&now).abs() <= PASSED * system.size * way.norm();
            *before = now;
            if passed && pulls(system, ws, *number, t) {
                return Err(of_force(system, *number, t));
            }
        }
        Ok(())
    }

    /// The constraint whose points meet within a time after a state, if there is one: why the way of
    /// a machine ends there.
    pub fn ahead(
        &self,
        system: &System<Planar>,
        ws: &mut Workspace<Planar>,
        state: &State,
        horizon: f64,
    ) -> Option<AnalysisError> {
        if self.constraints.is_empty() {
            return None;
        }
        system.update_markers(&state.q, &state.v, ws);
        let found = self.constraints.iter().find(|(_, pair)| {
            let d = between(ws, *pair);
            let [a, b] = pair.map(|m| ws.markers[m].velocity);
            let approach = -d.dot(&(b - a)) / d.norm();
            d.norm() <= CONSTRAINT * system.size || d.norm() <= approach * horizon
        });
        found.map(|(number, _)| of_constraint(system, *number, state.t))
    }
}

fn between(ws: &Workspace<Planar>, pair: [usize; 2]) -> Vector2<f64> {
    ws.markers[pair[1]].point - ws.markers[pair[0]].point
}

/// Does a force element pull although its points coincide?
fn pulls(system: &System<Planar>, ws: &Workspace<Planar>, number: usize, t: f64) -> bool {
    let f = &system.forces[number];
    let markers: Vec<PlanarMarker> = f.markers.iter().map(|&m| ws.markers[m]).collect();
    f.element.pulls_at_zero(t, &markers)
}

fn of_constraint(system: &System<Planar>, number: usize, time: f64) -> AnalysisError {
    let e = &system.elements[number];
    AnalysisError::NoDirection {
        element: format!("'{}' ({})", e.name, e.kind),
        time,
        remedy: "keep them apart, or hold their coordinates x and y (a slide, a path) instead of their distance",
    }
}

fn of_force(system: &System<Planar>, number: usize, time: f64) -> AnalysisError {
    let f = &system.forces[number];
    AnalysisError::NoDirection {
        element: format!("'{}' ({})", f.name, f.kind),
        time,
        remedy: "keep them apart, let the force vanish there (a free length of zero), or use a force along a slide",
    }
}
