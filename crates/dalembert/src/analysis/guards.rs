//! Vectors of elements that must not vanish on the way of a machine.

use super::AnalysisError;
use crate::joint::{Guarded, Lost};
use crate::space::Space;
use crate::system::{System, Workspace};
use nalgebra::Vector3;
use smallvec::SmallVec;
use std::marker::PhantomData;

/// Cosine of the turn of a vector in one step below which it went through zero: no step that followed it turns it so far.
const REVERSED: f64 = -0.98;
/// Length above which a vector is not near zero at either end of a step.
const LONG: f64 = 0.7;

/// An element with vectors that must not vanish.
#[derive(Clone, Copy, Debug)]
enum Owner {
    Constraint(usize),
    Force(usize),
}

/// The vectors of a system that must not vanish.
#[derive(Clone, Debug)]
pub(super) struct Guards<S: Space> {
    owners: Vec<Owner>,
    /// The vectors at the last state, in the order in which the owners show them.
    last: Vec<Vector3<f64>>,
    space: PhantomData<S>,
}

impl<S: Space> Guards<S> {
    /// Of a system.
    pub fn new(system: &System<S>) -> Self {
        // How many vectors an element has does not depend on where its markers are.
        let shown = |owner: Owner| {
            let still = |m: &usize| S::ground_marker(&system.markers[*m].frame);
            let mut count = 0;
            let numbers = markers(system, owner);
            let markers: Vec<S::Marker> = numbers.iter().map(still).collect();
            show(system, owner, &markers, &mut |_| count += 1);
            count
        };
        let constraints = (0..system.elements.len()).map(Owner::Constraint);
        let forces = (0..system.forces.len()).map(Owner::Force);
        Self {
            owners: constraints
                .chain(forces)
                .filter(|o| shown(*o) > 0)
                .collect(),
            last: Vec::new(),
            space: PhantomData,
        }
    }

    /// The first vector that has vanished at a state; the workspace holds its markers.
    pub fn vanished(&self, system: &System<S>, ws: &Workspace<S>, t: f64) -> Option<AnalysisError> {
        self.find(system, ws, t, Guarded::vanished)
    }

    /// The first vector that vanishes within a time after a state.
    pub fn ahead(
        &self,
        system: &System<S>,
        ws: &Workspace<S>,
        t: f64,
        horizon: f64,
    ) -> Option<AnalysisError> {
        self.find(system, ws, t, |g| g.vanishes_within(horizon))
    }

    /// The first vector that went through zero since the last state.
    pub fn reversed(&self, system: &System<S>, ws: &Workspace<S>, t: f64) -> Option<AnalysisError> {
        let mut last = self.last.iter();
        let mut found = None;
        for owner in &self.owners {
            let markers = seen(system, ws, *owner);
            show(system, *owner, &markers, &mut |g| {
                let Some(before) = last.next() else {
                    return;
                };
                let (a, b) = (before.norm(), g.vector.norm());
                if a < LONG && b < LONG && before.dot(&g.vector) < REVERSED * a * b {
                    found.get_or_insert((*owner, g.lost));
                }
            });
        }
        found.map(|(owner, lost)| error(system, owner, lost, t))
    }

    /// Keeps the vectors of a state as those of the last one.
    pub fn keep(&mut self, system: &System<S>, ws: &Workspace<S>) {
        let (owners, last) = (&self.owners, &mut self.last);
        last.clear();
        for owner in owners {
            let markers = seen(system, ws, *owner);
            show(system, *owner, &markers, &mut |g| last.push(g.vector));
        }
    }

    fn find(
        &self,
        system: &System<S>,
        ws: &Workspace<S>,
        t: f64,
        is: impl Fn(&Guarded) -> bool,
    ) -> Option<AnalysisError> {
        self.owners.iter().find_map(|owner| {
            let mut lost = None;
            let markers = seen(system, ws, *owner);
            show(system, *owner, &markers, &mut |g| {
                if is(&g) {
                    lost.get_or_insert(g.lost);
                }
            });
            lost.map(|lost| error(system, *owner, lost, t))
        })
    }
}

/// The markers of an element; steps of a run must not allocate.
fn seen<S: Space>(system: &System<S>, ws: &Workspace<S>, owner: Owner) -> SmallVec<[S::Marker; 4]> {
    let numbers = markers(system, owner).iter();
    numbers.map(|&m| ws.markers[m]).collect()
}

/// Numbers of the markers of an element.
fn markers<S: Space>(system: &System<S>, owner: Owner) -> &[usize] {
    match owner {
        Owner::Constraint(k) => &system.elements[k].markers,
        Owner::Force(k) => &system.forces[k].markers,
    }
}

fn show<S: Space>(
    system: &System<S>,
    owner: Owner,
    markers: &[S::Marker],
    see: &mut dyn FnMut(Guarded),
) {
    match owner {
        Owner::Constraint(k) => system.elements[k].element.guarded(markers, see),
        Owner::Force(k) => system.forces[k].element.guarded(markers, see),
    }
}

fn error<S: Space>(system: &System<S>, owner: Owner, lost: Lost, time: f64) -> AnalysisError {
    let (name, kind) = match owner {
        Owner::Constraint(k) => (&system.elements[k].name, &system.elements[k].kind),
        Owner::Force(k) => (&system.forces[k].name, &system.forces[k].kind),
    };
    AnalysisError::Lost {
        element: format!("'{name}' ({kind})"),
        time,
        lost,
    }
}
