//! What one run of a route came to.

use nalgebra::DVector;

/// Which equilibrium a run heads for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Goal {
    /// The one where the machine comes to rest when it is let go.
    Rest,
    /// Whichever is near.
    Any,
}

/// What one run of a route came to; multipliers and forces in scaled units.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    pub q: Vec<f64>,
    /// The scaled steps that led here, added up: it counts whole turns, which positions in space do not.
    pub way: DVector<f64>,
    pub lambda: DVector<f64>,
    /// Unbalanced force in the free motions.
    pub unbalanced: DVector<f64>,
    /// Its norm relative to the largest force.
    pub residual: f64,
    /// The largest force met on the way, scaled.
    pub scale: f64,
    pub iterations: usize,
    pub converged: bool,
}
