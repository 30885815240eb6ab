//! The equations of motion as dense matrices.

use super::FormulationError;
use crate::joint::RowUnit;
use crate::space::Space;
use crate::system::{System, Workspace};
use nalgebra::{DMatrix, DVector};

/// M a + C_q^T lambda = Q, C_q a = Q_d in some coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Terms {
    /// M.
    pub mass: DMatrix<f64>,
    /// C_q.
    pub jacobian: DMatrix<f64>,
    /// Q = Q_e + Q_v.
    pub force: DVector<f64>,
    /// Q_d.
    pub qd: DVector<f64>,
    /// Typical size of each coordinate, for rank decisions.
    pub column_scale: Vec<f64>,
}

impl Terms {
    /// The terms of a system at the state of its workspace, in the engine's coordinates.
    pub fn of<S: Space>(system: &System<S>, ws: &Workspace<S>) -> Self {
        Self {
            mass: system.dense_mass(),
            jacobian: system.dense_jacobian(ws),
            force: DVector::from_column_slice(&ws.force),
            qd: DVector::from_column_slice(&ws.qd),
            column_scale: column_scale(system),
        }
    }

    /// Refuses values that are not finite.
    ///
    /// # Errors
    /// [`FormulationError::NotFinite`].
    pub fn check(&self) -> Result<(), FormulationError> {
        let matrices = self.mass.iter().chain(self.jacobian.iter());
        let vectors = self.force.iter().chain(self.qd.iter());
        if matrices.chain(vectors).all(|x| x.is_finite()) {
            Ok(())
        } else {
            Err(FormulationError::NotFinite)
        }
    }

    /// Largest |C_q a - Q_d| of a row over the largest term that its gradient could give with the largest acceleration.
    pub fn constraint_residual(&self, a: &DVector<f64>) -> f64 {
        let fastest = a
            .iter()
            .zip(&self.column_scale)
            .fold(0.0_f64, |most, (a, s)| most.max((a / s).abs()));
        let mut worst: f64 = 0.0;
        for (row, qd) in self.jacobian.row_iter().zip(self.qd.iter()) {
            let (mut sum, mut gradient) = (-qd, 0.0_f64);
            for ((c, a), s) in row.iter().zip(a.iter()).zip(&self.column_scale) {
                sum += c * a;
                gradient = gradient.max((c * s).abs());
            }
            let largest = (gradient * fastest).max(qd.abs());
            if largest > 0.0 {
                worst = worst.max(sum.abs() / largest);
            }
        }
        worst
    }
}

/// Typical size of each velocity coordinate: the machine's size for lengths, one for angles.
pub fn column_scale<S: Space>(system: &System<S>) -> Vec<f64> {
    // Linear components come first: 2 of 3 in the plane, 3 of 6 in space.
    let linear = S::LINEAR;
    let mut scale = Vec::with_capacity(system.nv());
    for _ in &system.bodies {
        for k in 0..S::NV {
            scale.push(if k < linear { system.size } else { 1.0 });
        }
    }
    for e in &system.elements {
        for label in e.element.auxiliaries() {
            scale.push(match label.unit {
                RowUnit::Length => system.size,
                RowUnit::Angle | RowUnit::Other => 1.0,
            });
        }
    }
    scale
}
