//! Long runs against invariants.

mod mechanisms;

use dalembert::analysis::Dynamics;
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
