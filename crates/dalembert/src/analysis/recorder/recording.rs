//! What is written besides the usual.

use crate::space::orientation::OrientationSet;

/// Choices of what a run writes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Recording {
    /// Coordinates in which orientations in space are written.
    pub orientation: OrientationSet,
    /// Point, in ground axes, about which the angular momentum of each body and of the machine is written [m]; none: that
    /// of the machine only, about the origin.
    pub momentum_about: Option<[f64; 3]>,
}
