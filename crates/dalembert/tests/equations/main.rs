//! The written equations against examples of A. A. Shabana, *Computational Dynamics* (2nd edition, 2001). Numbers that
//! the book gives as symbols only were computed for these data from its formulas, with misprints corrected.

mod chapter_3;
mod chapter_4;
mod chapter_5;
mod chapter_6;
mod chapter_7;
mod chapter_7_problems;
#[path = "../support/mod.rs"]
mod support;

use dalembert::analysis::AnalysisError;
use dalembert::analysis::equations::{
    EquationBasis, Equations, EquationsReport, LabelledMatrix, LabelledVector, ReferenceFrame,
};
use nalgebra::{DMatrix, DVector};
use serde_json::{Value, json};
use support::{compiled, pin, rod};

/// The equations at the estimates of the model, as they stand.
fn at_estimate(model: Value, equations: &Equations) -> EquationsReport {
    let system = compiled(model).system.running();
    let state = system.estimate.clone();
    equations.run(&system, &state).unwrap()
}

/// The equations at the assembled start.
fn at_start(model: Value, equations: &Equations) -> EquationsReport {
    let (system, state) = support::assembled(model);
    equations.run(&system, &state).unwrap()
}

fn independent(names: &[&str]) -> Equations {
    Equations {
        independent: names.iter().map(|n| (*n).to_owned()).collect(),
        ..Equations::default()
    }
}

fn no_gravity(mut model: Value) -> Value {
    model["model"] = json!({"name": "test", "gravity": [0, 0]});
    model
}

fn dense(m: &LabelledMatrix) -> DMatrix<f64> {
    DMatrix::from_fn(m.rows.len(), m.columns.len(), |i, j| m.values[i][j])
}

fn vector(v: &LabelledVector) -> DVector<f64> {
    DVector::from_column_slice(&v.values)
}

/// Equal up to a part of the largest expected value.
#[track_caller]
fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let most = expected
        .iter()
        .fold(0.0_f64, |m, x| m.max(x.abs()))
        .max(1e-300);
    for (k, (x, y)) in found.iter().zip(expected).enumerate() {
        assert!(
            (x - y).abs() <= tolerance * most,
            "entry {k}: {x} for {y}\n{found:?}\n{expected:?}"
        );
    }
}

#[track_caller]
fn near_rows(found: &LabelledMatrix, expected: &[&[f64]], tolerance: f64) {
    let expected: Vec<f64> = expected.iter().flat_map(|r| r.iter().copied()).collect();
    near(&found.values.concat(), &expected, tolerance);
}

fn accelerations(r: &EquationsReport) -> &[f64] {
    &r.accelerations.as_ref().unwrap().values
}

fn multipliers(r: &EquationsReport) -> &[f64] {
    &r.multipliers.as_ref().unwrap().values
}

// Rounding of a few operations on numbers of one size.
const EXACT: f64 = 1e-14;
// Solutions of well conditioned systems of up to some 20 unknowns.
const SOLVED: f64 = 1e-12;

/// The user's frames and central frames describe one motion.
#[test]
fn both_frames_describe_the_same_motion() {
    for (name, model) in support::machines::all() {
        let (system, state) = support::assembled(model);
        let user = Equations::default().run(&system, &state).unwrap();
        let center = Equations {
            frame: ReferenceFrame::Center,
            ..Equations::default()
        }
        .run(&system, &state)
        .unwrap();
        near(multipliers(&user), multipliers(&center), SOLVED);
        let (s, c) = (&user.scalars, &center.scalars);
        near(
            &[s.kinetic, s.potential, s.gibbs_appel.unwrap()],
            &[c.kinetic, c.potential, c.gibbs_appel.unwrap()],
            SOLVED,
        );
        let (a, b) = (accelerations(&user), accelerations(&center));
        for (k, body) in system.bodies.iter().enumerate() {
            near(&[a[3 * k + 2]], &[b[3 * k + 2]], 1e-11);
            // Acceleration of the centre seen from the user's origin.
            let q = state.q[3 * k + 2];
            let d = -body.frame.at;
            let arm = [q.cos() * d.x - q.sin() * d.y, q.sin() * d.x + q.cos() * d.y];
            let (w2, alpha) = (state.v[3 * k + 2].powi(2), a[3 * k + 2]);
            let x = a[3 * k] - alpha * arm[1] - w2 * arm[0];
            let y = a[3 * k + 1] + alpha * arm[0] - w2 * arm[1];
            let most = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            assert!(
                (x - b[3 * k]).abs() + (y - b[3 * k + 1]).abs() < 1e-11 * most,
                "{name}"
            );
        }
        // M a + C_q^T lambda = Q_e + Q_v and C_q a = Q_d in the user's coordinates.
        let a = DVector::from_column_slice(a);
        let right = vector(&user.applied) + vector(&user.centrifugal);
        let rest = dense(&user.mass) * &a
            + dense(&user.jacobian).transpose() * vector(user.multipliers.as_ref().unwrap())
            - &right;
        let inertia = (dense(&user.mass) * &a).amax().max(right.amax());
        assert!(rest.amax() < 1e-11 * inertia, "{name}: {:e}", rest.amax());
        assert!(
            (dense(&user.jacobian) * &a - vector(&user.qd)).amax() < 1e-11 * a.amax(),
            "{name}"
        );
    }
}

#[test]
fn unknown_coordinates_and_missing_masses_are_named() {
    let (system, state) = support::assembled(support::machines::double_parallelogram());
    let error = independent(&["coupler.angel"])
        .run(&system, &state)
        .unwrap_err();
    assert_eq!(
        error,
        AnalysisError::BadName {
            what: "independent coordinate",
            name: "coupler.angel".to_owned(),
            detail: "did you mean 'coupler.angle'?".to_owned()
        }
    );
    let body = json!([{"name": "ghost"}, {"name": "rod", "mass": 1.0, "inertia": 0.1}]);
    let r = at_estimate(json!({"body": body}), &Equations::default());
    assert_eq!(r.accelerations, None);
    assert!(
        r.notes
            .iter()
            .any(|n| n.contains("ghost.x, ghost.y, ghost.angle;")),
        "{:?}",
        r.notes
    );
    assert_eq!(r.independent.unwrap().accelerations, None);
    assert_eq!(r.mass.values[3][3], 1.0);
}

#[test]
fn values_that_are_not_finite_name_their_element() {
    let model = json!({
        "body": [{"name": "rod", "mass": 1.0, "inertia": 0.1, "position": [1.0, 0.0]}],
        "force": [{"name": "pull", "kind": "force", "body": "rod", "value": ["1 N / (rod.angle)", 0.0]}]
    });
    let system = compiled(model).system.running();
    let error = Equations::default()
        .run(&system, &system.estimate)
        .unwrap_err();
    assert!(
        matches!(&error, AnalysisError::NotFinite { element, .. } if element.contains("pull")),
        "{error}"
    );
}

#[test]
fn a_state_off_the_constraints_is_noted() {
    let (system, mut state) = support::assembled(support::machines::double_parallelogram());
    assert!(
        Equations::default()
            .run(&system, &state)
            .unwrap()
            .notes
            .iter()
            .all(|n| !n.contains("satisfy"))
    );
    state.q[0] += 0.01;
    state.v[1] += 0.5;
    let notes = Equations::default().run(&system, &state).unwrap().notes;
    assert!(
        notes
            .iter()
            .any(|n| n.contains("the state does not satisfy the constraints: A1 (revolute): x")),
        "{notes:?}"
    );
    assert!(
        notes
            .iter()
            .any(|n| n.contains("the velocities do not satisfy the constraints")),
        "{notes:?}"
    );
}

#[test]
fn the_text_is_aligned_and_the_json_is_complete() {
    let (system, state) = support::assembled(support::machines::double_parallelogram());
    let r = Equations::default().run(&system, &state).unwrap();
    let text = r.to_text();
    for title in [
        "Mass matrix M",
        "Jacobian C_q",
        "Mbar = B^T M B",
        "Scalars",
        "Constraints",
    ] {
        assert!(text.contains(title), "{title}\n{text}");
    }
    assert!(
        text.lines().all(|line| line.chars().count() <= 120
            || line.starts_with("note:")
            || line.contains("dependent:")),
        "{text}"
    );
    // Every line of a block of the Jacobian ends at the same column.
    let block: Vec<usize> = text
        .lines()
        .skip_while(|l| *l != "Jacobian C_q")
        .skip(1)
        .take(13)
        .map(|l| l.chars().count())
        .collect();
    assert!(block.iter().all(|n| n == &block[0]), "{block:?}\n{text}");
    let json = serde_json::to_value(&r).unwrap();
    assert_eq!(json["jacobian"]["rows"][0], "A1 (revolute): x");
    assert_eq!(json["jacobian"]["columns"][2], "r1.angle");
    assert_eq!(json["independent"]["basis"], "partition");
    assert_eq!(json["frame"], "user");
}
