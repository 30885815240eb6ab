//! Machines without equilibrium, and how that is said.

use crate::common::{G, pendulum, slide, system};
use dalembert::analysis::{AnalysisError, Route, Statics};
use dalembert::space::Planar;
use dalembert::system::System;
use serde_json::json;

fn failure(system: &System<Planar>) -> (String, f64, String) {
    for route in [Route::Multipliers, Route::Reduced] {
        let error = Statics {
            route,
            starts: Some(4),
            ..Statics::default()
        }
        .run(system)
        .expect_err("no equilibrium");
        let AnalysisError::NoEquilibrium {
            coordinate,
            residual,
            reason,
        } = error
        else {
            panic!("{error}");
        };
        if route == Route::Reduced {
            return (coordinate, residual, reason);
        }
    }
    unreachable!()
}

/// No pose balances M > m g l/2.
#[test]
fn too_strong_a_moment_turns_the_pendulum_round_and_round() {
    for moment in [9.9, 12.0, 100.0] {
        let (coordinate, residual, reason) = failure(&pendulum(0.0, moment));
        assert!(reason.contains("bob"), "{reason}");
        assert!(reason.contains("round"), "{reason}");
        assert!(coordinate.starts_with("bob."), "{coordinate}");
        assert!(residual > 0.0);
    }
}

#[test]
fn a_constant_force_on_a_free_slide_is_named() {
    let s = system(json!({
        "model": {"name": "pushed sled", "gravity": [0.0, -G]},
        "body": [{"name": "sled", "mass": 1.0, "inertia": 1.0, "position": [0.3, 0.0]}],
        "joint": [slide("rail", "sled", [0.0, 0.0], 0.0)],
        "force": [{"name": "F", "kind": "force", "body": "sled", "value": [2.5, 0.0]}]
    }));
    let (coordinate, residual, reason) = failure(&s);
    assert_eq!(coordinate, "sled.x");
    crate::common::close(residual, 2.5, 1e-12);
    assert!(reason.contains("nothing holds sled.x"), "{reason}");
}

#[test]
fn a_falling_stone_is_named() {
    let s = system(json!({
        "model": {"name": "stone", "gravity": [0.0, -G]},
        "body": [{"name": "stone", "mass": 2.0, "inertia": 1.0, "position": [0.3, 0.0]}]
    }));
    let (coordinate, residual, reason) = failure(&s);
    assert_eq!(coordinate, "stone.y");
    crate::common::close(residual, 2.0 * G, 1e-12);
    assert!(reason.contains("nothing holds stone.y"), "{reason}");
}

#[test]
fn a_machine_that_cannot_be_assembled_says_so() {
    let s = system(json!({
        "model": {"name": "torn", "gravity": [0.0, -G]},
        "body": [crate::common::rod("bar", 2.0, 1.0, [0.0, 0.0], 0.0)],
        "joint": [crate::common::pin("A", ["ground", "bar"], [[0.0, 0.0], [-0.5, 0.0]]),
                  crate::common::pin("B", ["ground", "bar"], [[2.0, 0.0], [0.5, 0.0]])]
    }));
    let error = Statics::default().run(&s).expect_err("out of reach");
    assert!(
        matches!(error, AnalysisError::NotAssembled { .. }),
        "{error}"
    );
}

#[test]
fn a_force_without_value_is_named() {
    let s = system(json!({
        "model": {"name": "at the centre", "gravity": [0.0, 0.0]},
        "body": [{"name": "stone", "mass": 2.0, "inertia": 1.0}],
        "force": [{"name": "planet", "kind": "point-gravity", "body": "stone", "mu": 1.0}]
    }));
    let error = Statics::default().run(&s).expect_err("infinite attraction");
    let AnalysisError::NotFinite { element, .. } = error else {
        panic!("{error}");
    };
    assert!(element.starts_with("planet"), "{element}");
}
