//! Runs that come to a pose at which an element loses the direction or the angle it is made of.

use super::moving_machine::compiled;
use dalembert::analysis::{AnalysisError, Dynamics, DynamicsReport, Kinematics};
use dalembert::joint::Lost;
use dalembert::system::compile::Options;
use serde_json::{Value, json};
use std::f64::consts::PI;

/// Simulates to an end in steps of a hundredth of it.
fn simulated(parts: Value, end: f64, tolerance: f64) -> DynamicsReport {
    let instants: Vec<f64> = (0..=100).map(|k| end * f64::from(k) / 100.0).collect();
    let mut options = Dynamics::new(&Options::default());
    options.instants = instants;
    options.tolerance = tolerance;
    options.run(&compiled(parts).system, &mut |_| true).unwrap()
}

/// When an element was lost, and what it lost.
#[track_caller]
fn lost(stopped: Option<&AnalysisError>, name: &str) -> (f64, Lost) {
    let Some(
        error @ AnalysisError::Lost {
            element,
            time,
            lost,
        },
    ) = stopped
    else {
        panic!("{stopped:?}");
    };
    assert!(element.contains(name), "{error}");
    assert!(error.to_string().contains(lost.remedy()), "{error}");
    (*time, *lost)
}

fn last(report: &DynamicsReport, channel: &str) -> f64 {
    let values = &report.results.channel(channel).unwrap().values;
    *values.last().unwrap()
}

/// A coin that leans by an angle from lying flat, with a velocity of its axle's tilt.
fn coin(tilt: f64, omega: [f64; 3]) -> Value {
    let (m, r) = (0.0075, 0.012_f64);
    let flat = 0.25 * m * r * r;
    json!({
        "body": [{"name": "coin", "mass": m, "inertia": [flat, flat, 2.0 * flat],
                  "position": [0, 0, r * tilt.sin()],
                  "orientation": {"axis": [1, 0, 0], "angle": tilt}, "angular_velocity": omega}],
        "joint": [{"name": "floor", "kind": "rolling-disc", "bodies": ["ground", "coin"],
                   "at": [[0, 0, 0], [0, 0, 0]], "axes": [[0, 0, 1], [0, 0, 1]], "radius": r}]
    })
}

#[test]
fn a_coin_that_falls_flat_ends_the_run_with_its_energy() {
    for (tilt, tolerance) in [(PI / 3.0, 1e-9), (PI / 3.0, 1e-4), (0.5, 1e-6), (0.1, 1e-3)] {
        let report = simulated(coin(tilt, [0.0; 3]), 0.2, tolerance);
        let (time, what) = lost(report.stopped.as_ref(), "'floor' (rolling-disc)");
        assert_eq!(what, Lost::Contact);
        assert!(time > 0.0 && time < 0.2, "{time}");
        let energy = &report.results.channel("energy.total").unwrap().values;
        assert!(energy.len() > 3);
        for e in energy {
            // The runs are short: a few tolerances.
            let allowed = 20.0 * tolerance * energy[0];
            assert!((e - energy[0]).abs() < allowed, "{tilt} {tolerance:e}: {e}");
        }
    }
}

/// A coin that spins comes down, misses the flat pose and rises again: nothing is lost.
#[test]
fn a_coin_that_spins_does_not_lie_flat() {
    let report = simulated(coin(0.3, [0.0, 20.0, 5.0]), 0.1, 1e-8);
    assert!(report.stopped.is_none(), "{:?}", report.stopped);
    let energy = &report.results.channel("energy.total").unwrap().values;
    let drift = (energy[100] - energy[0]).abs();
    assert!(drift < 1e-6 * energy[0], "{drift:e}");
}

fn free_body(omega: [f64; 3]) -> Value {
    json!([{"name": "b", "mass": 1, "inertia": [0.1, 0.1, 0.1], "angular_velocity": omega}])
}

#[test]
fn a_bushing_turned_by_half_a_turn_ends_the_run() {
    for (tolerance, damping) in [(1e-9, 0.5), (1e-3, 0.0)] {
        let report = simulated(
            json!({
                "gravity": [0, 0, 0], "body": free_body([0.0; 3]),
                "force": [{"name": "bush", "kind": "bushing", "bodies": ["ground", "b"],
                           "at": [[0, 0, 0], [0, 0, 0]],
                           "stiffness": [1000, 1000, 1000, 10, 10, 10],
                           "damping": [1, 1, 1, damping, damping, damping]},
                          {"name": "m", "kind": "moment", "body": "b", "value": [0, 0, "50 * t"]}]
            }),
            2.0,
            tolerance,
        );
        let (_, what) = lost(report.stopped.as_ref(), "'bush' (bushing)");
        assert_eq!(what, Lost::RotationVector);
        let moment = &report.results.channel("bush.moment_z").unwrap().values;
        // It never turns forward before.
        assert!(moment.iter().all(|m| *m <= 1e-9), "{moment:?}");
        assert!(last(&report, "bush.moment_z") < -25.0);
    }
}

/// To and fro through rest, by nearly half a turn; and any turn of one that is soft in turns.
#[test]
fn a_bushing_below_half_a_turn_runs_on() {
    let bushing = |turns: f64, omega: [f64; 3]| {
        json!({
            "gravity": [0, 0, 0], "body": free_body(omega),
            "force": [{"name": "bush", "kind": "bushing", "bodies": ["ground", "b"],
                       "at": [[0, 0, 0], [0, 0, 0]],
                       "stiffness": [1000, 1000, 1000, turns, turns, turns],
                       "damping": [0, 0, 0, 0, 0, 0]}]
        })
    };
    // Omega^2 = 10 / 0.1: the turn goes up to speed / 10.
    for tolerance in [1e-9, 1e-2] {
        let report = simulated(bushing(10.0, [0.0, 0.0, 9.9 * PI]), 2.0, tolerance);
        assert!(report.stopped.is_none(), "{:?}", report.stopped);
    }
    let report = simulated(bushing(0.0, [0.0, 3.0, 9.9 * PI]), 2.0, 1e-6);
    assert!(report.stopped.is_none(), "{:?}", report.stopped);
}

#[test]
fn an_angle_between_bodies_that_tilt_by_a_quarter_turn_ends_the_run() {
    let spring = json!({"name": "s", "kind": "torsion-spring", "bodies": ["ground", "b"],
                        "axis": [0, 0, 1], "stiffness": 1});
    let driver = json!({"name": "d", "kind": "relative-angle", "bodies": ["ground", "b"],
                        "axis": [0, 0, 1], "value": 0});
    let with = |key: &str, element: &Value| {
        let mut parts = json!({"gravity": [0, 0, 0], "body": free_body([0.0, 5.0, 0.0])});
        parts[key] = json!([element]);
        parts
    };
    for (parts, name) in [
        (with("force", &spring), "'s' (torsion-spring)"),
        (with("driver", &driver), "'d' (relative-angle driver)"),
    ] {
        let report = simulated(parts, 1.0, 1e-8);
        let (time, what) = lost(report.stopped.as_ref(), name);
        assert_eq!(what, Lost::Angle);
        assert!((time - PI / 10.0).abs() < 1e-6, "{time}");
    }
}

/// The same in kinematics, where drivers turn the body about another axis.
#[test]
fn a_driven_angle_that_is_lost_ends_the_motion() {
    let model = json!({
        "body": [{"name": "b", "mass": 1, "inertia": [1, 1, 1]}],
        "joint": [{"name": "J", "kind": "spherical", "bodies": ["ground", "b"], "at": [[0, 0, 0], [0, 0, 0]]}],
        "driver": [
            {"name": "about", "kind": "relative-angle", "bodies": ["ground", "b"], "axis": [0, 0, 1], "value": "0.2"},
            {"name": "roll", "kind": "relative-angle", "bodies": ["ground", "b"], "axis": [1, 0, 0], "value": 0},
            {"name": "tilt", "kind": "relative-angle", "bodies": ["ground", "b"], "axis": [0, 1, 0], "value": "2 rad/s * t"}]
    });
    let mut kinematics = Kinematics::new(&Options::default());
    kinematics.instants = (0..=100).map(|k| 0.01 * f64::from(k)).collect();
    let run = kinematics.run(&compiled(model).system).unwrap();
    let (time, _) = lost(run.stopped.as_ref(), "");
    assert!(time > 0.7 && time < 0.8, "{time}");
}
