//! Mistakes that were found once, so that they do not come back.

use dalembert::analysis::{AnalysisError, Dynamics, Kinematics, KinematicsRun};
use dalembert::model::Model;
use dalembert::system::compile::{Compiled, Options, compile};
use serde_json::{Value, json};

fn compiled(model: Value) -> Compiled {
    let model: Model = serde_json::from_value(model).expect("a model");
    compile::<dalembert::space::Planar>(&model, &[]).unwrap_or_else(|e| panic!("{e}"))
}

fn kinematics(compiled: &Compiled) -> Result<KinematicsRun, AnalysisError> {
    let analysis = Kinematics {
        instants: compiled.options.instants(),
        ..Kinematics::default()
    };
    analysis.run(&compiled.system)
}

fn pendulum(extra: Value) -> Value {
    let mut model = json!({
        "model": { "name": "pendulum" },
        "body": [{ "name": "rod", "mass": 1, "inertia": 0.1, "position": [0.5, 0.0] }],
        "joint": [{ "name": "pin", "kind": "revolute", "bodies": ["ground", "rod"], "at": [[0, 0], [-0.5, 0]] }],
    });
    for (key, value) in extra.as_object().expect("an object") {
        model[key] = value.clone();
    }
    model
}

/// The integral of a rate was taken in a fixed number of panels: a fast rate over a long run was
/// off by turns.
#[test]
fn fast_rates_over_long_runs_are_integrated() {
    let model = pendulum(json!({
        "driver": [{ "name": "m", "kind": "angle", "joint": "pin", "rate": "10*cos(50*t)", "start": 0 }],
        "analysis": { "end": 1000, "step": 10.03 },
    }));
    let run = kinematics(&compiled(model)).expect("it runs");
    assert_eq!(run.stopped, None);
    let (t, angle) = ("time", "rod.angle");
    let [t, angle] = [t, angle].map(|n| &run.results.channel(n).expect("a channel").values);
    assert!(t.len() > 90);
    for (t, angle) in t.iter().zip(angle) {
        // Some 10^5 panels of rounding 1e-16 times the largest sum 0.2, and the rounding of 50 t.
        let expected = 0.2 * (50.0 * t).sin();
        assert!(
            (angle - expected).abs() < 1e-11,
            "t = {t}: {angle}, not {expected}"
        );
    }
}

/// A rate with a kink in the middle of a panel.
#[test]
fn rates_with_kinks_are_integrated() {
    let model = pendulum(json!({
        "driver": [{ "name": "m", "kind": "angle", "joint": "pin", "rate": "min(3*t, 1)", "start": 0 }],
        "analysis": { "end": 10, "step": 10 },
    }));
    let run = kinematics(&compiled(model)).expect("it runs");
    let angle = run.results.channel("rod.angle").expect("an angle").values[1];
    // 1/6 until the kink at t = 1/3, then 1 a second.
    let expected = 1.0 / 6.0 + 10.0 - 1.0 / 3.0;
    assert!((angle - expected).abs() < 1e-13, "{angle}, not {expected}");
}

/// A step longer than the run left out the end.
#[test]
fn start_and_end_are_always_written() {
    for step in [1.0, 1e6, 1e9, 1e300] {
        let options = Options {
            step,
            ..Options::default()
        };
        assert_eq!(options.instants(), [0.0, 1.0], "step {step}");
    }
}

/// A driver with one row too many was called singular where its other row held the machine.
#[test]
fn an_over_determined_path_has_no_dead_centre() {
    let model = pendulum(json!({
        "driver": [{ "name": "m", "kind": "path", "body": "rod", "at": [0.5, 0],
                     "x": "cos(1*t)", "y": "sin(1*t)" }],
        "analysis": { "end": 7, "step": 0.07 },
    }));
    let run = kinematics(&compiled(model)).expect("it runs");
    assert_eq!(run.stopped, None);
    let angle = &run.results.channel("rod.angle").expect("an angle").values;
    assert!((angle.last().expect("an end") - 7.0).abs() < 1e-12);
}

/// Above the size that is ranked densely, an undriven machine counted as driven.
#[test]
fn large_undriven_machines_are_not_kinematic() {
    let n = 101;
    let bodies: Vec<Value> = (0..n)
        .map(|k| json!({ "name": format!("b{k}"), "mass": 1, "inertia": 0.1, "position": [k as f64 + 0.5, 0.0] }))
        .collect();
    let joints: Vec<Value> = (0..n)
        .map(|k| {
            let (before, end) = if k == 0 { ("ground".to_owned(), 0.0) } else { (format!("b{}", k - 1), 0.5) };
            json!({ "name": format!("j{k}"), "kind": "revolute", "bodies": [before, format!("b{k}")],
                    "at": [[end, 0.0], [-0.5, 0.0]] })
        })
        .collect();
    let model = json!({ "model": { "name": "chain" }, "body": bodies, "joint": joints });
    match kinematics(&compiled(model)) {
        Err(AnalysisError::NotDriven { freedoms, .. }) => assert_eq!(freedoms, n),
        other => panic!("{other:?}"),
    }
}

/// Several singular poses between two instants went unseen: a parallelogram folds twice a turn.
#[test]
fn singular_poses_are_found_between_distant_instants() {
    let bar = |name: &str, x: f64, y: f64, angle: f64| json!({ "name": name, "mass": 1, "inertia": 0.1, "position": [x, y], "angle": angle });
    let th = 60.0_f64.to_radians();
    let (s, c) = th.sin_cos();
    let pin = |name: &str, a: &str, b: &str, at: [[f64; 2]; 2]| json!({ "name": name, "kind": "revolute", "bodies": [a, b], "at": at });
    for step in [0.1, 6.0, 7.0] {
        let model = json!({
            "model": { "name": "parallelogram" },
            "body": [
                bar("crank", 0.5 * c, 0.5 * s, th),
                bar("coupler", c + 1.0, s, 0.0),
                bar("rocker", 2.0 + 0.5 * c, 0.5 * s, th),
            ],
            "joint": [
                pin("O", "ground", "crank", [[0.0, 0.0], [-0.5, 0.0]]),
                pin("A", "crank", "coupler", [[0.5, 0.0], [-1.0, 0.0]]),
                pin("B", "coupler", "rocker", [[1.0, 0.0], [0.5, 0.0]]),
                pin("C", "ground", "rocker", [[2.0, 0.0], [-0.5, 0.0]]),
            ],
            "driver": [{ "name": "m", "kind": "angle", "joint": "O", "value": "60 deg + 1*t" }],
            "analysis": { "end": 7, "step": step },
        });
        let run = kinematics(&compiled(model)).expect("it starts");
        match run.stopped {
            // Flat at 180 degrees: t = 2 pi / 3.
            Some(AnalysisError::Singular { time, .. }) => {
                let expected = std::f64::consts::TAU / 3.0;
                assert!(
                    (time - expected).abs() < 0.01,
                    "step {step}: {time}, not {expected}"
                );
            }
            other => panic!("step {step}: {other:?}"),
        }
    }
}

/// Rounding of positions far from the origin stopped the projection.
#[test]
fn machines_far_from_the_origin_run() {
    let body = |name: &str, x: f64| {
        json!({ "name": name, "mass": 1, "inertia": 0.1, "position": [x, 4.95e6],
        "velocity": [100.0, 50.0], "angular_velocity": 0.0 })
    };
    let model = json!({
        "model": { "name": "satellite", "gravity": [0, 0] },
        "body": [body("a", 4.95e6), body("b", 4.95e6 + 2.0)],
        "joint": [{ "name": "J", "kind": "revolute", "bodies": ["a", "b"], "at": [[1.0, 0.0], [-1.0, 0.0]] }],
        "initial": [{ "kind": "angle", "joint": "J", "rate": 1 }],
        "analysis": { "end": 10 },
    });
    let compiled = compiled(model);
    let run = Dynamics::new(&compiled.options)
        .run(&compiled.system, &mut |_| true)
        .expect("it starts");
    assert_eq!(run.stopped, None);
    assert_eq!(run.results.len(), 101);
}

/// A gear that meshes with itself locked the machine without a word.
#[test]
fn a_gear_needs_three_different_bodies() {
    for bodies in [["rod", "rod"], ["rod", "ground"]] {
        let model = pendulum(json!({}));
        let mut model: Model = serde_json::from_value(model).expect("a model");
        model.joints.push(
            serde_json::from_value(
                json!({ "name": "g", "kind": "gear", "bodies": bodies, "radii": [1, 2] }),
            )
            .expect("a joint"),
        );
        let errors = compile::<dalembert::space::Planar>(&model, &[])
            .map(|_| ())
            .expect_err("a mistake")
            .0;
        assert_eq!(errors.len(), 1, "{errors:?}");
        assert_eq!(errors[0].code, "same-body");
    }
}
