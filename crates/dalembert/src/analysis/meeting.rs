//! Points whose distance must not become zero, as a direction is taken from one to the other; and other vectors that must
//! not vanish.

use super::AnalysisError;
use super::guards::Guards;
use crate::joint::Measure;
use crate::space::{Space, spread};
use crate::system::{State, System, Workspace};
use nalgebra::Vector3;
use std::marker::PhantomData;

/// Distance, relative to the machine's size, at which the points of a constraint have met: the
/// direction has lost half of its digits there.
const CONSTRAINT: f64 = 1e-8;
/// The same for a force, whose direction only has to be that of the force.
const FORCE: f64 = 1e-12;
/// Distance from the way between two states at which the points of a force met in between.
const PASSED: f64 = 1e-9;

/// The elements of a system that act along the line between two points, or take a direction from other vectors.
#[derive(Clone, Debug)]
pub(super) struct Meeting<S: Space> {
    /// Elements and their pairs of markers.
    constraints: Vec<(usize, [usize; 2])>,
    forces: Vec<(usize, [usize; 2])>,
    /// From the first to the second point of each force at the last state.
    last: Vec<Vector3<f64>>,
    guards: Guards<S>,
    space: PhantomData<S>,
}

impl<S: Space> Meeting<S> {
    /// Collects the pairs of points of a system.
    pub fn new(system: &System<S>) -> Self {
        let pairs = |markers: &[usize], list: Vec<Measure<S>>| -> Vec<[usize; 2]> {
            let pair = |m: &Measure<S>| [markers[m.first], markers[m.second]];
            list.iter().map(pair).collect()
        };
        let mut found = Self {
            constraints: Vec::new(),
            forces: Vec::new(),
            last: Vec::new(),
            guards: Guards::new(system),
            space: PhantomData,
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

    /// Refuses a state at which points have met or a direction is lost; the workspace holds its markers.
    ///
    /// # Errors
    /// [`AnalysisError::NoDirection`], [`AnalysisError::Lost`].
    pub fn check(
        &self,
        system: &System<S>,
        ws: &Workspace<S>,
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
        self.guards.vanished(system, ws, t).map_or(Ok(()), Err)
    }

    /// Refuses a step between whose ends the points of a force have passed each other, or another vector went through
    /// zero; keeps the markers of the workspace as those of the last state.
    ///
    /// # Errors
    /// [`AnalysisError::NoDirection`], [`AnalysisError::Lost`].
    pub fn step(
        &mut self,
        system: &System<S>,
        ws: &Workspace<S>,
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
                && before.cross(&now).norm() <= PASSED * system.size * way.norm();
            *before = now;
            if passed && pulls(system, ws, *number, t) {
                return Err(of_force(system, *number, t));
            }
        }
        let reversed = self.reversed(system, ws, t);
        self.guards.keep(system, ws);
        reversed
    }

    /// Refuses a state between which and the last one a vector went through zero.
    ///
    /// # Errors
    /// [`AnalysisError::Lost`].
    pub fn reversed(
        &self,
        system: &System<S>,
        ws: &Workspace<S>,
        t: f64,
    ) -> Result<(), AnalysisError> {
        self.guards.reversed(system, ws, t).map_or(Ok(()), Err)
    }

    /// The constraint whose points meet within a time after a state, or the element that loses a direction, if there is
    /// one: why the way of a machine ends there.
    pub fn ahead(
        &self,
        system: &System<S>,
        ws: &mut Workspace<S>,
        state: &State,
        horizon: f64,
    ) -> Option<AnalysisError> {
        system.update_markers(&state.q, &state.v, ws);
        let found = self.constraints.iter().find(|(_, pair)| {
            let d = between(ws, *pair);
            let [a, b] = pair.map(|m| spread::<S>(&S::twist(&ws.markers[m]))[0]);
            let approach = -d.dot(&(b - a)) / d.norm();
            d.norm() <= CONSTRAINT * system.size || d.norm() <= approach * horizon
        });
        found
            .map(|(number, _)| of_constraint(system, *number, state.t))
            .or_else(|| self.guards.ahead(system, ws, state.t, horizon))
    }
}

fn between<S: Space>(ws: &Workspace<S>, pair: [usize; 2]) -> Vector3<f64> {
    let [a, b] = pair.map(|m| Vector3::from(S::point(&ws.markers[m])));
    b - a
}

/// Does a force element pull although its points coincide?
fn pulls<S: Space>(system: &System<S>, ws: &Workspace<S>, number: usize, t: f64) -> bool {
    let f = &system.forces[number];
    f.element.pulls_at_zero(t, &ws.seen(&f.markers))
}

fn of_constraint<S: Space>(system: &System<S>, number: usize, time: f64) -> AnalysisError {
    let e = &system.elements[number];
    AnalysisError::NoDirection {
        element: format!("'{}' ({})", e.name, e.kind),
        time,
        remedy: "keep them apart, or hold their coordinates x and y (a slide, a path) instead of their distance",
    }
}

fn of_force<S: Space>(system: &System<S>, number: usize, time: f64) -> AnalysisError {
    let f = &system.forces[number];
    AnalysisError::NoDirection {
        element: format!("'{}' ({})", f.name, f.kind),
        time,
        remedy: "keep them apart, let the force vanish there (a free length of zero), or use a force along a slide",
    }
}
