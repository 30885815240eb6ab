//! Poses of equilibrium that go over into each other are one.

use super::moving_machine::compiled;
use dalembert::analysis::{AnalysisError, Assembly, Stability, Statics};
use serde_json::{Value, json};

/// The number of equilibria, and the stability of the first.
fn equilibria(parts: Value) -> (usize, Stability) {
    let report = Statics::default().run(&compiled(parts).system).unwrap();
    (report.equilibria.len(), report.equilibria[0].stability)
}

/// It comes to stand anywhere on its plane, with any heading, although the blade lets it slide one way only.
#[test]
fn a_skate_has_one_family_of_poses() {
    let joint = |kind: &str, axis: [f64; 3]| {
        json!({"name": kind, "kind": kind, "bodies": ["ground", "e"],
               "at": [[0, 0, 0], [0, 0, 0]], "axis": axis})
    };
    let skate = json!({
        "body": [{"name": "e", "mass": 1, "inertia": [1, 1, 1]}],
        "joint": [joint("planar", [0.0, 0.0, 1.0]), joint("knife-edge", [0.0, 1.0, 0.0])]
    });
    assert_eq!(equilibria(skate), (1, Stability::Neutral));
}

/// Upright, anywhere, with any heading and any point of its rim below; it would fall over.
#[test]
fn a_rolling_coin_has_one_family_of_poses() {
    let coin = json!({
        "body": [{"name": "coin", "position": [0, 0, 0.012], "mass": 0.0075,
                  "inertia": [3e-7, 3e-7, 6e-7], "orientation": {"axis": [1, 0, 0], "angle": "90 deg"}}],
        "joint": [{"name": "floor", "kind": "rolling-disc", "bodies": ["ground", "coin"],
                   "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]], "radius": 0.012}]
    });
    assert_eq!(equilibria(coin), (1, Stability::Unstable));
}

/// Where the shafts are twisted by half a turn the rows hold too.
#[test]
fn a_twisted_constant_velocity_joint_is_refused() {
    let shafts = |twist: &str| {
        compiled(json!({
            "body": [{"name": "in", "mass": 1, "inertia": [1, 1, 1]},
                     {"name": "out", "mass": 1, "inertia": [1, 1, 1], "orientation":
                      {"axis": [0, 0, 1], "angle": twist}}],
            "joint": [{"name": "r", "kind": "revolute", "bodies": ["ground", "in"],
                       "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]]},
                      {"name": "cv", "kind": "constant-velocity", "bodies": ["in", "out"],
                       "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]],
                       "x_axes": [[1, 0, 0], [1, 0, 0]]}]
        }))
        .system
    };
    assert!(Assembly::default().run(&shafts("80 deg")).is_ok());
    let error = Assembly::default().run(&shafts("100 deg")).unwrap_err();
    let AnalysisError::WrongSide { elements, .. } = &error else {
        panic!("{error}");
    };
    assert!(elements.contains("'cv'"), "{error}");
}
