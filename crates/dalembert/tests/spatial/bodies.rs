//! Coordinates of a spatial body: rates, steps, differences; pull and push; gyroscopic forces.

use super::*;
use dalembert::space::{Space, Spatial, SpatialFrame, Tuple};
use nalgebra::{Matrix3, Vector3, Vector6};

fn pose(source: &mut Random) -> [f64; 7] {
    let mut q = random::<7>(source, 1.0);
    Spatial::normalize(&mut q);
    q
}

#[test]
fn steps_and_differences_are_inverse() {
    let mut source = Random::new(SEED);
    for _ in 0..100 {
        let from = pose(&mut source);
        // Less than half a turn, so that the smallest step is the one taken.
        let step = random::<6>(&mut source, 1.7);
        let mut to = from;
        Spatial::advance(&mut to, &step);
        let norm: f64 = to[3..].iter().map(|b| b * b).sum();
        assert!((norm - 1.0).abs() < 1e-15);
        let mut found = [0.0; 6];
        Spatial::difference(&from, &to, &mut found);
        near("step", &found, &step, 1e-14);
        // Both signs of the parameters are one orientation.
        for b in &mut to[3..] {
            *b = -*b;
        }
        Spatial::difference(&from, &to, &mut found);
        near("step to the other sign", &found, &step, 1e-14);
    }
}

#[test]
fn rates_are_those_of_steps() {
    let mut source = Random::new(SEED);
    let (q, v) = (pose(&mut source), random::<6>(&mut source, 2.0));
    let mut rate = [0.0; 7];
    Spatial::rate(&q, &v, &mut rate);
    let h = 1e-3;
    let at = |s: f64| {
        let mut q = q;
        Spatial::advance(&mut q, &v.map(|x| s * x));
        q
    };
    let (a, b, c, d) = (at(h), at(-h), at(2.0 * h), at(-2.0 * h));
    let expected: Vec<f64> = (0..7)
        .map(|k| (8.0 * (a[k] - b[k]) - (c[k] - d[k])) / (12.0 * h))
        .collect();
    // Fourth order: h^4 times the fifth derivative.
    near("rate", &rate, &expected, 1e-11);
}

#[test]
fn pull_is_the_transpose_of_push() {
    let mut source = Random::new(SEED);
    for _ in 0..20 {
        let frame = SpatialFrame {
            at: Vector3::from(random(&mut source, 1.0)),
            axes: Matrix3::identity(),
        };
        let v = random::<6>(&mut source, 1.0);
        let m = Spatial::marker(&frame, &Spatial::pose(&pose(&mut source)), &v);
        let (wrench, twist) = (
            Vector6::from(random(&mut source, 1.0)),
            Vector6::from(random(&mut source, 1.0)),
        );
        let left = Tuple::dot(&Spatial::pull(&m, &wrench), &twist);
        let right = Tuple::dot(&wrench, &Spatial::push(&m, &twist));
        near("work", &[left], &[right], 1e-15);
        // The velocities of the body itself give the marker's own twist.
        near(
            "twist",
            Spatial::push(&m, &Vector6::from(v)).as_slice(),
            Spatial::twist(&m).as_slice(),
            1e-15,
        );
    }
}

/// Shabana, Example 7.10: the moment that keeps 15 rad/s about body x constant is (0, 225, 0) N m; and Problem 7.32.
#[test]
fn gyroscopic_moments() {
    let moment = |inertia: [[f64; 3]; 3], omega: [f64; 3]| {
        let mut mass = [0.0; 36];
        for i in 0..3 {
            mass[7 * i] = 2.0;
            for j in 0..3 {
                mass[6 * (3 + i) + 3 + j] = inertia[i][j];
            }
        }
        let [x, y, z] = omega;
        let force = Spatial::gyroscopic(&mass, &[0.3, -0.2, 0.1, x, y, z]);
        assert_eq!(force.as_slice()[..3], [0.0; 3]);
        [-force[3], -force[4], -force[5]]
    };
    let first = moment(
        [[1.5, 0.0, -1.0], [0.0, 2.0, 0.0], [-1.0, 0.0, 2.5]],
        [15.0, 0.0, 0.0],
    );
    assert_eq!(first, [0.0, 225.0, 0.0]);
    let second = moment(
        [[2.0, 1.5, -1.0], [1.5, 1.8, 0.5], [-1.0, 0.5, 3.0]],
        [0.0, 20.0, 0.0],
    );
    assert_eq!(second, [200.0, 0.0, -600.0]);
}
