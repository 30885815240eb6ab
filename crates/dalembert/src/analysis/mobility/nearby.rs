//! Poses near a given one, on the constraints.

use super::super::newton::{NewtonOptions, correct_positions};
use super::super::weights::Weights;
use super::ranked::column_scale;
use crate::space::Planar;
use crate::system::{State, System, Workspace};
use nalgebra::DMatrix;

/// A small generator of numbers in [-1, 1] (xorshift64*), so that a report is the same every time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11;
        bits as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Steps along random combinations of the free motions, each brought back onto the constraints.
///
/// `step` is the largest change: relative to the machine's size, or in radians. A pose that falls
/// back to where it came from (a motion that exists only to first order) is not returned.
pub(super) fn nearby_poses(
    system: &System<Planar>,
    state: &State,
    motions: &DMatrix<f64>,
    count: usize,
    step: f64,
) -> Vec<State> {
    let scale = column_scale(system);
    let mut ws = Workspace::new(system);
    let weights = Weights::even(system);
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut trial = Vec::new();
    let mut poses = Vec::new();
    if motions.ncols() == 0 {
        return poses;
    }
    for _ in 0..2 * count {
        if poses.len() == count {
            break;
        }
        let mix = nalgebra::DVector::from_fn(motions.ncols(), |_, _| random.next());
        let direction = motions * mix;
        let largest = direction
            .iter()
            .zip(&scale)
            .fold(0.0_f64, |m, (d, s)| m.max((d / s).abs()));
        if largest.is_nan() || largest <= 0.0 {
            continue;
        }
        let mut pose = state.clone();
        for (x, d) in pose.q.iter_mut().zip(direction.iter()) {
            *x += step / largest * d;
        }
        let found = correct_positions(
            system,
            &mut ws,
            &mut pose,
            &weights,
            &NewtonOptions::default(),
            &mut trial,
        );
        let moved = pose
            .q
            .iter()
            .zip(&state.q)
            .zip(&scale)
            .fold(0.0_f64, |m, ((a, b), s)| m.max(((a - b) / s).abs()));
        if found.is_ok() && moved > 0.1 * step {
            poses.push(pose);
        }
    }
    poses
}
