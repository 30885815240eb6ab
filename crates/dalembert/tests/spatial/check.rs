//! C, C_q, C_t and Q_d of a system against dual numbers, at random states off the manifold.

use super::machine::{Machine, evaluated, pose, system};
use super::oracle::Number;
use super::rows::Residual;
use super::{Random, SEED, near, random};
use dalembert::space::Spatial;
use dalembert::system::{State, System};
use num_dual::{Dual2_64, Dual64};
use serde_json::Value;

const STATES: usize = 4;
/// A few roundings of terms of the size of the largest entry; angles of some turns cost a digit, and projections that
/// are short at a random pose another.
const EXACT: f64 = 5e-14;

/// A state off the manifold with all velocities non-zero, and angles that remember some turns.
pub fn random_state(system: &System<Spatial>, source: &mut Random) -> State {
    let mut q: Vec<f64> = (0..system.nq())
        .map(|_| source.uniform(-1.0, 1.0))
        .collect();
    for body in q[..7 * system.bodies.len()].chunks_exact_mut(7) {
        let norm = body[3..].iter().map(|b| b * b).sum::<f64>().sqrt();
        body[3..].iter_mut().for_each(|b| *b /= norm);
    }
    let turns = system.nq() - system.turns.len();
    q[turns..].iter_mut().for_each(|angle| *angle *= 20.0);
    State {
        t: source.uniform(0.1, 0.9),
        q,
        v: random::<32>(source, 1.0)[..system.nv()].to_vec(),
    }
}

/// What the oracle sees at a state, moving with some velocities for the time s.
fn machine<D: Number>(
    system: &System<Spatial>,
    state: &State,
    v: &[f64],
    t: D,
    s: D,
) -> Machine<D> {
    let bodies = 7 * system.bodies.len();
    let nv = system.body_nv();
    let auxiliary = state.q[bodies..bodies + system.aux].iter().zip(&v[nv..]);
    Machine {
        t,
        s,
        poses: state.q[..bodies].chunks_exact(7).map(pose).collect(),
        v: v[..nv].to_vec(),
        auxiliary: auxiliary.map(|(x, rate)| s * *rate + *x).collect(),
        memory: state.q[bodies + system.aux..].to_vec(),
    }
}

/// At random states.
pub fn check(name: &str, parts: &Value, oracle: &impl Residual) {
    let system = system(parts).running();
    assert!(system.rows > 0, "{name} has no rows");
    let mut source = Random::new(SEED);
    let states = (0..STATES).map(|_| random_state(&system, &mut source));
    for (n, state) in states.enumerate() {
        let ws = evaluated(&system, &state);
        let off = ws.value.iter().any(|c| c.abs() > 1e-6);
        assert!(off, "{name}, state {n}: on the manifold");
        check_at(&format!("{name}, state {n}"), &system, &state, oracle);
    }
}

/// Along constant velocities in the engine's coordinates the second derivative of C is -Q_d.
pub fn check_at(name: &str, system: &System<Spatial>, state: &State, oracle: &impl Residual) {
    let constants = oracle.constants(&Machine::estimate());
    let ws = evaluated(system, state);
    let (t, still) = (state.t, vec![0.0; system.nv()]);
    let plain = oracle.rows(&machine(system, state, &still, t, 0.0));
    let value: Vec<f64> = plain.iter().zip(&constants).map(|(c, k)| c - k).collect();
    assert_eq!(value.len(), system.rows, "{name}: rows");
    near(&format!("{name}: C"), &ws.value, &value, EXACT);

    let slope = |v: &[f64], t: Dual64| -> Vec<f64> {
        let machine = machine(system, state, v, t, Dual64::new(0.0, 1.0));
        oracle.rows(&machine).iter().map(|c| c.eps).collect()
    };
    let jacobian = system.dense_jacobian(&ws);
    for k in 0..system.nv() {
        let mut v = still.clone();
        v[k] = 1.0;
        near(
            &format!("{name}: C_q column {k}"),
            jacobian.column(k).as_slice(),
            &slope(&v, Dual64::from(t)),
            EXACT,
        );
    }
    let time = slope(&still, Dual64::new(t, 1.0));
    near(&format!("{name}: C_t"), &ws.time, &time, EXACT);

    let (t, s) = (Dual2_64::new(t, 1.0, 0.0), Dual2_64::new(0.0, 1.0, 0.0));
    let path = oracle.rows(&machine(system, state, &state.v, t, s));
    let mut rate = vec![0.0; system.rows];
    system.jac_mul(&ws, &state.v, &mut rate);
    rate.iter_mut().zip(&ws.time).for_each(|(r, t)| *r += t);
    let expected: Vec<f64> = path.iter().map(|c| c.v1).collect();
    near(&format!("{name}: C_q v + C_t"), &rate, &expected, EXACT);
    let expected: Vec<f64> = path.iter().map(|c| -c.v2).collect();
    near(&format!("{name}: Q_d"), &ws.qd, &expected, EXACT);
}
