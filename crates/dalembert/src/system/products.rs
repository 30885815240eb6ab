//! Products with the mass matrix and the Jacobian, and both as dense matrices.

use super::{ElementData, System, Workspace};
use crate::space::Space;

impl<S: Space> System<S> {
    /// out = M v on the bodies.
    pub fn mass_mul(&self, v: &[f64], out: &mut [f64]) {
        let n = S::NV;
        for b in 0..self.bodies.len() {
            let block = &self.mass[b * n * n..(b + 1) * n * n];
            for i in 0..n {
                out[b * n + i] = (0..n).map(|j| block[i * n + j] * v[b * n + j]).sum();
            }
        }
    }

    /// out = C_q v (with the auxiliary columns).
    pub fn jac_mul(&self, ws: &Workspace<S>, v: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        self.each_block(|e, body, at| {
            for (r, row) in e.rows.clone().enumerate() {
                let j = &ws.jac[at + r * S::NV..at + (r + 1) * S::NV];
                let x = &v[body * S::NV..(body + 1) * S::NV];
                out[row] += j.iter().zip(x).map(|(a, b)| a * b).sum::<f64>();
            }
        });
        self.each_aux(|row, aux, at| out[row] += ws.jac_aux[at] * v[self.body_nv() + aux]);
    }

    /// out += factor * C_q^T lambda (with the auxiliary columns).
    pub fn jac_transpose_add(
        &self,
        ws: &Workspace<S>,
        factor: f64,
        lambda: &[f64],
        out: &mut [f64],
    ) {
        self.each_block(|e, body, at| {
            for (r, row) in e.rows.clone().enumerate() {
                let j = &ws.jac[at + r * S::NV..at + (r + 1) * S::NV];
                for (x, y) in out[body * S::NV..(body + 1) * S::NV].iter_mut().zip(j) {
                    *x += factor * lambda[row] * y;
                }
            }
        });
        let n = self.body_nv();
        self.each_aux(|row, aux, at| out[n + aux] += factor * lambda[row] * ws.jac_aux[at]);
    }

    pub(super) fn each_block(&self, mut f: impl FnMut(&ElementData<S>, usize, usize)) {
        let mut at = 0;
        for e in &self.elements {
            for &b in &e.bodies {
                f(e, b, at);
                at += e.rows.len() * S::NV;
            }
        }
    }

    pub(super) fn each_aux(&self, mut f: impl FnMut(usize, usize, usize)) {
        let mut at = 0;
        for e in &self.elements {
            for row in e.rows.clone() {
                for aux in e.aux.clone() {
                    f(row, aux, at);
                    at += 1;
                }
            }
        }
    }

    /// C_q as a dense matrix, rows x velocity coordinates.
    pub fn dense_jacobian(&self, ws: &Workspace<S>) -> nalgebra::DMatrix<f64> {
        let mut c = nalgebra::DMatrix::zeros(self.rows, self.nv());
        self.each_block(|e, body, at| {
            for (r, row) in e.rows.clone().enumerate() {
                for k in 0..S::NV {
                    c[(row, body * S::NV + k)] += ws.jac[at + r * S::NV + k];
                }
            }
        });
        let n = self.body_nv();
        self.each_aux(|row, aux, at| c[(row, n + aux)] += ws.jac_aux[at]);
        c
    }

    /// M as a dense matrix (auxiliaries have none).
    pub fn dense_mass(&self) -> nalgebra::DMatrix<f64> {
        let mut m = nalgebra::DMatrix::zeros(self.nv(), self.nv());
        let n = S::NV;
        for b in 0..self.bodies.len() {
            for i in 0..n {
                for j in 0..n {
                    m[(b * n + i, b * n + j)] = self.mass[(b * n + i) * n + j];
                }
            }
        }
        m
    }
}
