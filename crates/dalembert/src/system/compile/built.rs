//! What an element of the model becomes on its way into the system.

use crate::joint::{ConstraintElement, MeasureRow, MeasureRows};
use crate::space::Space;
use crate::system::Coordinate;
use smallvec::SmallVec;
use std::sync::Arc;

/// A constraint element with the markers and coordinates that belong to it.
pub(super) struct Built<S: Space> {
    pub kind: &'static str,
    pub element: Arc<dyn ConstraintElement<S>>,
    pub markers: SmallVec<[usize; 4]>,
    pub coordinates: SmallVec<[Coordinate<S>; 2]>,
    pub auxiliary_start: SmallVec<[f64; 1]>,
    /// Marker of the user's second body, on which the reaction is reported.
    pub reaction_marker: usize,
}

impl<S: Space> Built<S> {
    /// Rows that are sums of measures between two markers.
    pub fn rows(
        kind: &'static str,
        markers: [usize; 2],
        rows: SmallVec<[MeasureRow<S>; 2]>,
        coordinates: SmallVec<[Coordinate<S>; 2]>,
    ) -> Self {
        Self {
            kind,
            element: Arc::new(MeasureRows::new(2, rows)),
            markers: SmallVec::from_slice(&markers),
            coordinates,
            auxiliary_start: SmallVec::new(),
            reaction_marker: 1,
        }
    }
}
