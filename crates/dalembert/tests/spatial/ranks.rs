//! Ranks of the rows of joints, at random poses and at those where badly chosen rows lose it.

use super::SEED;
use super::check::random_state;
use super::joints::joint;
use super::machine::{compiled, evaluated, system};
use super::motion::{CATALOGUE, rank};
use super::support::Random;
use dalembert::system::State;
use serde_json::{Value, json};

#[test]
fn ranks_at_random_poses() {
    let mut source = Random::new(SEED);
    for (kind, rows, ..) in CATALOGUE {
        let system = system(&json!({"joint": [joint("J", kind, ["a", "b"])]}));
        for _ in 0..20 {
            let state = random_state(&system, &mut source);
            let ws = evaluated(&system, &state);
            assert_eq!(rank(&system.dense_jacobian(&ws)), rows, "{kind}");
        }
    }
}

/// A joint of the ground and a body: points together, axes along each other, and the body turned about the axis from
/// where the ground's frame stands.
fn upright(kind: &str, turn: f64) -> (Value, bool) {
    let mut joint = json!({"name": "J", "kind": kind, "bodies": ["ground", "b"],
        "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]], "x_axes": [[1, 0, 0], [1, 0, 0]]});
    let mut turns = true;
    match kind {
        "screw" => joint["pitch"] = json!(0.1),
        // Nothing turns about the axis.
        "weld" | "prismatic" | "constant-velocity" => {
            joint["x_axes"] = json!([[turn.cos(), turn.sin(), 0], [1, 0, 0]]);
            turns = false;
        }
        "universal" | "perpendicular-axes" => {
            joint["axes"] = json!([[0, 0, 1], [1, 0, 0]]);
            joint.as_object_mut().unwrap().remove("x_axes");
        }
        // Two points that keep a distance must have one.
        "distance" => {
            joint["at"] = json!([[0, 0, 0.3], [0, 0, 0]]);
            for key in ["axes", "x_axes"] {
                joint.as_object_mut().unwrap().remove(key);
            }
        }
        _ => {}
    }
    let body = json!({"name": "b", "mass": 1.0, "inertia": [1, 1, 1],
        "orientation": {"axis": [0, 0, 1], "angle": turn}});
    (json!({"body": [body], "joint": [joint]}), turns)
}

/// The poses at which machines are drawn: all joints keep their rank there, with and without their coordinates.
#[test]
fn ranks_where_points_and_axes_coincide() {
    use std::f64::consts::PI;
    for (kind, rows, ..) in CATALOGUE {
        for turn in [0.0, 0.5 * PI, PI, -PI] {
            let (model, turns) = upright(kind, turn);
            let compiled = compiled(model).system;
            let system = compiled.running();
            let ws = evaluated(&system, &compiled.estimate);
            let what = format!("{kind} turned by {turn}");
            assert!(system.violation(&ws).0 < 1e-15, "{what}: C");
            assert_eq!(rank(&system.dense_jacobian(&ws)), rows, "{what}");
            let e = &system.elements[0];
            let markers = ws.seen(&e.markers);
            if let (true, Some(c)) = (turns, e.coordinates.iter().find(|c| c.name == "angle")) {
                let m = c.measure.evaluate(&markers);
                assert!(
                    (m.value.abs() - turn.abs()).abs() < 1e-15,
                    "{what}: {}",
                    m.value
                );
                assert_eq!(
                    m.second.as_slice(),
                    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
                    "{what}"
                );
            }
        }
    }
}

/// A universal joint loses its rank nowhere; its angles do where the second shaft stands across the cross. There no
/// number becomes infinite.
#[test]
fn bent_shafts_have_finite_numbers() {
    for bend in [0.5, 1.0, 2.0] {
        let q = std::f64::consts::FRAC_PI_2 * bend;
        for kind in ["universal", "constant-velocity"] {
            let (mut model, _) = upright(kind, 0.0);
            model["body"][0]["orientation"] = json!({"axis": [1, 0, 0], "angle": q});
            let compiled = compiled(model).system;
            let state = State {
                v: vec![0.3, -0.2, 0.5, 0.7, 0.4, -0.6],
                ..compiled.estimate.clone()
            };
            let ws = evaluated(&compiled, &state);
            let numbers = ws.value.iter().chain(&ws.qd).chain(&ws.jac);
            assert!(numbers.clone().all(|x| x.is_finite()), "{kind} bent by {q}");
            // A constant-velocity joint folded back by half a turn transmits nothing.
            let lost = usize::from(kind == "constant-velocity" && bend == 2.0);
            let found = rank(&compiled.dense_jacobian(&ws));
            assert_eq!(found, 4 - lost, "{kind} bent by {q}");
        }
    }
}
