//! Long runs against invariants.

mod mechanisms;

use dalembert::analysis::Dynamics;
use dalembert::model::Method;
use dalembert::system::compile::compile;
use mechanisms::{moment, slider_crank, spinning, spring};

fn largest(results: &dalembert::results::Results, name: &str) -> f64 {
    let channel = results
        .channel(name)
        .unwrap_or_else(|| panic!("no channel {name}"));
    channel.values.iter().fold(0.0_f64, |a, b| a.max(b.abs()))
}

/// A hundred turns of a free slider crank at tolerance 1e-8: the energy balance closes to 1e-7 of
/// the peak energy, the constraints to 1e-9 of the size.
#[test]
fn slider_crank_keeps_energy_over_100_turns() {
    let mut model = slider_crank();
    model.initial.push(spinning("O", 150.0));
    // Spring, damper and a motor that replaces what the damper takes: every kind of power flows.
    model.forces.push(spring(
        "spring",
        ["ground", "slider"],
        [[0.8, 0.0], [0.0, 0.0]],
        200.0,
        2.0,
        0.3,
    ));
    model
        .forces
        .push(moment("motor", "crank", "2 + 0.5*sin(20*t)"));
    model.analysis.end = Some(6.0.into());
    model.analysis.step = Some(0.01.into());
    let compiled = compile::<dalembert::space::Planar>(&model, &[]).expect("a valid model");
    let run = Dynamics::new(&compiled.options)
        .run(&compiled.system, &mut |_| true)
        .expect("the machine runs");
    assert_eq!(run.stopped, None);
    let turns = run
        .results
        .channel("crank.angle")
        .and_then(|c| c.values.last())
        .expect("an angle")
        / std::f64::consts::TAU;
    assert!(turns > 100.0, "{turns} turns only");
    let peak = largest(&run.results, "energy.kinetic");
    let balance = largest(&run.results, "energy.balance");
    assert!(balance < 1e-7 * peak, "balance {balance} J of {peak} J");
    // Projection reaches 1e-11 of the size (a thousandth of the tolerance).
    assert!(largest(&run.results, "violation.position") < 1e-11);
    assert!(largest(&run.results, "violation.velocity") < 1e-9 * 150.0);
}

/// Baumgarte's stabilization holds the constraints roughly, the projection exactly; both reach the
/// same motion.
#[test]
fn baumgarte_agrees_with_projection() {
    let mut model = slider_crank();
    model.initial.push(spinning("O", 20.0));
    model.analysis.end = Some(1.0.into());
    model.analysis.tolerance = Some(1e-10.into());
    let angle = |model: &dalembert::model::Model| {
        let compiled = compile::<dalembert::space::Planar>(model, &[]).expect("a valid model");
        let run = Dynamics::new(&compiled.options)
            .run(&compiled.system, &mut |_| true)
            .expect("the machine runs");
        assert_eq!(run.stopped, None);
        (run.state.q[2], largest(&run.results, "violation.position"))
    };
    let (projected, exact) = angle(&model);
    model.analysis.stabilization = Some(dalembert::model::Stabilization::Baumgarte);
    let (stabilized, rough) = angle(&model);
    // Global error: some hundred steps of local error 1e-10 over 3 turns.
    assert!(
        (projected - stabilized).abs() < 1e-7,
        "{projected} and {stabilized}"
    );
    assert!(exact < 1e-12 && rough < 1e-8, "{exact} and {rough}");
}

/// A free body with three moments of inertia tumbles for more than a thousand revolutions at tolerance 1e-10: energy and
/// angular momentum stay to 1e-8 of their size, the norm of the orientation to rounding.
#[test]
fn free_body_keeps_its_invariants_over_a_thousand_revolutions() {
    let (moments, omega) = ([1.0, 2.0, 3.0], [5.0, 7.0, 9.0]);
    let momentum: [f64; 3] = std::array::from_fn(|k| moments[k] * omega[k]);
    let size = momentum.iter().map(|l| l * l).sum::<f64>().sqrt();
    // The body goes round its angular momentum with at least |L|/I_max.
    let end = 1000.0 * std::f64::consts::TAU * 3.0 / size;
    let model = serde_json::json!({
        "model": {"name": "free body", "space": "spatial", "gravity": [0, 0, 0]},
        "body": [{"name": "top", "mass": 1, "inertia": moments, "angular_velocity": omega}],
        "analysis": {"end": end, "step": end / 1000.0, "tolerance": 1e-10},
    });
    let model = serde_json::from_value(model).expect("a model");
    let compiled = compile::<dalembert::space::Spatial>(&model, &[]).expect("a valid model");
    let run = Dynamics::new(&compiled.options)
        .run(&compiled.system, &mut |_| true)
        .expect("the body turns");
    assert_eq!(run.stopped, None);
    let channel = |name: &str| &run.results.channel(name).expect("a channel").values;
    let energy = channel("energy.kinetic");
    let drift = energy.iter().map(|e| (e / energy[0] - 1.0).abs());
    let drift = drift.fold(0.0, f64::max);
    assert!(drift < 1e-8, "energy off by {drift:e}");
    for (axis, expected) in ["x", "y", "z"].into_iter().zip(momentum) {
        let values = channel(&format!("momentum.angular_{axis}"));
        let off = values.iter().map(|l| (l - expected).abs() / size);
        let off = off.fold(0.0, f64::max);
        assert!(off < 1e-8, "angular momentum about {axis} off by {off:e}");
    }
    let parameters = [0, 1, 2, 3].map(|k| channel(&format!("top.b{k}")));
    for row in 0..energy.len() {
        let norm = parameters
            .map(|b| b[row] * b[row])
            .iter()
            .sum::<f64>()
            .sqrt();
        assert!((norm - 1.0).abs() < 1e-14, "norm {norm} in row {row}");
    }
}

/// State of a free slider crank at 0.1 s, half a turn later.
fn at_a_tenth(method: Method, tolerance: f64, step: f64) -> Vec<f64> {
    let mut model = slider_crank();
    model.initial.push(spinning("O", 20.0));
    let compiled = compile::<dalembert::space::Planar>(&model, &[]).expect("a valid model");
    let mut options = Dynamics::new(&compiled.options);
    options.instants = vec![0.0, 0.1];
    options.integrator = method;
    options.tolerance = tolerance;
    options.max_step = step;
    let report = options
        .run(&compiled.system, &mut |_| true)
        .expect("it runs");
    assert_eq!(report.stopped, None);
    [report.state.q, report.state.v].concat()
}

/// On constraints, with projection after every step, the methods keep their orders in positions and velocities.
#[test]
fn orders_on_constraints() {
    let exact = at_a_tenth(Method::Dop853, 1e-14, f64::INFINITY);
    let error = |found: &[f64]| {
        let off = found.iter().zip(&exact).map(|(a, b)| (a - b).abs());
        off.fold(0.0, f64::max)
    };
    for (method, order, step) in [
        (Method::Euler, 1.0, 2e-5),
        (Method::Midpoint, 2.0, 2e-4),
        (Method::Heun, 2.0, 2e-4),
        (Method::Rk4, 4.0, 1e-3),
    ] {
        let [one, half] = [step, 0.5 * step].map(|h| error(&at_a_tenth(method, 1e-8, h)));
        let found = (one / half).log2();
        assert!((found - order).abs() < 0.1, "{method:?}: order {found}");
    }
    for method in [Method::Dopri5, Method::Dop853, Method::Adams] {
        for tolerance in [1e-6, 1e-8, 1e-10] {
            let off = error(&at_a_tenth(method, tolerance, f64::INFINITY));
            // Velocities are some metres a second, angular ones some tens of radians.
            assert!(off < 1e3 * tolerance, "{method:?}, {tolerance:e}: {off:e}");
        }
    }
}
