//! Ranks of the rows of joints, at random poses and at those where badly chosen rows lose it.

use super::SEED;
use super::check::random_state;
use super::joints::joint;
use super::machine::{compiled, evaluated, system};
use super::motion::{CATALOGUE, null_space, rank};
use super::support::Random;
use dalembert::system::State;
use nalgebra::DMatrix;
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

/// What a contact or a velocity row takes: its entry in the model, its rows, its auxiliary coordinates, and how many of
/// the rows hold velocities alone.
fn contacts() -> Vec<(Value, usize, usize, usize)> {
    let at = [[0.31, -0.12, 0.27], [-0.23, 0.19, 0.11]];
    let axes = [[0.3, -0.5, 0.8], [1.5, 0.4, -0.6]];
    let named = |kind: &str, mut keys: Value| {
        keys["name"] = json!("J");
        keys["kind"] = json!(kind);
        keys["bodies"] = json!(["a", "b"]);
        keys["at"] = json!(at);
        keys
    };
    let egg = json!({"kind": "ellipsoid", "semi_axes": [0.5, 0.3, 0.2]});
    let ball = json!({"kind": "sphere", "radius": 0.4});
    let ring = json!({"kind": "torus", "radius": 0.6, "tube": 0.2});
    let touching = |surfaces: [&Value; 2]| {
        named(
            "surface-contact",
            json!({"surfaces": surfaces, "parameters": [[0.3, 0.2], [-0.4, 0.5]]}),
        )
    };
    let on_surface = |surface: &Value| {
        named(
            "point-on-surface",
            json!({"surface": surface, "parameters": [0.3, 0.2]}),
        )
    };
    vec![
        (joint("J", "point-on-curve", ["a", "b"]), 3, 1, 0),
        // Round surfaces have unit vectors: three parameters and a row for their length.
        (on_surface(&egg), 4, 3, 0),
        (on_surface(&ring), 3, 2, 0),
        (touching([&egg, &json!({"kind": "plane"})]), 6, 5, 0),
        (touching([&ring, &egg]), 6, 5, 0),
        // Two spheres need no parameters.
        (touching([&ball, &ball]), 1, 0, 0),
        (
            named("rolling-disc", json!({"axes": axes, "radius": 0.3})),
            3,
            0,
            2,
        ),
        (
            named(
                "rolling-disc",
                json!({"axes": axes, "radius": 0.3, "rounding": 0.1}),
            ),
            3,
            0,
            2,
        ),
        (
            named("rolling-ball", json!({"axes": axes, "radius": 0.3})),
            3,
            0,
            2,
        ),
        (named("knife-edge", json!({"axes": axes})), 1, 0, 1),
    ]
}

/// Contacts take as many freedoms of the bodies as they have rows beyond their own parameters: one for surfaces, two for
/// a curve, with two more for velocities where they roll.
#[test]
fn contacts_at_random_poses() {
    let mut source = Random::new(SEED);
    for (entry, rows, parameters, velocities) in contacts() {
        let system = system(&json!({"joint": [entry]})).running();
        assert_eq!(
            (system.rows, system.aux, system.velocity_rows().len()),
            (rows, parameters, velocities),
            "{entry}"
        );
        for _ in 0..20 {
            let state = random_state(&system, &mut source);
            let mut ws = evaluated(&system, &state);
            let all = system.dense_jacobian(&ws);
            assert_eq!(rank(&all), rows, "{entry}");
            let own = all.columns(system.body_nv(), system.aux).into_owned();
            // What is left for the bodies, and of it for positions.
            let left = if parameters == 0 {
                DMatrix::identity(rows, rows)
            } else {
                assert_eq!(rank(&own), parameters, "{entry}: C_s");
                null_space(&own.transpose())
            };
            assert_eq!(left.ncols(), rows - parameters, "{entry}");
            let bodies = all.columns(0, system.body_nv());
            assert_eq!(
                rank(&(left.transpose() * bodies)),
                rows - parameters,
                "{entry}"
            );
            system.evaluate_positions(state.t, &mut ws);
            assert_eq!(
                rank(&system.dense_jacobian(&ws)),
                rows - velocities,
                "{entry}: positions"
            );
        }
    }
}

/// Gears and racks take one freedom beside the joints they mesh.
#[test]
fn meshed_joints_at_random_poses() {
    let mut source = Random::new(SEED);
    for (kind, key, other) in [
        ("gear-pair", "ratio", "revolute"),
        ("gear-pair", "ratio", "cylindrical"),
        ("rack-pair", "radius", "prismatic"),
        ("rack-pair", "radius", "cylindrical"),
    ] {
        for second in [["a", "c"], ["ground", "c"], ["b", "c"]] {
            let mut mesh = json!({"name": "G", "kind": kind, "joints": ["J", "K"]});
            mesh[key] = json!(0.6);
            let joints = [
                joint("J", "revolute", ["a", "b"]),
                joint("K", other, second),
            ];
            let system = system(&json!({"joint": [joints[0], joints[1], mesh]}));
            let rows = CATALOGUE.iter().find(|c| c.0 == other).unwrap().1 + 6;
            assert_eq!(system.rows, rows);
            for _ in 0..20 {
                let state = random_state(&system, &mut source);
                let ws = evaluated(&system, &state);
                let found = rank(&system.dense_jacobian(&ws));
                assert_eq!(found, rows, "{kind} of revolute and {other} of {second:?}");
            }
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
