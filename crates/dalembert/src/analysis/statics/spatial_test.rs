//! Equilibria of spatial machines.

use super::holding::loads_at;
use super::problem::Problem;
use super::{Route, Stability, Statics, StaticsReport, Unknown};
use crate::analysis::{AnalysisError, NewtonOptions};
use crate::joint::SpatialMeasure;
use crate::space::orientation::{Axis, Rotation, triad};
use crate::space::{Space, Spatial};
use crate::system::System;
use crate::system::test_machine::Machine;
use nalgebra::{Matrix3, Vector3};

const G: f64 = 9.81;
const PLAIN: Matrix3<f64> = Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);

fn inertia() -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(0.2, 0.3, 0.4))
}

fn problem_of(system: &System<Spatial>) -> Problem<'_, Spatial> {
    Problem::new(system, NewtonOptions::default())
}

fn run(system: &System<Spatial>, route: Route) -> Result<StaticsReport, AnalysisError> {
    let running = system.running();
    let statics = Statics {
        route,
        ..Statics::default()
    };
    statics.search(system, &mut problem_of(&running))
}

fn center(q: &[f64]) -> Vector3<f64> {
    Vector3::new(q[0], q[1], q[2])
}

/// A body of mass 2 that hangs by the point `arm` of its own at `pivot`, in some pose.
fn pendulum(pivot: [f64; 3], arm: [f64; 3]) -> Machine {
    let mut machine = Machine::default();
    let turn = Rotation::from_euler_angles(0.7, -1.1, 2.0);
    let at = Vector3::from(pivot) - turn * Vector3::from(arm);
    let body = machine.body("bob", at.into(), turn, 2.0, inertia());
    let ground = machine.marker(None, pivot, PLAIN);
    let own = machine.marker(Some(body), arm, PLAIN);
    machine.spherical("ball", [ground, own]);
    machine
}

#[test]
fn a_spherical_pendulum_hangs_and_stands() {
    let (pivot, arm) = ([0.4, -0.3, 1.5], [0.1, -0.2, 0.5]);
    let length = Vector3::from(arm).norm();
    for route in [Route::Reduced, Route::Multipliers] {
        let report = run(&pendulum(pivot, arm).build(G), route).unwrap();
        assert_eq!(report.freedoms, 3);
        let [hanging, standing] = &report.equilibria[..] else {
            panic!("{} equilibria", report.equilibria.len())
        };
        for (found, sign) in [(hanging, -1.0), (standing, 1.0)] {
            let expected = Vector3::from(pivot) + Vector3::new(0.0, 0.0, sign * length);
            assert!(
                (center(&found.q) - expected).amax() < 1e-9,
                "{route:?} {found:?}"
            );
            assert!(found.conservative);
            // On the body acts G down, from the joint 2 G up: rows read first - second.
            let [x, y, z] = found.multipliers[..] else {
                panic!()
            };
            assert!(x.abs().max(y.abs()) < 1e-8 && (z - 2.0 * G).abs() < 1e-9);
            assert!((found.potential - 2.0 * G * expected.z).abs() < 1e-9);
            // A turn by one radian moves the centre by the size: of norm 1 is a turn by 1 / sqrt(2).
            let stiffness = 0.5 * 2.0 * G * length;
            let mut expected = [0.0, -sign * stiffness, -sign * stiffness];
            expected.sort_by(f64::total_cmp);
            for (x, y) in found.stiffness.iter().zip(expected) {
                assert!((x - y).abs() < 1e-7 * stiffness, "{:?}", found.stiffness);
            }
        }
        assert_eq!(hanging.stability, Stability::Neutral);
        assert_eq!(hanging.motions.len(), 1);
        assert!(
            hanging.motions[0].ends_with("bob turns about (0, 0, 1) through (0.4, -0.3, 1.5)"),
            "{}",
            hanging.motions[0]
        );
        assert_eq!(standing.stability, Stability::Unstable);
    }
}

/// A plate on three springs, each of another stiffness and free length.
struct Plate {
    /// Anchor on the ground and point of the plate, for each spring.
    pairs: Vec<[Vector3<f64>; 2]>,
    /// Stiffness and free length.
    springs: [[f64; 2]; 3],
}

impl Plate {
    fn new() -> Self {
        let anchors = [[1.0, 0.0, 0.0], [-0.6, 0.8, 0.1], [-0.5, -0.9, 0.0]];
        let points = [[0.5, 0.0, 0.05], [-0.3, 0.45, 0.0], [-0.25, -0.4, -0.02]];
        let pairs = anchors.into_iter().zip(points);
        Self {
            pairs: pairs.map(|(a, p)| [a.into(), p.into()]).collect(),
            springs: [[200.0, 0.6], [150.0, 0.8], [250.0, 0.7]],
        }
    }

    fn system(&self) -> System<Spatial> {
        let mut machine = Machine::default();
        let turn = Rotation::from_euler_angles(0.2, 0.1, -0.3);
        let body = machine.body("plate", [0.1, 0.0, -1.0], turn, 3.0, inertia());
        for (k, [anchor, point]) in self.pairs.iter().enumerate() {
            let ground = machine.marker(None, (*anchor).into(), PLAIN);
            let own = machine.marker(Some(body), (*point).into(), PLAIN);
            let [stiffness, free] = self.springs[k];
            let name = format!("spring {}", k + 1);
            let law = [stiffness, free, 0.0];
            machine.force(&name, SpatialMeasure::Distance, [ground, own], law);
        }
        machine.build(G)
    }

    /// Potential energy, force and moment about the centre at a pose.
    fn loads(&self, q: &[f64]) -> (f64, Vector3<f64>, Vector3<f64>) {
        let pose = Spatial::pose(q);
        let mut force = Vector3::new(0.0, 0.0, -3.0 * G);
        let (mut energy, mut moment) = (3.0 * G * pose.point.z, Vector3::zeros());
        for ([anchor, point], [k, l0]) in self.pairs.iter().zip(self.springs) {
            let arm = pose.axes * point;
            let way = anchor - pose.point - arm;
            let stretch = way.norm() - l0;
            let pull = k * stretch * way.normalize();
            energy += 0.5 * k * stretch * stretch;
            force += pull;
            moment += arm.cross(&pull);
        }
        (energy, force, moment)
    }
}

#[test]
fn a_plate_on_three_springs() {
    let plate = Plate::new();
    let system = plate.system();
    for route in [Route::Reduced, Route::Multipliers] {
        let report = run(&system, route).unwrap();
        let stable: Vec<_> = report
            .equilibria
            .iter()
            .filter(|e| e.stability == Stability::Stable)
            .collect();
        assert!(!stable.is_empty());
        for found in &report.equilibria {
            let (energy, force, moment) = plate.loads(&found.q);
            assert!(force.amax().max(moment.amax()) < 1e-8, "{force} {moment}");
            assert!((found.potential - energy).abs() < 1e-10 * energy.abs());
            assert!(found.conservative);
        }
        // The Hessian of the energy along steps, by differences of the energy itself.
        let found = stable[0];
        let energy = |step: &[f64; 6]| {
            let mut q = found.q.clone();
            Spatial::advance(&mut q, step);
            plate.loads(&q).0
        };
        let h = 1e-4;
        let unit = |k: usize| if k < 3 { system.size } else { 1.0 };
        let hessian = nalgebra::Matrix6::from_fn(|i, j| {
            let at = |a: f64, b: f64| {
                let mut step = [0.0; 6];
                step[i] += a * h * unit(i);
                step[j] += b * h * unit(j);
                energy(&step)
            };
            (at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)) / (4.0 * h * h)
        });
        let mut values: Vec<f64> = hessian.symmetric_eigenvalues().iter().copied().collect();
        values.sort_by(f64::total_cmp);
        // Rounding of the energy over h^2.
        for (x, y) in found.stiffness.iter().zip(&values) {
            assert!(
                (x - y).abs() < 1e-5 * values[5],
                "{:?} {values:?}",
                found.stiffness
            );
        }
    }
}

/// A body on a horizontal hinge along y, its centre half a metre aside.
fn hinged() -> Machine {
    let mut machine = Machine::default();
    let axis = *triad(&Vector3::y()).unwrap().to_rotation_matrix().matrix();
    let body = machine.body(
        "door",
        [0.5, 0.0, 0.0],
        Rotation::identity(),
        2.0,
        inertia(),
    );
    let ground = machine.marker(None, [0.0; 3], axis);
    let own = machine.marker(Some(body), [-0.5, 0.0, 0.0], axis);
    machine.revolute("hinge", [ground, own]);
    machine
}

#[test]
fn what_holds_a_hinged_body() {
    let mut machine = hinged();
    machine.force(
        "motor",
        SpatialMeasure::Angle(Axis::Z),
        [1, 2],
        [0.0, 0.0, 5.0],
    );
    let system = machine.build(G).running();
    let mut problem = problem_of(&system);
    problem.evaluate(&system.estimate.q).unwrap();
    let force = loads_at(&problem, &[Unknown::Force("motor".to_owned())]).unwrap();
    // About +y the weight turns with + m g l, which an angle from the first to the second marker counts.
    let load = &force.loads[0];
    assert!(load.unique && load.unit == "N m");
    assert!((load.value.abs() - G).abs() < 1e-12, "{load:?}");
    let mut without = hinged().build(G).running();
    without.forces.clear();
    let mut problem = problem_of(&without);
    problem.evaluate(&without.estimate.q).unwrap();
    let effort = loads_at(&problem, &[Unknown::Effort("hinge".to_owned())]).unwrap();
    assert!((effort.loads[0].value + G).abs() < 1e-12, "{effort:?}");
}

#[test]
fn a_motor_that_is_too_strong() {
    let mut machine = hinged();
    machine.force(
        "motor",
        SpatialMeasure::Angle(Axis::Z),
        [1, 2],
        [0.0, 0.0, 12.0],
    );
    let system = machine.build(G);
    for route in [Route::Reduced, Route::Multipliers] {
        let error = run(&system, route).unwrap_err();
        let AnalysisError::NoEquilibrium { reason, .. } = error else {
            panic!("{error}")
        };
        assert_eq!(
            reason,
            "the loads turn door round and round: no pose balances them"
        );
    }
}

#[test]
fn a_motor_lifts_a_hinged_body() {
    let mut machine = hinged();
    machine.force(
        "motor",
        SpatialMeasure::Angle(Axis::Z),
        [1, 2],
        [0.0, 0.0, -0.5 * G],
    );
    let report = run(&machine.build(G), Route::Reduced).unwrap();
    // m g l sin(angle from hanging) = m g l / 2: at 30 degrees it rests, at 150 it tips.
    let angles: Vec<f64> = report
        .equilibria
        .iter()
        .map(|e| (e.q[0] / 0.5).abs())
        .collect();
    assert_eq!(report.equilibria.len(), 2);
    assert!(angles.iter().all(|s| (s - 0.5).abs() < 1e-9), "{angles:?}");
    let [rests, tips] = [0, 1].map(|k| &report.equilibria[k]);
    assert_eq!(
        (rests.stability, tips.stability),
        (Stability::Stable, Stability::Unstable)
    );
    assert!(rests.q[2] < 0.0 && tips.q[2] > 0.0);
    assert_eq!(
        tips.motions,
        ["unstable: door turns about (0, 1, 0) through (0, 0, 0)"]
    );
}

/// Two rods on balls hang or stand, each free to spin: four families of equilibria, however many poses of them are met.
#[test]
fn a_double_pendulum_has_four_families() {
    let mut machine = Machine::default();
    let upper = Rotation::from_euler_angles(0.5, 0.2, 0.1);
    let lower = Rotation::from_euler_angles(-0.3, 0.6, 0.4);
    let half = Vector3::new(0.0, 0.0, 0.5);
    let first = -(upper * half);
    let second = 2.0 * first - lower * half;
    let one = machine.body("upper", first.into(), upper, 1.0, inertia());
    let two = machine.body("lower", second.into(), lower, 1.0, inertia());
    let ground = machine.marker(None, [0.0; 3], PLAIN);
    let top = machine.marker(Some(one), half.into(), PLAIN);
    let end = machine.marker(Some(one), (-half).into(), PLAIN);
    let start = machine.marker(Some(two), half.into(), PLAIN);
    machine.spherical("shoulder", [ground, top]);
    machine.spherical("elbow", [end, start]);
    let report = run(&machine.build(G), Route::Reduced).unwrap();
    let mut heights: Vec<[f64; 2]> = Vec::new();
    for found in &report.equilibria {
        let flat = found.stiffness.iter().filter(|k| k.abs() < 1e-6).count();
        assert_eq!(flat, 2, "{:?}", found.stiffness);
        heights.push([found.q[2], found.q[9]]);
        let unstable = (found.q[2] > 0.0) || (found.q[9] > 2.0 * found.q[2]);
        let expected = if unstable {
            Stability::Unstable
        } else {
            Stability::Neutral
        };
        assert_eq!(found.stability, expected);
    }
    heights.sort_by_key(|h| h.map(|z| (10.0 * z).round() as i32));
    assert_eq!(heights.len(), 4, "{heights:?}");
    let all = [[-0.5, -1.5], [-0.5, -0.5], [0.5, 0.5], [0.5, 1.5]];
    for (found, expected) in heights.iter().flatten().zip(all.iter().flatten()) {
        assert!((found - expected).abs() < 1e-9, "{heights:?}");
    }
}
