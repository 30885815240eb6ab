//! Contacts whose rows hold where their surfaces do not touch: at poles of parameters, and where they cross.

use super::moving_machine::{compiled, run, start};
use super::*;
use dalembert::analysis::{AnalysisError, Assembly, Dynamics, Statics};
use dalembert::space::Spatial;
use dalembert::system::System;
use serde_json::{Value, json};

/// A body in a contact with the ground.
fn contact(gravity: [f64; 3], body: Value, surfaces: [Value; 2]) -> System<Spatial> {
    let mut body = body;
    body["name"] = json!("e");
    body["mass"] = json!(1);
    body["inertia"] = json!([0.02, 0.03, 0.025]);
    compiled(json!({
        "gravity": gravity,
        "body": [body],
        "joint": [{"name": "c", "kind": "surface-contact", "bodies": ["ground", "e"], "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": surfaces}]
    }))
    .system
}

fn down() -> [f64; 3] {
    [0.0, 0.0, -9.81]
}

fn profile() -> Value {
    json!({"kind": "revolved", "r": "0.2 m*cos(b)", "z": "0.3 m*sin(b)"})
}

fn written() -> Value {
    json!({"kind": "expression", "x": "0.2 m*cos(b)*cos(a)", "y": "0.2 m*cos(b)*sin(a)", "z": "0.3 m*sin(b)"})
}

/// An egg that lies, estimated too low or too high, comes onto the plane as it lies and not at its pole, where its normal by
/// the parameters vanishes and every row of the contact holds.
#[test]
fn an_egg_does_not_start_at_its_pole() {
    for surface in [profile(), written()] {
        for z in [0.1, 0.19, 0.25, 0.6] {
            let body = json!({"position": [0, 0, z], "orientation": {"axis": [1, 0, 0], "angle": "90 deg"}});
            let system = contact(down(), body, [json!({"kind": "plane"}), surface.clone()]);
            let state = start(&system);
            near(
                &format!("{surface} from {z}"),
                &state.q[2..3],
                &[0.2],
                1e-12,
            );
            let b: f64 = state.q[10];
            assert!(b.abs() < 1e-6, "{b}");
        }
    }
}

/// A slide holds the egg upright: it can only stand on its pole, and that is said.
#[test]
fn an_egg_held_on_its_pole_is_refused() {
    let system = compiled(json!({
        "body": [{"name": "e", "mass": 1, "inertia": [0.02, 0.03, 0.025], "position": [0, 0, 0.31],
                  "orientation": {"axis": [1, 0, 0], "angle": "5 deg"}}],
        "joint": [{"name": "slide", "kind": "prismatic", "bodies": ["ground", "e"], "at": [[0, 0, 0], [0, 0, 0]],
                   "axes": [[0, 0, 1], [0, 0, 1]], "x_axes": [[1, 0, 0], [1, 0, 0]]},
                  {"name": "c", "kind": "surface-contact", "bodies": ["ground", "e"], "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": [{"kind": "plane"}, profile()]}]
    }))
    .system;
    let error = Assembly::default().run(&system).unwrap_err();
    let AnalysisError::SurfacePole {
        element, surface, ..
    } = &error
    else {
        panic!("{error}");
    };
    assert_eq!(
        (element.as_str(), *surface),
        ("'c' (surface-contact)", "second")
    );
    assert!(error.to_string().contains("`parameters`"), "{error}");
}

/// Bodies that are too large for a hollow, or too round for it, do not come together in it.
#[test]
fn surfaces_that_cross_are_refused() {
    let bowl = || json!({"kind": "sphere", "radius": 1, "inside": true});
    let tilted = json!({"matrix": [[-0.8536117155695915, -0.43041808050615593, 0.293406399070871],
                                   [-0.3143179914983467, 0.8747560869204938, 0.36878990765988845],
                                   [-0.41539287338949876, 0.2225804671774729, -0.881990190630414]]});
    let cases = [
        (
            json!({"position": [0.1, 0, 0]}),
            [
                json!({"kind": "cylinder", "radius": 0.2, "inside": true}),
                json!({"kind": "sphere", "radius": 0.3}),
            ],
            [5.0, -1.0 / 0.3],
        ),
        (
            json!({"position": [0.1, 0, -0.1]}),
            [
                bowl(),
                json!({"kind": "ellipsoid", "semi_axes": [1.2, 1.2, 1.2]}),
            ],
            [1.0, -1.0 / 1.2],
        ),
        // A cylinder without ends is straight along its axis.
        (
            json!({"position": [0.05, 0.02, -0.3307108325598094], "orientation": tilted}),
            [bowl(), json!({"kind": "cylinder", "radius": 0.1})],
            [1.0, 0.0],
        ),
    ];
    for (body, surfaces, expected) in cases {
        let name = format!("{surfaces:?}");
        let system = contact(down(), body, surfaces);
        let error = Assembly::default().run(&system).unwrap_err();
        let AnalysisError::CrossingSurfaces {
            element,
            curvatures,
            ..
        } = &error
        else {
            panic!("{name}: {error}");
        };
        assert_eq!(element, "'c' (surface-contact)");
        near(&name, curvatures, &expected, 1e-9);
        assert!(
            error.to_string().contains("hollow with a radius of"),
            "{error}"
        );
    }
}

/// A torus does not touch a plane in the saddle of its hole, where it lies on both sides of it.
#[test]
fn a_torus_does_not_touch_in_its_hole() {
    let orientation = json!({"matrix": [[0.7333863029753865, 0.23828304553062574, -0.6366833756434548],
                                        [0.5376819375810837, 0.3697723454561376, 0.7577377821746244],
                                        [0.41598397157480277, -0.8980476617354541, 0.14306548376298578]]});
    let body = json!({"position": [-0.135, 0.0945, 0.0165], "orientation": orientation});
    let torus = json!({"kind": "torus", "radius": 0.3, "tube": 0.1});
    let system = contact(down(), body, [json!({"kind": "plane"}), torus]);
    let state = start(&system);
    // Outside the circle of the tube's middle, cos b > 0, and above the plane as it must be.
    let b: f64 = state.q[10];
    assert!(b.cos() > 0.0, "{b}");
    let z = state.q[2];
    assert!(z > 0.1, "{z}");
}

/// A flat ellipsoid at the bottom of a bowl would pass through it all around: no pose of rest.
#[test]
fn statics_drops_poses_that_cross() {
    let surfaces = [
        json!({"kind": "sphere", "radius": 1, "inside": true}),
        json!({"kind": "ellipsoid", "semi_axes": [0.9, 0.9, 0.1]}),
    ];
    // On its rim; upright it stands at rest.
    let body =
        json!({"position": [0, 0, -0.1], "orientation": {"axis": [1, 0, 0], "angle": "85 deg"}});
    let system = contact(down(), body, surfaces);
    let report = Statics {
        starts: Some(6),
        ..Statics::default()
    }
    .run(&system)
    .unwrap();
    for e in &report.equilibria {
        // Flat at the bottom its middle lies at -0.9.
        assert!(e.q[2] > -0.5, "{:?}", e.q);
    }
}

/// A coin that is nearly without thickness, and a needle, touch a plane in a point all the same.
#[test]
fn flat_and_slender_bodies_touch_in_a_point() {
    let tilted = json!({"axis": [1, 0, 0], "angle": "60 deg"});
    for (semi_axes, z) in [([0.1, 0.1, 1e-6], 0.0866), ([1e-4, 1e-4, 0.1], 0.05)] {
        let body =
            json!({"position": [0, 0, z], "orientation": tilted, "angular_velocity": [0, 0, 3]});
        let ellipsoid = json!({"kind": "ellipsoid", "semi_axes": semi_axes});
        let all = contact(down(), body, [json!({"kind": "plane"}), ellipsoid]);
        // Six coordinates of the points and no row that holds one of them.
        assert!(
            !all.elements[0]
                .element
                .labels()
                .iter()
                .any(|l| l.text == "point of the line")
        );
        let mut options = Dynamics::new(&Default::default());
        options.instants = vec![0.0, 0.05];
        let report = options.run(&all, &mut |_| true).unwrap();
        assert!(
            report.stopped.is_none(),
            "{semi_axes:?}: {:?}",
            report.stopped
        );
    }
}

/// Two balls that turn on the spot press with nothing but rounding.
#[test]
fn rounding_does_not_pull() {
    let ball = |name: &str, z: f64, omega: [f64; 3], axis: [f64; 3]| {
        json!({"name": name, "mass": 1, "inertia": [0.036, 0.036, 0.036], "position": [0, 0, z],
               "orientation": {"axis": axis, "angle": 1.1}, "angular_velocity": omega})
    };
    let system = compiled(json!({
        "gravity": [0, 0, 0],
        "body": [ball("a", 0.0, [1.5, -1.9, 3.6], [1.0, 2.0, 3.0]), ball("b", 0.5, [0.5, 1.9, 0.7], [-1.0, 2.0, 0.5])],
        "joint": [{"name": "c", "kind": "surface-contact", "bodies": ["a", "b"], "at": [[0, 0, 0], [0, 0, 0]],
                   "surfaces": [{"kind": "sphere", "radius": 0.3},
                                {"kind": "ellipsoid", "semi_axes": [0.2, 0.2, 0.2]}]}]
    }))
    .system;
    let instants: Vec<f64> = (0..=100).map(|k| 0.02 * f64::from(k)).collect();
    let report = run(&system, &instants, 1e-9);
    let force = &report.results.channel("c.normal_force").unwrap().values;
    // Some of them are negative, or the test says nothing.
    assert!(force.iter().any(|f| *f < 0.0) && force.iter().all(|f| f.abs() < 1e-12));
    let notes = &report.results.notes;
    assert!(!notes.iter().any(|n| n.contains("pull")), "{notes:?}");
}
