//! Constraint rows: C_q, C_t and Q_d.

use super::*;

fn constraints(system: &System<Planar>, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
    let mut ws = Workspace::new(system);
    system.update_markers(q, v, &mut ws);
    system.evaluate_constraints(t, &mut ws);
    ws.value.clone()
}

/// C_q, C_t and Q_d of a system against differences of its residual along each coordinate, along time, and along the
/// path q + v s, t + s, on which d2C/ds2 = -Q_d.
fn check(name: &str, parts: Value) {
    let system = system(parts);
    assert!(system.rows > 0, "{name} has no rows");
    let mut random = Random::new(SEED);
    for n in 0..STATES {
        let name = format!("{name}, state {n}");
        let state = random_state(&system, &mut random);
        let State { t, q, v } = &state;
        let ws = evaluated(&system, &state);
        assert!(
            ws.value.iter().any(|c| c.abs() > 1e-3),
            "{name} is on the manifold"
        );
        let jacobian = system.dense_jacobian(&ws);
        for k in 0..system.nv() {
            let mut unit = vec![0.0; system.nv()];
            unit[k] = 1.0;
            let (slope, _) = differentiate(|s| constraints(&system, *t, &moved(q, &unit, s), v));
            near(
                &format!("{name}: C_q column {k}"),
                jacobian.column(k).as_slice(),
                &slope,
                TOLERANCE,
            );
        }
        let (slope, _) = differentiate(|s| constraints(&system, t + s, q, v));
        near(&format!("{name}: C_t"), &ws.time, &slope, TOLERANCE);
        let (rate, second) = differentiate(|s| constraints(&system, t + s, &moved(q, v, s), v));
        let mut own = vec![0.0; system.rows];
        system.jac_mul(&ws, v, &mut own);
        for (own, time) in own.iter_mut().zip(&ws.time) {
            *own += time;
        }
        near(&format!("{name}: C_q v + C_t"), &own, &rate, TOLERANCE);
        let qd: Vec<f64> = ws.qd.iter().map(|x| -x).collect();
        near(&format!("{name}: -Q_d"), &qd, &second, TOLERANCE);
    }
}

#[test]
fn joints_without_parameters() {
    for kind in ["revolute", "prismatic", "weld", "distance", "pin-slot"] {
        for bodies in [["a", "b"], ["ground", "b"], ["a", "ground"]] {
            let mut joint = joint(kind, bodies, json!({}));
            if kind == "distance" {
                // Long, so that the direction turns slowly enough for the differences.
                joint["at"] = json!([[0.31, -0.12], [6.0, 0.19]]);
            }
            let parts = json!({"joint": [joint]});
            check(&format!("{kind} between {bodies:?}"), parts);
        }
    }
}

#[test]
fn gears() {
    for internal in [false, true] {
        for carrier in [Some("c"), None] {
            let mut gear = json!({"name": "G", "kind": "gear", "bodies": ["a", "b"],
                                  "radii": [0.3, 0.17], "internal": internal});
            if let Some(carrier) = carrier {
                gear["carrier"] = json!(carrier);
            }
            check(
                &format!("gear, internal {internal}, carrier {carrier:?}"),
                json!({"joint": [gear]}),
            );
        }
    }
}

#[test]
fn racks_and_rolling() {
    for kind in ["rack", "rolling-on-line"] {
        for side in ["left", "right"] {
            for bodies in [["a", "b"], ["ground", "b"], ["a", "ground"]] {
                let more = json!({"radius": 0.4, "side": side});
                let parts = json!({"joint": [joint(kind, bodies, more)]});
                check(&format!("{kind}, {side}, {bodies:?}"), parts);
            }
        }
    }
    for (radii, internal) in [([0.5, 0.2], false), ([0.5, 0.2], true), ([0.2, 0.5], true)] {
        for bodies in [["a", "b"], ["ground", "b"], ["a", "ground"]] {
            let more = json!({"radii": radii, "internal": internal});
            let parts = json!({"joint": [joint("rolling-on-circle", bodies, more)]});
            check(
                &format!("rolling on circle {radii:?}, internal {internal}, {bodies:?}"),
                parts,
            );
        }
    }
}

#[test]
fn cams() {
    let profiles = [
        json!({"radius": "0.3 m + 0.05 m * sin(2*phi) + 0.02 m * phi"}),
        json!({"x": "0.3 m * cos(phi) + 0.02 m * phi^2", "y": "0.2 m * sin(phi) - 0.03 m * cos(2*phi)"}),
    ];
    let followers = [
        json!({"kind": "knife-edge"}),
        json!({"kind": "roller", "radius": 0.11}),
        json!({"kind": "flat"}),
    ];
    for profile in &profiles {
        for follower in &followers {
            for bodies in [["a", "b"], ["ground", "b"], ["a", "ground"]] {
                let more = json!({"profile": profile, "follower": follower, "phi": 0.4});
                let parts = json!({"joint": [joint("cam", bodies, more)]});
                check(&format!("cam {profile} {follower} {bodies:?}"), parts);
            }
        }
    }
}

#[test]
fn fixed_coordinates_and_couplers() {
    for coordinate in ["x", "y", "angle"] {
        let fixed = json!({"name": "F", "kind": "fixed", "value": 0.3,
            "quantity": {"kind": "coordinate", "body": "b", "at": [0.2, 0.4], "coordinate": coordinate}});
        check(
            &format!("fixed {coordinate}"),
            json!({"constraint": [fixed]}),
        );
    }
    let coupler = json!({"name": "K", "kind": "coupler", "value": 0.2, "terms": [
        {"factor": 1.5, "kind": "angle", "joint": "R"},
        {"factor": -0.7, "kind": "displacement", "joint": "P"},
        {"factor": 0.4, "kind": "coordinate", "body": "c", "at": [0.1, -0.3], "coordinate": "y"},
        {"factor": 2.1, "kind": "relative-angle", "bodies": ["c", "b"]},
        {"factor": -1.2, "kind": "distance", "bodies": ["a", "c"], "at": [[0.1, 0.2], [6.5, -0.3]]}
    ]});
    let mut revolute = joint("revolute", ["a", "b"], json!({}));
    revolute["name"] = json!("R");
    let mut slide = joint("prismatic", ["c", "b"], json!({}));
    slide["name"] = json!("P");
    check(
        "coupler",
        json!({"joint": [revolute, slide], "constraint": [coupler]}),
    );
}

#[test]
fn user_expressions() {
    for expression in [
        "(a.x - b.x)^2 + 0.5 m * (a.y + b.y) * sin(a.angle - 2*b.angle) - 0.1 m^2 * cos(3 rad/s * t) * b.angle",
        "exp(0.3 * R.angle) * sqrt(1 m^2 + (tip.x - c.x)^2) - 0.2 m * t / 1 s",
    ] {
        let mut revolute = joint("revolute", ["a", "b"], json!({}));
        revolute["name"] = json!("R");
        let parts = json!({
            "trace": [{"name": "tip", "body": "b", "at": [0.4, -0.2]}],
            "joint": [revolute],
            "constraint": [{"name": "E", "kind": "expression", "expression": expression}]
        });
        check(expression, parts);
    }
}

#[test]
fn drivers() {
    let length = "0.2 m + 0.3 m * sin(1.5 rad/s * t) + 0.1 m/s^3 * t^3 / 1";
    let angle = "0.2 + 0.3 * sin(1.5 rad/s * t) + 0.4 * (t / 1 s)^3";
    let quantities = [
        (
            json!({"kind": "coordinate", "body": "b", "at": [0.3, 0.1], "coordinate": "x"}),
            true,
        ),
        (
            json!({"kind": "coordinate", "body": "b", "at": [0.3, 0.1], "coordinate": "y"}),
            true,
        ),
        (
            json!({"kind": "coordinate", "body": "b", "coordinate": "angle"}),
            false,
        ),
        (json!({"kind": "angle", "joint": "R"}), false),
        (json!({"kind": "displacement", "joint": "P"}), true),
        (
            json!({"kind": "relative-angle", "bodies": ["a", "b"]}),
            false,
        ),
        (
            json!({"kind": "distance", "bodies": ["a", "b"], "at": [[0.1, 0.2], [6.0, 0.1]]}),
            true,
        ),
    ];
    for (quantity, is_length) in quantities {
        let motions = if is_length {
            [
                json!({"value": length}),
                json!({"rate": "0.4 m/s * cos(1.5 rad/s * t)", "start": 0.3}),
            ]
        } else {
            [
                json!({"value": angle}),
                json!({"rate": "0.4 rad/s * cos(1.5 rad/s * t) + 0.2 rad/s", "start": 0.3}),
            ]
        };
        for motion in motions {
            let mut driver = quantity.clone();
            driver["name"] = json!("D");
            for (key, value) in motion.as_object().unwrap() {
                driver[key] = value.clone();
            }
            let mut revolute = joint("revolute", ["a", "b"], json!({}));
            revolute["name"] = json!("R");
            let mut slide = joint("prismatic", ["c", "b"], json!({}));
            slide["name"] = json!("P");
            check(
                &driver.to_string(),
                json!({"joint": [revolute, slide], "driver": [driver]}),
            );
        }
    }
    for from in [None, Some("c")] {
        let mut path = json!({"name": "D", "kind": "path", "body": "b", "at": [0.3, -0.2],
                              "x": length, "y": "0.4 m * cos(2 rad/s * t)"});
        if let Some(from) = from {
            path["from"] = json!(from);
            path["from_at"] = json!([0.2, 0.6]);
        }
        check(&path.to_string(), json!({"driver": [path]}));
    }
}
