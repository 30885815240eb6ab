//! What the evaluation of the constraints needs, close together in memory.

use super::ElementData;
use crate::joint::ConstraintElement;
use crate::space::Space;
use std::sync::Arc;

/// The elements in order, without what only people need: machines of ten thousand joints are limited by memory.
#[derive(Clone, Debug)]
pub(super) struct Plan<S: Space> {
    entries: Vec<Entry<S>>,
    places: Vec<Place>,
}

#[derive(Clone, Debug)]
struct Entry<S: Space> {
    element: Arc<dyn ConstraintElement<S>>,
    markers: u32,
    rows: u32,
    aux: u32,
    bodies: u32,
}

/// A marker of an element, and which of the element's bodies it is on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    marker: u32,
    slot: u32,
}

/// Slot of a marker on the ground.
const GROUND: u32 = u32::MAX;

/// One element to be evaluated.
pub(super) struct Step<'a, S: Space> {
    pub element: &'a dyn ConstraintElement<S>,
    pub places: &'a [Place],
    pub rows: usize,
    pub aux: usize,
    /// Number of its movable bodies.
    pub bodies: usize,
}

impl Place {
    pub fn marker(self) -> usize {
        self.marker as usize
    }

    /// Place of the marker's body among the element's; nothing on the ground.
    pub fn slot(self) -> Option<usize> {
        (self.slot != GROUND).then_some(self.slot as usize)
    }
}

impl<S: Space> Plan<S> {
    /// Lays out the plan; slots, rows and auxiliaries of the elements are set. Numbers of markers fit 32 bits: each
    /// marker takes more than a byte of memory.
    pub fn new(elements: &[ElementData<S>]) -> Self {
        let places = elements.iter().flat_map(|e| {
            e.markers.iter().zip(&e.slots).map(|(&marker, slot)| Place {
                marker: marker as u32,
                slot: slot.map_or(GROUND, |slot| slot as u32),
            })
        });
        Self {
            entries: elements
                .iter()
                .map(|e| Entry {
                    element: Arc::clone(&e.element),
                    markers: e.markers.len() as u32,
                    rows: e.rows.len() as u32,
                    aux: e.aux.len() as u32,
                    bodies: e.bodies.len() as u32,
                })
                .collect(),
            places: places.collect(),
        }
    }

    /// The elements in order.
    pub fn steps(&self) -> impl Iterator<Item = Step<'_, S>> {
        let mut rest = &self.places[..];
        self.entries.iter().map(move |entry| {
            let (places, behind) = rest.split_at(entry.markers as usize);
            rest = behind;
            Step {
                element: &*entry.element,
                places,
                rows: entry.rows as usize,
                aux: entry.aux as usize,
                bodies: entry.bodies as usize,
            }
        })
    }
}

impl<S: Space> Default for Plan<S> {
    fn default() -> Self {
        Self {
            entries: Vec::new(),
            places: Vec::new(),
        }
    }
}
