//! Mobility of spatial machines.

use super::{Mobility, MobilityReport, conflicts};
use crate::joint::{MeasureRow, MeasureTerm, SpatialMeasure};
use crate::space::Spatial;
use crate::space::orientation::{Axis, Rotation, triad};
use crate::system::test_machine::{Machine, between, parallel, together, zero};
use crate::system::{Role, System};
use nalgebra::{Matrix3, Vector3};

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
            "upper.turn about x, upper.turn about y and upper.turn about z: upper turns every way about (0, 0, 0), lower moves along (0, 1, 0), moves along (1, 0, 0)",
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
        ["nut.turn about z: nut screws about (0, 0, 1) through (0, 0, 0), 0.1 m a radian"]
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
