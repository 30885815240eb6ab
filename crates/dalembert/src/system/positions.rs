//! Positions of a machine: how they move with the velocity coordinates.

use super::System;
use crate::space::{Space, Tuple};

impl<S: Space> System<S> {
    /// Moves positions by factor * step, a step in the velocity coordinates.
    pub fn advance(&self, q: &mut [f64], factor: f64, step: &[f64]) {
        if S::NQ == S::NV {
            // Plain coordinates: one sum.
            for (x, d) in q.iter_mut().zip(step) {
                *x += factor * d;
            }
            return;
        }
        let (nq, nv) = (self.bodies.len() * S::NQ, self.body_nv());
        let (bodies, rest) = q.split_at_mut(nq);
        let mut own = S::Twist::default();
        for (q, d) in bodies
            .chunks_exact_mut(S::NQ)
            .zip(step[..nv].chunks_exact(S::NV))
        {
            for (own, d) in own.as_mut_slice().iter_mut().zip(d) {
                *own = factor * d;
            }
            S::advance(q, own.as_slice());
        }
        for (x, d) in rest.iter_mut().zip(&step[nv..]) {
            *x += factor * d;
        }
        self.count_turns(q);
    }

    /// The smallest step in the velocity coordinates that [`System::advance`] needs from one pose to another.
    pub fn difference(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        let (nq, nv) = (self.bodies.len() * S::NQ, self.body_nv());
        let mut step = vec![0.0; self.nv()];
        let (bodies, rest) = step.split_at_mut(nv);
        for ((out, from), to) in bodies
            .chunks_exact_mut(S::NV)
            .zip(from.chunks_exact(S::NQ))
            .zip(to.chunks_exact(S::NQ))
        {
            S::difference(from, to, out);
        }
        for ((out, from), to) in rest.iter_mut().zip(&from[nq..]).zip(&to[nq..]) {
            *out = to - from;
        }
        step
    }

    /// Rates of the positions with velocities v.
    pub fn position_rates(&self, q: &[f64], v: &[f64], out: &mut [f64]) {
        if S::NQ == S::NV {
            out.copy_from_slice(v);
            return;
        }
        let (nq, nv) = (self.bodies.len() * S::NQ, self.body_nv());
        let (bodies, rest) = out.split_at_mut(nq);
        for ((out, q), v) in bodies
            .chunks_exact_mut(S::NQ)
            .zip(q.chunks_exact(S::NQ))
            .zip(v.chunks_exact(S::NV))
        {
            S::rate(q, v, out);
        }
        let (aux, turns) = rest.split_at_mut(self.aux);
        aux.copy_from_slice(&v[nv..]);
        // What is remembered changes between steps, not in them.
        turns.fill(0.0);
    }

    /// Brings redundant coordinates of the bodies back to their own condition, and remembered angles up to date.
    pub fn normalize(&self, q: &mut [f64]) {
        let nq = self.bodies.len() * S::NQ;
        q[..nq].chunks_exact_mut(S::NQ).for_each(S::normalize);
        self.count_turns(q);
    }
}
