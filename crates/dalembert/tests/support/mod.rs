//! Small machines for tests, written as model files are, and a seeded source of numbers.
#![allow(dead_code)]

use dalembert::analysis::Assembly;
use dalembert::model::Model;
use dalembert::space::Planar;
use dalembert::system::compile::{Compiled, compile};
use dalembert::system::{State, System, Workspace};
use serde_json::{Value, json};

pub mod machines;

/// Compiles a model given as JSON.
pub fn compiled(mut value: Value) -> Compiled {
    if value.get("model").is_none() {
        value["model"] = json!({"name": "test"});
    }
    let model: Model = serde_json::from_value(value).expect("a model");
    compile::<dalembert::space::Planar>(&model, &[]).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The system with the rows that always hold, and its assembled start.
pub fn assembled(value: Value) -> (System<Planar>, State) {
    let all = compiled(value).system;
    let (state, report) = Assembly::default()
        .run(&all)
        .unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(report.velocity_conflict, None);
    (all.running(), state)
}

/// A workspace with everything evaluated at a state.
pub fn evaluated(system: &System<Planar>, state: &State) -> Workspace<Planar> {
    let mut ws = Workspace::new(system);
    system.update_markers(&state.q, &state.v, &mut ws);
    system.evaluate_constraints(state.t, &mut ws);
    system.evaluate_forces(state.t, &mut ws);
    ws
}

/// A uniform slender rod whose frame sits at its centre.
pub fn rod(name: &str, mass: f64, length: f64, at: [f64; 2], angle: f64) -> Value {
    json!({"name": name, "mass": mass, "inertia": mass * length * length / 12.0,
           "position": at, "angle": angle})
}

/// A revolute joint.
pub fn pin(name: &str, bodies: [&str; 2], at: [[f64; 2]; 2]) -> Value {
    json!({"name": name, "kind": "revolute", "bodies": bodies, "at": at})
}

/// Equal numbers, relative to the largest expected one and to one.
#[track_caller]
pub fn near(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    let most = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    for (k, (x, y)) in found.iter().zip(expected).enumerate() {
        assert!(
            (x - y).abs() <= tolerance * most,
            "{what}, entry {k}: {x} for {y}, off by {:e}",
            x - y
        );
    }
}

/// SplitMix64 (Steele, Lea and Flood 2014).
pub struct Random(pub u64);

impl Random {
    /// Seeds it, and prints the seed for whoever has to repeat a failure.
    pub fn new(seed: u64) -> Self {
        println!("seed {seed}");
        Self(seed)
    }

    /// Uniform on [low, high).
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        low + (high - low) * (z >> 11) as f64 / (1_u64 << 53) as f64
    }
}
