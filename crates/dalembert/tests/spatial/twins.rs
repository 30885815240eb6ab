//! Planar machines modelled in space: the same motion and the same reactions in the plane.

use super::machine::compiled;
use super::support;
use dalembert::analysis::{Assembly, Dynamics, Inverse, Mobility, NewtonOptions, Recording};
use dalembert::results::Results;
use dalembert::space::{Planar, Spatial};
use dalembert::system::compile::Compiled;
use nalgebra::{Rotation3, Vector3};
use serde_json::{Value, json};

/// Agreement of the motions, relative to the largest value of a quantity over the machine and the run: the integrators
/// of both keep this at a tolerance of 1e-13.
const SAME: f64 = 1e-10;

/// A machine of the plane x-y in space: bodies whose centres of mass lie off the plane and whose products of inertia do
/// not vanish, joints in layers. Nothing of that has a part in the motion.
pub fn in_space(plane: &Value) -> Value {
    let mut model = plane.clone();
    let three = |p: &Value, z: f64| json!([p[0], p[1], z]);
    model["model"]["space"] = json!("spatial");
    model["model"]["gravity"] = json!([0, -9.81, 0]);
    for (k, body) in model["body"].as_array_mut().unwrap().iter_mut().enumerate() {
        let j = body["inertia"].as_f64().unwrap();
        let off = 0.05 * (k + 1) as f64;
        body["inertia"] = json!([
            [0.9 * j, 0.02 * j, 0.1 * j],
            [0.02 * j, 0.8 * j, -0.15 * j],
            [0.1 * j, -0.15 * j, j]
        ]);
        let center = body.get("center").cloned().unwrap_or(json!([0, 0]));
        body["center"] = three(&center, off);
        body["position"] = three(&body["position"], 0.0);
        let angle = body
            .as_object_mut()
            .unwrap()
            .remove("angle")
            .unwrap_or(json!(0));
        body["orientation"] = json!({"axis": [0, 0, 1], "angle": angle});
    }
    for (k, joint) in model["joint"]
        .as_array_mut()
        .unwrap()
        .iter_mut()
        .enumerate()
    {
        let layer = 0.03 * (k as f64 - 1.0);
        let at = joint["at"].clone();
        joint["at"] = json!([three(&at[0], layer), three(&at[1], layer)]);
        let axes = if joint["kind"] == "prismatic" {
            json!([[1, 0, 0], [1, 0, 0]])
        } else {
            json!([[0, 0, 1], [0, 0, 1]])
        };
        joint.as_object_mut().unwrap().remove("angles");
        joint["axes"] = axes;
    }
    let forces = model.get_mut("force").and_then(Value::as_array_mut);
    for force in forces.into_iter().flatten() {
        match force["kind"].as_str().unwrap() {
            "torsion-spring" => force["axis"] = json!([0, 0, 1]),
            "moment" => force["value"] = json!([0, 0, force["value"]]),
            "force" => force["value"] = three(&force["value"], 0.0),
            "spring-damper" => {
                let at = force["at"].clone();
                force["at"] = json!([three(&at[0], 0.0), three(&at[1], 0.0)]);
            }
            other => panic!("no twin of {other}"),
        }
    }
    let drivers = model.get_mut("driver").and_then(Value::as_array_mut);
    for driver in drivers.into_iter().flatten() {
        if driver["kind"] == "relative-angle" {
            driver["axis"] = json!([0, 0, 1]);
        }
    }
    model
}

/// The name that a planar channel has in space. None for angles of bodies, of which space has none, and for components
/// along the joint's axes, which are others.
fn twin(name: &str) -> Option<String> {
    let (owner, end) = name.rsplit_once('.')?;
    Some(match end {
        "omega" | "alpha" => format!("{owner}.{end}_z"),
        "angle" if owner.chars().next()?.is_lowercase() => return None,
        "force_1" | "force_2" => return None,
        _ => name.to_owned(),
    })
}

/// Every channel of the plane that space has too; those of a kind are compared relative to their largest value.
fn compare(what: &str, plane: &Results, space: &Results) {
    let kind = |name: &str| match name.rsplit_once('.').map_or(name, |(_, end)| end) {
        "x" | "y" | "displacement" => "length",
        "vx" | "vy" | "displacement_rate" => "velocity",
        "ax" | "ay" | "displacement_acceleration" => "acceleration",
        "omega" | "angle_rate" => "angular velocity",
        "alpha" | "angle_acceleration" => "angular acceleration",
        "angle" => "angle",
        "force_x" | "force_y" | "force" => "force",
        "moment" => "moment",
        _ => "",
    };
    let size = |of: &str| {
        let all = plane.channels.iter().filter(|c| kind(&c.name) == of);
        let values = all.flat_map(|c| &c.values);
        values.fold(0.0_f64, |m, x| m.max(x.abs()))
    };
    let mut compared = 0;
    for channel in &plane.channels {
        let of = kind(&channel.name);
        if of.is_empty() {
            continue;
        }
        let Some(mut name) = twin(&channel.name) else {
            continue;
        };
        let owner = name.split('.').next().unwrap().to_owned();
        if of == "moment" && space.channel(&name).is_none() {
            name = format!("{owner}.moment_z");
        }
        let other = space
            .channel(&name)
            .unwrap_or_else(|| panic!("{what}: no channel {name}"));
        let size = if of == "moment" {
            size("force") + size("moment")
        } else {
            size(of)
        };
        assert_eq!(channel.values.len(), other.values.len());
        for (k, (x, y)) in channel.values.iter().zip(&other.values).enumerate() {
            assert!(
                (x - y).abs() <= SAME * size,
                "{what}: {name} at instant {k}: {y} in space, {x} in the plane, off by {:e} of {size}",
                (x - y).abs()
            );
        }
        compared += 1;
    }
    assert!(compared > 20, "{what}: only {compared} channels");
}

struct Twins {
    name: &'static str,
    joints: Vec<&'static str>,
    plane: Compiled<Planar>,
    space: Compiled<Spatial>,
}

impl Twins {
    fn new(name: &'static str, joints: &[&'static str], mut model: Value, more: &Value) -> Self {
        for (key, value) in more.as_object().unwrap() {
            model[key] = value.clone();
        }
        model["model"] = json!({"name": name, "gravity": [0, -9.81]});
        Self {
            name,
            joints: joints.to_vec(),
            space: compiled(in_space(&model)),
            plane: support::compiled(model),
        }
    }

    fn simulate(&self) -> Results {
        let plane = Dynamics::new(&self.plane.options).run(&self.plane.system, &mut |_| true);
        let space = Dynamics::new(&self.space.options).run(&self.space.system, &mut |_| true);
        let (plane, space) = (plane.unwrap(), space.unwrap_or_else(|e| panic!("{e}")));
        assert_eq!((plane.stopped, space.stopped.clone()), (None, None));
        compare(
            &format!("{}, simulate", self.name),
            &plane.results,
            &space.results,
        );
        space.results
    }

    fn inverse(&self) -> Results {
        let inverse = Inverse {
            instants: self.plane.options.instants(),
            newton: NewtonOptions::of(&self.plane.options),
            recording: Recording::default(),
            actuators: Vec::new(),
        };
        let plane = inverse.run(&self.plane.system).unwrap();
        let space = inverse
            .run(&self.space.system)
            .unwrap_or_else(|e| panic!("{e}"));
        assert_eq!((plane.stopped, space.stopped.clone()), (None, None));
        compare(
            &format!("{}, inverse", self.name),
            &plane.results,
            &space.results,
        );
        space.results
    }

    /// The freedoms, the elements with redundant rows, and those whose reactions are not unique.
    fn mobility(&self) -> (usize, usize, Vec<String>) {
        let (state, _) = Assembly::default().run(&self.space.system).unwrap();
        let report = Mobility::default().run(&self.space.system, &state).unwrap();
        for row in &report.redundant {
            assert!(!row.depends_on.is_empty(), "{}: {row:?}", self.name);
            assert!(self.joints.contains(&row.element.as_str()));
            // What holds the machine in its plane is there more than once; nothing in the plane is.
            let across = ["z", "tilt about x", "tilt about y"];
            let of_guide = ["across the axis, y", "turn about z", "turn about x"];
            let list = if row.kind == "prismatic" {
                of_guide
            } else {
                across
            };
            assert!(list.contains(&row.row.as_str()), "{}: {row:?}", self.name);
        }
        assert!(!report.is_singular());
        (
            report.freedoms(),
            report.redundant.len(),
            report.reactions_not_unique,
        )
    }
}

const RUN: &str = r#"{"end": 0.1, "step": 0.01, "tolerance": 1e-13}"#;

fn run() -> Value {
    serde_json::from_str(RUN).unwrap()
}

fn machine(name: &str) -> Value {
    let all = support::machines::all();
    let mut found = all.into_iter().find(|(n, _)| n == name).unwrap().1;
    // Slower than there: the comparison is of the equations, not of the steps.
    found["initial"] = json!([]);
    found
}

fn four_bar() -> Value {
    let mut model = machine("four-bar with spring");
    // Between half a turn backwards and forwards, as space has it.
    let angle = model["body"][2]["angle"].as_f64().unwrap() - std::f64::consts::TAU;
    model["body"][2]["angle"] = json!(angle);
    model
}

#[track_caller]
fn open(notes: &[String], joints: &[&str]) {
    let note = notes.iter().find(|n| n.contains("not unique"));
    let note = note.unwrap_or_else(|| panic!("no note: {notes:?}"));
    let listed = note.split_once("the reactions of ").unwrap().1;
    let listed = listed.split_once(" are not unique").unwrap().0;
    let mut names: Vec<&str> = listed.split(", ").flat_map(|n| n.split(" and ")).collect();
    names.sort_unstable();
    assert_eq!(names, joints);
}

/// Four parallel revolutes in space: an overconstrained loop.
#[test]
fn four_bars() {
    let names = ["A", "B", "C", "O"];
    let start = json!({"kind": "angle", "joint": "O", "rate": 9.0});
    let twins = Twins::new(
        "four-bar",
        &names,
        four_bar(),
        &json!({"analysis": run(), "initial": [start]}),
    );
    let (freedoms, redundant, mut not_unique) = twins.mobility();
    not_unique.sort();
    assert_eq!((freedoms, redundant), (1, 3));
    assert_eq!(not_unique, names);
    open(&twins.simulate().notes, &names);

    let driver = json!({"name": "motor", "kind": "angle", "joint": "O", "value": "70 deg + 9 rad/s * t + 30 rad/s^2 * t^2"});
    let driven = Twins::new(
        "four-bar",
        &names,
        four_bar(),
        &json!({"analysis": run(), "driver": [driver]}),
    );
    open(&driven.inverse().notes, &names);
}

#[test]
fn slider_cranks() {
    let names = ["A", "B", "O", "guide"];
    let model = || machine("slider-crank");
    let start = json!({"kind": "angle", "joint": "O", "rate": 9.0});
    let twins = Twins::new(
        "slider-crank",
        &names,
        model(),
        &json!({"analysis": run(), "initial": [start]}),
    );
    let (freedoms, redundant, mut not_unique) = twins.mobility();
    not_unique.sort();
    assert_eq!((freedoms, redundant), (1, 3));
    assert_eq!(not_unique, names);
    open(&twins.simulate().notes, &names);

    let driver = json!({"name": "motor", "kind": "angle", "joint": "O", "value": "45 deg + 9 rad/s * t + 30 rad/s^2 * t^2"});
    let driven = Twins::new(
        "slider-crank",
        &names,
        model(),
        &json!({"analysis": run(), "driver": [driver]}),
    );
    open(&driven.inverse().notes, &names);
}

/// The same loop with all its parallel axes askew in the ground's frame: nothing but the names of the axes changes.
#[test]
fn a_tilted_four_bar() {
    let start = json!({"kind": "angle", "joint": "O", "rate": 9.0});
    let names = ["A", "B", "C", "O"];
    let twins = Twins::new(
        "four-bar",
        &names,
        four_bar(),
        &json!({"analysis": run(), "initial": [start]}),
    );
    let mut model = four_bar();
    model["analysis"] = run();
    model["initial"] = json!([start]);
    model["model"] = json!({"name": "tilted"});
    let mut model = in_space(&model);
    let turn = Rotation3::from_euler_angles(0.7, -0.4, 1.9);
    let turned = |v: &Value| {
        let v = turn * Vector3::from([0, 1, 2].map(|k| v[k].as_f64().unwrap()));
        json!([v.x, v.y, v.z])
    };
    model["model"]["gravity"] = turned(&json!([0, -9.81, 0]));
    for body in model["body"].as_array_mut().unwrap() {
        body["position"] = turned(&body["position"]);
        let own = Rotation3::from_axis_angle(
            &Vector3::z_axis(),
            body["orientation"]["angle"].as_f64().unwrap(),
        );
        let m = turn * own;
        let rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[(i, j)]));
        body["orientation"] = json!({"matrix": rows});
    }
    for joint in model["joint"].as_array_mut().unwrap() {
        joint["x_axes"] = json!([[1, 0, 0], [1, 0, 0]]);
        for k in 0..2 {
            if joint["bodies"][k] == "ground" {
                for key in ["at", "axes", "x_axes"] {
                    joint[key][k] = turned(&joint[key][k]);
                }
            }
        }
    }
    let tilted = compiled(model);
    let (state, _) = Assembly::default().run(&tilted.system).unwrap();
    let report = Mobility::default().run(&tilted.system, &state).unwrap();
    assert_eq!((report.freedoms(), report.redundant.len()), (1, 3));
    let run = Dynamics::new(&tilted.options)
        .run(&tilted.system, &mut |_| true)
        .unwrap();
    assert_eq!(run.stopped, None);
    open(&run.results.notes, &names);
    let upright = twins.simulate();
    for name in names {
        for end in [
            "angle",
            "angle_rate",
            "angle_acceleration",
            "force_1",
            "force_2",
            "moment_3",
        ] {
            let name = format!("{name}.{end}");
            let [x, y] = [&upright, &run.results].map(|r| r.channel(&name).unwrap().values.clone());
            let size = x.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
            for (x, y) in x.iter().zip(&y) {
                assert!((x - y).abs() <= SAME * size, "{name}: {y} for {x}");
            }
        }
    }
}

/// An open chain: nothing is redundant, all reactions are unique.
#[test]
fn double_pendulums() {
    let names = ["O", "A"];
    let model = || {
        let mut model = machine("double pendulum");
        model["force"] = json!([{"name": "spring", "kind": "torsion-spring", "bodies": ["a", "b"],
                                 "stiffness": 3.0, "damping": 0.1, "free_angle": 0.4}]);
        model
    };
    let start = json!([{"kind": "angle", "joint": "O", "value": 0.3, "rate": 2.0},
                       {"kind": "angle", "joint": "A", "value": -0.9, "rate": -5.0}]);
    let twins = Twins::new(
        "double pendulum",
        &names,
        model(),
        &json!({"analysis": run(), "initial": start}),
    );
    assert_eq!(twins.mobility(), (2, 0, Vec::new()));
    assert!(twins.simulate().notes.iter().all(|n| !n.contains("unique")));

    let drivers = json!([
        {"name": "first", "kind": "angle", "joint": "O", "value": "0.3 + 2 rad/s * t + 30 rad/s^2 * t^2"},
        {"name": "second", "kind": "angle", "joint": "A", "value": "-0.9 + 0.5 * sin(20 rad/s * t)"}
    ]);
    let driven = Twins::new(
        "double pendulum",
        &names,
        model(),
        &json!({"analysis": run(), "driver": drivers}),
    );
    assert!(driven.inverse().notes.iter().all(|n| !n.contains("unique")));
}
