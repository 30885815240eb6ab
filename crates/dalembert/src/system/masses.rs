//! Size and masses of a compiled machine.

use super::{Metric, System};
use crate::space::Space;

/// Lengths below this part of the extent of a machine are rounding.
const ROUNDING: f64 = 1e-12;

impl<S: Space> System<S> {
    /// The characteristic length: the farthest reach of a marker from its body's centre or of a surface from its marker,
    /// or, where all are at their centres, the extent of the estimate.
    pub(crate) fn set_size(&mut self) {
        let arms = self
            .markers
            .iter()
            .filter(|m| m.body.is_some())
            .map(|m| S::arm(&m.frame))
            .chain(self.elements.iter().map(|e| e.element.reach()))
            .fold(0.0, f64::max);
        let bodies = self.estimate.q.chunks_exact(S::NQ).take(self.bodies.len());
        let extent = bodies.map(|q| S::reach(q)[0]).fold(0.0, f64::max);
        // Arms of rounding size, like that of cos(90 deg), are none.
        let size = if arms > ROUNDING * extent {
            arms
        } else {
            extent
        };
        self.size = if size > 0.0 { size } else { 1.0 };
    }

    /// Weighs the bodies and makes the masses regular; the size is set.
    pub(crate) fn set_masses(&mut self) {
        let n = S::NV;
        self.weight = vec![0.0; n * self.bodies.len()];
        for (weight, block) in self
            .weight
            .chunks_exact_mut(n)
            .zip(self.mass.chunks_exact(n * n))
        {
            for (w, g) in weight.iter_mut().zip(&self.gravity).take(S::LINEAR) {
                *w = block[0] * g;
            }
        }
        self.massless = self.bodies.iter().any(|b| b.massless);
        self.metric = Metric::new(self);
    }

    /// Mass block of a body, NV x NV, row-major.
    pub fn mass_block(&self, body: usize) -> &[f64] {
        &self.mass[body * S::NV * S::NV..(body + 1) * S::NV * S::NV]
    }
}
