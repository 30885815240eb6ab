//! Ways to write joints that fail, and that ours do not.

use super::machine::{Machine, Spot, between, compiled, evaluated, pose};
use super::motion::rank;
use super::oracle::{cross, dot};
use super::{Random, SEED, near, random};
use dalembert::analysis::{AnalysisError, Assembly};
use dalembert::space::orientation::EulerSequence;
use dalembert::space::{Space, Spatial};
use nalgebra::{DMatrix, Rotation3, Vector3};
use num_dual::Dual64;
use serde_json::{Value, json};

/// A revolute joint as a cylindrical one with a distance that stays (Shabana 7.171 to 7.173, with squared length) has rank
/// 4 where the two points coincide; ours has 5.
#[test]
fn revolute_with_coincident_points() {
    let at = [0.2, -0.1, 0.3];
    let spot = |body| Spot {
        body,
        at,
        z: [0.3, 0.5, 0.8],
        x: [1.0, 0.0, 0.0],
    };
    let q: Vec<f64> = [
        [0.4, 0.1, 0.2, 0.5, 0.5, 0.5, 0.5],
        [0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.5],
    ]
    .concat();
    let gradient = |apart: f64| {
        let mut rows = DMatrix::zeros(5, 12);
        for k in 0..12 {
            let mut machine = Machine {
                t: Dual64::from(0.0),
                s: Dual64::new(0.0, 1.0),
                poses: q.chunks_exact(7).map(pose).collect(),
                v: vec![0.0; 12],
                auxiliary: Vec::new(),
                memory: Vec::new(),
            };
            machine.v[k] = 1.0;
            let a = machine.marker(&spot("a"));
            // The second body stands where the points are apart by this much along the axis.
            let meet = pose_at(&machine, &spot("a"), &spot("b"), apart);
            machine.poses[1].point += meet;
            let b = machine.marker(&spot("b"));
            let d = between(&a, &b);
            let (v, w) = (cross(&a.axes[2], &b.axes[2]), cross(&a.axes[2], &d));
            // Two components of each cross product are independent here.
            let r = [v[0], v[1], w[0], w[1], dot(&d, &d)];
            for (row, x) in r.iter().enumerate() {
                rows[(row, k)] = x.eps;
            }
        }
        rows
    };
    assert_eq!(rank(&gradient(0.3)), 5);
    assert_eq!(rank(&gradient(0.0)), 4);

    let body = |name: &str, position: [f64; 3]| {
        json!({"name": name, "mass": 1.0, "inertia": [1, 2, 3], "position": position,
               "orientation": {"euler_parameters": [0.5, 0.5, 0.5, 0.5]}})
    };
    let ours = compiled(json!({
        "body": [body("a", [0.4, 0.1, 0.2]), body("b", [0.4, 0.1, 0.2])],
        "joint": [{"name": "J", "kind": "revolute", "bodies": ["a", "b"], "at": [at, at],
                   "axes": [[0.3, 0.5, 0.8], [0.3, 0.5, 0.8]]}]
    }))
    .system;
    let ws = evaluated(&ours, &ours.estimate);
    assert!(ours.violation(&ws).0 < 1e-15);
    assert_eq!(rank(&ours.dense_jacobian(&ws)), 5);
}

/// By how much the second body must move for its point to lie on the first axis, so far from the first point.
fn pose_at(machine: &Machine<Dual64>, a: &Spot, b: &Spot, apart: f64) -> Vector3<f64> {
    let (a, b) = (machine.marker(a), machine.marker(b));
    Vector3::from([0, 1, 2].map(|k| a.point[k].re + apart * a.axes[2][k].re - b.point[k].re))
}

fn joint_on_ground(kind: &str, orientation: &Value) -> Value {
    let mut joint = json!({"name": "J", "kind": kind, "bodies": ["ground", "b"],
        "at": [[0.1, 0.2, 0.3], [0.2, -0.1, 0.1]], "axes": [[0, 0, 1], [0, 0, 1]],
        "x_axes": [[1, 0, 0], [1, 0, 0]]});
    if kind == "screw" {
        joint["pitch"] = json!(0.05);
    }
    json!({"body": [{"name": "b", "mass": 1.0, "inertia": [1, 2, 3], "center": [0.1, 0.2, 0.05],
                     "orientation": orientation}],
           "joint": [joint]})
}

/// Rows of scalar products also hold where axes are opposite: the assembly refuses such a pose and names the joint.
#[test]
fn opposite_axes_are_refused() {
    for (kind, axes) in [
        ("revolute", &[[1.0, 0.1, 0.02], [0.2, 1.0, -0.03]][..]),
        ("cylindrical", &[[1.0, 0.1, 0.02], [0.2, 1.0, -0.03]]),
        ("screw", &[[1.0, 0.1, 0.02], [0.2, 1.0, -0.03]]),
        ("planar", &[[1.0, 0.1, 0.02], [0.2, 1.0, -0.03]]),
        ("parallel-axes", &[[1.0, 0.1, 0.02], [0.2, 1.0, -0.03]]),
        // Turned about any of its axes by half a turn.
        (
            "weld",
            &[[1.0, 0.01, 0.02], [0.02, 1.0, -0.03], [0.02, 0.03, 1.0]],
        ),
        (
            "prismatic",
            &[[1.0, 0.01, 0.02], [0.02, 1.0, -0.03], [0.02, 0.03, 1.0]],
        ),
    ] {
        for axis in axes {
            let system = compiled(joint_on_ground(
                kind,
                &json!({"axis": axis, "angle": "178 deg"}),
            ))
            .system;
            match Assembly::default().run(&system) {
                Err(AnalysisError::WrongSide { elements, .. }) => {
                    assert_eq!(elements, format!("'J' ({kind})"));
                }
                other => panic!("{kind} turned about {axis:?}: {other:?}"),
            }
        }
    }
}

/// The three scalar products of a weld also vanish where its axes are exchanged in a circle: a third of a turn about the
/// diagonal.
#[test]
fn axes_exchanged_in_a_circle_are_refused() {
    for kind in ["weld", "prismatic"] {
        for (axis, angle) in [
            ([1.0, 1.0, 1.0], 2.05),
            ([1.0, 1.0, 1.0], -2.05),
            ([1.0, -1.0, -1.0], 2.05),
            ([1.0, -1.0, -1.0], -2.05),
            ([-1.0, 1.0, -1.0], -2.1),
            ([-1.0, -1.0, 1.0], 2.1),
        ] {
            let model = joint_on_ground(kind, &json!({"axis": axis, "angle": angle}));
            let system = compiled(model).system;
            let found = Assembly::default().run(&system);
            match found {
                Err(AnalysisError::WrongSide { elements, .. }) => {
                    assert_eq!(elements, format!("'J' ({kind})"));
                }
                Err(other) => panic!("{kind} turned about {axis:?} by {angle}: {other}"),
                // Where the rows brought it back it must stand as meant.
                Ok((state, _)) => {
                    let axes = pose(&state.q).axes;
                    assert!(
                        (axes - nalgebra::Matrix3::identity()).amax() < 1e-12,
                        "{kind}: {axes}"
                    );
                }
            }
        }
    }
}

/// Euler angles whose differences stay constant let two bodies turn against each other (Shabana 7.183); our weld does not.
#[test]
fn a_weld_is_rigid_where_differences_of_euler_angles_are_not() {
    let angles = |x: [f64; 3]| {
        *EulerSequence::ZXZ
            .rotation(&Vector3::from(x))
            .to_rotation_matrix()
            .matrix()
    };
    let (first, apart) = ([0.3, 0.8, -0.4], [0.5, 0.6, 0.2]);
    let moved = [1.1, 1.3, 0.7];
    let second = |x: [f64; 3]| [0, 1, 2].map(|k| x[k] + apart[k]);
    let relative = |x: [f64; 3]| angles(x).transpose() * angles(second(x));
    let turned =
        Rotation3::from_matrix_unchecked(relative(first).transpose() * relative(moved)).angle();
    assert!(turned > 0.3, "the trap is none: {turned}");

    // The same two bodies on a weld: wherever the assembly puts the first, the second keeps its place on it.
    let body = |name: &str, position: [f64; 3], x: [f64; 3]| {
        json!({"name": name, "mass": 1.0, "inertia": [1, 2, 3], "center": [0.1, 0.2, 0.05], "position": position,
               "orientation": {"euler": "zxz", "angles": x}})
    };
    let system = compiled(json!({
        "body": [body("a", [0.1, 0.2, 0.3], first), body("b", [0.4, -0.2, 0.5], second(first))],
        "joint": [{"name": "J", "kind": "weld", "bodies": ["a", "b"], "point": [0.3, 0.3, 0.3]}]
    }))
    .system;
    let seen = |q: &[f64]| {
        let (a, b) = (Spatial::pose(&q[..7]), Spatial::pose(&q[7..14]));
        let turn = a.axes.tr_mul(&b.axes);
        (turn, a.axes.tr_mul(&(b.point - a.point)))
    };
    let (turn, place) = seen(&system.estimate.q);
    let mut source = Random::new(SEED);
    for _ in 0..10 {
        let mut other = system.clone();
        // Both bodies moved alike, and a little apart, so that the assembly has to close the weld.
        let step = random::<6>(&mut source, 1.0);
        for b in 0..2 {
            let q = &mut other.estimate.q[7 * b..7 * b + 7];
            let axes = Spatial::pose(&system.estimate.q[..7]).axes;
            let here = Spatial::pose(&q[..7]).axes;
            let omega = here.tr_mul(&(axes * Vector3::new(step[3], step[4], step[5])));
            let apart = random::<6>(&mut source, 0.1);
            let mut own = [step[0], step[1], step[2], omega.x, omega.y, omega.z];
            own.iter_mut().zip(apart).for_each(|(x, d)| *x += d);
            Spatial::advance(q, &own);
        }
        let (state, _) = Assembly::default()
            .run(&other)
            .unwrap_or_else(|e| panic!("{e}"));
        let (t, p) = seen(&state.q);
        near("relative orientation", t.as_slice(), turn.as_slice(), 1e-13);
        near("relative position", p.as_slice(), place.as_slice(), 1e-13);
    }
}
