//! Watches a driven motion for singular poses.

use crate::formulation::column_scale;
use crate::solve::independent_rows;
use crate::space::Space;
use crate::system::{System, Workspace};
use nalgebra::DMatrix;

/// Watches the sign of the determinant of the independent rows: a change means that a singular
/// pose lies between two instants, where Newton could land on either branch.
#[derive(Debug)]
pub(super) struct Watch {
    /// Independent rows; empty where the system is too large to be watched.
    pub(super) rows: Vec<usize>,
    /// Sign of the determinant.
    pub(super) sign: f64,
    /// Smallest ratio of pivots.
    pub(super) smallest: f64,
}

impl Watch {
    pub(super) fn new(c: &DMatrix<f64>) -> Self {
        let mut watch = Self {
            // Columns are scaled already; a failure (not finite) leaves nothing to watch.
            rows: independent_rows(c, &vec![1.0; c.ncols()], 1e-8).unwrap_or_default(),
            sign: 0.0,
            smallest: 1.0,
        };
        watch.look(c);
        watch
    }

    pub(super) fn none() -> Self {
        Self {
            rows: Vec::new(),
            sign: 0.0,
            smallest: 1.0,
        }
    }

    /// Sign of the determinant and smallest pivot ratio.
    pub(super) fn look(&mut self, c: &DMatrix<f64>) {
        if self.rows.len() != c.ncols() {
            return;
        }
        let mut square = c.select_rows(&self.rows);
        for mut row in square.row_iter_mut() {
            let norm = row.norm();
            if norm > 0.0 {
                row /= norm;
            }
        }
        let lu = square.full_piv_lu();
        let diagonal = lu.u().diagonal();
        let largest = diagonal.amax();
        self.smallest = if largest > 0.0 {
            diagonal.amin() / largest
        } else {
            0.0
        };
        self.sign = lu.determinant().signum();
    }
}

/// C_q with columns in units of the machine's size.
pub(super) fn scaled_jacobian<S: Space>(system: &System<S>, ws: &Workspace<S>) -> DMatrix<f64> {
    let mut c = system.dense_jacobian(ws);
    for (mut column, scale) in c.column_iter_mut().zip(column_scale(system)) {
        column *= scale;
    }
    c
}
