//! Small machines for the tests.

use dalembert::analysis::{Route, Statics, StaticsReport};
use dalembert::model::Model;
use dalembert::space::Planar;
use dalembert::system::compile::compile;
use dalembert::system::{System, Workspace};
use serde_json::{Value, json};

pub const G: f64 = 9.81;

/// Compiles a model that is given as JSON.
pub fn system(model: Value) -> System<Planar> {
    let model: Model = serde_json::from_value(model).expect("a model");
    match compile::<dalembert::space::Planar>(&model, &[]) {
        Ok(compiled) => compiled.system,
        Err(diagnostics) => panic!("{diagnostics:?}"),
    }
}

pub fn run(system: &System<Planar>) -> StaticsReport {
    Statics::default().run(system).expect("an equilibrium")
}

/// Runs both routes and compares their answers; the equations of motion must give no acceleration at
/// any equilibrium.
pub fn run_both(system: &System<Planar>) -> StaticsReport {
    let reduced = run(system);
    let full = Statics {
        route: Route::Multipliers,
        ..Statics::default()
    }
    .run(system)
    .expect("an equilibrium by multipliers");
    let (a, b) = (&reduced.equilibria[0], &full.equilibria[0]);
    assert_eq!(a.stability, b.stability);
    for (x, y) in a.q.iter().zip(&b.q) {
        // The routes may arrive after different numbers of turns.
        let d = x - y;
        let turns = (d / std::f64::consts::TAU).round() * std::f64::consts::TAU;
        close(d - turns, 0.0, 1e-10);
    }
    for (x, y) in a.multipliers.iter().zip(&b.multipliers) {
        close(*x, *y, 1e-9 * (1.0 + x.abs()));
    }
    let running = system.running();
    let mut ws = Workspace::new(&running);
    for e in &reduced.equilibria {
        running.update_markers(&e.q, &vec![0.0; e.q.len()], &mut ws);
        running.evaluate_constraints(reduced.time, &mut ws);
        running.evaluate_forces(reduced.time, &mut ws);
        ws.rhs.fill(0.0);
        ws.factor(&running.metric.inverse);
        ws.solve_forces(&running.mass);
        for a in &ws.a {
            close(*a, 0.0, 1e-7);
        }
        // The pose is on the constraints.
        assert!(running.violation(&ws).0 < 1e-12);
        assert!(e.residual < 1e-10);
    }
    reduced
}

/// Value of a channel at the first equilibrium.
pub fn value(report: &StaticsReport, channel: &str) -> f64 {
    at(&report.results, channel, 0)
}

pub fn at(results: &dalembert::results::Results, channel: &str, k: usize) -> f64 {
    results
        .channel(channel)
        .unwrap_or_else(|| {
            let names: Vec<&str> = results.channels.iter().map(|c| c.name.as_str()).collect();
            panic!("no channel {channel} in {names:?}")
        })
        .values[k]
}

#[track_caller]
pub fn close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "found {found}, expected {expected}, off by {:e}",
        found - expected
    );
}

/// A uniform rod, its frame at its middle, its first end at a point, at an angle.
pub fn rod(name: &str, mass: f64, length: f64, from: [f64; 2], angle: f64) -> Value {
    let (s, c) = angle.sin_cos();
    json!({
        "name": name, "mass": mass, "inertia": mass * length * length / 12.0 + 1e-6,
        "position": [from[0] + length / 2.0 * c, from[1] + length / 2.0 * s], "angle": angle
    })
}

/// A pin between points of two bodies.
pub fn pin(name: &str, bodies: [&str; 2], at: [[f64; 2]; 2]) -> Value {
    json!({"name": name, "kind": "revolute", "bodies": bodies, "at": at})
}

/// A slide of a body along a direction of the ground through a point, its frame upright.
pub fn slide(name: &str, body: &str, point: [f64; 2], angle: f64) -> Value {
    json!({"name": name, "kind": "prismatic", "bodies": ["ground", body],
           "at": [point, [0.0, 0.0]], "angles": [angle, angle]})
}

/// A rod of 1 m and 2 kg, pinned to the ground at its end, with a moment.
pub fn pendulum(angle: f64, moment: f64) -> System<Planar> {
    system(json!({
        "model": {"name": "pendulum", "gravity": [0.0, -G]},
        "body": [rod("bob", 2.0, 1.0, [0.0, 0.0], angle)],
        "joint": [pin("O", ["ground", "bob"], [[0.0, 0.0], [-0.5, 0.0]])],
        "force": [{"name": "M", "kind": "moment", "body": "bob", "value": moment}]
    }))
}
