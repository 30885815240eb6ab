//! What counts as 1 in rows that are neither lengths nor angles.

use super::{System, Workspace};
use crate::joint::RowUnit;
use crate::space::Space;

/// How far the pose of the second look is from the first, in parts of the machine's size and radians.
const ASIDE: f64 = 0.1;
/// A gradient below this part of the one aside has nearly vanished at the first pose and says nothing.
const VANISHED: f64 = 1e-3;

impl<S: Space> System<S> {
    /// Sets the scale of user constraints: the change of the residual when the coordinates move by
    /// the machine's size and a radian, by the gradient at the estimate. So the unit in which a
    /// user writes a constraint has no part in its accuracy.
    pub(crate) fn set_row_scales(&mut self) {
        let other = |r: &super::RowRef| r.label.unit == RowUnit::Other;
        if !self.row_refs().iter().any(other) {
            return;
        }
        let here = self.scaled_gradients(&self.estimate.q);
        let linear = S::LINEAR;
        let mut moved = self.estimate.q.clone();
        let uneven = |k: usize| {
            // Uneven steps, so that differences of coordinates change too.
            let step = ASIDE * (1.0 + 0.37 * (k % 5) as f64);
            let is_length = k < self.body_nv() && k % S::NV < linear;
            if is_length { step * self.size } else { step }
        };
        let step: Vec<f64> = (0..self.nv()).map(uneven).collect();
        self.advance(&mut moved, 1.0, &step);
        let aside = self.scaled_gradients(&moved);
        for e in &mut self.elements {
            let largest = |x: &[f64]| x[e.rows.clone()].iter().fold(0.0_f64, |a, b| a.max(*b));
            let scale = largest(&here).max(VANISHED * largest(&aside));
            e.scale = if scale.is_finite() && scale > 0.0 {
                scale
            } else {
                1.0
            };
        }
    }

    /// Norm of the gradient of every row over scaled coordinates.
    fn scaled_gradients(&self, q: &[f64]) -> Vec<f64> {
        let mut ws = Workspace::new(self);
        let still = vec![0.0; self.nv()];
        self.update_markers(q, &still, &mut ws);
        self.evaluate_constraints(self.estimate.t, &mut ws);
        let linear = S::LINEAR;
        let mut norms = vec![0.0_f64; self.rows];
        self.each_block(|e, _, at| {
            for (r, row) in e.rows.clone().enumerate() {
                for k in 0..S::NV {
                    let unit = if k < linear { self.size } else { 1.0 };
                    norms[row] = norms[row].hypot(unit * ws.jac[at + r * S::NV + k]);
                }
            }
        });
        norms
    }
}
