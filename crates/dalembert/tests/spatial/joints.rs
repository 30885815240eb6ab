//! Rows of every joint against dual numbers.

use super::check::{check, check_at, random_state};
use super::machine::{Machine, Spot, evaluated, placed, system};
use super::motion::CATALOGUE;
use super::rows::{Both, Curve, Pair, Sum, What};
use super::{Random, SEED, near};
use dalembert::system::State;
use nalgebra::{Rotation3, Vector3};
use serde_json::{Value, json};
use std::f64::consts::{PI, TAU};

const AT: [[f64; 3]; 2] = [[0.31, -0.12, 0.27], [-0.23, 0.19, 0.11]];
const AXES: [[f64; 3]; 2] = [[0.3, -0.5, 0.8], [1.5, 0.4, -0.6]];
const X_AXES: [[f64; 3]; 2] = [[1.0, 0.2, 0.1], [-0.3, 0.9, 0.4]];
const BODIES: [[&str; 2]; 3] = [["a", "b"], ["ground", "b"], ["a", "ground"]];
const PITCH: f64 = -0.37;

/// The frames of a joint whose axes are all given.
pub fn spots(bodies: [&'static str; 2]) -> [Spot; 2] {
    [0, 1].map(|k| Spot {
        body: bodies[k],
        at: AT[k],
        z: AXES[k],
        x: X_AXES[k],
    })
}

/// A joint with all that its kind takes.
pub fn joint(name: &str, kind: &str, bodies: [&str; 2]) -> Value {
    let mut joint = json!({"name": name, "kind": kind, "bodies": bodies, "at": AT});
    if kind != "distance" {
        joint["axes"] = json!(AXES);
    }
    if !matches!(kind, "distance" | "universal" | "perpendicular-axes") {
        joint["x_axes"] = json!(X_AXES);
    }
    match kind {
        "screw" => joint["pitch"] = json!(PITCH),
        "point-on-curve" => {
            let [x, y, z] = Curve::TEXT;
            joint["curve"] = json!({"x": x, "y": y, "z": z});
            joint["u"] = json!(0.3);
        }
        _ => {}
    }
    joint
}

fn pair(kind: &'static str, bodies: [&'static str; 2]) -> Pair {
    let mut spots = spots(bodies);
    if kind == "universal" {
        // The second axis of the cross is x of the second frame.
        spots[1] = spots[1].along_x(spots[1].z);
    }
    Pair {
        kind,
        spots,
        pitch: PITCH,
    }
}

#[test]
fn joints_of_two_frames() {
    for (kind, ..) in CATALOGUE {
        for bodies in BODIES {
            check(
                &format!("{kind} between {bodies:?}"),
                &json!({"joint": [joint("J", kind, bodies)]}),
                &pair(kind, bodies),
            );
        }
    }
}

/// Points together; frames alike, or turned by half a turn about each of their axes, or by a third about the diagonal.
#[test]
fn joints_at_degenerate_poses() {
    let turn = |axis: [f64; 3], angle: f64| {
        let axis = nalgebra::Unit::new_normalize(Vector3::from(axis));
        *Rotation3::from_axis_angle(&axis, angle).matrix()
    };
    let mut source = Random::new(SEED);
    for (kind, ..) in CATALOGUE {
        let bodies = ["ground", "b"];
        let oracle = pair(kind, bodies);
        let system = system(&json!({"joint": [joint("J", kind, bodies)]}));
        for (axis, angle) in [
            ([0.0, 0.0, 1.0], 0.0),
            ([0.0, 0.0, 1.0], PI),
            ([1.0, 0.0, 0.0], PI),
            ([0.0, 1.0, 0.0], PI),
            ([1.0, 1.0, 1.0], TAU / 3.0),
        ] {
            // The direction of a distance needs two points.
            let apart = if kind == "distance" {
                [0.0, 0.0, 0.4]
            } else {
                [0.0; 3]
            };
            let mut state = random_state(&system, &mut source);
            state.q[7..14].copy_from_slice(&placed(&oracle.spots, &turn(axis, angle), apart));
            // Half a turn is as near to zero from both sides.
            state.q[21..].fill(3.0);
            // Seen from another body, x may stand along the axis: then the angle says nothing.
            if kind == "screw" && angle == TAU / 3.0 {
                continue;
            }
            check_at(
                &format!("{kind} turned about {axis:?} by {angle}"),
                &system,
                &state,
                &oracle,
            );
        }
    }
}

#[test]
fn points_on_curves() {
    for bodies in BODIES {
        check(
            &format!("point-on-curve between {bodies:?}"),
            &json!({"joint": [joint("J", "point-on-curve", bodies)]}),
            &Curve(spots(bodies)),
        );
    }
}

/// A curve through points: the rows of splines against differences of their values along a motion.
#[test]
fn points_on_splines() {
    // Knots that no step of the differences crosses.
    let knots = [-3.0, -2.0, -1.1, 1.2, 2.1, 3.0];
    let values = [
        [0.2, -0.4, 0.1, 0.5, 0.3, -0.2],
        [-0.3, 0.1, 0.4, -0.2, 0.2, 0.6],
    ];
    for (interpolation, exact) in [("cubic", 1e-9), ("quintic", 1e-9)] {
        let table = |name: &str, y: [f64; 6]| json!({"name": name, "interpolation": interpolation, "x": knots, "y": y.map(|y| format!("{y} m"))});
        for bodies in BODIES {
            let mut wire = joint("J", "point-on-curve", bodies);
            wire["curve"] = json!({"x": "wx(u)", "y": "wy(u)", "z": "0.3 m * u"});
            let system = system(&json!({
                "table": [table("wx", values[0]), table("wy", values[1])],
                "joint": [wire]
            }));
            let mut source = Random::new(SEED);
            for _ in 0..5 {
                let state = random_state(&system, &mut source);
                let ws = evaluated(&system, &state);
                let name = format!("{interpolation} wire between {bodies:?}");
                let along = |v: &[f64], s: f64| {
                    let mut q = state.q.clone();
                    system.advance(&mut q, s, v);
                    evaluated(&system, &State { q, ..state.clone() }).value
                };
                // Differences of fourth order.
                const H: f64 = 5e-3;
                let stencil = |v: &[f64], weights: [f64; 5]| -> Vec<f64> {
                    let steps = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| along(v, k * H));
                    let row = |r: usize| (0..5).map(|k| weights[k] * steps[k][r]).sum::<f64>();
                    (0..system.rows).map(row).collect()
                };
                let jacobian = system.dense_jacobian(&ws);
                for k in 0..system.nv() {
                    let mut v = vec![0.0; system.nv()];
                    v[k] = 1.0;
                    let slope = stencil(&v, [1.0, -8.0, 0.0, 8.0, -1.0].map(|w| w / (12.0 * H)));
                    let what = format!("{name}: C_q column {k}");
                    near(&what, jacobian.column(k).as_slice(), &slope, exact);
                }
                let weights = [-1.0, 16.0, -30.0, 16.0, -1.0].map(|w| -w / (12.0 * H * H));
                let bend = stencil(&state.v, weights);
                near(&format!("{name}: Q_d"), &ws.qd, &bend, exact);
            }
        }
    }
}

/// Gears on joints that share a body, and on joints that share none.
#[test]
fn gear_pairs_and_rack_pairs() {
    for second in [["a", "c"], ["ground", "c"]] {
        for (kind, key, other) in [
            ("gear-pair", "ratio", "revolute"),
            ("gear-pair", "ratio", "cylindrical"),
            ("rack-pair", "radius", "prismatic"),
            ("rack-pair", "radius", "point-on-line"),
        ] {
            let first = ["a", "b"];
            let mut mesh = json!({"name": "G", "kind": kind, "joints": ["J", "K"]});
            mesh[key] = json!(-0.6);
            let parts =
                json!({"joint": [joint("J", "revolute", first), joint("K", other, second), mesh]});
            let moved = if kind == "gear-pair" {
                What::Angle(spots(second), 1)
            } else {
                What::Along(spots(second))
            };
            let terms = vec![(1.0, moved), (0.6, What::Angle(spots(first), 0))];
            check(
                &format!("{kind} on revolute and {other} of {second:?}"),
                &parts,
                &Both(
                    Both(pair("revolute", first), pair(other, second)),
                    Sum(terms, None),
                ),
            );
        }
    }
}

/// Directions given in ground axes at the estimate, and those that are left out.
#[test]
fn axes_that_are_not_given_in_frames() {
    let estimate = Machine::estimate();
    let [a, b] = [0, 1].map(|k| estimate.poses[k].axes);
    let (z, x) = (Vector3::new(0.4, 0.9, -0.2), Vector3::new(0.1, -0.3, 0.8));
    let (point, own) = (Vector3::new(0.5, 0.1, 0.7), [0.2, 0.5, -0.3]);
    let at_a = a.tr_mul(&(point - Vector3::from(own)));
    let at_b = b.tr_mul(&(point - Vector3::new(1.1, 0.9, 0.4)));
    let seen = |z: Vector3<f64>, x: Vector3<f64>| {
        let spot = |body, at: Vector3<f64>, z: Vector3<f64>, x: Vector3<f64>| Spot {
            body,
            at: at.into(),
            z: z.into(),
            x: x.into(),
        };
        [
            spot("a", at_a, a.tr_mul(&z), a.tr_mul(&x)),
            spot("b", at_b, b.tr_mul(&z), b.tr_mul(&x)),
        ]
    };
    let joint = |kind: &str, more: Value| {
        let mut joint =
            json!({"name": "J", "kind": kind, "bodies": ["a", "b"], "point": [0.5, 0.1, 0.7]});
        for (key, value) in more.as_object().unwrap() {
            joint[key] = value.clone();
        }
        json!({"joint": [joint]})
    };
    let pair = |kind, spots| Pair {
        kind,
        spots,
        pitch: 0.21,
    };
    let (axis, x_axis) = (json!([0.4, 0.9, -0.2]), json!([0.1, -0.3, 0.8]));
    for kind in ["revolute", "cylindrical", "screw", "prismatic", "planar"] {
        let mut more = json!({"axis": axis, "x_axis": x_axis});
        if kind == "screw" {
            more["pitch"] = json!(0.21);
        }
        check(kind, &joint(kind, more), &pair(kind, seen(z, x)));
    }
    // A weld without directions has the axes of its first body, as they stand in the estimate.
    let columns = |k: usize| a.column(k).into_owned();
    let (z, x) = (columns(2), columns(0));
    check("weld", &joint("weld", json!({})), &pair("weld", seen(z, x)));
    // The axes of a cross in ground axes.
    let cross = json!({"axis": axis, "second_axis": [0.9, -0.4, 0.3]});
    let first = Vector3::new(0.4, 0.9, -0.2);
    let second = Vector3::new(0.9, -0.4, 0.3);
    let mut spots = seen(first, Vector3::x());
    spots[1] = spots[1].along_x(b.tr_mul(&second).into());
    let universal = pair("universal", spots);
    check("universal", &joint("universal", cross.clone()), &universal);
    let mut spots = seen(first, Vector3::x());
    spots[1].z = b.tr_mul(&second).into();
    spots[1].x = [0.1, 0.2, 0.9];
    let perpendicular = pair("perpendicular-axes", spots);
    check(
        "perpendicular",
        &joint("perpendicular-axes", cross),
        &perpendicular,
    );
}

/// A joint between bodies with parallel frames has the angle of its bodies, whatever body axis it stands along.
#[test]
fn angles_without_x_axes_are_those_of_the_bodies() {
    for (axis, name) in [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()]
        .into_iter()
        .zip(["x", "y", "z"])
    {
        let q = Rotation3::from_axis_angle(&axis, 0.7);
        let m = q.matrix();
        let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[(i, j)]));
        let model = json!({
            "body": [{"name": "b", "mass": 1.0, "inertia": [1, 1, 1], "orientation": {"matrix": matrix}}],
            "joint": [{"name": "J", "kind": "revolute", "bodies": ["ground", "b"], "point": [0, 0, 0],
                       "axis": axis.as_ref().as_slice()}]
        });
        let system = super::machine::compiled(model).system;
        let angle = system.estimate.q[7];
        assert!((angle - 0.7).abs() < 1e-15, "about {name}: {angle}");
    }
}
