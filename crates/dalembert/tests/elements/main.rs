//! Every constraint element against dual numbers, and every force element against numerical differentiation, at random
//! states that are off the constraint manifold, with all velocities different from zero.

mod constraints;
mod contacts;
mod forces;
mod oracle;
#[path = "../support/mod.rs"]
mod support;

use dalembert::space::{Planar, PlanarMarker};
use dalembert::system::{State, System, Workspace};
use serde_json::{Value, json};
use support::{Random, assembled, compiled, evaluated, near};

const SEED: u64 = 20_011_213;
const STATES: usize = 5;

/// Two bodies whose frames are not at their centres of mass, and one that carries others.
fn bodies() -> Value {
    json!([
        {"name": "a", "mass": 2.0, "inertia": 0.4, "center": [0.13, -0.21], "position": [0.2, 0.5], "angle": 0.3},
        {"name": "b", "mass": 1.5, "inertia": 0.3, "center": [-0.17, 0.08], "position": [1.1, 0.9], "angle": -0.4},
        {"name": "c", "mass": 0.7, "inertia": 0.1, "center": [0.05, 0.11], "position": [-0.6, 0.4], "angle": 1.2}
    ])
}

fn system(parts: Value) -> System<Planar> {
    let mut model = json!({"model": {"name": "test", "gravity": [0, 0]}, "body": bodies()});
    for (key, value) in parts.as_object().unwrap() {
        model[key] = value.clone();
    }
    compiled(model).system.running()
}

fn joint(kind: &str, bodies: [&str; 2], more: Value) -> Value {
    let mut joint = json!({"name": "J", "kind": kind, "bodies": bodies,
                           "at": [[0.31, -0.12], [-0.23, 0.19]], "angles": [0.35, -0.8]});
    for (key, value) in more.as_object().unwrap() {
        joint[key] = value.clone();
    }
    joint
}

fn random_state(system: &System<Planar>, random: &mut Random) -> State {
    let mut draw = |n: usize, limit: f64| (0..n).map(|_| random.uniform(-limit, limit)).collect();
    let (mut q, v): (Vec<f64>, Vec<f64>) = (draw(system.nq(), 1.0), draw(system.nv(), 1.0));
    for angle in q.iter_mut().take(system.body_nv()).skip(2).step_by(3) {
        *angle *= 3.0;
    }
    State {
        t: random.uniform(0.1, 0.9),
        q,
        v,
    }
}

/// Step of the differences. Angles turn by some radians per unit of the path and profiles double that: the formulas of
/// tenth order then err by less than 1e-11, and so does rounding.
const STEP: f64 = 0.03;
/// What that leaves, relative to the largest entry and to one.
const TOLERANCE: f64 = 1e-11;

/// First and second derivative at zero by central differences of tenth order (Fornberg 1988).
fn differentiate(f: impl Fn(f64) -> Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let first = [
        5.0 / 6.0,
        -5.0 / 21.0,
        5.0 / 84.0,
        -5.0 / 504.0,
        1.0 / 1260.0,
    ];
    let second = [
        5.0 / 3.0,
        -5.0 / 21.0,
        5.0 / 126.0,
        -5.0 / 1008.0,
        1.0 / 3150.0,
    ];
    let middle = f(0.0);
    let mut d = vec![0.0; middle.len()];
    let mut dd: Vec<f64> = middle.iter().map(|x| -5269.0 / 1800.0 * x).collect();
    for (k, (first, second)) in first.into_iter().zip(second).enumerate() {
        let h = STEP * (k + 1) as f64;
        let (plus, minus) = (f(h), f(-h));
        for i in 0..d.len() {
            d[i] += first * (plus[i] - minus[i]);
            dd[i] += second * (plus[i] + minus[i]);
        }
    }
    for i in 0..d.len() {
        d[i] /= STEP;
        dd[i] /= STEP * STEP;
    }
    (d, dd)
}

fn moved(q: &[f64], v: &[f64], s: f64) -> Vec<f64> {
    q.iter().zip(v).map(|(q, v)| q + s * v).collect()
}
