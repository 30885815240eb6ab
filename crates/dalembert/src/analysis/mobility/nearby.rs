//! Poses near a given one, on the constraints.

use super::super::newton::{NewtonOptions, correct_positions};
use super::super::weights::Weights;
use crate::formulation::column_scale;
use crate::space::Space;
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
pub(super) fn nearby_poses<S: Space>(
    system: &System<S>,
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
        system.advance(&mut pose.q, step / largest, direction.as_slice());
        let found = correct_positions(
            system,
            &mut ws,
            &mut pose,
            &weights,
            &NewtonOptions::default(),
            &mut trial,
        );
        let moved = system
            .difference(&state.q, &pose.q)
            .iter()
            .zip(&scale)
            .fold(0.0_f64, |m, (d, s)| m.max((d / s).abs()));
        if found.is_ok() && moved > 0.1 * step {
            poses.push(pose);
        }
    }
    poses
}

/// Dependent rows whose dependence ends with the second order along the free motions: with the
/// combination y of rows that vanishes, y.J = 0, and a free motion d, y.C(q + h d) / h^2 stays
/// away from zero. Rows that depend on each other all along a motion leave terms of third order.
pub(super) fn bent_rows<S: Space>(
    system: &System<S>,
    state: &State,
    redundant: &[(usize, Vec<(usize, f64)>)],
    motions: &DMatrix<f64>,
) -> Vec<usize> {
    // Rounding leaves 1e-16 / h^2 = 1e-8, the third order h = 1e-4.
    const STEP: f64 = 1e-4;
    const BENT: f64 = 1e-2;
    let mut bent = Vec::new();
    if motions.ncols() == 0 || redundant.is_empty() {
        return bent;
    }
    let scale = column_scale(system);
    let mut random = Random(0x0DDB_1A5E_5BAD_5EED);
    let mut values = Vec::new();
    for _ in 0..3 {
        let mix = nalgebra::DVector::from_fn(motions.ncols(), |_, _| random.next());
        let direction = motions * mix;
        let size = |(d, s): (&f64, &f64)| (d / s).abs();
        let largest = direction.iter().zip(&scale).map(size).fold(0.0, f64::max);
        let side = |h: f64| {
            let mut pose = state.clone();
            system.advance(&mut pose.q, h / largest, direction.as_slice());
            super::ranked::evaluated(system, &pose).value
        };
        let (here, there) = (side(0.0), side(STEP));
        let change: Vec<f64> = there.iter().zip(&here).map(|(a, b)| a - b).collect();
        values.push(change);
    }
    for (row, others) in redundant {
        let terms = std::iter::once((*row, 1.0)).chain(others.iter().map(|(r, c)| (*r, -c)));
        let (mut weight, mut sums) = (0.0_f64, vec![0.0; values.len()]);
        for (r, y) in terms {
            weight = weight.max((y * system.row_scale(r)).abs());
            for (sum, value) in sums.iter_mut().zip(&values) {
                *sum += y * value[r];
            }
        }
        let curved = |sum: &f64| sum.abs() > BENT * weight * STEP * STEP;
        if sums.iter().any(curved) {
            bent.push(*row);
        }
    }
    bent
}
