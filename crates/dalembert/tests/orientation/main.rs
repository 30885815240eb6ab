//! Orientation coordinates: conversions, their singular poses, rates; and the numbers of Shabana's chapters 7 and 8.

mod cosines;
mod euler;
mod parameters;
mod problems;
#[path = "../support/mod.rs"]
mod support;

use dalembert::space::orientation::Rotation;
use nalgebra::{Matrix3, Quaternion, Vector3};
use support::Random;

const SEED: u64 = 71_085;

/// A few roundings.
const EXACT: f64 = 4e-15;

/// A random orientation: four numbers of a normal distribution would be even; even signs and sizes suffice here.
fn rotation(random: &mut Random) -> Rotation {
    let [w, i, j, k] = [0; 4].map(|_| random.uniform(-1.0, 1.0));
    Rotation::from_quaternion(Quaternion::new(w, i, j, k))
}

fn vector(random: &mut Random) -> Vector3<f64> {
    Vector3::from_fn(|_, _| random.uniform(-2.0, 2.0))
}

fn matrix(rotation: &Rotation) -> Matrix3<f64> {
    *rotation.to_rotation_matrix().matrix()
}

/// The same orientation, whatever the sign of its quaternion.
#[track_caller]
fn same(found: &Rotation, expected: &Rotation, tolerance: f64) {
    let d = (matrix(found) - matrix(expected)).amax();
    assert!(d <= tolerance, "{found} for {expected}, off by {d:e}");
}

#[track_caller]
fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (x, y) in found.iter().zip(expected) {
        assert!(
            (x - y).abs() <= tolerance,
            "{found:?} for {expected:?}, off by {:e}",
            x - y
        );
    }
}

/// Derivative of a matrix along a path by central differences of order 8, good to 1e-11 at this step.
fn rate(path: impl Fn(f64) -> Matrix3<f64>) -> Matrix3<f64> {
    let h = 0.01;
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut sum = Matrix3::zeros();
    for (k, w) in weights.into_iter().enumerate() {
        let s = h * (k + 1) as f64;
        sum += (path(s) - path(-s)) * w;
    }
    sum / h
}

/// omegabar of A^T dA/dt.
fn body_omega(a: &Matrix3<f64>, rate: &Matrix3<f64>) -> Vector3<f64> {
    let w = a.transpose() * rate;
    Vector3::new(w[(2, 1)], w[(0, 2)], w[(1, 0)])
}
