//! All formulations give the same accelerations and, where they are unique, the same multipliers.

mod support;

use dalembert::formulation::{
    Accelerations, Basis, Formulation, FormulationError, RowSpace, Terms, column_scale,
};
use dalembert::space::Planar;
use dalembert::system::{State, System};
use support::{assembled, evaluated, machines};

fn formulations() -> Vec<Formulation> {
    let partition = Basis::default;
    vec![
        Formulation::Augmented,
        Formulation::AugmentedDense,
        Formulation::Embedding(partition()),
        Formulation::Embedding(Basis::Qr),
        Formulation::Embedding(Basis::Svd),
        Formulation::Elimination(partition()),
        Formulation::Elimination(Basis::Svd),
        Formulation::Amalgamated(partition()),
        Formulation::Amalgamated(Basis::Qr),
    ]
}

/// Largest difference, in comparable units, over the largest acceleration.
fn difference(a: &[f64], b: &[f64], scale: &[f64]) -> f64 {
    let most = a
        .iter()
        .zip(scale)
        .map(|(x, s)| (x / s).abs())
        .fold(0.0, f64::max);
    let worst = a
        .iter()
        .zip(b)
        .zip(scale)
        .map(|((x, y), s)| ((x - y) / s).abs())
        .fold(0.0, f64::max);
    worst / most
}

fn agree(name: &str, system: &System<Planar>, state: &State, tolerance: f64) -> Accelerations {
    let mut ws = evaluated(system, state);
    let scale = column_scale(system);
    let unique = RowSpace::new(&system.dense_jacobian(&ws), &scale)
        .unwrap()
        .unique;
    let reference = Formulation::AugmentedDense.solve(system, &mut ws).unwrap();
    let most = reference.lambda.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for formulation in formulations() {
        let found = formulation
            .solve(system, &mut ws)
            .unwrap_or_else(|e| panic!("{name}, {formulation:?}: {e}"));
        let d = difference(&reference.a, &found.a, &scale);
        assert!(
            d <= tolerance,
            "{name}, {formulation:?}: accelerations differ by {d:e}"
        );
        assert!(
            found.residual < 1e-9,
            "{name}, {formulation:?}: residual {:e}",
            found.residual
        );
        for (row, (x, y)) in reference.lambda.iter().zip(&found.lambda).enumerate() {
            let open = !unique[row] && formulation == Formulation::Augmented;
            assert!(
                open || (x - y).abs() <= tolerance * most,
                "{name}, {formulation:?}: {} has {x} and {y}",
                system.row_name(row)
            );
        }
    }
    reference
}

#[test]
fn formulations_agree_on_many_machines() {
    for (name, model) in machines::all() {
        let (system, state) = assembled(model);
        agree(&name, &system, &state, 1e-12);
    }
}

#[test]
fn andrews_mechanism_starts_with_the_published_accelerations() {
    let (system, state) = assembled(machines::andrews());
    let found = agree("Andrews", &system, &state, 1e-12);
    // beta is the angle of K1, Theta that of K2 from K1.
    let (beta, theta) = (found.a[2], found.a[5] - found.a[2]);
    // The assembled pose is good to rounding, which the accelerations magnify.
    assert!(
        (beta / 14_222.443_919_954_114 - 1.0).abs() < 1e-11,
        "{beta}"
    );
    assert!(
        (theta / -10_666.832_939_965_585 - 1.0).abs() < 1e-11,
        "{theta}"
    );
}

#[test]
fn motions_without_mass_are_named() {
    let mut model = machines::double_parallelogram();
    model["joint"].as_array_mut().unwrap().remove(5);
    model["body"][2]["mass"] = serde_json::json!(0.0);
    model["body"][2]["inertia"] = serde_json::json!(0.0);
    let (system, state) = assembled(model);
    let mut ws = evaluated(&system, &state);
    for formulation in formulations() {
        let found = formulation.solve(&system, &mut ws);
        // The third rocker turns freely: body 2, coordinates 6 to 8.
        assert_eq!(
            found,
            Err(FormulationError::Massless {
                coordinates: vec![6, 7, 8]
            }),
            "{formulation:?}"
        );
    }
}

#[test]
fn values_that_are_not_finite_are_refused() {
    let (system, mut state) = assembled(machines::double_parallelogram());
    state.v[2] = f64::INFINITY;
    let mut ws = evaluated(&system, &state);
    for formulation in formulations() {
        assert!(
            formulation.solve(&system, &mut ws).is_err(),
            "{formulation:?}"
        );
    }
}

#[test]
fn embedding_gives_consistent_terms() {
    for (name, model) in machines::all() {
        let (system, state) = assembled(model);
        let ws = evaluated(&system, &state);
        let terms = Terms::of(&system, &ws);
        for basis in [Basis::default(), Basis::Qr, Basis::Svd] {
            let e = dalembert::formulation::embedding(&terms, &basis).unwrap();
            let c = &terms.jacobian;
            assert!(
                (c * &e.motion.b).amax() < 1e-13 * c.amax() * e.motion.b.amax(),
                "{name}"
            );
            let rest = c * &e.gamma - &terms.qd;
            assert!(
                rest.amax() <= 1e-12 * terms.qd.amax().max(1e-3),
                "{name} {basis:?} {:e}",
                rest.amax()
            );
            // A velocity that the constraints allow is found again from its independent part.
            let ct = nalgebra::DVector::from_column_slice(&ws.time);
            let g = e.motion.particular(&-ct);
            let v = nalgebra::DVector::from_column_slice(&state.v);
            let u = e.motion.independent_velocities(&v, &terms.column_scale);
            let again = &e.motion.b * u + g;
            assert!((again - &v).amax() < 1e-11 * v.amax(), "{name} {basis:?}");
        }
    }
}
