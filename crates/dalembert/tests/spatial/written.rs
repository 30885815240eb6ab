//! What a run writes beside its usual channels: momenta about a point, and notes.

use super::moving_machine::{G, compiled};
use dalembert::analysis::{Dynamics, Recording};
use dalembert::results::Results;
use dalembert::space::orientation::{OrientationSet, Rotation};
use nalgebra::{Matrix3, Quaternion, Vector3};
use serde_json::{Value, json};

/// Results of a run with the outputs that the model asks for.
fn results(model: Value, instants: Vec<f64>, tolerance: f64) -> Results {
    let all = compiled(model);
    let mut dynamics = Dynamics::new(&all.options);
    dynamics.instants = instants;
    dynamics.tolerance = tolerance;
    let report = dynamics.run(&all.system, &mut |_| true).unwrap();
    assert_eq!(report.stopped, None);
    report.results
}

fn evenly(end: f64, count: u32) -> Vec<f64> {
    (0..=count)
        .map(|k| end * f64::from(k) / f64::from(count))
        .collect()
}

fn vector(results: &Results, name: &str, k: usize) -> Vector3<f64> {
    let of = |axis| {
        let name = format!("{name}{axis}");
        let channel = results.channel(&name);
        channel.unwrap_or_else(|| panic!("no {name}")).values[k]
    };
    Vector3::new(of("x"), of("y"), of("z"))
}

fn turn(results: &Results, body: &str, k: usize) -> Rotation {
    let [w, x, y, z] = [0, 1, 2, 3].map(|n| {
        let channel = results.channel(&format!("{body}.b{n}"));
        channel.unwrap().values[k]
    });
    Rotation::from_quaternion(Quaternion::new(w, x, y, z))
}

const CENTERS: [[f64; 3]; 2] = [[0.1, -0.2, 0.3], [-0.1, 0.15, 0.05]];
const MASSES: [f64; 2] = [2.0, 3.0];

fn inertia(body: usize) -> Matrix3<f64> {
    [
        Matrix3::new(1.1, 0.2, -0.1, 0.2, 0.9, 0.3, -0.1, 0.3, 1.4),
        Matrix3::from_diagonal(&Vector3::new(0.4, 0.5, 0.6)),
    ][body]
}

/// Two bodies on a ball joint, thrown; `gravity` and the point of the momenta as they come.
fn thrown(gravity: [f64; 3], about: Option<[f64; 3]>) -> Value {
    let body = |name: &str, k: usize, v: [f64; 3], w: [f64; 3]| {
        let i = inertia(k);
        let rows = [0, 1, 2].map(|r| [i[(r, 0)], i[(r, 1)], i[(r, 2)]]);
        json!({"name": name, "mass": MASSES[k], "center": CENTERS[k], "inertia": rows, "velocity": v,
               "angular_velocity": w, "position": [0.4, 0.7, -0.3],
               "orientation": {"axis": [1, 2, 3], "angle": 0.4 + k as f64}})
    };
    let mut model = json!({
        "gravity": gravity,
        "body": [body("a", 0, [0.3, -0.1, 0.5], [1.2, -0.6, 0.8]), body("b", 1, [0.3, -0.1, 0.5], [-0.7, 0.4, 1.1])],
        "joint": [{"name": "J", "kind": "spherical", "bodies": ["a", "b"], "at": [[0, 0, 0], [0, 0, 0]]}]
    });
    if let Some(point) = about {
        model["output"] = json!({"momentum_about": point});
    }
    model
}

/// p = m v and L = r x p + J w of each body about a point, from what else is written; their sums are those of the machine,
/// and stay without forces.
#[test]
fn momenta_about_any_point() {
    for about in [[0.0; 3], [0.7, -1.2, 2.5]] {
        let found = results(thrown([0.0; 3], Some(about)), evenly(4.0, 20), 1e-12);
        let mut first = None;
        for k in 0..found.len() {
            let mut sum = [Vector3::zeros(); 2];
            for (b, name) in ["a", "b"].into_iter().enumerate() {
                let turn = turn(&found, name, k);
                let of = |what: &str| vector(&found, &format!("{name}.{what}"), k);
                let (omega, arm) = (of("omega_"), turn * Vector3::from(CENTERS[b]));
                let linear = MASSES[b] * (of("v") + omega.cross(&arm));
                let spin = turn * (inertia(b) * (turn.inverse() * omega));
                let at = of("") + arm - Vector3::from(about);
                let angular = at.cross(&linear) + spin;
                let off = (of("momentum.") - linear).amax();
                assert!(off < 1e-14, "{name} at {k}: p off by {off:e}");
                let off = (of("momentum.angular_") - angular).amax();
                assert!(off < 5e-14, "{name} at {k}: L off by {off:e}");
                sum[0] += linear;
                sum[1] += angular;
            }
            let own = [
                vector(&found, "momentum.", k),
                vector(&found, "momentum.angular_", k),
            ];
            for (sum, own) in sum.iter().zip(own) {
                assert!((sum - own).amax() < 1e-13, "sum at {k}");
            }
            let start = *first.get_or_insert(own);
            for (start, own) in start.iter().zip(own) {
                let moved = (own - start).amax();
                assert!(moved < 1e-10, "about {about:?}, row {k}: {moved:e}");
            }
        }
        let meaning = &found.channel("a.momentum.angular_x").unwrap().meaning;
        let [x, y, z] = about;
        assert!(
            meaning.contains(&format!("about ({x}, {y}, {z})")),
            "{meaning}"
        );
    }
    // Bodies have momenta of their own only where a point is asked for.
    let plain = results(thrown([0.0; 3], None), vec![0.0, 0.1], 1e-8);
    assert!(plain.channel("a.momentum.x").is_none());
    let meaning = &plain.channel("momentum.angular_x").unwrap().meaning;
    assert!(meaning.contains("about the origin"), "{meaning}");
}

/// The quantities that the note of a run names, and by how much it says they change.
fn kept(results: &Results) -> Option<(f64, Vec<String>)> {
    let mut notes = results.notes.iter().filter_map(|note| {
        let (change, names) = note
            .strip_prefix("conserved to ")?
            .split_once(" of their size: ")?;
        let names = names.split(", ").map(str::to_owned).collect();
        Some((change.parse().unwrap(), names))
    });
    let note = notes.next();
    assert!(notes.next().is_none(), "one note: {:?}", results.notes);
    note
}

/// A run says what it kept: everything without forces, what lies across gravity and turns about it, nothing but the energy on a joint of
/// the ground, and nothing at all where a motor drives.
#[test]
fn a_run_notes_what_it_keeps() {
    let momenta = ["x", "y", "z", "angular_x", "angular_y", "angular_z"];
    let all: Vec<String> = momenta.iter().map(|m| format!("momentum.{m}")).collect();
    let with_energy = |names: &[String]| [&["energy.total".to_owned()], names].concat();

    let free = results(thrown([0.0; 3], None), evenly(2.0, 20), 1e-11);
    let (change, names) = kept(&free).unwrap();
    assert_eq!(names, with_energy(&all));
    assert!(change > 0.0 && change < 1e-9, "{change:e}");
    // As large as the channels say.
    let energy = &free.channel("energy.total").unwrap().values;
    let moved = energy
        .iter()
        .fold(0.0_f64, |m, e| m.max((e - energy[0]).abs()));
    let largest = energy.iter().fold(0.0_f64, |m, e| m.max(e.abs()));
    // The note has two digits.
    assert!(change >= 0.95 * moved / largest, "{change:e}");

    let thrown = results(thrown([0.0, 0.0, -G], None), evenly(2.0, 20), 1e-11);
    let (_, names) = kept(&thrown).unwrap();
    assert_eq!(
        names,
        with_energy(&[all[0].clone(), all[1].clone(), all[5].clone()])
    );

    let pendulum = |motor: bool| {
        let mut model = json!({
            "body": [{"name": "b", "mass": 1, "inertia": [0.1, 0.1, 0.1], "position": [1, 0, 0]}],
            "joint": [{"name": "pin", "kind": "revolute", "bodies": ["ground", "b"], "at": [[0, 0, 0], [-1, 0, 0]],
                       "axes": [[0, 1, 0], [0, 1, 0]]}]
        });
        if motor {
            model["force"] =
                json!([{"name": "motor", "kind": "actuator", "joint": "pin", "value": 5}]);
        }
        results(model, evenly(1.0, 20), 1e-10)
    };
    // At its height the pendulum has no energy: none that could count.
    let (_, names) = kept(&pendulum(false)).unwrap_or_default();
    assert!(names.iter().all(|n| n == "energy.total"), "{names:?}");
    assert_eq!(kept(&pendulum(true)), None);
}

/// A body that turns about x from one side of theta = 0 to the other.
fn turning(set: &str) -> Results {
    let model = json!({
        "gravity": [0, 0, 0],
        "output": {"orientation": set},
        "body": [{"name": "b", "mass": 1, "inertia": [1, 2, 3], "angular_velocity": [1, 0, 0],
                  "orientation": {"axis": [1, 0, 0], "angle": -0.5}}],
        "trace": [{"name": "tip", "body": "b", "at": [0, 0, 1]}]
    });
    results(model, evenly(1.0, 10), 1e-10)
}

/// Near a singular pose of the set of the output a note says of which body, when, in which set, and what helps.
#[test]
fn singular_outputs_are_noted() {
    let warned = |set: &str| -> Vec<String> {
        let notes = turning(set).notes.into_iter();
        notes.filter(|note| note.contains("singular")).collect()
    };
    let found = warned("euler-zxz");
    assert_eq!(found.len(), 1, "{found:?}");
    for part in [
        "warning: near t = 0.500000 s",
        "the orientation of b is singular in euler-zxz",
        "another output.orientation has other singular poses, Euler parameters have none",
    ] {
        assert!(found[0].contains(part), "{part}: {}", found[0]);
    }
    for set in ["euler-parameters", "euler-xyz", "direction-cosines"] {
        assert_eq!(warned(set), Vec::<String>::new(), "{set}");
    }
    // The default has no singular pose.
    assert_eq!(
        Recording::default().orientation,
        OrientationSet::EulerParameters
    );
}

/// A bead slides down a dome from rest near its top: the dome would have to pull below two thirds of the height from which it
/// started, and a warning says from when on.
#[test]
fn a_contact_that_pulls_is_told() {
    let (s, c) = 0.3_f64.sin_cos();
    let dome = |end: f64| {
        let model = json!({
            "body": [{"name": "bead", "mass": 0.5, "inertia": [0.01, 0.01, 0.01], "position": [s, 0, c],
                      "hold": ["x"]}],
            "joint": [{"name": "dome", "kind": "surface-contact", "bodies": ["ground", "bead"],
                       "at": [[0, 0, 0], [0, 0, 0]],
                       "surfaces": [{"kind": "sphere", "radius": 0.9}, {"kind": "sphere", "radius": 0.1}]}]
        });
        results(model, evenly(end, 200), 1e-10)
    };
    let warnings = |results: &Results| -> Vec<String> {
        let notes = results.notes.iter().filter(|note| note.contains("pull"));
        notes.cloned().collect()
    };
    let found = dome(0.95);
    let heights = &found.channel("bead.z").unwrap().values;
    let part = heights.iter().position(|z| *z < 2.0 / 3.0 * c).unwrap();
    let time = found.channel("time").unwrap().values[part];
    let force = found.channel("dome.normal_force").unwrap().values[part];
    assert!(force < 0.0 && found.channel("dome.normal_force").unwrap().values[part - 1] > 0.0);
    let told = warnings(&found);
    let expected = format!(
        "warning: from t = {time:.6} s on the contact 'dome' would have to pull (normal force {force:.3e} N): real surfaces \
         part there"
    );
    assert_eq!(told, [expected]);
    // Before that nothing is said.
    assert_eq!(
        warnings(&dome(0.9 * time)),
        Vec::<String>::new(),
        "too early"
    );
}
