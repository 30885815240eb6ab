//! Contacts at the places where parameters of surfaces fail, and sides of surfaces.

use super::moving_machine::{G, compiled, mobility, motion, run, spread, start};
use super::*;
use dalembert::analysis::{AnalysisError, Dynamics, DynamicsReport, Stability, Statics};
use dalembert::diagnostic::Diagnostics;
use dalembert::model::Model;
use dalembert::space::Spatial;
use dalembert::system::System;
use dalembert::system::compile::compile;
use serde_json::{Value, json};

const HALF: [f64; 3] = [0.3, 0.2, 0.15];

/// A body with the inertia of the ellipsoid.
fn egg(position: [f64; 3], orientation: Value) -> Value {
    let [a, b, c] = HALF.map(|x| x * x);
    let inertia = [b + c, a + c, a + b].map(|x| 0.4 * x);
    json!({"name": "egg", "mass": 2, "inertia": inertia, "position": position, "orientation": orientation,
           "hold": ["x", "y", "orientation"]})
}

/// An ellipsoid on a plane; the z axis of its surface, on which the poles of a and b lie, is one of the body's axes.
fn egg_on_plane(body: Value, pole: usize) -> System<Spatial> {
    // The z axis along the wanted one, the x axis along the next.
    let axis = |k: usize| [0, 1, 2].map(|i| f64::from(u8::from(i == k % 3)));
    let half = [1, 2, 0].map(|k| HALF[(pole + k) % 3]);
    compiled(json!({
        "body": [body],
        "joint": [{"name": "floor", "kind": "surface-contact", "bodies": ["egg", "ground"],
                   "at": [[0, 0, 0], [0, 0, 0]], "axes": [axis(pole), [0, 0, 1]], "x_axes": [axis(pole + 1), [1, 0, 0]],
                   "surfaces": [{"kind": "ellipsoid", "semi_axes": half}, {"kind": "plane"}]}]
    }))
    .system
}

fn channel<'a>(report: &'a DynamicsReport, name: &str) -> &'a [f64] {
    &report.results.channel(name).unwrap().values
}

fn instants(end: f64) -> Vec<f64> {
    (0..=50).map(|k| end * f64::from(k) / 50.0).collect()
}

/// An ellipsoid that rocks about its shortest axis in its plane of symmetry touches at a pole each time it swings through.
/// Where the poles lie has no part in the motion.
#[test]
fn an_ellipsoid_rocks_over_its_pole() {
    let tilted = || json!({"axis": [1, 0, 0], "angle": "25 deg"});
    let runs = [2, 0].map(|pole| {
        let system = egg_on_plane(egg([0.0, 0.0, 0.15], tilted()), pole);
        assert_eq!(mobility(&system).freedoms(), 5);
        run(&system, &instants(2.0), 1e-11)
    });
    for name in ["egg.z", "floor.normal_force", "floor.point_y"] {
        near(name, channel(&runs[0], name), channel(&runs[1], name), 1e-9);
    }
    assert!(
        channel(&runs[0], "floor.normal_force")
            .iter()
            .all(|f| *f > 0.0)
    );
    assert!(spread(&runs[0], "energy.total") < 1e-10);
    // It went over the pole: b = -90 deg below, on either side.
    let point = channel(&runs[0], "floor.point_y");
    assert!(point.iter().any(|y| *y > 0.01) && point.iter().any(|y| *y < -0.01));
    // The parameters in the results are those of the point.
    let [a, b] = ["floor.a1", "floor.b1"].map(|name| channel(&runs[0], name));
    let q = &runs[0].state.q;
    let (pose, ..) = motion(&runs[0].state, 0);
    let (a, b) = (a[50], b[50]);
    let u = nalgebra::Vector3::new(
        HALF[0] * b.cos() * a.cos(),
        HALF[1] * b.cos() * a.sin(),
        HALF[2] * b.sin(),
    );
    let seen = pose.point + pose.axes * u;
    let point = ["x", "y", "z"].map(|of| channel(&runs[0], &format!("floor.point_{of}"))[50]);
    near("point by a and b", seen.as_slice(), &point, 1e-13);
    let w = nalgebra::Vector3::new(q[7], q[8], q[9]);
    assert!((w.norm() - 1.0).abs() < 1e-11);
}

/// A point in a hollow sphere, and a ball in an ellipsoid with equal axes, swing through the lowest point, a pole, like
/// pendulums.
#[test]
fn bodies_slide_through_the_pole_of_a_bowl() {
    let body = json!({"name": "bob", "mass": 1.5, "inertia": [0.01, 0.01, 0.01], "position": [0.3, 0, -0.4]});
    let of = |joint: Value| compiled(json!({"body": [body.clone()], "joint": [joint]})).system;
    let at = json!([[0, 0, 0], [0, 0, 0]]);
    let rod = json!({"name": "bowl", "kind": "distance", "bodies": ["ground", "bob"], "at": at});
    let expected = run(&of(rod), &instants(2.0), 1e-11);
    let sphere = json!({"kind": "sphere", "radius": 0.5, "inside": true});
    let bowl = json!({"kind": "ellipsoid", "semi_axes": [0.6, 0.6, 0.6], "inside": true});
    let ball = json!({"kind": "sphere", "radius": 0.1});
    for joint in [
        json!({"name": "bowl", "kind": "point-on-surface", "bodies": ["ground", "bob"], "at": at, "surface": sphere}),
        json!({"name": "bowl", "kind": "surface-contact", "bodies": ["ground", "bob"], "at": at, "surfaces": [bowl, ball]}),
    ] {
        let report = run(&of(joint.clone()), &instants(2.0), 1e-11);
        for name in ["bob.x", "bob.z"] {
            let (found, wanted) = (channel(&report, name), channel(&expected, name));
            near(&format!("{joint}: {name}"), found, wanted, 1e-9);
        }
        let normal = channel(&report, "bowl.normal_force");
        assert!(normal.iter().all(|f| *f > 0.0), "{joint}");
        assert!(
            !report.results.notes.iter().any(|n| n.contains("pull")),
            "{joint}"
        );
    }
}

/// An egg at rest on its flat side touches at a pole: five freedoms, and nothing is unstable. Of all poses of rest none lies
/// under the plane.
#[test]
fn an_egg_at_rest() {
    let system = egg_on_plane(
        egg([0.0, 0.0, 0.16], json!({"axis": [0, 0, 1], "angle": 0.0})),
        2,
    );
    assert_eq!(mobility(&system).freedoms(), 5);
    let report = Statics {
        starts: Some(6),
        ..Statics::default()
    }
    .run(&system)
    .unwrap();
    assert_eq!(report.equilibria[0].stability, Stability::Neutral);
    near("z", &report.equilibria[0].q[2..3], &[0.15], 1e-12);
    assert_eq!(
        report.equilibria[0]
            .motions
            .iter()
            .filter(|m| m.contains("unstable"))
            .count(),
        0
    );
    for e in &report.equilibria {
        assert!(e.q[2] > 0.1, "{:?}", e.q);
    }
    assert!(!report.results.notes.iter().any(|n| n.contains("pull")));
}

/// Under a ceiling all poses of rest hang: each is named.
#[test]
fn poses_at_rest_that_would_pull_are_named() {
    let system = compiled(json!({
        "body": [egg([0.0, 0.0, -0.2], json!({"axis": [0, 1, 0], "angle": "20 deg"}))],
        "joint": [{"name": "ceiling", "kind": "surface-contact", "bodies": ["ground", "egg"], "at": [[0, 0, 0], [0, 0, 0]],
                   "axes": [[0, 0, -1], [0, 0, 1]],
                   "surfaces": [{"kind": "plane"}, {"kind": "ellipsoid", "semi_axes": HALF}]},
                  {"name": "line", "kind": "point-on-line", "bodies": ["ground", "egg"], "at": [[0, 0, 0], [0, 0, 0]],
                   "axis": [0, 0, 1]}]
    }))
    .system;
    let report = Statics {
        starts: Some(2),
        ..Statics::default()
    }
    .run(&system)
    .unwrap();
    for k in 1..=report.equilibria.len() {
        let wanted = format!("at equilibrium {k} the contact 'ceiling' would have to pull");
        assert!(
            report.results.notes.iter().any(|n| n.contains(&wanted)),
            "{:?}",
            report.results.notes
        );
    }
}

/// A bead on a wire-like surface is held both ways by intention.
#[test]
fn points_on_surfaces_hold_both_ways() {
    let system = compiled(json!({
        "body": [{"name": "bob", "mass": 1, "inertia": [0.01, 0.01, 0.01], "position": [0.3, 0.1, -0.4]}],
        "joint": [{"name": "track", "kind": "point-on-surface", "bodies": ["ground", "bob"], "at": [[0, 0, 0], [0, 0, 0]],
                   "surface": {"kind": "sphere", "radius": 0.5}}]
    }))
    .system;
    let report = run(&system, &[0.0, 0.1], 1e-9);
    assert!(channel(&report, "track.normal_force")[0] < -1.0);
    assert!(!report.results.notes.iter().any(|n| n.contains("pull")));
}

fn stopped(parts: Value, end: f64) -> AnalysisError {
    let mut options = Dynamics::new(&Default::default());
    options.instants = vec![0.0, end];
    let report = options.run(&compiled(parts).system, &mut |_| true).unwrap();
    assert!(report.results.statistics["steps"] < 500.0);
    report.stopped.unwrap()
}

/// A profile that meets the axis has a real pole.
#[test]
fn a_run_ends_at_the_pole_of_a_revolved_surface() {
    let error = stopped(
        json!({
            "body": [{"name": "ball", "mass": 1, "inertia": [0.01, 0.01, 0.01], "position": [0.3, 0, 0.4]}],
            "joint": [{"name": "bowl", "kind": "surface-contact", "bodies": ["ground", "ball"], "at": [[0, 0, 0], [0, 0, 0]],
                       "surfaces": [{"kind": "revolved", "r": "b * 1 m", "z": "b^2 * 1 m", "inside": true},
                                    {"kind": "sphere", "radius": 0.05}]}]
        }),
        2.0,
    );
    let AnalysisError::SurfacePole {
        element,
        surface,
        time,
        ..
    } = &error
    else {
        panic!("{error}");
    };
    assert_eq!(
        (element.as_str(), *surface),
        ("'bowl' (surface-contact)", "first")
    );
    assert!((0.1..1.0).contains(time));
}

#[test]
fn a_run_ends_where_cylinders_become_parallel() {
    let error = stopped(
        json!({
            "body": [{"name": "log", "mass": 1, "inertia": [0.02, 0.02, 0.005], "position": [0, 0, 0.2],
                      "orientation": {"axis": [0, 0, 1], "angle": "40 deg"}, "angular_velocity": [0, 0, -1]}],
            "joint": [{"name": "contact", "kind": "surface-contact", "bodies": ["ground", "log"],
                       "at": [[0, 0, 0], [0, 0, 0]], "axes": [[1, 0, 0], [1, 0, 0]],
                       "surfaces": [{"kind": "cylinder", "radius": 0.1}, {"kind": "cylinder", "radius": 0.1}]}]
        }),
        2.0,
    );
    let AnalysisError::LineContact { element, time } = &error else {
        panic!("{error}");
    };
    assert_eq!(element, "'contact' (surface-contact)");
    // 40 deg at 1 rad/s; the curvatures are as tan(angle/2)^2, and a hundred-thousandth of them at 40 deg is left 2.3e-3
    // before.
    let left = 40.0_f64.to_radians() - time;
    assert!((0.0..2.4e-3).contains(&left), "{left}");
}

/// A standing cylinder above a plane may fall to either side, but not below the plane; a body on a slide comes up to the
/// plane from below.
#[test]
fn bodies_lie_on_the_right_side() {
    let above = compiled(json!({
        "body": [{"name": "log", "mass": 1, "inertia": [0.01, 0.01, 0.01], "position": [0.1, 0, 2]}],
        "joint": [{"name": "c", "kind": "surface-contact", "bodies": ["ground", "log"], "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": [{"kind": "plane"}, {"kind": "cylinder", "radius": 0.1}]}]
    }))
    .system;
    near("cylinder", &start(&above).q[2..3], &[0.1], 1e-12);
    let below = compiled(json!({
        "body": [{"name": "egg", "mass": 1, "inertia": [0.01, 0.01, 0.01], "position": [0, 0, -0.2]}],
        "joint": [{"name": "c", "kind": "surface-contact", "bodies": ["ground", "egg"], "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": [{"kind": "plane"}, {"kind": "ellipsoid", "semi_axes": HALF}]},
                  {"name": "slide", "kind": "prismatic", "bodies": ["ground", "egg"], "point": [0, 0, 0],
                   "axis": [0, 0, 1]}]
    }))
    .system;
    near("on a slide", &start(&below).q[2..3], &[0.15], 1e-12);
}

/// In the middle of its bowl a ball has no direction to the wall: it falls.
#[test]
fn a_ball_in_the_middle_of_its_bowl() {
    let system = compiled(json!({
        "gravity": [G, 0, 0],
        "body": [{"name": "ball", "mass": 1, "inertia": [0.01, 0.01, 0.01]}],
        "joint": [{"name": "bowl", "kind": "surface-contact", "bodies": ["ground", "ball"], "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": [{"kind": "sphere", "radius": 0.5, "inside": true}, {"kind": "sphere", "radius": 0.06}]}]
    }))
    .system;
    near("place", &start(&system).q[..3], &[0.44, 0.0, 0.0], 1e-13);
}

/// A ball of 1 m touches a small hyperboloid where it fits, not at the waist, where it would run into it beside the contact.
#[test]
fn a_ball_touches_where_it_fits() {
    let system = compiled(json!({
        "body": [{"name": "b", "mass": 1, "inertia": [0.1, 0.1, 0.1], "position": [0.1, 0.2, 1.3]}],
        "joint": [{"name": "c", "kind": "surface-contact", "bodies": ["ground", "b"], "at": [[0, 0, 0], [0, 0, 0]],
                   "axes": [[0, 0, 1], [0, 0, 1]],
                   "surfaces": [{"kind": "sphere", "radius": 1.0},
                                {"kind": "revolved", "r": "0.1 m*sqrt(1+b^2)", "z": "0.1 m*b"}]}]
    }))
    .system;
    let state = start(&system);
    // Curvature of the hyperbola: 0.1 m (1 + 2 b^2)^(3/2) is its radius.
    let b = state.q[8];
    assert!(0.1 * (1.0 + 2.0 * b * b).powf(1.5) > 1.0, "{b}");
}

/// Lengths of surfaces are lengths of the machine.
#[test]
fn surfaces_count_in_the_size() {
    let system = egg_on_plane(
        egg([0.0, 0.0, 0.15], json!({"axis": [1, 0, 0], "angle": 0.0})),
        2,
    );
    assert_eq!(system.size, 0.3);
}

fn outcome(surface: Value, parameters: Option<[[f64; 2]; 2]>) -> Result<(), Diagnostics> {
    let mut joint = json!({"name": "c", "kind": "surface-contact", "bodies": ["ground", "ball"], "at": [[0, 0, 0], [0, 0, 0]],
                           "surfaces": [surface, {"kind": "sphere", "radius": 0.1}]});
    if let Some(parameters) = parameters {
        joint["parameters"] = json!(parameters);
    }
    let model: Model = serde_json::from_value(json!({
        "model": {"name": "test", "space": "spatial"},
        "body": [{"name": "ball", "mass": 1, "inertia": [0.01, 0.01, 0.01], "position": [0.1, 0, 2]}],
        "joint": [joint]
    }))
    .unwrap();
    compile::<Spatial>(&model, &[]).map(drop)
}

#[test]
fn surfaces_that_are_refused() {
    let mistakes = |surface| outcome(surface, None).unwrap_err().0;
    let crossing = mistakes(json!({"kind": "torus", "radius": 0.1, "tube": 0.3}));
    assert_eq!(crossing[0].code, "crossing-torus");
    let number =
        mistakes(json!({"kind": "expression", "x": "a", "y": "b * 1 m", "z": "0.1 m * a^2"}));
    let help = number[0].help.clone().unwrap();
    assert!(help.contains("\"a * 1 m\""), "{help}");
    // At a pole, beside it, and away from it.
    let hill = || json!({"kind": "revolved", "r": "b * 1 m", "z": "1 m - b^2 * 1 m"});
    for (b, good) in [(0.0, false), (1e-7, false), (1e-3, true)] {
        let found = outcome(hill(), Some([[0.0, b], [0.0, 0.0]]));
        assert_eq!(found.is_ok(), good, "{b}");
        if let Err(found) = found {
            assert_eq!(found.0[0].code, "no-contact");
        }
    }
}
