//! Runs that cannot go on say why, and keep what they have.

mod support;

use dalembert::analysis::{AnalysisError, Assembly, Dynamics, Kinematics, Statics};
use dalembert::results::Results;
use serde_json::{Value, json};
use support::{compiled, pin, rod};

/// A block on a slide, between a soft spring and another element.
fn block(element: &Value, analysis: &Value) -> Value {
    let mut second = json!({"name": "second", "kind": "spring-damper", "bodies": ["ground", "block"],
        "at": [[-1.0, 0.0], [0.0, 0.0]]});
    for (key, value) in element.as_object().expect("an object") {
        second[key] = value.clone();
    }
    json!({
        "model": {"name": "block", "gravity": [0.0, 0.0]},
        "body": [{"name": "block", "mass": 2.0, "inertia": 0.1, "position": [0.3, 0.0]}],
        "joint": [{"name": "guide", "kind": "prismatic", "bodies": ["ground", "block"],
                   "at": [[0.0, 0.0], [0.0, 0.0]], "angles": [0.0, 0.0]}],
        "force": [{"name": "soft", "kind": "spring-damper", "bodies": ["ground", "block"],
                   "at": [[-1.0, 0.0], [0.0, 0.0]], "stiffness": 10.0, "free_length": 1.0}, second],
        "analysis": analysis
    })
}

fn simulate(model: Value) -> Result<(Results, Option<AnalysisError>), AnalysisError> {
    let c = compiled(model);
    let run = Dynamics::new(&c.options).run(&c.system, &mut |_| true)?;
    Ok((run.results, run.stopped))
}

fn text(error: Option<AnalysisError>) -> String {
    error.expect("the run ends early").to_string()
}

#[test]
fn a_stiff_damper_is_named_long_before_the_steps_are_used_up() {
    let model = block(&json!({"damping": 2e7}), &json!({"end": 10.0}));
    let (results, stopped) = simulate(model).unwrap();
    assert_eq!(results.len(), 1);
    assert!(results.statistics["steps"] < 20_000.0);
    let text = text(stopped);
    // The rate is c/m.
    for part in [
        "stiff",
        "damping of 'second' (spring-damper), 1.0e7 1/s",
        "less damping",
        "max_steps, now 1000000",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn a_hard_spring_is_named_when_the_steps_are_used_up() {
    let model = block(
        &json!({"stiffness": 2e8, "free_length": 1.2}),
        &json!({"end": 10.0, "max_steps": 2000}),
    );
    let (results, stopped) = simulate(model).unwrap();
    assert_eq!(results.statistics["steps"], 2000.0);
    let text = text(stopped);
    // The frequency is sqrt(k/m).
    for part in [
        "after 2000 steps",
        "stiffness of 'second' (spring-damper), 1.0e4 1/s",
        "softer",
        "max_steps, now 2000",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn results_until_the_end_of_the_steps_are_kept() {
    let model = block(
        &json!({"stiffness": 10.0}),
        &json!({"end": 100.0, "step": 0.1, "max_steps": 200}),
    );
    let (results, stopped) = simulate(model).unwrap();
    assert!(results.len() > 10, "{}", results.len());
    let Some(AnalysisError::OutOfSteps {
        time, steps: 200, ..
    }) = stopped
    else {
        panic!("{stopped:?}");
    };
    let last = results.channel("time").unwrap().values[results.len() - 1];
    assert!(
        last <= time && time < last + 0.11 && time < 100.0,
        "{last} {time}"
    );
}

#[test]
fn a_run_that_was_stiff_and_came_through_says_so() {
    let model = block(&json!({"damping": 1e5}), &json!({"end": 1.0}));
    let (results, stopped) = simulate(model).unwrap();
    assert_eq!(stopped, None);
    let note = results.notes.iter().find(|n| n.contains("stiff from t ="));
    let note = note.unwrap_or_else(|| panic!("{:?}", results.notes));
    assert!(
        note.starts_with("warning: ") && note.contains("damping of 'second'"),
        "{note}"
    );
    // A soft machine has no such note.
    let model = block(&json!({"damping": 1.0}), &json!({"end": 100.0}));
    let (results, _) = simulate(model).unwrap();
    assert!(
        results.notes.iter().all(|n| !n.contains("stiff")),
        "{:?}",
        results.notes
    );
}

#[test]
fn a_largest_step_out_of_reach_is_refused_at_once() {
    let model = block(
        &json!({"stiffness": 1.0}),
        &json!({"end": 10.0, "max_step": 1e-9}),
    );
    let text = simulate(model).unwrap_err().to_string();
    for part in [
        "max_step = 1e-9 s",
        "at least 1.0e10 steps",
        "1000000 are allowed",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    // One that can be reached holds.
    let model = block(
        &json!({"stiffness": 1.0}),
        &json!({"end": 0.01, "max_step": 1e-4, "max_steps": 101}),
    );
    assert_eq!(simulate(model).unwrap().1, None);
}

#[test]
fn a_spring_whose_points_meet_ends_the_run() {
    let at = |free: f64| {
        let element =
            json!({"at": [[0.0, 0.0], [0.0, 0.0]], "stiffness": 40.0, "free_length": free});
        let mut model = block(&element, &json!({"end": 2.0}));
        // The soft one alone would meet nothing.
        model["force"][0]["stiffness"] = json!(0.001);
        model
    };
    let (results, stopped) = simulate(at(0.1)).unwrap();
    assert!(results.len() > 5);
    let Some(AnalysisError::NoDirection { element, time, .. }) = stopped else {
        panic!("{stopped:?}");
    };
    assert!(element.contains("second"), "{element}");
    // x = 0.1 + 0.2 cos(w t), w^2 = 20: zero at w t = 2 pi / 3; the other spring hardly counts.
    let expected = 2.0 / 3.0 * std::f64::consts::PI / 20.0_f64.sqrt();
    assert!((time - expected).abs() < 1e-3, "{time} {expected}");
    // Without force there the direction does not matter.
    assert_eq!(simulate(at(0.0)).unwrap().1, None);
}

#[test]
fn a_distance_driven_to_zero_ends_the_run() {
    let mut model = block(&json!({"stiffness": 1.0}), &json!({"end": 1.0}));
    model["driver"] = json!([{"name": "winch", "kind": "distance", "bodies": ["ground", "block"],
        "at": [[0.0, 0.0], [0.0, 0.0]], "value": "0.3 m - 0.7 m/s * t"}]);
    let met = 0.3 / 0.7;
    let check = |results: &Results, stopped: Option<AnalysisError>, accuracy: f64| {
        let Some(AnalysisError::NoDirection { element, time, .. }) = stopped else {
            panic!("{stopped:?}");
        };
        assert!(element.contains("winch"), "{element}");
        assert!((time - met).abs() < accuracy, "{time}");
        assert_eq!(results.len(), 43);
    };
    let (results, stopped) = simulate(model.clone()).unwrap();
    check(&results, stopped, 1e-6);
    let c = compiled(model);
    let run = Kinematics::new(&c.options).run(&c.system).unwrap();
    // A thousandth of the time between two instants.
    check(&run.results, run.stopped, 2e-5);
}

#[test]
fn statics_refuses_points_that_meet() {
    // The initial value brings the block onto the anchor.
    let mut model = block(
        &json!({"at": [[0.0, 0.0], [0.0, 0.0]], "stiffness": 40.0, "free_length": 0.1}),
        &json!({}),
    );
    model["initial"] = json!([{"kind": "displacement", "joint": "guide", "value": 0.0}]);
    let c = compiled(model);
    let error = Statics::default().run(&c.system).unwrap_err();
    assert!(
        matches!(error, AnalysisError::NoDirection { .. }),
        "{error}"
    );
}

fn pendulum(extra: &Value) -> Value {
    let mut model = json!({
        "body": [rod("rod", 1.0, 1.0, [0.5, 0.0], 0.0)],
        "joint": [pin("A", ["ground", "rod"], [[0.0, 0.0], [-0.5, 0.0]])],
    });
    for (key, value) in extra.as_object().expect("an object") {
        model[key] = value.clone();
    }
    model
}

#[test]
fn contradicting_rates_are_refused_with_what_would_fit() {
    for size in [1.0, 1e-3, 1e3] {
        let model = json!({
            "body": [rod("rod", 1.0, size, [0.5 * size, 0.0], 0.0)],
            "joint": [pin("A", ["ground", "rod"], [[0.0, 0.0], [-0.5 * size, 0.0]])],
            "initial": [{"kind": "angle", "joint": "A", "rate": 1e-3},
                        {"kind": "coordinate", "body": "rod", "coordinate": "y", "rate": 0.0}],
        });
        let error = Assembly::default()
            .run(&compiled(model).system)
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("rate of rod.y cannot hold: stated 0 m/s, the nearest that fits")
                || error.contains("rate of A.angle cannot hold: stated 0.001 rad/s, the nearest"),
            "size {size}: {error}"
        );
    }
}

#[test]
fn stated_velocities_that_break_a_pin_are_told() {
    let mut model = pendulum(&json!({}));
    model["body"][0]["velocity"] = json!([1.0, 2.0]);
    model["body"][0]["angular_velocity"] = json!(4.0);
    let (state, report) = Assembly::default().run(&compiled(model).system).unwrap();
    assert!((state.v[0]).abs() < 1e-14 && (state.v[1] - 0.5 * state.v[2]).abs() < 1e-14);
    let [changed] = report.rates_changed.as_slice() else {
        panic!("{:?}", report.rates_changed);
    };
    // 2 = 4/2 fits the pin: only the part along the rod does not.
    assert_eq!(changed.stated, [1.0, 2.0]);
    assert!((changed.found[0]).abs() < 1e-14 && (changed.found[1] - 2.0).abs() < 1e-12);
    let (_, report) = Assembly::default()
        .run(&compiled(pendulum(&json!({}))).system)
        .unwrap();
    assert_eq!(report.rates_changed, []);
}

/// A rate that is impossible although nothing moves.
#[test]
fn a_rate_of_a_rigid_frame_is_refused() {
    let mut model = pendulum(&json!({"initial": [{"kind": "angle", "joint": "A", "rate": 5.0}]}));
    let weld = json!({"name": "B", "kind": "weld", "bodies": ["ground", "rod"], "at": [[1.0, 0.0], [0.5, 0.0]]});
    model["joint"].as_array_mut().expect("joints").push(weld);
    let error = Assembly::default()
        .run(&compiled(model).system)
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("the initial rate of A.angle cannot hold: stated 5 rad/s, the nearest that fits the others is 0 rad/s"),
        "{error}"
    );
}

/// A chain of slides, each driven: large and regular.
#[test]
fn large_machines_say_that_they_are_not_checked_for_singular_poses() {
    for (bodies, expected) in [(100, false), (101, true)] {
        let name = |k: usize| {
            if k == 0 {
                "ground".to_owned()
            } else {
                format!("b{k}")
            }
        };
        let list: Vec<Value> = (1..=bodies)
            .map(|k| rod(&name(k), 1.0, 1.0, [k as f64, 0.0], 0.0))
            .collect();
        let joints: Vec<Value> = (1..=bodies)
            .map(|k| {
                pin(
                    &format!("j{k}"),
                    [&name(k - 1), &name(k)],
                    [[0.5, 0.0], [-0.5, 0.0]],
                )
            })
            .collect();
        let drivers: Vec<Value> = (1..=bodies)
            .map(|k| json!({"name": format!("d{k}"), "kind": "angle", "joint": format!("j{k}"), "rate": 0.01}))
            .collect();
        let c = compiled(
            json!({"body": list, "joint": joints, "driver": drivers, "analysis": {"end": 0.1, "step": 0.1}}),
        );
        let run = Kinematics::new(&c.options).run(&c.system).unwrap();
        assert_eq!(run.stopped, None);
        let note = "not checked for singular poses between the instants: the machine has more than 300 coordinates";
        let told = run.results.notes.iter().any(|n| n.contains(note));
        assert_eq!(told, expected, "{:?}", run.results.notes);
    }
}

/// Dry friction holds the block where it comes to rest: the run hangs at the jump, and says so soon.
#[test]
fn a_force_that_jumps_ends_the_run_with_its_name() {
    let friction = |law: &str| {
        let mut model = block(&json!({"damping": 0.0}), &json!({"end": 3.0}));
        model["force"][1] =
            json!({"name": "friction", "kind": "actuator", "joint": "guide", "value": law});
        simulate(model).unwrap()
    };
    let (results, stopped) = friction("-8 N*sign(block.vx)");
    assert!(
        results.statistics["steps"] < 2e4,
        "{:?}",
        results.statistics
    );
    let text = text(stopped);
    for part in ["'friction' jumps (sign(block.vx))", "tanh(x / eps)"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let (_, stopped) = friction("-8 N*tanh(block.vx/(1 mm/s))");
    assert_eq!(stopped, None);
}
