//! Constraint rows against the same rows in dual numbers: C, C_q, C_t and Q_d.

use super::oracle::{
    Both, CamOracle, CamProfile, Difference, Expression, Follow, Gear, Machine, Motion, Pair,
    Residual, Rolling, RollingCircle, Sum, Term, Touch, What,
};
use super::*;
use num_dual::{Dual2_64, Dual64};

/// A few roundings of terms of the size of the largest entry; angles of some radians cost a digit.
const EXACT: f64 = 4e-15;
/// Motions given by their rate: the integral is adaptive, and good to this.
const INTEGRATED: f64 = 1e-13;

/// Residual, C_q, C_t and Q_d of a system at random states off the manifold. Along the path q + v s, t + s the second
/// derivative of C is -Q_d.
fn check(name: &str, parts: Value, oracle: &impl Residual) {
    let system = system(parts);
    assert!(system.rows > 0, "{name} has no rows");
    let constants = oracle.constants(&Machine::estimate());
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

        let plain = oracle.rows(&Machine {
            t: *t,
            q: q.clone(),
        });
        let value: Vec<f64> = plain.iter().zip(&constants).map(|(c, k)| c - k).collect();
        near(&format!("{name}: C"), &ws.value, &value, INTEGRATED);

        let slope = |t: Dual64, q: Vec<Dual64>| -> Vec<f64> {
            oracle
                .rows(&Machine { t, q })
                .iter()
                .map(|c| c.eps)
                .collect()
        };
        let still = |k| {
            q.iter()
                .enumerate()
                .map(move |(i, x)| Dual64::new(*x, f64::from(u8::from(i == k))))
        };
        let jacobian = system.dense_jacobian(&ws);
        for k in 0..system.nv() {
            near(
                &format!("{name}: C_q column {k}"),
                jacobian.column(k).as_slice(),
                &slope(Dual64::from(*t), still(k).collect()),
                EXACT,
            );
        }
        let time = slope(Dual64::new(*t, 1.0), still(usize::MAX).collect());
        near(&format!("{name}: C_t"), &ws.time, &time, EXACT);

        let path = q.iter().zip(v).map(|(q, v)| Dual2_64::new(*q, *v, 0.0));
        let path = oracle.rows(&Machine {
            t: Dual2_64::new(*t, 1.0, 0.0),
            q: path.collect(),
        });
        let mut rate = vec![0.0; system.rows];
        system.jac_mul(&ws, v, &mut rate);
        for (rate, time) in rate.iter_mut().zip(&ws.time) {
            *rate += time;
        }
        let expected: Vec<f64> = path.iter().map(|c| c.v1).collect();
        near(&format!("{name}: C_q v + C_t"), &rate, &expected, EXACT);
        let expected: Vec<f64> = path.iter().map(|c| -c.v2).collect();
        near(&format!("{name}: Q_d"), &ws.qd, &expected, EXACT);
    }
}

const AT: [[f64; 2]; 2] = [[0.31, -0.12], [-0.23, 0.19]];
const ANGLES: [f64; 2] = [0.35, -0.8];
const PAIRS: [[&str; 2]; 3] = [["a", "b"], ["ground", "b"], ["a", "ground"]];

fn pair(kind: &'static str, bodies: [&'static str; 2]) -> Pair {
    Pair {
        kind,
        bodies,
        at: AT,
        angles: ANGLES,
    }
}

/// A revolute joint R of a and b and a prismatic joint P of c and b, whose coordinates others use.
fn carriers() -> (Value, Both<Pair, Pair>) {
    let mut revolute = joint("revolute", ["a", "b"], json!({}));
    revolute["name"] = json!("R");
    let mut slide = joint("prismatic", ["c", "b"], json!({}));
    slide["name"] = json!("P");
    let oracle = Both(pair("revolute", ["a", "b"]), pair("prismatic", ["c", "b"]));
    (json!([revolute, slide]), oracle)
}

/// The coordinates of R and P: what they measure, and what the angles of the markers add.
const ANGLE_OF_R: (What, f64) = (What::Angle("a", "b"), ANGLES[1] - ANGLES[0]);
const DISPLACEMENT_OF_P: (What, f64) = (What::Along(["c", "b"], AT, ANGLES[0]), 0.0);

#[test]
fn joints_without_parameters() {
    for kind in ["revolute", "prismatic", "weld", "distance", "pin-slot"] {
        for bodies in PAIRS {
            let parts = json!({"joint": [joint(kind, bodies, json!({}))]});
            check(
                &format!("{kind} between {bodies:?}"),
                parts,
                &pair(kind, bodies),
            );
        }
    }
}

#[test]
fn gears() {
    let radii = [0.3, 0.17];
    for internal in [false, true] {
        for carrier in ["c", "ground"] {
            let mut gear = json!({"name": "G", "kind": "gear", "bodies": ["a", "b"],
                                  "radii": radii, "internal": internal});
            if carrier != "ground" {
                gear["carrier"] = json!(carrier);
            }
            check(
                &format!("gear, internal {internal}, carrier {carrier}"),
                json!({"joint": [gear]}),
                &Gear {
                    carrier,
                    radii,
                    internal,
                },
            );
        }
    }
}

#[test]
fn racks_and_rolling_on_lines() {
    for kind in ["rack", "rolling-on-line"] {
        for (name, side) in [("left", 1.0), ("right", -1.0)] {
            for bodies in PAIRS {
                let more = json!({"radius": 0.4, "side": name});
                let parts = json!({"joint": [joint(kind, bodies, more)]});
                let frame = |k: usize| (bodies[k], AT[k], ANGLES[k]);
                // The rack is the second body, the line is the first.
                let (line, circle) = if kind == "rack" { (1, 0) } else { (0, 1) };
                let oracle = Rolling {
                    line: frame(line),
                    circle: frame(circle),
                    radius: 0.4,
                    side,
                    touches: kind == "rolling-on-line",
                };
                check(&format!("{kind}, {name}, {bodies:?}"), parts, &oracle);
            }
        }
    }
}

#[test]
fn rolling_on_circles() {
    for (radii, internal) in [([0.5, 0.2], false), ([0.5, 0.2], true), ([0.2, 0.5], true)] {
        for bodies in PAIRS {
            let more = json!({"radii": radii, "internal": internal});
            let parts = json!({"joint": [joint("rolling-on-circle", bodies, more)]});
            let oracle = RollingCircle {
                pair: pair("rolling-on-circle", bodies),
                radii,
                internal,
            };
            check(
                &format!("rolling on circle {radii:?}, internal {internal}, {bodies:?}"),
                parts,
                &oracle,
            );
        }
    }
}

#[test]
fn cams() {
    let profiles = [
        (
            CamProfile::Polar,
            json!({"radius": "0.3 m + 0.05 m * sin(2*phi) + 0.02 m * phi"}),
        ),
        (
            CamProfile::Cartesian,
            json!({"x": "0.3 m * cos(phi) + 0.02 m * phi^2", "y": "0.2 m * sin(phi) - 0.03 m * cos(2*phi)"}),
        ),
    ];
    let followers = [
        (Touch::KnifeEdge, json!({"kind": "knife-edge"})),
        (
            Touch::Roller(0.11),
            json!({"kind": "roller", "radius": 0.11}),
        ),
        (Touch::Flat, json!({"kind": "flat"})),
    ];
    for (profile, profile_value) in &profiles {
        for (touch, follower) in &followers {
            for bodies in PAIRS {
                let more = json!({"profile": profile_value, "follower": follower, "phi": 0.4});
                let parts = json!({"joint": [joint("cam", bodies, more)]});
                let oracle = CamOracle {
                    bodies,
                    at: AT,
                    angles: ANGLES,
                    profile: *profile,
                    touch: *touch,
                };
                check(
                    &format!("cam {profile_value} {follower} {bodies:?}"),
                    parts,
                    &oracle,
                );
            }
        }
    }
}

#[test]
fn fixed_coordinates_and_couplers() {
    let at = [0.2, 0.4];
    for (coordinate, what) in [
        ("x", What::X("b", at)),
        ("y", What::Y("b", at)),
        ("angle", What::Angle("ground", "b")),
    ] {
        let fixed = json!({"name": "F", "kind": "fixed", "value": 0.3,
            "quantity": {"kind": "coordinate", "body": "b", "at": at, "coordinate": coordinate}});
        check(
            &format!("fixed {coordinate}"),
            json!({"constraint": [fixed]}),
            &Sum(vec![Term(1.0, what, 0.0)], 0.3),
        );
    }
    let far = [[0.1, 0.2], [6.5, -0.3]];
    let coupler = json!({"name": "K", "kind": "coupler", "value": 0.2, "terms": [
        {"factor": 1.5, "kind": "angle", "joint": "R"},
        {"factor": -0.7, "kind": "displacement", "joint": "P"},
        {"factor": 0.4, "kind": "coordinate", "body": "c", "at": [0.1, -0.3], "coordinate": "y"},
        {"factor": 2.1, "kind": "relative-angle", "bodies": ["c", "b"]},
        {"factor": -1.2, "kind": "distance", "bodies": ["a", "c"], "at": far}
    ]});
    let terms = vec![
        Term(1.5, ANGLE_OF_R.0, ANGLE_OF_R.1),
        Term(-0.7, DISPLACEMENT_OF_P.0, DISPLACEMENT_OF_P.1),
        Term(0.4, What::Y("c", [0.1, -0.3]), 0.0),
        Term(2.1, What::Angle("c", "b"), 0.0),
        Term(-1.2, What::Distance(["a", "c"], far), 0.0),
    ];
    let (joints, oracle) = carriers();
    check(
        "coupler",
        json!({"joint": joints, "constraint": [coupler]}),
        &Both(oracle, Sum(terms, 0.2)),
    );
}

#[test]
fn user_expressions() {
    for (expression, oracle) in [
        (
            "(a.x - b.x)^2 + 0.5 m * (a.y + b.y) * sin(a.angle - 2*b.angle) - 0.1 m^2 * cos(3 rad/s * t) * b.angle",
            Expression::Polynomial,
        ),
        (
            "exp(0.3 * R.angle) * sqrt(1 m^2 + (tip.x - c.x)^2) - 0.2 m * t / 1 s",
            Expression::Root,
        ),
    ] {
        let (joints, others) = carriers();
        let parts = json!({
            "trace": [{"name": "tip", "body": "b", "at": [0.4, -0.2]}],
            "joint": joints,
            "constraint": [{"name": "E", "kind": "expression", "expression": expression}]
        });
        check(expression, parts, &Both(others, oracle));
    }
}

#[test]
fn drivers() {
    let length = "0.2 m + 0.3 m * sin(1.5 rad/s * t) + 0.1 m/s^3 * t^3 / 1";
    let angle = "0.2 + 0.3 * sin(1.5 rad/s * t) + 0.4 * (t / 1 s)^3";
    let far = [[0.1, 0.2], [6.0, 0.1]];
    let quantities = [
        (
            json!({"kind": "coordinate", "body": "b", "at": [0.3, 0.1], "coordinate": "x"}),
            (What::X("b", [0.3, 0.1]), 0.0),
            true,
        ),
        (
            json!({"kind": "coordinate", "body": "b", "at": [0.3, 0.1], "coordinate": "y"}),
            (What::Y("b", [0.3, 0.1]), 0.0),
            true,
        ),
        (
            json!({"kind": "coordinate", "body": "b", "coordinate": "angle"}),
            (What::Angle("ground", "b"), 0.0),
            false,
        ),
        (json!({"kind": "angle", "joint": "R"}), ANGLE_OF_R, false),
        (
            json!({"kind": "displacement", "joint": "P"}),
            DISPLACEMENT_OF_P,
            true,
        ),
        (
            json!({"kind": "relative-angle", "bodies": ["a", "b"]}),
            (What::Angle("a", "b"), 0.0),
            false,
        ),
        (
            json!({"kind": "distance", "bodies": ["a", "b"], "at": far}),
            (What::Distance(["a", "b"], far), 0.0),
            true,
        ),
    ];
    for (quantity, (what, offset), is_length) in quantities {
        let motions = if is_length {
            [
                (Motion::Length, json!({"value": length})),
                (
                    Motion::LengthByRate,
                    json!({"rate": "0.4 m/s * cos(1.5 rad/s * t)", "start": 0.3}),
                ),
            ]
        } else {
            [
                (Motion::Angle, json!({"value": angle})),
                (
                    Motion::AngleByRate,
                    json!({"rate": "0.4 rad/s * cos(1.5 rad/s * t) + 0.2 rad/s", "start": 0.3}),
                ),
            ]
        };
        for (follows, motion) in motions {
            let mut driver = quantity.clone();
            driver["name"] = json!("D");
            for (key, value) in motion.as_object().unwrap() {
                driver[key] = value.clone();
            }
            let (joints, oracle) = carriers();
            check(
                &driver.to_string(),
                json!({"joint": joints, "driver": [driver]}),
                &Both(oracle, Follow(what, offset, follows)),
            );
        }
    }
}

#[test]
fn path_drivers() {
    let at = [0.3, -0.2];
    for from in [None, Some("c")] {
        let mut path = json!({"name": "D", "kind": "path", "body": "b", "at": at,
            "x": "0.2 m + 0.3 m * sin(1.5 rad/s * t) + 0.1 m/s^3 * t^3 / 1", "y": "0.4 m * cos(2 rad/s * t)"});
        let mut start = ("ground", [0.0, 0.0]);
        if let Some(from) = from {
            path["from"] = json!(from);
            path["from_at"] = json!([0.2, 0.6]);
            start = (from, [0.2, 0.6]);
        }
        let along = |motion, pick: fn(&'static str, [f64; 2]) -> What| Difference {
            motion,
            from: pick(start.0, start.1),
            to: pick("b", at),
        };
        let oracle = Both(
            along(Motion::Length, What::X),
            along(Motion::Cosine, What::Y),
        );
        check(&path.to_string(), json!({"driver": [path]}), &oracle);
    }
}
