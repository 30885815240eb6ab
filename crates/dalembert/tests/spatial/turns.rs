//! Angles that count turns, in machines that turn far.

use super::machine::compiled;
use dalembert::analysis::{Assembly, Dynamics, Kinematics};
use dalembert::results::Results;
use dalembert::space::Spatial;
use dalembert::system::compile::Compiled;
use nalgebra::Vector3;
use serde_json::{Value, json};
use std::f64::consts::TAU;

const AXIS: [f64; 3] = [0.4, -0.5, 0.8];
const TENSOR: [[f64; 3]; 3] = [
    [0.05, 0.004, -0.006],
    [0.004, 0.04, 0.005],
    [-0.006, 0.005, 0.03],
];
const CENTER: [f64; 3] = [0.1, -0.2, 0.05];

/// A wheel whose centre of mass lies at a place, with its frame elsewhere.
fn wheel(name: &str, at: [f64; 3]) -> Value {
    let position = [0, 1, 2].map(|k| at[k] - CENTER[k]);
    json!({"name": name, "mass": 1.3, "inertia": TENSOR, "center": CENTER, "position": position})
}

fn hinge(name: &str, body: &str, at: [f64; 3], axis: [f64; 3]) -> Value {
    json!({"name": name, "kind": "revolute", "bodies": ["ground", body], "point": at, "axis": axis})
}

fn about(axis: [f64; 3]) -> f64 {
    let n = Vector3::from(axis).normalize();
    let inertia = nalgebra::Matrix3::from_fn(|i, j| TENSOR[i][j]);
    n.dot(&(inertia * n))
}

fn simulate(c: &Compiled<Spatial>) -> Results {
    let run = Dynamics::new(&c.options)
        .run(&c.system, &mut |_| true)
        .unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(run.stopped, None);
    run.results
}

fn kinematics(c: &Compiled<Spatial>) -> Results {
    let run = Kinematics::new(&c.options)
        .run(&c.system)
        .unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(run.stopped, None);
    run.results
}

fn values<'a>(results: &'a Results, name: &str) -> &'a [f64] {
    let channel = results.channel(name);
    &channel
        .unwrap_or_else(|| panic!("no channel {name}"))
        .values
}

#[track_caller]
fn follows(results: &Results, name: &str, tolerance: f64, f: impl Fn(usize, f64) -> f64) {
    let times = values(results, "time");
    for (k, (&t, &x)) in times.iter().zip(values(results, name)).enumerate() {
        let expected = f(k, t);
        assert!(
            (x - expected).abs() <= tolerance,
            "{name} at t = {t}: {x} for {expected}"
        );
    }
}

/// The balance of energy, relative to what moves.
#[track_caller]
fn balanced(results: &Results, tolerance: f64) {
    let largest = |name: &str| {
        values(results, name)
            .iter()
            .fold(0.0_f64, |m, x| m.max(x.abs()))
    };
    let scale = largest("energy.kinetic");
    let off = largest("energy.balance");
    assert!(
        off <= tolerance * scale,
        "energy is off by {off:e} of {scale}"
    );
}

/// Instants that are nearer than half a turn, and farther apart than one.
#[test]
fn a_hinge_is_driven_through_many_turns() {
    for (step, sign) in [(0.02, 1.0), (0.25, 1.0), (0.5, -1.0), (1.0, -1.0)] {
        let c = compiled(json!({
            "body": [wheel("b", [0.3, 0.1, 0.2])],
            "joint": [hinge("A", "b", [0.2, 0.6, -0.1], AXIS)],
            "driver": [{"name": "D", "kind": "angle", "joint": "A", "value": format!("{} rad/s^2 * t^2", sign * 3.7 * TAU)}],
            "analysis": {"end": 1.0, "step": step}
        }));
        let results = kinematics(&c);
        let turn = |t: f64| sign * 3.7 * TAU * t * t;
        follows(&results, "A.angle", 1e-12, |_, t| turn(t));
        follows(&results, "D.angle", 1e-12, |_, t| turn(t));
        follows(&results, "A.angle_rate", 1e-11, |_, t| {
            sign * 2.0 * 3.7 * TAU * t
        });
        follows(&results, "A.angle_acceleration", 1e-10, |_, _| {
            sign * 2.0 * 3.7 * TAU
        });
    }
}

/// The two springs that turn: between bodies about an axis, and on the coordinate of a joint.
#[test]
fn torsion_springs_wind_up_over_many_turns() {
    let (stiffness, rate) = (0.02, 40.0);
    let omega = (stiffness / about(AXIS)).sqrt();
    assert!(rate / omega > 3.0 * TAU, "few turns");
    for spring in [
        json!({"kind": "torsion-spring", "bodies": ["ground", "b"], "axis": AXIS}),
        json!({"kind": "joint-spring", "joint": "A"}),
    ] {
        let mut spring = spring;
        spring["name"] = json!("S");
        spring["stiffness"] = json!(stiffness);
        let at = [0.3, 0.1, 0.2];
        let c = compiled(json!({
            "model": {"name": "test", "space": "spatial", "gravity": [0, 0, -9.81]},
            "body": [wheel("b", at)],
            "joint": [hinge("A", "b", at, AXIS)],
            "force": [spring],
            "initial": [{"kind": "angle", "joint": "A", "rate": rate}],
            "analysis": {"end": 3.0 * TAU / omega, "step": 0.3, "tolerance": 1e-11}
        }));
        let results = simulate(&c);
        // Errors of the steps over some hundred radians of motion.
        follows(&results, "A.angle", 1e-6, |_, t| {
            rate / omega * (omega * t).sin()
        });
        balanced(&results, 1e-8);
    }
}

/// A nut falls along a screw: every turn moves it on by the pitch.
#[test]
fn a_screw_turns_many_times() {
    for pitch in [0.05, -0.08] {
        let at = [0.3, 0.1, 0.2];
        let c = compiled(json!({
            "model": {"name": "test", "space": "spatial", "gravity": [0, 0, -9.81]},
            "body": [wheel("b", at)],
            "joint": [{"name": "A", "kind": "screw", "bodies": ["ground", "b"], "point": at, "axis": AXIS, "pitch": pitch}],
            "initial": [{"kind": "angle", "joint": "A", "rate": 3.0}],
            "trace": [{"name": "center", "body": "b", "at": CENTER}],
            "analysis": {"end": 6.0, "step": 0.05, "tolerance": 1e-11}
        }));
        let results = simulate(&c);
        let n = Vector3::from(AXIS).normalize();
        let lead = pitch / TAU;
        // (I + m lead^2) theta'' = m g . n lead.
        let pull = 1.3 * -9.81 * n.z * lead / (about(AXIS) + 1.3 * lead * lead);
        let turned = |t: f64| 3.0 * t + 0.5 * pull * t * t;
        assert!(turned(6.0).abs() > 3.0 * TAU, "few turns: {}", turned(6.0));
        follows(&results, "A.angle", 1e-8, |_, t| turned(t));
        balanced(&results, 1e-9);
        let turns = values(&results, "A.angle").to_vec();
        for (k, name) in ["center.x", "center.y", "center.z"].into_iter().enumerate() {
            follows(&results, name, 1e-12, |instant, _| {
                at[k] + n[k] * pitch * turns[instant] / TAU
            });
        }
    }
}

/// Gears and couplers hold over many turns, driven and free.
#[test]
fn gears_turn_many_times() {
    let other = [0.3, 0.9, 0.1];
    let (p, q) = ([0.3, 0.1, 0.2], [0.8, -0.4, 0.5]);
    let ratio = -0.45;
    for mesh in [
        (
            "joint",
            json!({"name": "G", "kind": "gear-pair", "joints": ["A", "B"], "ratio": ratio}),
        ),
        (
            "constraint",
            json!({"name": "G", "kind": "coupler", "terms": [
                {"factor": 1.0, "kind": "angle", "joint": "B"}, {"factor": -ratio, "kind": "angle", "joint": "A"}]}),
        ),
    ] {
        let mut model = json!({
            "body": [wheel("a", p), wheel("b", q)],
            "joint": [hinge("A", "a", p, AXIS), hinge("B", "b", q, other)],
            "analysis": {"end": 2.0, "step": 0.5, "tolerance": 1e-11}
        });
        let (place, mesh) = mesh;
        if place == "joint" {
            model["joint"].as_array_mut().unwrap().push(mesh);
        } else {
            model[place] = json!([mesh]);
        }
        let mut driven = model.clone();
        driven["driver"] =
            json!([{"name": "D", "kind": "angle", "joint": "A", "value": "20 rad/s^2 * t^2"}]);
        let results = kinematics(&compiled(driven));
        follows(&results, "A.angle", 1e-12, |_, t| 20.0 * t * t);
        follows(&results, "B.angle", 1e-12, |_, t| ratio * 20.0 * t * t);

        let moment = 2.0;
        model["force"] = json!([{"name": "M", "kind": "actuator", "joint": "A", "value": moment}]);
        let results = simulate(&compiled(model));
        let acceleration = moment / (about(AXIS) + ratio * ratio * about(other));
        assert!(2.0 * acceleration > 3.0 * TAU, "few turns");
        follows(&results, "A.angle", 1e-8, |_, t| 0.5 * acceleration * t * t);
        follows(&results, "B.angle", 1e-8, |_, t| {
            ratio * 0.5 * acceleration * t * t
        });
        balanced(&results, 1e-9);
    }
}

/// A rack on a slide, over many turns of its pinion.
#[test]
fn a_rack_follows_its_pinion_over_many_turns() {
    let (p, q) = ([0.3, 0.1, 0.2], [0.8, -0.4, 0.5]);
    let c = compiled(json!({
        "body": [wheel("a", p), wheel("b", q)],
        "joint": [hinge("A", "a", p, AXIS),
                  {"name": "B", "kind": "prismatic", "bodies": ["ground", "b"], "point": q, "axis": [0.3, 0.9, 0.1]},
                  {"name": "G", "kind": "rack-pair", "joints": ["A", "B"], "radius": -0.07}],
        "driver": [{"name": "D", "kind": "angle", "joint": "A", "value": "20 rad/s^2 * t^2"}],
        "analysis": {"end": 2.0, "step": 0.5}
    }));
    let results = kinematics(&c);
    follows(&results, "B.displacement", 1e-12, |_, t| {
        -0.07 * 20.0 * t * t
    });
}

/// A driver may start turns away from the estimate: the angle is that of the driver, the pose is not turned round.
#[test]
fn a_driver_starts_after_two_turns() {
    let at = [0.3, 0.1, 0.2];
    for degrees in [725.0, -715.0] {
        let c = compiled(json!({
            "body": [wheel("b", at)],
            "joint": [hinge("A", "b", at, AXIS)],
            "driver": [{"name": "D", "kind": "angle", "joint": "A", "value": format!("{degrees} deg + 90 deg/s * t")}],
            "analysis": {"end": 9.0, "step": 1.5}
        }));
        let (_, report) = Assembly::default().run(&c.system).unwrap();
        let turned = report.moved.iter().fold(0.0_f64, |m, b| m.max(b.turn));
        assert!(
            (turned - 5_f64.to_radians()).abs() < 1e-12,
            "turned by {turned}"
        );
        let results = kinematics(&c);
        let angle = |t: f64| (degrees + 90.0 * t).to_radians();
        follows(&results, "A.angle", 1e-12, |_, t| angle(t));
        // The force laws and constraints of the joint's angle see the same turns.
        let mut model = json!({
            "body": [wheel("b", at)],
            "joint": [hinge("A", "b", at, AXIS)],
            "force": [{"name": "S", "kind": "joint-spring", "joint": "A", "stiffness": 0.3}],
            "driver": [{"name": "D", "kind": "angle", "joint": "A", "value": degrees.to_radians()}],
            "analysis": {"end": 1.0, "step": 0.5}
        });
        let moment = 0.3 * degrees.to_radians();
        let held = kinematics(&compiled(model.clone()));
        follows(&held, "D.moment", 1e-11, |_, _| moment);
        // So it is where an initial value asks for it.
        model.as_object_mut().unwrap().remove("driver");
        model["initial"] =
            json!([{"kind": "angle", "joint": "A", "value": degrees.to_radians(), "rate": 0.0}]);
        let free = simulate(&compiled(model));
        let found = values(&free, "A.angle_acceleration")[0];
        let expected = -moment / about(AXIS);
        assert!(
            (found - expected).abs() < 1e-10 * expected.abs(),
            "{found} for {expected}"
        );
    }
}

/// What turns with the driven angle has turned as many times at the start, in space as in the plane: wheels of a coupler,
/// springs about the same axis, whichever way they are stated.
#[test]
fn turns_at_the_start_are_those_of_the_plane() {
    let spring = |name: &str, bodies: [&str; 2]| json!({"name": name, "kind": "torsion-spring", "bodies": bodies, "stiffness": 0.3});
    let model = |start: Value| {
        let mut model = json!({
            "model": {"name": "test"},
            "body": [{"name": "a", "mass": 1.0, "inertia": 0.2, "position": [0.0, 0.0], "angle": 0.3},
                     {"name": "b", "mass": 1.0, "inertia": 0.1, "position": [1.0, 0.0]}],
            "joint": [{"name": "A", "kind": "revolute", "bodies": ["ground", "a"], "at": [[0, 0], [0, 0]]},
                      {"name": "B", "kind": "revolute", "bodies": ["ground", "b"], "at": [[1, 0], [0, 0]]}],
            "constraint": [{"name": "K", "kind": "coupler", "terms": [
                {"factor": 1.0, "kind": "angle", "joint": "B"}, {"factor": 0.3, "kind": "angle", "joint": "A"}]}],
            "force": [spring("S", ["ground", "a"]), spring("back", ["a", "ground"]),
                      spring("turned", ["a", "ground"]), spring("T", ["ground", "b"])],
            "analysis": {"end": 1.0, "step": 0.5}
        });
        for (key, value) in start.as_object().unwrap() {
            model[key] = value.clone();
        }
        model
    };
    for start in [
        json!({"driver": [{"name": "D", "kind": "angle", "joint": "A", "value": "725 deg"}]}),
        json!({"driver": [{"name": "D", "kind": "relative-angle", "bodies": ["ground", "a"], "value": "-725 deg"}]}),
        json!({"driver": [{"name": "D", "kind": "relative-angle", "bodies": ["a", "ground"], "value": "725 deg"}]}),
    ] {
        let plane = model(start);
        let mut space = super::twins::in_space(&plane);
        // The same angle, seen from the other body about the other direction.
        space["force"][2]["bodies"] = json!(["ground", "a"]);
        space["force"][2]["axis"] = json!([0, 0, -1]);
        let plane = super::support::compiled(plane);
        let plane = Kinematics::new(&plane.options)
            .run(&plane.system)
            .unwrap()
            .results;
        let space = kinematics(&compiled(space));
        for name in [
            "A.angle",
            "B.angle",
            "D.angle",
            "D.moment",
            "S.moment",
            "back.moment",
            "turned.moment",
            "T.moment",
        ] {
            super::near(name, values(&space, name), values(&plane, name), 1e-12);
        }
    }
}
