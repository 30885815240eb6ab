//! Motions that nothing holds: their poses are one equilibrium, and they are named.

use crate::common::{G, pin, rod, run, slide, system, value};
use dalembert::analysis::{Route, Stability, Statics};
use dalembert::space::Planar;
use dalembert::system::System;
use serde_json::{Value, json};

/// A machine with a block on a level slide that nothing pushes.
fn with_free_block(mut model: Value) -> System<Planar> {
    let block = json!({"name": "block", "mass": 1.0, "inertia": 0.1, "position": [3.0, 0.0]});
    model["body"].as_array_mut().expect("bodies").push(block);
    let guide = slide("guide", "block", [3.0, 0.0], 0.0);
    model["joint"].as_array_mut().expect("joints").push(guide);
    system(model)
}

#[test]
fn a_block_that_slides_freely_does_not_multiply_the_equilibria() {
    let s = with_free_block(json!({
        "model": {"name": "pendulum and block", "gravity": [0.0, -G]},
        "body": [rod("bob", 2.0, 1.0, [0.0, 0.0], 0.3)],
        "joint": [pin("O", ["ground", "bob"], [[0.0, 0.0], [-0.5, 0.0]])]
    }));
    for route in [Route::Reduced, Route::Multipliers] {
        for seed in [1, 5, 11] {
            let report = Statics {
                seed,
                route,
                ..Statics::default()
            }
            .run(&s)
            .unwrap();
            let found: Vec<Stability> = report.equilibria.iter().map(|e| e.stability).collect();
            assert_eq!(
                found,
                [Stability::Neutral, Stability::Unstable],
                "seed {seed}"
            );
            for e in &report.equilibria {
                let neutral: Vec<&String> = e
                    .motions
                    .iter()
                    .filter(|m| m.starts_with("neutral"))
                    .collect();
                assert_eq!(neutral, ["neutral along guide.displacement: block slides"]);
            }
        }
    }
}

#[test]
fn a_linkage_without_loads_has_one_equilibrium() {
    let angle = 0.9_f64;
    let (s, c) = angle.sin_cos();
    let crank = |name: &str, x: f64| rod(name, 1.0, 0.5, [x, 0.0], angle);
    let s = system(json!({
        "model": {"name": "double parallelogram", "gravity": [0.0, 0.0]},
        "body": [crank("a", 0.0), crank("b", 1.0), crank("c", 2.0),
                 {"name": "beam", "mass": 2.0, "inertia": 1.0, "position": [1.0 + 0.5 * c, 0.5 * s]}],
        "joint": [pin("A", ["ground", "a"], [[0.0, 0.0], [-0.25, 0.0]]),
                  pin("B", ["ground", "b"], [[1.0, 0.0], [-0.25, 0.0]]),
                  pin("C", ["ground", "c"], [[2.0, 0.0], [-0.25, 0.0]]),
                  pin("D", ["a", "beam"], [[0.25, 0.0], [-1.0, 0.0]]),
                  pin("E", ["b", "beam"], [[0.25, 0.0], [0.0, 0.0]]),
                  pin("F", ["c", "beam"], [[0.25, 0.0], [1.0, 0.0]])]
    }));
    let report = run(&s);
    assert_eq!(report.equilibria.len(), 1);
    let e = &report.equilibria[0];
    assert_eq!(e.stability, Stability::Neutral);
    assert_eq!(
        e.motions,
        ["neutral along A.angle: a turns, b turns, c turns, beam moves"]
    );
    // The estimate stands for all.
    assert_eq!(value(&report, "equilibrium.distance"), 0.0);
}

#[test]
fn several_free_motions_are_told_apart() {
    let s = with_free_block(json!({
        "model": {"name": "wheel and block", "gravity": [0.0, -G]},
        "body": [{"name": "wheel", "mass": 1.0, "inertia": 0.5}],
        "joint": [pin("axle", ["ground", "wheel"], [[0.0, 0.0], [0.0, 0.0]])]
    }));
    let report = run(&s);
    assert_eq!(report.equilibria.len(), 1);
    assert_eq!(
        report.equilibria[0].motions,
        [
            "neutral along axle.angle: wheel turns",
            "neutral along guide.displacement: block slides"
        ]
    );
}

/// Two mirrored poses of the same energy, between which the toggle would have to be pushed.
#[test]
fn poses_of_equal_energy_that_are_not_connected_stay_two() {
    let s = with_free_block(json!({
        "model": {"name": "toggle and block", "gravity": [0.0, 0.0]},
        "body": [{"name": "knob", "mass": 1.0, "inertia": 0.1, "position": [0.3, 0.1]}],
        "joint": [slide("rail", "knob", [0.3, 0.0], std::f64::consts::FRAC_PI_2)],
        "force": [{"name": "spring", "kind": "spring-damper", "bodies": ["ground", "knob"],
            "at": [[0.0, 0.0], [0.0, 0.0]], "stiffness": 500.0, "free_length": 0.5}]
    }));
    let report = run(&s);
    let mut heights: Vec<f64> = report.equilibria.iter().map(|e| e.q[1]).collect();
    heights.sort_by(f64::total_cmp);
    assert_eq!(heights.len(), 3, "{heights:?}");
    for (found, expected) in heights.iter().zip([-0.4, 0.0, 0.4]) {
        assert!((found - expected).abs() < 1e-9, "{heights:?}");
    }
}

/// A long chain: one run takes the cube of its links, so unstable poses are not searched for.
#[test]
fn long_chains_come_to_rest_in_reasonable_time() {
    let links = 60;
    let length = 1.5 / links as f64;
    let mut from = [0.0, 0.0];
    let mut bodies = Vec::new();
    let mut joints = Vec::new();
    for k in 0..links {
        let angle = if k < links / 2 { -0.83_f64 } else { 0.83 };
        bodies.push(rod(
            &format!("l{k}"),
            2.0 / links as f64,
            length,
            from,
            angle,
        ));
        from[0] += length * angle.cos();
        from[1] += length * angle.sin();
        let before = if k == 0 {
            "ground".to_owned()
        } else {
            format!("l{}", k - 1)
        };
        let end = if k == 0 { 0.0 } else { length / 2.0 };
        joints.push(pin(
            &format!("j{k}"),
            [&before, &format!("l{k}")],
            [[end, 0.0], [-length / 2.0, 0.0]],
        ));
    }
    let last = format!("l{}", links - 1);
    joints.push(pin(
        "end",
        [&last, "ground"],
        [[length / 2.0, 0.0], [from[0], 0.0]],
    ));
    let s = system(
        json!({"model": {"name": "chain", "gravity": [0.0, -G]}, "body": bodies, "joint": joints}),
    );
    let report = run(&s);
    assert_eq!(report.equilibria.len(), 1);
    assert_eq!(report.equilibria[0].stability, Stability::Stable);
    let note = &report.results.notes[0];
    assert!(
        note.contains("has 58 freedoms") && note.contains("unstable ones not at all"),
        "{note}"
    );
    // Half of the weight at each end.
    assert!((value(&report, "j0.force_y") - G).abs() < 1e-9);
}
