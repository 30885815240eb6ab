//! The user's body frame as the reference of a body's coordinates.

use crate::space::{Space, Tuple};
use crate::system::{System, Workspace};
use nalgebra::{DMatrix, DVector};

/// v = T u, a = T u' + gamma: from the velocities u of a body's own frame to those of its centre of mass.
#[derive(Clone, Debug)]
pub(super) struct BodyFrame {
    /// T.
    pub transform: DMatrix<f64>,
    /// gamma: with c the way from the frame to the centre, omega x (omega x c).
    pub bias: DVector<f64>,
    /// u.
    pub velocities: DVector<f64>,
    /// Positions of the frame.
    pub positions: Vec<f64>,
}

impl BodyFrame {
    /// Of a body at the state of a workspace; none where the frame is that of the engine.
    pub fn new<S: Space>(system: &System<S>, ws: &Workspace<S>, body: usize) -> Option<Self> {
        let data = &system.bodies[body];
        if data.frame == S::Frame::default() {
            return None;
        }
        let marker = &ws.markers[data.frame_marker];
        let mut transform = DMatrix::zeros(S::NV, S::NV);
        for k in 0..S::NV {
            let mut unit = S::Twist::zero();
            unit.as_mut_slice()[k] = 1.0;
            let column = S::from_own(&data.frame, marker, &unit);
            transform.column_mut(k).copy_from_slice(column.as_slice());
        }
        let mut positions = vec![0.0; S::NQ];
        S::own_position(marker, &mut positions);
        Some(Self {
            transform,
            bias: -DVector::from_column_slice(S::bias(marker).as_slice()),
            velocities: DVector::from_column_slice(S::own_velocity(marker).as_slice()),
            positions,
        })
    }
}
