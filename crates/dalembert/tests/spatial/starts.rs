//! Estimates far from the pose that is meant, and models that are refused.

use super::machine::{compiled, model};
use super::support::{Random, near};
use super::{SEED, random};
use dalembert::analysis::{AnalysisError, Assembly};
use dalembert::space::Spatial;
use dalembert::system::compile::compile;
use nalgebra::{UnitQuaternion, Vector3};
use serde_json::{Value, json};

fn rod(more: &Value) -> Value {
    let mut rod =
        json!({"name": "rod", "mass": 1, "inertia": [0.01, 0.1, 0.1], "position": [0.5, 0, 0]});
    for (key, value) in more.as_object().unwrap() {
        rod[key] = value.clone();
    }
    rod
}

fn pin(axis: [f64; 3]) -> Value {
    json!({"name": "pin", "kind": "revolute", "bodies": ["ground", "rod"], "at": [[0, 0, 0], [-0.5, 0, 0]],
           "axes": [[0, 1, 0], axis]})
}

/// The y axis of the rod's frame that the joint turns about, at the assembled pose.
fn axis_of(q: &[f64], axis: [f64; 3]) -> Vector3<f64> {
    let b = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(q[3], q[4], q[5], q[6]));
    b * Vector3::from(axis).normalize()
}

#[test]
fn axes_of_a_body_of_unknown_orientation_come_together_from_anywhere() {
    let mut source = Random::new(SEED);
    let mut axes = vec![[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]];
    axes.extend((0..40).map(|_| random::<3>(&mut source, 1.0)));
    for axis in axes {
        let system = compiled(json!({"body": [rod(&json!({}))], "joint": [pin(axis)]})).system;
        let (state, _) = Assembly::default()
            .run(&system)
            .unwrap_or_else(|why| panic!("{axis:?}, seed {SEED}: {why}"));
        let found = axis_of(&state.q, axis);
        near(
            "axis",
            found.as_slice(),
            &[0.0, 1.0, 0.0],
            // Twice the tolerance of the assembly.
            2e-10,
        );
    }
}

/// A body whose orientation is stated is not turned around: then the axis is the mistake.
#[test]
fn stated_orientations_are_not_turned_around() {
    let stated = rod(&json!({"orientation": {"axis": [0, 0, 1], "angle": 0.1}}));
    let system = compiled(json!({"body": [stated], "joint": [pin([0.0, -1.0, 0.0])]})).system;
    let why = Assembly::default().run(&system).unwrap_err();
    assert!(matches!(why, AnalysisError::WrongSide { .. }), "{why}");
}

/// The machine's own size does not limit how far a body comes: a lever of a nanometre, half a metre away.
#[test]
fn a_small_machine_comes_from_far() {
    let mut joint = pin([0.0, 1.0, 0.0]);
    joint["at"] = json!([[0, 0, 0], [-1e-9, 0, 0]]);
    let system = compiled(json!({"body": [rod(&json!({}))], "joint": [joint]})).system;
    let (state, report) = Assembly::default().run(&system).expect("it assembles");
    assert!(report.iterations < 60, "{report:?}");
    near("centre", &state.q[..3], &[1e-9, 0.0, 0.0], 1e-16);
}

/// Code and place of what is refused or doubted.
fn told(parts: Value) -> Vec<(String, String)> {
    let all = match compile::<Spatial>(&model(parts), &[]) {
        Ok(compiled) => compiled.warnings,
        Err(refused) => refused.0,
    };
    all.into_iter().map(|d| (d.code, d.path)).collect()
}

#[test]
fn pairs_need_two_joints_with_coordinates() {
    let pair = |kind: &str, key: &str, joints: [&str; 2]| {
        let pair = json!({"name": "g", "kind": kind, "joints": joints, key: 2});
        told(json!({"body": [rod(&json!({}))], "joint": [pin([0.0, 1.0, 0.0]), pair]}))
    };
    let list = |code: &str, path: &str| vec![(code.to_owned(), path.to_owned())];
    let own = list("no-coordinate", "joint[1].joints[1]");
    assert_eq!(pair("gear-pair", "ratio", ["pin", "g"]), own);
    assert_eq!(pair("rack-pair", "radius", ["pin", "g"]), own);
    let same = list("same-joint", "joint[1].joints[1]");
    assert_eq!(pair("gear-pair", "ratio", ["pin", "pin"]), same);
}

#[test]
fn degrees_without_a_unit_are_doubted() {
    let angles = |angles: Value| {
        told(json!({"body": [rod(&json!({"orientation": {"euler": "zxz", "angles": angles}}))]}))
    };
    let doubt = |k: usize| {
        (
            "radians".to_owned(),
            format!("body[0].orientation.angles[{k}]"),
        )
    };
    assert_eq!(angles(json!([30, 45, 0])), [doubt(0), doubt(1)]);
    assert_eq!(angles(json!(["30 rad", 6, 6.5])), []);
}
