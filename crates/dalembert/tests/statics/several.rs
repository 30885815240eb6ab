//! Machines with several equilibria.

use crate::common::{G, at, close, pin, rod, run, run_both, slide, system, value};
use dalembert::analysis::{Stability, Statics};
use serde_json::json;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

#[test]
fn a_double_pendulum_has_four() {
    for seed in [1, 7, 2026] {
        let s = system(json!({
            "model": {"name": "double pendulum", "gravity": [0.0, -G]},
            "body": [rod("upper", 1.0, 1.0, [0.0, 0.0], 0.4), rod("lower", 0.7, 0.8, [0.921, 0.389], -0.9)],
            "joint": [pin("O", ["ground", "upper"], [[0.0, 0.0], [-0.5, 0.0]]),
                      pin("A", ["upper", "lower"], [[0.5, 0.0], [-0.4, 0.0]])]
        }));
        let report = Statics {
            seed,
            ..Statics::default()
        }
        .run(&s)
        .unwrap();
        let mut found: Vec<(i64, i64, Stability)> = report
            .equilibria
            .iter()
            .map(|e| {
                let half_turns = |a: f64| {
                    let x = ((a + FRAC_PI_2) / PI).rem_euclid(2.0);
                    close(x - x.round(), 0.0, 1e-10);
                    x.round() as i64 % 2
                };
                (half_turns(e.q[2]), half_turns(e.q[5]), e.stability)
            })
            .collect();
        assert_eq!(found[0], (0, 0, Stability::Stable), "seed {seed}");
        found.sort_by_key(|f| (f.0, f.1));
        assert_eq!(
            found,
            [
                (0, 0, Stability::Stable),
                (0, 1, Stability::Unstable),
                (1, 0, Stability::Unstable),
                (1, 1, Stability::Unstable)
            ],
            "seed {seed}"
        );
        let down = report
            .equilibria
            .iter()
            .filter(|e| e.stiffness.iter().filter(|k| **k < 0.0).count() == 2)
            .count();
        assert_eq!(down, 1, "only the upright pose falls in both motions");
    }
}

/// A block on an upright guide, held by a spring that is longer than its distance from the guide:
/// it snaps from y = sqrt(l0^2 - a^2) to the mirrored pose.
fn toggle(start: f64) -> dalembert::system::System<dalembert::space::Planar> {
    system(json!({
        "model": {"name": "toggle", "gravity": [0.0, 0.0]},
        "body": [{"name": "block", "mass": 1.0, "inertia": 0.1, "position": [0.3, start]}],
        "joint": [slide("guide", "block", [0.3, 0.0], FRAC_PI_2)],
        "force": [{"name": "spring", "kind": "spring-damper", "bodies": ["ground", "block"],
            "at": [[0.0, 0.0], [0.0, 0.0]], "stiffness": 500.0, "free_length": 0.5}]
    }))
}

#[test]
fn a_toggle_has_two_stable_states_and_takes_the_nearer_one() {
    for (start, expected) in [(0.1, 0.4), (0.9, 0.4), (-0.05, -0.4)] {
        let report = run_both(&toggle(start));
        close(value(&report, "block.y"), expected, 1e-12);
        assert_eq!(report.equilibria[0].stability, Stability::Stable);
        let mut all: Vec<(f64, Stability)> = report
            .equilibria
            .iter()
            .map(|e| (e.q[1], e.stability))
            .collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert_eq!(all.len(), 3, "{all:?}");
        for (found, (y, stability)) in all.iter().zip([
            (-0.4, Stability::Stable),
            (0.0, Stability::Unstable),
            (0.4, Stability::Stable),
        ]) {
            close(found.0, y, 1e-10);
            assert_eq!(found.1, stability);
        }
        // One instant for each of them, in the same order.
        assert_eq!(report.results.len(), 3);
        for (k, e) in report.equilibria.iter().enumerate() {
            close(at(&report.results, "block.y", k), e.q[1], 1e-15);
            close(
                at(&report.results, "equilibrium.number", k),
                k as f64 + 1.0,
                0.0,
            );
        }
        assert_eq!(report.results.channels[0].name, "time");
    }
}

#[test]
fn the_dead_point_of_a_toggle_is_unstable() {
    let report = run_both(&toggle(0.0));
    assert_eq!(report.equilibria[0].stability, Stability::Unstable);
    assert_eq!(
        report.equilibria[0].motions,
        ["unstable: block moves along (0.000, 1.000)"]
    );
    assert_eq!(report.equilibria.len(), 3);
}

/// Two pins of a parallel guide too many: reactions are not unique, the pose is.
#[test]
fn redundant_constraints_do_not_stop_the_analysis() {
    let s = system(json!({
        "model": {"name": "double parallelogram", "gravity": [0.0, -G]},
        "body": [rod("a", 1.0, 0.5, [0.0, 0.0], -0.8), rod("b", 1.0, 0.5, [1.0, 0.0], -0.8),
                 rod("c", 1.0, 0.5, [2.0, 0.0], -0.8),
                 {"name": "beam", "mass": 2.0, "inertia": 1.0, "position": [1.0 + 0.5 * 0.8_f64.cos(), -0.5 * 0.8_f64.sin()]}],
        "joint": [pin("A", ["ground", "a"], [[0.0, 0.0], [-0.25, 0.0]]),
                  pin("B", ["ground", "b"], [[1.0, 0.0], [-0.25, 0.0]]),
                  pin("C", ["ground", "c"], [[2.0, 0.0], [-0.25, 0.0]]),
                  pin("D", ["a", "beam"], [[0.25, 0.0], [-1.0, 0.0]]),
                  pin("E", ["b", "beam"], [[0.25, 0.0], [0.0, 0.0]]),
                  pin("F", ["c", "beam"], [[0.25, 0.0], [1.0, 0.0]])]
    }));
    let report = run_both(&s);
    assert_eq!(report.freedoms, 1);
    let e = &report.equilibria[0];
    assert_eq!(e.stability, Stability::Stable);
    close((value(&report, "a.angle") + FRAC_PI_2) % TAU, 0.0, 1e-11);
    let up: f64 = ["A", "B", "C"]
        .iter()
        .map(|p| value(&report, &format!("{p}.force_y")))
        .sum();
    close(up, 5.0 * G, 1e-10);
    assert!(
        report
            .results
            .notes
            .iter()
            .any(|n| n.contains("not unique")),
        "{:?}",
        report.results.notes
    );
}

/// Ziegler's column: the load follows the upper rod, so the stiffness is not symmetric.
#[test]
fn a_following_load_is_reported() {
    for (body_axes, conservative) in [("body", false), ("ground", true)] {
        let s = system(json!({
            "model": {"name": "column", "gravity": [0.0, 0.0]},
            "body": [rod("lower", 1.0, 1.0, [0.0, 0.0], FRAC_PI_2), rod("upper", 1.0, 1.0, [0.0, 1.0], FRAC_PI_2)],
            "joint": [pin("O", ["ground", "lower"], [[0.0, 0.0], [-0.5, 0.0]]),
                      pin("A", ["lower", "upper"], [[0.5, 0.0], [-0.5, 0.0]])],
            "force": [
                {"name": "k1", "kind": "joint-spring", "joint": "O", "stiffness": 10.0, "free": FRAC_PI_2},
                {"name": "k2", "kind": "joint-spring", "joint": "A", "stiffness": 10.0},
                {"name": "P", "kind": "force", "body": "upper", "at": [0.5, 0.0],
                 "value": if body_axes == "body" { [-2.0, 0.0] } else { [0.0, -2.0] }, "axes": body_axes}]
        }));
        let report = run(&s);
        let e = &report.equilibria[0];
        close(e.distance, 0.0, 1e-12);
        assert_eq!(e.stability, Stability::Stable);
        assert_eq!(e.conservative, conservative);
        assert_eq!(
            report.results.notes.iter().any(|n| n.contains("flutter")),
            !conservative
        );
    }
}
