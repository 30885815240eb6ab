//! Redundant machines: every analysis reports the same set of reactions, the least one.

mod support;

use dalembert::analysis::{
    Assembly, Dynamics, EquationBasis, Equations, Inverse, Kinematics, NewtonOptions, Statics,
};
use dalembert::formulation::column_scale;
use dalembert::results::Results;
use dalembert::solve::analyse_rows;
use dalembert::system::State;
use dalembert::system::compile::{Compiled, Options};
use serde_json::{Value, json};
use support::{compiled, evaluated, pin, rod};

const G: f64 = 9.81;

/// Three parallel cranks of different masses under one coupler, a spring between two of them.
fn double_parallelogram(angle: f64, extra: &Value) -> Compiled {
    let (s, c) = angle.sin_cos();
    let crank =
        |name: &str, mass: f64, x: f64| rod(name, mass, 0.3, [x + 0.15 * c, 0.15 * s], angle);
    let mut model = json!({
        "model": {"name": "double parallelogram", "gravity": [0.0, -G]},
        "body": [crank("a", 1.0, 0.0), crank("b", 0.4, 0.5), crank("c", 2.5, 1.2),
                 {"name": "beam", "mass": 3.0, "inertia": 0.4, "position": [0.6 + 0.3 * c, 0.3 * s]}],
        "joint": [pin("A", ["ground", "a"], [[0.0, 0.0], [-0.15, 0.0]]),
                  pin("B", ["ground", "b"], [[0.5, 0.0], [-0.15, 0.0]]),
                  pin("C", ["ground", "c"], [[1.2, 0.0], [-0.15, 0.0]]),
                  pin("D", ["a", "beam"], [[0.15, 0.0], [-0.6, 0.0]]),
                  pin("E", ["b", "beam"], [[0.15, 0.0], [-0.1, 0.0]]),
                  pin("F", ["c", "beam"], [[0.15, 0.0], [0.6, 0.0]])],
        "force": [{"name": "spring", "kind": "spring-damper", "bodies": ["ground", "beam"],
                   "at": [[0.1, -0.8], [0.2, 0.0]], "stiffness": 30.0, "free_length": 0.2}],
        "analysis": {"end": 0.01, "step": 0.005}
    });
    extend(&mut model, extra);
    compiled(model)
}

/// A drawer on two slides a different way apart: lengths and angles among the redundant rows.
fn drawer(position: f64, extra: &Value) -> Compiled {
    let slide = |name: &str, y: f64| {
        json!({"name": name, "kind": "prismatic", "bodies": ["ground", "box"],
               "at": [[0.0, y], [0.0, y]], "angles": [0.0, 0.0]})
    };
    let mut model = json!({
        "model": {"name": "drawer", "gravity": [0.0, -G]},
        "body": [{"name": "box", "mass": 2.0, "inertia": 0.3, "position": [position, 0.0], "center": [0.2, 0.05]}],
        "joint": [slide("upper", 0.3), slide("lower", -0.1)],
        "force": [{"name": "spring", "kind": "spring-damper", "bodies": ["ground", "box"],
                   "at": [[-1.0, 0.0], [0.0, 0.15]], "stiffness": 100.0, "free_length": 1.0}],
        "analysis": {"end": 0.01, "step": 0.005}
    });
    extend(&mut model, extra);
    compiled(model)
}

fn extend(model: &mut Value, extra: &Value) {
    for (key, value) in extra.as_object().expect("an object") {
        model[key] = value.clone();
    }
}

/// Values of the reaction channels at an instant.
fn reactions(results: &Results, instant: usize) -> Vec<(String, f64)> {
    let parts = ["force_x", "force_y", "moment"];
    let of_joint = |name: &str| {
        name.split_once('.')
            .is_some_and(|(owner, part)| owner != "motor" && parts.contains(&part))
    };
    let channels = results.channels.iter().filter(|c| of_joint(&c.name));
    channels
        .map(|c| (c.name.clone(), c.values[instant]))
        .collect()
}

#[track_caller]
fn agree(what: &str, found: &[(String, f64)], expected: &[(String, f64)]) {
    let size = expected.iter().fold(0.0_f64, |m, (_, x)| m.max(x.abs()));
    assert!(!expected.is_empty() && size > 1.0, "nothing to compare");
    assert_eq!(found.len(), expected.len());
    for ((name, x), (other, y)) in found.iter().zip(expected) {
        assert_eq!(name, other);
        assert!(
            (x - y).abs() <= 1e-9 * size,
            "{what}: {name} is {x}, not {y}"
        );
    }
}

/// The names in a note on reactions that are not unique.
fn open(notes: &[String]) -> Vec<String> {
    let text = notes
        .iter()
        .find_map(|n| n.split_once("the reactions of ")?.1.split_once(" are not"))
        .unwrap_or_else(|| panic!("no note: {notes:?}"));
    let names = text.0.replace(" and ", ", ");
    names.split(", ").map(str::to_owned).collect()
}

fn simulate(c: &Compiled) -> Results {
    let run = Dynamics::new(&c.options)
        .run(&c.system, &mut |_| true)
        .unwrap();
    assert_eq!(run.stopped, None);
    run.results
}

fn start(c: &Compiled) -> State {
    Assembly::default().run(&c.system).unwrap().0
}

/// The least multipliers in the sense of the manual, by singular values, and which are unique.
fn least(c: &Compiled, state: &State, multipliers: &[f64]) -> (Vec<f64>, Vec<bool>) {
    let system = c.system.running();
    let ws = evaluated(&system, state);
    let found = analyse_rows(&system.dense_jacobian(&ws), &column_scale(&system), 1e-9).unwrap();
    let mut null = found.left_null_space;
    for (row, mut values) in null.row_iter_mut().enumerate() {
        values *= system.row_scale(row);
    }
    let scaled: Vec<f64> = (0..system.rows)
        .map(|r| multipliers[r] * system.row_scale(r))
        .collect();
    let mut scaled = nalgebra::DVector::from_vec(scaled);
    let q = null.qr().q();
    scaled -= &q * (q.transpose() * &scaled);
    let plain = (0..system.rows).map(|r| scaled[r] / system.row_scale(r));
    (plain.collect(), found.unique)
}

/// Reactions of a state by the equations of motion, and the multipliers themselves.
fn by_equations(c: &Compiled, state: &State) -> (Vec<f64>, Vec<String>) {
    let report = Equations {
        basis: EquationBasis::Absolute,
        ..Equations::default()
    }
    .run(&c.system, state)
    .unwrap();
    let named = open(&report.notes);
    (report.multipliers.unwrap().values, named)
}

/// The set that `equations` gives is the least one, and its rows without unique multipliers are
/// those that singular values tell.
#[track_caller]
fn check_least(c: &Compiled, state: &State, multipliers: &[f64], named: &[String]) {
    let (expected, unique) = least(c, state, multipliers);
    let size = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (row, (x, y)) in multipliers.iter().zip(&expected).enumerate() {
        assert!((x - y).abs() <= 1e-9 * size, "row {row}: {x}, not {y}");
    }
    let system = c.system.running();
    let of_element = |e: &&dalembert::system::ElementData<dalembert::space::Planar>| {
        e.rows.clone().any(|row| !unique[row])
    };
    let expected: Vec<&str> = system
        .elements
        .iter()
        .filter(of_element)
        .map(|e| e.name.as_str())
        .collect();
    assert_eq!(named, expected);
}

/// Multipliers of the pins of a machine from its reactions: a pin's multiplier is its reaction.
fn pins(multipliers: &[f64], names: &[&str]) -> Vec<(String, f64)> {
    let mut list = Vec::new();
    for (k, name) in names.iter().enumerate() {
        list.push((format!("{name}.force_x"), multipliers[2 * k]));
        list.push((format!("{name}.force_y"), multipliers[2 * k + 1]));
        list.push((format!("{name}.moment"), 0.0));
    }
    list
}

const PINS: [&str; 6] = ["A", "B", "C", "D", "E", "F"];

#[test]
fn at_rest_all_analyses_give_the_same_set() {
    let loose = double_parallelogram(-1.0, &json!({}));
    let report = Statics::default().run(&loose.system).unwrap();
    let state = report.state(0).unwrap();
    let expected = reactions(&report.results, 0);
    let angle = state.q[2];

    let at_equilibrium = double_parallelogram(angle, &json!({}));
    let moving = simulate(&at_equilibrium);
    agree("simulate", &reactions(&moving, 0), &expected);

    let (multipliers, named) = by_equations(&at_equilibrium, &state);
    check_least(&at_equilibrium, &state, &multipliers, &named);
    agree("equations", &pins(&multipliers, &PINS), &expected);

    let driver =
        json!({"driver": [{"name": "motor", "kind": "angle", "joint": "A", "value": angle}]});
    let held = double_parallelogram(angle, &driver);
    let inverse = Inverse {
        instants: held.options.instants(),
        ..Inverse::default()
    };
    let inverse = inverse.run(&held.system).unwrap().results;
    agree("inverse", &reactions(&inverse, 0), &expected);
    let kinematics = Kinematics::new(&held.options)
        .run(&held.system)
        .unwrap()
        .results;
    agree("kinematics", &reactions(&kinematics, 2), &expected);
    for results in [&report.results, &moving, &inverse, &kinematics] {
        assert_eq!(open(&results.notes), named);
    }
}

/// Simulates from a moving start, and drives the same motion.
fn moving_machine(make: &dyn Fn(&Value) -> Compiled, quantity: &Value, body: usize, k: usize) {
    let rate = 2.5;
    let mut initial = quantity.clone();
    initial["rate"] = json!(rate);
    let free = make(&json!({"initial": [initial]}));
    let state = start(&free);
    assert!((state.v[3 * body + k] - rate).abs() < 1e-12);
    let simulated = simulate(&free);
    let (multipliers, named) = by_equations(&free, &state);
    check_least(&free, &state, &multipliers, &named);
    let running = free.system.running();
    let mut ws = evaluated(&running, &state);
    dalembert::formulation::augmented(&running, &mut ws).unwrap();
    let a = ws.a[3 * body + k];
    let mut driver = quantity.clone();
    driver["name"] = json!("motor");
    driver["rate"] = json!(format!("{rate} + {a:e} * t"));
    let driven = make(&json!({"driver": [driver]}));
    let run = Inverse {
        instants: vec![0.0, 1e-3],
        newton: NewtonOptions::of(&Options::default()),
        ..Inverse::default()
    }
    .run(&driven.system)
    .unwrap();
    let (given, expected) = (reactions(&run.results, 0), reactions(&simulated, 0));
    agree("inverse", &given, &expected);
    let (of_driven, _) = by_equations(&driven, &state);
    let size = multipliers.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (x, y) in multipliers.iter().zip(&of_driven) {
        assert!((x - y).abs() <= 1e-9 * size, "equations: {x}, not {y}");
    }
    assert_eq!(open(&run.results.notes), named);
    assert_eq!(open(&simulated.notes), named);
}

#[test]
fn moving_all_analyses_give_the_same_set() {
    moving_machine(
        &|extra| double_parallelogram(-0.7, extra),
        &json!({"kind": "angle", "joint": "A"}),
        0,
        2,
    );
    moving_machine(
        &|extra| drawer(0.4, extra),
        &json!({"kind": "displacement", "joint": "upper"}),
        0,
        0,
    );
}

/// The moment and the force of the two slides share the load in the sense of the manual: the least
/// sum of (force * size)^2 and moment^2.
#[test]
fn a_drawer_shares_its_load_by_its_size() {
    let c = drawer(0.0, &json!({}));
    let simulated = simulate(&c);
    let value = |name: &str| simulated.channel(name).unwrap().values[0];
    let (upper, lower) = (value("upper.force_2"), value("lower.force_2"));
    let (m, n) = (value("upper.moment"), value("lower.moment"));
    // Equal shares: both slides are at the same x.
    assert!(
        (upper - lower).abs() < 1e-9 * upper.abs(),
        "{upper} {lower}"
    );
    assert!((m - n).abs() < 1e-9 * m.abs().max(1.0), "{m} {n}");
    assert!(
        simulated.notes[0].contains("least sum of squares"),
        "{:?}",
        simulated.notes
    );
}

/// The note is no longer left out for large machines.
#[test]
fn large_machines_are_told_which_reactions_are_not_unique() {
    let cells = 60;
    let mut bodies = Vec::new();
    let mut joints = Vec::new();
    for k in 0..cells {
        let x = k as f64;
        bodies.push(rod(
            &format!("crank{k}"),
            1.0,
            1.0,
            [x, 0.5],
            std::f64::consts::FRAC_PI_2,
        ));
        joints.push(pin(
            &format!("foot{k}"),
            ["ground", &format!("crank{k}")],
            [[x, 0.0], [-0.5, 0.0]],
        ));
        let beam = format!("beam{k}");
        bodies.push(rod(&beam, 1.0, 1.0, [x + 0.5, 1.0], 0.0));
        let other = if k == 0 {
            None
        } else {
            Some(format!("beam{}", k - 1))
        };
        joints.push(pin(
            &format!("head{k}"),
            [&format!("crank{k}"), &beam],
            [[0.5, 0.0], [-0.5, 0.0]],
        ));
        if let Some(other) = other {
            joints.push(pin(
                &format!("link{k}"),
                [&other, &beam],
                [[0.5, 0.0], [-0.5, 0.0]],
            ));
        }
    }
    // A beam pinned twice to the same neighbour at one point.
    joints.push(pin("twice", ["beam3", "beam4"], [[0.5, 0.0], [-0.5, 0.0]]));
    let c =
        compiled(json!({"body": bodies, "joint": joints, "analysis": {"end": 1e-3, "step": 1e-3}}));
    assert!(c.system.nv() > 300);
    let results = simulate(&c);
    assert_eq!(open(&results.notes), ["link4", "twice"]);
    for part in ["force_x", "force_y"] {
        let [a, b] =
            ["link4", "twice"].map(|n| results.channel(&format!("{n}.{part}")).unwrap().values[0]);
        assert!((a - b).abs() <= 1e-9 * a.abs().max(1.0), "{part}: {a} {b}");
    }
}
