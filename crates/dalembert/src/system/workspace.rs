//! Everything that changes while a system is evaluated, allocated once.

use super::System;
use crate::solve::{Factored, Residual, Rhs, Saddle};
use crate::space::Space;

/// Buffers of one evaluation of a system.
#[derive(Debug)]
pub struct Workspace<S: Space> {
    /// Poses of the bodies.
    pub poses: Vec<S::Pose>,
    /// Poses and velocities of the markers.
    pub markers: Vec<S::Marker>,
    /// Auxiliary coordinates.
    pub s: Vec<f64>,
    /// Their rates.
    pub s_rate: Vec<f64>,
    /// C.
    pub value: Vec<f64>,
    /// C_t.
    pub time: Vec<f64>,
    /// Q_d.
    pub qd: Vec<f64>,
    /// C_q of the bodies, in blocks (see [`crate::solve::Saddle`]).
    pub jac: Vec<f64>,
    /// C_q of the auxiliaries, in blocks.
    pub jac_aux: Vec<f64>,
    /// Q_e, all velocity coordinates.
    pub force: Vec<f64>,
    /// Accelerations (or another unknown of the same kind), all velocity coordinates.
    pub a: Vec<f64>,
    /// Multipliers.
    pub lambda: Vec<f64>,
    /// Right side of the constraint rows.
    pub rhs: Vec<f64>,
    /// The solver.
    pub saddle: Saddle,
    /// Q_v of every body; empty where a space has none.
    pub(super) gyroscopic: Vec<S::Twist>,
    pub(super) local_markers: Vec<S::Marker>,
    pub(super) gradient: Vec<S::Twist>,
    zero_aux: Vec<f64>,
}

impl<S: Space> Workspace<S> {
    /// Buffers for a system.
    pub fn new(system: &System<S>) -> Self {
        let (max_rows, max_markers, _) = system.scratch_sizes();
        let saddle = Saddle::new(system.shape());
        let jac_aux = system
            .elements
            .iter()
            .map(|e| e.rows.len() * e.aux.len())
            .sum();
        Self {
            poses: vec![S::Pose::default(); system.bodies.len()],
            markers: system
                .markers
                .iter()
                .map(|m| S::ground_marker(&m.frame))
                .collect(),
            s: vec![0.0; system.aux],
            s_rate: vec![0.0; system.aux],
            value: vec![0.0; system.rows],
            time: vec![0.0; system.rows],
            qd: vec![0.0; system.rows],
            jac: vec![0.0; saddle.jac_len()],
            jac_aux: vec![0.0; jac_aux],
            force: vec![0.0; system.nv()],
            a: vec![0.0; system.nv()],
            lambda: vec![0.0; system.rows],
            rhs: vec![0.0; system.rows],
            saddle,
            gyroscopic: vec![
                S::Twist::default();
                if S::GYROSCOPIC {
                    system.bodies.len()
                } else {
                    0
                }
            ],
            local_markers: vec![S::Marker::default(); max_markers],
            gradient: vec![S::Twist::default(); (max_rows.max(1)) * max_markers],
            zero_aux: vec![0.0; system.aux],
        }
    }

    /// The markers of an element, in its own order.
    pub fn seen(&self, markers: &[usize]) -> Vec<S::Marker> {
        markers.iter().map(|&m| self.markers[m]).collect()
    }

    /// Factors [W C_q^T; C_q 0] with the Jacobian of the workspace.
    pub fn factor(&mut self, weight_inverse: &[f64]) -> Factored<'_> {
        self.saddle.factor(weight_inverse, &self.jac, &self.jac_aux)
    }

    /// Solves W a + C_q^T lambda = f, C_q a = rhs for `a` and `lambda` with the last factors; `f`
    /// has an entry for every velocity coordinate, zero for auxiliaries.
    pub fn solve(&mut self, weight: &[f64], f: &[f64]) -> Residual {
        let bodies = self.a.len() - self.zero_aux.len();
        let (a, s) = self.a.split_at_mut(bodies);
        let rhs = Rhs {
            f: &f[..bodies],
            g: &self.rhs,
            h: &self.zero_aux,
        };
        self.saddle.solve(weight, rhs, a, &mut self.lambda, s)
    }

    /// Solves M a + C_q^T lambda = Q_e, C_q a = rhs with the forces of the workspace.
    pub fn solve_forces(&mut self, mass: &[f64]) -> Residual {
        let bodies = self.a.len() - self.zero_aux.len();
        let (a, s) = self.a.split_at_mut(bodies);
        let rhs = Rhs {
            f: &self.force[..bodies],
            g: &self.rhs,
            h: &self.zero_aux,
        };
        self.saddle.solve(mass, rhs, a, &mut self.lambda, s)
    }
}
