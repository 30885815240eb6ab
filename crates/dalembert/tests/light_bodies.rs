//! Bodies without mass or with next to none between joints.

mod support;

use dalembert::analysis::{AnalysisError, Dynamics, DynamicsReport, Motion};
use dalembert::formulation::Formulation;
use serde_json::{Value, json};
use support::{assembled, compiled, evaluated, machines, pin, rod};

fn four_bar() -> Value {
    let all = machines::all();
    let found = all.into_iter().find(|(name, _)| name == "massless link");
    found.expect("it is in the list").1
}

/// The four-bar with a coupler of a given mass, a slender bar.
fn with_coupler(mass: f64) -> Value {
    let mut model = four_bar();
    let coupler = &mut model["body"][1];
    coupler["mass"] = json!(mass);
    coupler["inertia"] = json!(mass * 0.4 * 0.4 / 12.0);
    // Slow enough that errors of single steps do not grow.
    model["initial"][0]["rate"] = json!(10.0);
    model
}

/// Two heavy bars with two massless links between them, and a point mass on the second link.
fn two_links(point: f64) -> Value {
    json!({
        "body": [
            rod("left", 2.0, 1.0, [0.0, 0.5], 1.5),
            {"name": "a", "mass": 0.0, "inertia": 0.0, "position": [0.4, 1.3], "angle": 0.6},
            {"name": "b", "mass": point, "inertia": 0.0, "position": [1.2, 1.3], "angle": -0.6},
            rod("right", 1.0, 1.0, [1.6, 0.5], 1.6),
        ],
        "joint": [
            pin("O", ["ground", "left"], [[0.0, 0.0], [-0.5, 0.0]]),
            pin("A", ["left", "a"], [[0.5, 0.0], [-0.5, 0.0]]),
            pin("B", ["a", "b"], [[0.5, 0.0], [-0.5, 0.0]]),
            pin("C", ["b", "right"], [[0.5, 0.0], [0.5, 0.0]]),
            pin("Q", ["ground", "right"], [[1.6, 0.0], [-0.5, 0.0]]),
        ],
        "initial": [{"kind": "angle", "joint": "O", "rate": 2.0}]
    })
}

/// A massless slider on a guide that carries a pendulum without inertia.
fn slider_and_point() -> Value {
    json!({
        "body": [
            rod("crank", 1.0, 0.4, [0.2, 0.0], 0.3),
            {"name": "slider", "position": [0.9, 0.0]},
            rod("link", 0.5, 0.6, [0.6, 0.0], -0.2),
            {"name": "bob", "mass": 0.3, "inertia": 0.0, "position": [0.9, -0.5]},
        ],
        "joint": [
            pin("O", ["ground", "crank"], [[0.0, 0.0], [-0.2, 0.0]]),
            pin("A", ["crank", "link"], [[0.2, 0.0], [-0.3, 0.0]]),
            pin("B", ["link", "slider"], [[0.3, 0.0], [0.0, 0.0]]),
            {"name": "guide", "kind": "prismatic", "bodies": ["ground", "slider"],
             "at": [[0, 0], [0, 0]], "angles": [0, 0]},
            pin("C", ["slider", "bob"], [[0.0, 0.0], [0.0, 0.5]]),
        ],
        "initial": [{"kind": "angle", "joint": "O", "rate": 3.0}, {"kind": "angle", "joint": "C", "rate": 1.0}]
    })
}

#[test]
fn the_accelerations_are_those_of_the_dense_equations() {
    let machines = [
        four_bar(),
        two_links(0.4),
        two_links(0.0),
        slider_and_point(),
    ];
    for (number, machine) in machines.into_iter().enumerate() {
        let options = compiled(machine.clone()).options;
        let (system, state) = assembled(machine);
        assert!(system.massless);
        let mut motion = Motion::new(&system, &Dynamics::new(&options));
        let y = [&state.q[..], &state.v, &[0.0]].concat();
        let found = motion.evaluate(0.0, &y);
        let mut ws = evaluated(&system, &state);
        let dense = Formulation::Augmented.solve(&system, &mut ws);
        found.expect("it moves");
        let dense = dense.expect("it moves");
        let close = |found: &[f64], right: &[f64]| {
            let size = right.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            for (x, y) in found.iter().zip(right) {
                assert!((x - y).abs() < 1e-14 * size, "machine {number}: {x} {y}");
            }
        };
        close(&motion.ws.a, &dense.a);
        close(&motion.ws.lambda, &dense.lambda);
    }
}

#[test]
fn every_machine_without_the_mass_of_one_body_agrees_or_is_refused() {
    let (mut solved, mut refused) = (0, 0);
    for (name, machine) in machines::all() {
        for b in 0..machine["body"].as_array().map_or(0, Vec::len) {
            let mut model = machine.clone();
            for key in ["mass", "inertia", "shape", "center"] {
                model["body"][b].as_object_mut().unwrap().remove(key);
            }
            let (system, state) = assembled(model.clone());
            let mut ws = evaluated(&system, &state);
            let dense = Formulation::Augmented.solve(&system, &mut ws);
            let Ok(dense) = dense else {
                assert!(
                    matches!(run(model), Err(AnalysisError::Massless { .. })),
                    "{name}, body {b}: {dense:?}"
                );
                refused += 1;
                continue;
            };
            let mut motion = Motion::new(&system, &Dynamics::new(&compiled(model).options));
            let y = [&state.q[..], &state.v, &[0.0]].concat();
            motion.evaluate(0.0, &y).expect("it moves");
            let size = dense.a.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            for (x, y) in motion.ws.a.iter().zip(&dense.a) {
                // The planetary gear without its first body is worst: 3e-13.
                assert!((x - y).abs() < 1e-12 * size, "{name}, body {b}: {x} {y}");
            }
            solved += 1;
        }
    }
    // So that neither branch is empty.
    assert!(solved > 10 && refused > 3, "{solved} {refused}");
}

fn run(model: Value) -> Result<DynamicsReport, AnalysisError> {
    let compiled = compiled(model);
    let mut analysis = Dynamics::new(&compiled.options);
    analysis.tolerance = 1e-9;
    analysis.instants = (0..=20).map(|k| 0.05 * f64::from(k)).collect();
    analysis.run(&compiled.system, &mut |_| true)
}

#[test]
fn a_motion_that_nothing_holds_ends_the_run_before_it_starts() {
    // Even where no force acts on it: then any acceleration would satisfy the equations.
    let mut model = slider_and_point();
    model["body"][3]["mass"] = json!(0.0);
    let Err(AnalysisError::Massless { names }) = run(model) else {
        panic!("not found")
    };
    assert_eq!(names, "bob.x, bob.y and bob.angle");
}

#[test]
fn a_light_coupler_moves_as_a_massless_one_and_as_fast_as_a_heavy_one() {
    let [massless, light, heavy] = [0.0, 1e-12, 1e-3].map(|mass| {
        let report = run(with_coupler(mass)).expect("it runs");
        assert!(report.stopped.is_none(), "{mass}: {:?}", report.stopped);
        report
    });
    let (light_y, massless_y) = (&light.state.q, &massless.state.q);
    for (x, y) in light_y.iter().zip(massless_y) {
        // The runs take the same steps; the mass itself changes the angles by 1.2e-11.
        assert!((x - y).abs() < 2e-11, "{x} {y}");
    }
    let steps = |report: &DynamicsReport| report.results.statistics["steps"];
    assert!(
        (steps(&light) - steps(&heavy)).abs() <= 0.1 * steps(&heavy),
        "{} {}",
        steps(&light),
        steps(&heavy)
    );
    let warned = |report: &DynamicsReport| {
        let notes = &report.results.notes;
        notes.iter().any(|note| note.contains("next to nothing"))
    };
    assert!(warned(&light), "{:?}", light.results.notes);
    assert!(!warned(&heavy) && !warned(&massless));
}

#[test]
fn the_lighter_the_coupler_the_closer_to_none() {
    // No mass on the way is worse than others: what is left is the effect of the mass, 12.4 rad a kilogram.
    let reference = run(with_coupler(0.0)).expect("it runs").state;
    for exponent in 5..=20 {
        let mass = 10_f64.powi(-exponent);
        let report = run(with_coupler(mass)).expect("it runs");
        assert!(report.stopped.is_none(), "{mass}: {:?}", report.stopped);
        let bound = 13.0 * mass + 1e-12;
        for (x, y) in report.state.q.iter().zip(&reference.q) {
            assert!((x - y).abs() < bound, "{mass}: {x} {y}");
        }
    }
}

#[test]
fn a_light_pendulum_on_a_light_coupler_keeps_its_own_motion() {
    // The coupler is held by its neighbours, the pendulum hangs freely from it: only its own mass moves it.
    let hang = |mass: f64| {
        let mut model = with_coupler(mass);
        let at = model["body"][1]["position"].clone();
        let (x, y) = (at[0].as_f64().unwrap(), at[1].as_f64().unwrap());
        let mut bob = rod("bob", mass.max(1e-13), 0.4, [x + 0.2, y], 0.0);
        bob["inertia"] = json!(mass.max(1e-13) * 0.16 / 12.0);
        model["body"].as_array_mut().unwrap().push(bob);
        let joint = pin("hang", ["coupler", "bob"], [[0.0, 0.0], [-0.2, 0.0]]);
        model["joint"].as_array_mut().unwrap().push(joint);
        run(model).expect("it runs")
    };
    let (light, lighter) = (hang(1e-12), hang(1e-13));
    for report in [&light, &lighter] {
        assert!(report.stopped.is_none(), "{:?}", report.stopped);
    }
    for (x, y) in light.state.q.iter().zip(&lighter.state.q) {
        assert!((x - y).abs() < 1e-10, "{x} {y}");
    }
}
