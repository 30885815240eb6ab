//! Coordinates of the user's body frames.

use super::ReferenceFrame;
use crate::formulation::{Terms, column_scale};
use crate::space::Planar;
use crate::system::{State, System, Workspace};
use nalgebra::DVector;

/// The equations in coordinates (reference points and angles, then auxiliaries).
#[derive(Clone, Debug)]
pub(super) struct CoordinateTerms {
    pub positions: DVector<f64>,
    pub velocities: DVector<f64>,
    /// Q_e.
    pub applied: DVector<f64>,
    /// Q_v.
    pub centrifugal: DVector<f64>,
    /// The rest, with Q = Q_e + Q_v.
    pub terms: Terms,
    /// From each reference point to the centre of mass, ground axes, a pair a body.
    arms: Vec<[f64; 2]>,
}

impl CoordinateTerms {
    /// The terms at the state of a workspace.
    ///
    /// With c the way from the reference point to the centre of mass, v_c = v_O + w k x c, in short v_c = T v:
    /// M = T^T M_c T holds the first moment m k x c, Q_v = w^2 [m c; 0] and C_q a = Q_d loses the same normal
    /// acceleration (Shabana 6.16 to 6.45).
    pub fn new(
        system: &System<Planar>,
        state: &State,
        ws: &Workspace<Planar>,
        frame: ReferenceFrame,
    ) -> Self {
        let mut terms = Terms {
            mass: system.dense_mass(),
            jacobian: system.dense_jacobian(ws),
            force: DVector::zeros(system.nv()),
            qd: DVector::from_column_slice(&ws.qd),
            column_scale: column_scale(system),
        };
        let mut positions = DVector::from_column_slice(&state.q);
        let mut velocities = DVector::from_column_slice(&state.v);
        let mut applied = DVector::from_column_slice(&ws.force);
        let mut centrifugal = DVector::zeros(system.nv());
        let mut arms = vec![[0.0; 2]; system.bodies.len()];
        for (b, body) in system.bodies.iter().enumerate() {
            let at = 3 * b;
            let away = ws.markers[body.frame_marker].arm;
            if frame == ReferenceFrame::Center || away.norm() == 0.0 {
                continue;
            }
            let c = [-away.x, -away.y];
            arms[b] = c;
            let (m, w) = (terms.mass[(at, at)], velocities[at + 2]);
            for k in 0..2 {
                positions[at + k] -= c[k];
                centrifugal[at + k] = m * w * w * c[k];
            }
            velocities[at] += w * c[1];
            velocities[at + 1] -= w * c[0];
            // The column of the angle: what turning about the reference point does to the centre.
            let side = [-m * c[1], m * c[0]];
            for (k, side) in side.into_iter().enumerate() {
                terms.mass[(at + k, at + 2)] = side;
                terms.mass[(at + 2, at + k)] = side;
            }
            terms.mass[(at + 2, at + 2)] += m * (c[0] * c[0] + c[1] * c[1]);
            applied[at + 2] += c[0] * applied[at + 1] - c[1] * applied[at];
            for row in 0..system.rows {
                let (x, y) = (terms.jacobian[(row, at)], terms.jacobian[(row, at + 1)]);
                terms.jacobian[(row, at + 2)] += c[0] * y - c[1] * x;
                terms.qd[row] += w * w * (c[0] * x + c[1] * y);
            }
        }
        terms.force = &applied + &centrifugal;
        Self {
            positions,
            velocities,
            applied,
            centrifugal,
            terms,
            arms,
        }
    }

    /// Sum of m |a_c|^2 / 2 + J (theta''^2 + theta'^4) / 2 (Shabana 5.164, integrated over a planar rigid body).
    pub fn gibbs_appel(&self, system: &System<Planar>, a: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (b, c) in self.arms.iter().enumerate() {
            let (m, j) = (system.mass[9 * b], system.mass[9 * b + 8]);
            let a = &a[3 * b..3 * b + 3];
            let w2 = self.velocities[3 * b + 2].powi(2);
            let x = a[0] - a[2] * c[1] - w2 * c[0];
            let y = a[1] + a[2] * c[0] - w2 * c[1];
            sum += 0.5 * m * (x * x + y * y) + 0.5 * j * (a[2] * a[2] + w2 * w2);
        }
        sum
    }
}
