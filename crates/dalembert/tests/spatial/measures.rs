//! Value, gradients, rate and bias of every measure.

use super::oracle::{Number, marker, measure};
use super::*;
use dalembert::joint::SpatialMeasure;
use dalembert::space::orientation::{Axis, EulerSequence};
use dalembert::space::{Space, Spatial, SpatialFrame, SpatialPose};
use nalgebra::Vector3;
use num_dual::{Dual2_64, Dual64};

/// A few roundings of terms of the size of the largest entry; angles of nearly parallel axes cost a digit.
const EXACT: f64 = 5e-14;

fn kinds() -> Vec<SpatialMeasure> {
    let mut kinds = vec![SpatialMeasure::Distance];
    for e in Axis::ALL {
        kinds.extend([
            SpatialMeasure::Ground(e),
            SpatialMeasure::Along(e),
            SpatialMeasure::Angle(e),
        ]);
        kinds.extend(Axis::ALL.map(|f| SpatialMeasure::Dot(e, f)));
    }
    kinds
}

fn frame(source: &mut Random) -> SpatialFrame {
    let angles = Vector3::from(random(source, 3.0));
    SpatialFrame {
        at: Vector3::from(random(source, 0.7)),
        axes: *EulerSequence::ZXZ
            .rotation(&angles)
            .to_rotation_matrix()
            .matrix(),
    }
}

/// Two bodies with a frame each.
struct Two {
    poses: [SpatialPose; 2],
    frames: [SpatialFrame; 2],
    v: [[f64; 6]; 2],
}

impl Two {
    fn new(source: &mut Random) -> Self {
        Self {
            poses: [0; 2].map(|_| Spatial::pose(&random::<7>(source, 1.5))),
            frames: [0; 2].map(|_| frame(source)),
            v: [0; 2].map(|_| random(source, 2.0)),
        }
    }

    /// The measure after the time s, with other velocities.
    fn at<D: Number>(&self, kind: SpatialMeasure, v: &[[f64; 6]; 2], s: D) -> D {
        let [a, b] = [0, 1].map(|k| marker(&self.poses[k], &self.frames[k], &v[k], s));
        measure(kind, &a, &b)
    }
}

#[test]
fn derivatives_are_exact() {
    let mut source = Random::new(SEED);
    for state in 0..10 {
        let two = Two::new(&mut source);
        let markers = [0, 1].map(|k| Spatial::marker(&two.frames[k], &two.poses[k], &two.v[k]));
        for kind in kinds() {
            let what = format!("{kind:?}, state {state}");
            let found = kind.evaluate(&markers[0], &markers[1]);
            let expected = two.at(kind, &two.v, 0.0);
            near(
                &format!("{what}: value"),
                &[found.value],
                &[expected],
                EXACT,
            );
            let path = two.at(kind, &two.v, Dual2_64::new(0.0, 1.0, 0.0));
            near(&format!("{what}: rate"), &[found.rate], &[path.v1], EXACT);
            // At zero accelerations of the bodies the markers still have their normal accelerations.
            let own = [0, 1].map(|k| Spatial::bias(&markers[k]));
            let second = found.bias + found.first.dot(&own[0]) + found.second.dot(&own[1]);
            near(&format!("{what}: second"), &[second], &[path.v2], EXACT);
            for (body, gradient) in [found.first, found.second].into_iter().enumerate() {
                let pulled = Spatial::pull(&markers[body], &gradient);
                let slopes: Vec<f64> = (0..6)
                    .map(|k| {
                        let mut v = [[0.0; 6]; 2];
                        v[body][k] = 1.0;
                        two.at(kind, &v, Dual64::new(0.0, 1.0)).eps
                    })
                    .collect();
                near(
                    &format!("{what}: gradient of body {body}"),
                    pulled.as_slice(),
                    &slopes,
                    EXACT,
                );
            }
        }
    }
}

/// The poses at which joints stand: points together, axes aligned or opposite.
#[test]
fn degenerate_poses_have_gradients() {
    let plain = SpatialFrame::default();
    let v = [
        [0.1, 0.2, -0.3, 0.4, -0.5, 0.6],
        [0.3, -0.1, 0.2, -0.7, 0.2, 0.5],
    ];
    for turn in [0.0, std::f64::consts::PI, 1.0] {
        let mut q = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        let first = Spatial::pose(&q);
        Spatial::advance(&mut q, &[0.0, 0.0, 0.0, 0.0, 0.0, turn]);
        let two = Two {
            poses: [first, Spatial::pose(&q)],
            frames: [plain; 2],
            v,
        };
        let markers = [0, 1].map(|k| Spatial::marker(&plain, &two.poses[k], &v[k]));
        for kind in kinds() {
            if kind == SpatialMeasure::Distance
                || (turn == 1.0 && matches!(kind, SpatialMeasure::Angle(Axis::X | Axis::Y)))
            {
                continue;
            }
            let found = kind.evaluate(&markers[0], &markers[1]);
            let path = two.at(kind, &v, Dual2_64::new(0.0, 1.0, 0.0));
            near(
                &format!("{kind:?} at {turn}"),
                &[found.rate, found.bias],
                &[path.v1, path.v2],
                EXACT,
            );
        }
        let angle = SpatialMeasure::Angle(Axis::Z).evaluate(&markers[0], &markers[1]);
        near("angle", &[angle.value], &[turn], EXACT);
        assert_eq!(angle.second.as_slice()[5], 1.0);
    }
}

/// What cannot have a gradient has none, and no number that is not finite.
#[test]
fn what_is_undefined_is_zero() {
    let plain = Spatial::ground_marker(&SpatialFrame::default());
    let found = SpatialMeasure::Distance.evaluate(&plain, &plain);
    assert_eq!(found.second.as_slice(), [0.0; 6]);
    // The x axis of the second marker stands along the z axis of the first.
    let mut q = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    Spatial::advance(
        &mut q,
        &[0.0, 0.0, 0.0, 0.0, -std::f64::consts::FRAC_PI_2, 0.0],
    );
    let pose = Spatial::pose(&q);
    let upright = Spatial::marker(&SpatialFrame::default(), &pose, &[0.0; 6]);
    let found = SpatialMeasure::Angle(Axis::Z).evaluate(&plain, &upright);
    assert!(found.value.is_finite() && found.first.as_slice().iter().all(|x| x.is_finite()));
}
