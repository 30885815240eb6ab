//! Mobility of spatial machines.

use super::{
    Mobility, MobilityReport, SingularKind, SweepOptions, conflicts, driver_singularities,
};
use crate::joint::{MeasureRow, MeasureTerm, SpatialMeasure, TimeFunction};
use crate::space::Spatial;
use crate::space::orientation::{Axis, Rotation, triad};
use crate::system::test_machine::{Machine, between, parallel, together, zero};
use crate::system::{Role, System};
use dalembert_expr::{Quantity, Resolved, UnknownName};
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

const PLAIN: Matrix3<f64> = Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);

fn inertia() -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(0.2, 0.3, 0.4))
}

fn report(system: &System<Spatial>) -> MobilityReport {
    Mobility::default().run(system, &system.estimate).unwrap()
}

fn texts(report: &MobilityReport) -> Vec<String> {
    report.motions.iter().map(ToString::to_string).collect()
}

#[test]
fn a_free_body() {
    let mut machine = Machine::default();
    let turn = Rotation::from_euler_angles(0.3, -0.5, 1.1);
    machine.body("stone", [1.0, 2.0, 3.0], turn, 2.0, inertia());
    let report = report(&machine.build(9.81));
    assert_eq!((report.coordinates, report.freedoms()), (6, 6));
    assert_eq!(report.mobility.count, 6);
    assert_eq!(
        texts(&report),
        ["body stone is free in turn about x, turn about y, turn about z, x, y and z"]
    );
}

/// Two rods on spherical joints, the second one turned out of the first one's line.
fn double_pendulum() -> Machine {
    let mut machine = Machine::default();
    let tilt = Rotation::from_axis_angle(&Vector3::x_axis(), 0.5);
    let below = tilt * Vector3::new(0.0, 0.0, -0.5);
    let second = Vector3::new(0.0, 0.0, -1.0) + below;
    let one = machine.body(
        "upper",
        [0.0, 0.0, -0.5],
        Rotation::identity(),
        1.0,
        inertia(),
    );
    let two = machine.body("lower", second.into(), tilt, 1.0, inertia());
    let ground = machine.marker(None, [0.0; 3], PLAIN);
    let top = machine.marker(Some(one), [0.0, 0.0, 0.5], PLAIN);
    let end = machine.marker(Some(one), [0.0, 0.0, -0.5], PLAIN);
    let start = machine.marker(Some(two), [0.0, 0.0, 0.5], PLAIN);
    machine.spherical("shoulder", [ground, top]);
    machine.spherical("elbow", [end, start]);
    machine
}

#[test]
fn a_double_spherical_pendulum() {
    let report = report(&double_pendulum().build(9.81));
    assert_eq!((report.coordinates, report.mobility.rows), (12, 6));
    assert_eq!((report.mobility.rank, report.mobility.count), (6, 6));
    assert_eq!(report.freedoms(), 6);
    assert!(!report.is_singular() && !report.locked && report.redundant.is_empty());
    let found = texts(&report);
    assert_eq!(
        found,
        [
            "upper.turn about x, upper.turn about y and upper.turn about z: upper turns every way about (0, 0, 0), lower moves along (0, 1, 0) and moves along (1, 0, 0)",
            "lower.turn about x, lower.turn about y and lower.turn about z: lower turns every way about (0, 0, -1)",
        ]
    );
}

/// A four-bar linkage in space with parallel axes: cranks of the same length, a coupler of length 2 above them.
fn four_bar() -> Machine {
    let mut machine = Machine::default();
    let axis = *triad(&Vector3::y()).unwrap().to_rotation_matrix().matrix();
    let upright = Rotation::identity();
    let left = machine.body("left", [0.0, 0.1, 0.5], upright, 1.0, inertia());
    let coupler = machine.body("coupler", [1.0, 0.2, 1.2], upright, 1.0, inertia());
    let right = machine.body("right", [2.2, 0.3, 0.6], upright, 1.0, inertia());
    let mut pin = |name: &str, a: (Option<usize>, [f64; 3]), b: (Option<usize>, [f64; 3])| {
        let markers = [a, b].map(|(body, at)| machine.marker(body, at, axis));
        machine.revolute(name, markers);
    };
    pin("A", (None, [0.0; 3]), (Some(left), [0.0, -0.1, -0.5]));
    pin(
        "B",
        (Some(left), [0.0, -0.1, 0.5]),
        (Some(coupler), [-1.0, -0.2, -0.2]),
    );
    pin(
        "C",
        (Some(coupler), [1.2, -0.2, 0.0]),
        (Some(right), [0.0, -0.3, 0.6]),
    );
    pin(
        "D",
        (Some(right), [0.0, -0.3, -0.6]),
        (None, [2.2, 0.0, 0.0]),
    );
    machine
}

#[test]
fn four_parallel_revolutes() {
    let report = report(&four_bar().build(9.81));
    assert_eq!((report.coordinates, report.mobility.rows), (18, 20));
    assert_eq!(
        (report.mobility.rank, report.mobility.generic_rank),
        (17, 17)
    );
    assert_eq!((report.mobility.count, report.freedoms()), (-2, 1));
    assert_eq!(report.redundant.len(), 3);
    for row in &report.redundant {
        assert_eq!(row.kind, "revolute");
        assert!(!row.depends_on.is_empty());
    }
    assert_eq!(report.reactions_not_unique, ["A", "B", "C", "D"]);
    let [motion] = &report.motions[..] else {
        panic!("{:?}", report.motions)
    };
    assert_eq!(motion.coordinates, ["A.angle"]);
    // The cranks go 1 and 1.2 high and are upright: the coupler moves level.
    let words: Vec<&str> = motion.bodies.iter().map(|b| &*b.motion).collect();
    assert_eq!(
        words,
        [
            "turns about (0, 1, 0) through (0, 0, 0)",
            "moves along (1, 0, 0)",
            "turns about (0, 1, 0) through (2.2, 0, 0)",
        ]
    );
}

#[test]
fn tilted_axes_lock_the_linkage() {
    let mut machine = four_bar();
    let tilted = *triad(&Vector3::new(0.0, 1.0, 0.3))
        .unwrap()
        .to_rotation_matrix()
        .matrix();
    let last = machine.elements[3].markers.clone();
    for m in last {
        machine.markers[m].frame.axes = tilted;
    }
    let report = report(&machine.build(9.81));
    assert_eq!(report.freedoms(), 0);
}

#[test]
fn a_screw() {
    let mut machine = Machine::default();
    let turn = Rotation::from_axis_angle(&Vector3::z_axis(), 0.2);
    let nut = machine.body("nut", [0.0, 0.0, 0.02], turn, 1.0, inertia());
    let ground = machine.marker(None, [0.0; 3], PLAIN);
    let own = machine.marker(Some(nut), [0.0; 3], PLAIN);
    let term = |factor, kind| MeasureTerm {
        factor,
        measure: between(kind),
    };
    let mut pitch: MeasureRow<Spatial> = zero(SpatialMeasure::Along(Axis::Z), "pitch");
    pitch.terms.push(term(0.1, SpatialMeasure::Angle(Axis::Z)));
    let mut rows = together();
    rows[2] = pitch;
    rows.extend(parallel());
    machine.element("screw", "screw", Role::Joint, [ground, own], rows);
    let report = report(&machine.build(9.81));
    assert_eq!(report.freedoms(), 1);
    assert_eq!(
        texts(&report),
        ["nut.turn about z: nut screws about (0, 0, 1) through (0, 0, 0.02), 0.1 m a radian"]
    );
}

/// A thin rod along (1, 1, 0) has no inertia about itself: on a point of its axis nothing holds it from spinning.
#[test]
fn a_thin_rod_spins_freely() {
    let along = Vector3::new(1.0, 1.0, 0.0).normalize();
    let tensor = 0.3 * (Matrix3::identity() - along * along.transpose());
    let on = |at: Vector3<f64>| {
        let mut machine = Machine::default();
        let rod = machine.body("rod", [0.0; 3], Rotation::identity(), 2.0, tensor);
        let ground = machine.marker(None, at.into(), PLAIN);
        let own = machine.marker(Some(rod), at.into(), PLAIN);
        machine.spherical("ball", [ground, own]);
        report(&machine.build(9.81)).massless
    };
    let found = on(0.5 * along);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].bodies, ["rod"]);
    let mut names = found[0].coordinates.clone();
    names.sort();
    assert_eq!(names, ["rod.turn about x", "rod.turn about y"]);
    assert_eq!(on(0.5 * along + Vector3::new(0.0, 0.0, 0.1)), []);
}

#[test]
fn contradictions_are_found() {
    let mut machine = double_pendulum();
    assert_eq!(
        conflicts(
            &double_pendulum().build(9.81),
            &double_pendulum().build(9.81).estimate
        ),
        Ok(Vec::new())
    );
    // The rods reach 2 m.
    let ground = machine.marker(None, [2.5, 0.0, 0.0], PLAIN);
    let tip = machine.marker(Some(1), [0.0, 0.0, -0.5], PLAIN);
    machine.spherical("far", [ground, tip]);
    let system = machine.build(9.81);
    let found = conflicts(&system, &system.estimate).unwrap();
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].elements, ["shoulder", "elbow", "far"]);
    // Stretched, each of the three joints is off by a third of the missing half metre.
    assert!(
        (found[0].residual - 0.5 / 3.0).abs() < 1e-6,
        "{:?}",
        found[0]
    );
}

/// The time, and nothing else.
struct Clock;

impl dalembert_expr::Scope for Clock {
    fn variable(&self, _: &[&str]) -> Result<Resolved, UnknownName> {
        Ok(Resolved::Slot {
            index: 0,
            dim: Quantity::Free,
        })
    }

    fn function(&self, _: &str) -> Option<Arc<dyn dalembert_expr::Function>> {
        None
    }
}

/// A crank in the plane z = 0 and a rod on a ball whose tip is driven along the line y = 0, z = 0.3, 0.2 m/s outwards: it
/// comes to its end where crank and rod are in line seen from above. The rod may spin all the while.
#[test]
fn a_driven_tip_comes_to_its_dead_centre() {
    let mut machine = Machine::default();
    let angle = 0.6_f64;
    let pin = Vector3::new(angle.cos(), angle.sin(), 0.0);
    let (length, aside) = (1.5_f64, 0.3_f64);
    let reach = |sine: f64| (length * length - aside * aside - sine * sine).sqrt();
    let tip = Vector3::new(pin.x + reach(pin.y), 0.0, aside);
    let rod_turn = Rotation::rotation_between(&Vector3::x(), &(tip - pin)).unwrap();
    let crank_turn = Rotation::from_axis_angle(&Vector3::z_axis(), angle);
    let crank = machine.body("crank", (0.5 * pin).into(), crank_turn, 1.0, inertia());
    let rod = machine.body("rod", (0.5 * (pin + tip)).into(), rod_turn, 1.0, inertia());
    let ground = machine.marker(None, [0.0; 3], PLAIN);
    let guide = machine.marker(None, [0.0, 0.0, aside], PLAIN);
    let foot = machine.marker(Some(crank), [-0.5, 0.0, 0.0], PLAIN);
    let head = machine.marker(Some(crank), [0.5, 0.0, 0.0], PLAIN);
    let start = machine.marker(Some(rod), [-0.5 * length, 0.0, 0.0], PLAIN);
    let end = machine.marker(Some(rod), [0.5 * length, 0.0, 0.0], PLAIN);
    machine.revolute("shaft", [ground, foot]);
    machine.spherical("ball", [head, start]);
    let mut line = together();
    line.remove(0);
    machine.element("line", "line", Role::Joint, [guide, end], line);
    let text = format!("{:?} + 0.2 * t", tip.x);
    let program = dalembert_expr::compile(&text, &Clock, Quantity::Free).unwrap();
    let way = TimeFunction::Expression(Box::new(program));
    let row = MeasureRow::follow(between(SpatialMeasure::Ground(Axis::X)), way, "x");
    machine.element("pusher", "driver", Role::Driver, [guide, end], vec![row]);
    let system = machine.build(9.81);
    let report = report(&system);
    assert_eq!((report.freedoms(), report.freedoms_left()), (2, 1));
    let [left] = &report.motions_left[..] else {
        panic!("{:?}", report.motions_left)
    };
    let [spin] = &left.bodies[..] else {
        panic!("{left}")
    };
    let along = rod_turn * Vector3::x();
    assert_eq!(spin.body, "rod");
    let digits = along.map(|x| (x * 1e3).round() / 1e3);
    let direction = format!("({}, {}, {})", digits.x, digits.y, digits.z);
    assert!(
        spin.motion
            .starts_with(&format!("turns about {direction} through")),
        "{left}"
    );
    let sweep = driver_singularities(&system, &system.estimate, &SweepOptions::until(5.0)).unwrap();
    let [pose] = &sweep.poses[..] else {
        panic!("{sweep:?}")
    };
    let expected = (1.0 + reach(0.0) - tip.x) / 0.2;
    assert!((pose.time - expected).abs() < 1e-6, "{expected} {pose:?}");
    assert_eq!(pose.kind, SingularKind::DeadCentre);
    assert!(pose.end);
    assert_eq!(pose.drivers, ["pusher"]);
    assert_eq!(pose.bodies, ["crank", "rod"]);
}
