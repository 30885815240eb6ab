//! The bushing with coupled matrices, against the derivatives of its pose by dual numbers.

use super::oracle::{Number, dot, marker};
use super::*;
use dalembert::force::{Bushing, ForceElement};
use dalembert::space::orientation::EulerSequence;
use dalembert::space::{Space, Spatial, SpatialFrame, SpatialPose};
use nalgebra::{DMatrix, DVector, Vector3, Vector6};
use num_dual::Dual64;
use std::marker::PhantomData;

/// A few roundings of sums of some thirty products, and of the logarithm.
const EXACT: f64 = 2e-13;

struct Two {
    poses: [SpatialPose; 2],
    frames: [SpatialFrame; 2],
}

impl Two {
    fn new(source: &mut Random) -> Self {
        let frame = |source: &mut Random| SpatialFrame {
            at: Vector3::from(random(source, 0.7)),
            axes: *EulerSequence::ZXZ
                .rotation(&Vector3::from(random(source, 3.0)))
                .to_rotation_matrix()
                .matrix(),
        };
        Self {
            poses: [0; 2].map(|_| Spatial::pose(&random::<7>(source, 1.5))),
            frames: [0; 2].map(|_| frame(source)),
        }
    }

    /// Displacements in the first frame and the rotation vector, after the time s: theta (R - R^T) / (2 sin theta).
    fn pose<D: Number>(&self, v: &[f64], s: D) -> [D; 6] {
        let [a, b] =
            [0, 1].map(|k| marker(&self.poses[k], &self.frames[k], &v[6 * k..6 * k + 6], s));
        let d = [0, 1, 2].map(|k| b.point[k] - a.point[k]);
        let r = |i: usize, j: usize| dot(&a.axes[i], &b.axes[j]);
        let twice = [r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)];
        let sine = dot(&twice, &twice).sqrt() * 0.5;
        let cosine = (r(0, 0) + r(1, 1) + r(2, 2) - 1.0) * 0.5;
        let factor = sine.atan2(cosine) / (sine * 2.0);
        let along = |k: usize| dot(&a.axes[k], &d);
        let turn = |k: usize| twice[k] * factor;
        [along(0), along(1), along(2), turn(0), turn(1), turn(2)]
    }
}

/// Values and derivatives along a motion.
fn along(two: &Two, v: &[f64]) -> (DVector<f64>, DVector<f64>) {
    let pose = two.pose(v, Dual64::new(0.0, 1.0));
    let part = |f: fn(&Dual64) -> f64| DVector::from_iterator(6, pose.iter().map(f));
    (part(|x| x.re), part(|x| x.eps))
}

#[test]
fn coupled_bushings_pull_by_their_potential_and_damp_by_their_rates() {
    let mut source = Random::new(SEED);
    for state in 0..20 {
        let two = Two::new(&mut source);
        let square = |source: &mut Random| {
            DMatrix::from_fn(6, 6, |i, j| {
                source.uniform(-1.0, 1.0) + if i == j { 4.0 } else { 0.0 }
            })
        };
        let k = square(&mut source);
        let stiffness = &k + k.transpose();
        let damping = square(&mut source);
        let v: [f64; 12] = random(&mut source, 2.0);
        let what = format!("seed {SEED}, state {state}");

        let (pose, rate) = along(&two, &v);
        assert!(pose.rows(3, 3).norm() > 0.1, "{what}: not off rest");
        let force = -(&stiffness * &pose + &damping * &rate);
        let expected: Vec<f64> = (0..12)
            .map(|k| {
                let mut unit = [0.0; 12];
                unit[k] = 1.0;
                along(&two, &unit).1.dot(&force)
            })
            .collect();

        let bushing = Bushing::<Spatial> {
            stiffness: stiffness.clone(),
            damping: damping.clone(),
            space: PhantomData,
        };
        let markers =
            [0, 1].map(|k| Spatial::marker(&two.frames[k], &two.poses[k], &v[6 * k..6 * k + 6]));
        let mut wrenches = [Vector6::zeros(); 2];
        bushing.wrenches(0.0, &markers, &mut wrenches);
        let found: Vec<f64> = (0..2)
            .flat_map(|k| Spatial::pull(&markers[k], &wrenches[k]).as_slice().to_vec())
            .collect();
        near(&format!("{what}: force"), &found, &expected, EXACT);

        let report = bushing.report(0.0, &markers);
        let potential = 0.5 * pose.dot(&(&stiffness * &pose));
        let potential_rate = pose.dot(&(&stiffness * &rate));
        let damped = rate.dot(&(&damping * &rate));
        assert!(damped > 0.0, "{what}");
        near(
            &format!("{what}: potential, its rate, power"),
            &[report.potential, report.potential_rate, report.values[6]],
            &[potential, potential_rate, -potential_rate - damped],
            EXACT,
        );
        // Power is force times velocity.
        let power: f64 = found.iter().zip(&v).map(|(f, v)| f * v).sum();
        near(&what, &[power], &[report.values[6]], EXACT);
        // Action and reaction: force and moment about the origin add up to nothing.
        let about_origin = |k: usize| {
            let w = &wrenches[k];
            let f = Vector3::new(w[0], w[1], w[2]);
            let m = Vector3::new(w[3], w[4], w[5]) + markers[k].point.cross(&f);
            [f, m]
        };
        let ([f, m], [g, n]) = (about_origin(0), about_origin(1));
        let left = [(f + g).norm(), (m + n).norm()];
        assert!(
            left.iter().all(|x| *x < EXACT * force.norm()),
            "{what}: {left:?}"
        );
    }
}
