//! How far a state is off the constraints.

use super::{System, Workspace};
use crate::space::Space;

impl<S: Space> System<S> {
    /// What a residual, in units of the row scales, can be by the rounding of the positions alone:
    /// machines far from the origin, or after many turns.
    pub fn rounding(&self, q: &[f64]) -> f64 {
        let mut largest = [0.0_f64; 2];
        for body in q[..self.bodies.len() * S::NQ].chunks_exact(S::NQ) {
            let [distance, angle] = S::reach(body);
            largest = [largest[0].max(distance), largest[1].max(angle)];
        }
        4.0 * f64::EPSILON * (1.0 + largest[0] / self.size + largest[1])
    }

    /// Largest residual in units of the row scales, and its row.
    pub fn violation(&self, ws: &Workspace<S>) -> (f64, usize) {
        self.largest(&ws.value)
    }

    /// Largest entry of a vector over the rows, in units of the row scales, and its row.
    pub fn largest(&self, x: &[f64]) -> (f64, usize) {
        let mut worst = (0.0, 0);
        for (row, value) in x.iter().enumerate() {
            let scaled = value.abs() / self.row_scale(row);
            // A NaN counts as infinitely large.
            if scaled.is_nan() {
                return (f64::INFINITY, row);
            }
            if scaled > worst.0 {
                worst = (scaled, row);
            }
        }
        worst
    }
}
