//! The unit in which a user writes a constraint has no part in its accuracy or in the rank.

use dalembert::analysis::{Assembly, Mobility};
use dalembert::model::Model;
use dalembert::system::compile::{Compiled, compile};
use serde_json::json;

fn pendulum(expression: &str) -> Compiled {
    let model: Model = serde_json::from_value(json!({
        "model": { "name": "pendulum" },
        "body": [{ "name": "rod", "mass": 1, "inertia": 0.1, "position": [0.5, 0.0], "angle": 0.4 }],
        "joint": [{ "name": "pin", "kind": "revolute", "bodies": ["ground", "rod"], "at": [[0, 0], [-0.5, 0]] }],
        "constraint": [{ "name": "stop", "kind": "expression", "expression": expression }],
    }))
    .expect("a model");
    compile::<dalembert::space::Planar>(&model, &[]).unwrap_or_else(|e| panic!("{expression}: {e}"))
}

#[test]
fn tiny_and_huge_units_assemble_alike() {
    // rod.x^4 of some 0.01 m^4: an area moment of a small machine, and the same in other units.
    for factor in [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9] {
        let compiled = pendulum(&format!("{factor:e}*(rod.x^4 - 0.3^4)"));
        let (state, _) = Assembly::default()
            .run(&compiled.system)
            .expect("it closes");
        // The fourth power is good to some 1e-16 of itself, Newton's tolerance is 1e-13 of the
        // gradient times the size, which is 7 times it.
        let off = (state.q[0] - 0.3).abs();
        assert!(off < 1e-12, "factor {factor:e}: off by {off:e}");
        let report = Mobility::default()
            .run(&compiled.system, &state)
            .expect("mobility");
        assert_eq!(report.freedoms_left(), 0, "factor {factor:e}: {report}");
        assert!(report.redundant.is_empty(), "factor {factor:e}: {report}");
    }
}

#[test]
fn a_gradient_that_vanishes_at_the_estimate_does_not_spoil_the_scale() {
    // The derivative of rod.y^2 is zero at the estimate.
    let compiled = pendulum("(rod.y - 0.5*sin(0.4))^2 - 1e-4");
    let system = &compiled.system;
    let row = system.rows - 1;
    let scale = system.row_scale(row);
    assert!(scale > 1e-6 && scale < 1.0, "{scale:e}");
}
