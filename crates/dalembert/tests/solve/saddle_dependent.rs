//! Dependent and vanishing rows against the pseudo-inverse.

use crate::problem::{Problem, chain, double_parallelogram, relative};
use crate::random::Random;
use dalembert::solve::{ElementShape, Pattern, Saddle, SaddleShape};
use nalgebra::{DMatrix, DVector};

/// Accelerations and the multipliers that minimize the sum of `S_ii l_i^2`, from singular values.
fn pseudo(problem: &Problem) -> (DVector<f64>, DVector<f64>) {
    let jac = problem.dense_jac();
    let inverse = problem.dense_mass().try_inverse().unwrap();
    let s = &jac * &inverse * jac.transpose();
    let weight = DVector::from_fn(s.nrows(), |i, _| {
        if s[(i, i)] > 0.0 {
            s[(i, i)].sqrt().recip()
        } else {
            0.0
        }
    });
    let scaled = DMatrix::from_diagonal(&weight) * &s * DMatrix::from_diagonal(&weight);
    let f = DVector::from_vec(problem.f.clone());
    let rhs = &jac * &inverse * &f - DVector::from_vec(problem.g.clone());
    let l = scaled.pseudo_inverse(1e-11).unwrap() * rhs.component_mul(&weight);
    let l = l.component_mul(&weight);
    let a = inverse * (f - jac.transpose() * &l);
    (a, l)
}

#[test]
fn double_parallelogram_has_one_redundant_row_and_right_accelerations() {
    for angle in [0.3, 1.0, 1.5, 2.5] {
        let problem = double_parallelogram(angle);
        let mut saddle = problem.factored();
        let report = saddle.factored();
        assert_eq!(
            (report.vanished.len(), report.zero.len(), report.rank()),
            (1, 0, 11),
            "{report:?}"
        );
        let answer = problem.solve_with(&mut saddle);
        assert!(answer.residual.converged, "{:?}", answer.residual);
        let (a, l) = pseudo(&problem);
        println!(
            "{angle}: a {:e} l {:e} {:?}",
            relative(&answer.a, &a),
            relative(&answer.l, &l),
            answer.residual
        );
        assert!(
            relative(&answer.a, &a) < 1e-12,
            "{:e}",
            relative(&answer.a, &a)
        );
        assert!(
            relative(&answer.l, &l) < 1e-6,
            "{:e}",
            relative(&answer.l, &l)
        );
    }
}

#[test]
fn flat_parallelogram_still_has_finite_right_accelerations() {
    // All bars in one line: two rows vanish, because the mechanism may leave the pose on two branches.
    let mut problem = double_parallelogram(0.0);
    // A consistent right-hand side: the rows applied to some accelerations.
    let some = DVector::from_fn(12, |i, _| (i as f64 * 1.3).sin());
    problem.g = (problem.dense_jac() * some).as_slice().to_vec();
    let mut saddle = problem.factored();
    assert!(
        saddle.factored().vanished.len() >= 2,
        "{:?}",
        saddle.factored()
    );
    let answer = problem.solve_with(&mut saddle);
    assert!(answer.residual.converged, "{:?}", answer.residual);
    let (a, _) = pseudo(&problem);
    assert!(
        relative(&answer.a, &a) < 1e-11,
        "{:e}",
        relative(&answer.a, &a)
    );
}

#[test]
fn random_dependent_rows_agree_with_the_pseudo_inverse() {
    for seed in 100..130 {
        let mut random = Random::new(seed);
        let bodies = 3 + random.below(5);
        // Twice the same joint between neighbours, with mixed rows; every second copy is redundant.
        let mut elements = Vec::new();
        for body in 0..bodies {
            let on: Vec<usize> = (body.saturating_sub(1)..=body).collect();
            for _ in 0..2 {
                elements.push(ElementShape {
                    rows: 2,
                    bodies: on.iter().copied().collect(),
                    aux: 0,
                });
            }
        }
        let mut problem = Problem::random(
            SaddleShape {
                bodies,
                dof: 6,
                elements,
            },
            &mut random,
        );
        for pair in 0..bodies {
            let from = problem.pattern.jac_offset(2 * pair, 0);
            let to = problem.pattern.jac_offset(2 * pair + 1, 0);
            let mix = random.values(4);
            let blocks = problem.pattern.shape().elements[2 * pair].bodies.len();
            for c in 0..blocks {
                for k in 0..6 {
                    let at = from + c * 12 + k;
                    let rows = [problem.jac[at], problem.jac[at + 6]];
                    problem.jac[to + c * 12 + k] = mix[0] * rows[0] + mix[1] * rows[1];
                    problem.jac[to + c * 12 + k + 6] =
                        100.0 * (mix[2] * rows[0] + mix[3] * rows[1]);
                }
            }
        }
        let some = DVector::from_vec(random.values(6 * bodies));
        problem.g = (problem.dense_jac() * some).as_slice().to_vec();
        let mut saddle = problem.factored();
        assert_eq!(
            saddle.factored().vanished.len(),
            2 * bodies,
            "{:?}",
            saddle.factored()
        );
        let answer = problem.solve_with(&mut saddle);
        assert!(answer.residual.converged, "{:?}", answer.residual);
        let (a, l) = pseudo(&problem);
        println!(
            "a {:e} l {:e} {:?}",
            relative(&answer.a, &a),
            relative(&answer.l, &l),
            answer.residual
        );
        assert!(
            relative(&answer.a, &a) < 1e-11,
            "{:e}",
            relative(&answer.a, &a)
        );
        assert!(
            relative(&answer.l, &l) < 1e-6,
            "{:e}",
            relative(&answer.l, &l)
        );
    }
}

#[test]
fn rows_without_gradient_are_reported_and_harmless() {
    let mut problem = chain(5);
    let right = problem.solve_with(&mut problem.factored());
    let mut elements = problem.pattern.shape().elements.clone();
    elements.push(ElementShape {
        rows: 1,
        bodies: [1, 3].into_iter().collect(),
        aux: 0,
    });
    let (mass, inverse, mut jac, f) = (problem.mass, problem.mass_inverse, problem.jac, problem.f);
    jac.extend([0.0; 6]);
    problem = Problem::random(
        SaddleShape {
            bodies: 5,
            dof: 3,
            elements,
        },
        &mut Random::new(0),
    );
    (problem.mass, problem.mass_inverse, problem.jac, problem.f) = (mass, inverse, jac, f);
    problem.g = vec![0.0; 11];
    let mut saddle = problem.factored();
    assert_eq!(saddle.factored().zero, [10]);
    assert!(saddle.factored().vanished.is_empty());
    let answer = problem.solve_with(&mut saddle);
    assert!(answer.residual.converged);
    assert!(relative(&answer.a, &right.a) < 1e-13);
    assert_eq!(answer.l[10], 0.0);
}

#[test]
fn contradicting_rows_are_not_called_solved() {
    let mut problem = double_parallelogram(1.0);
    problem.g = (0..12).map(|i| (i as f64).cos()).collect();
    let mut saddle = problem.factored();
    let answer = problem.solve_with(&mut saddle);
    assert!(!answer.residual.converged);
    assert!(
        answer
            .a
            .iter()
            .chain(answer.l.iter())
            .all(|value| value.is_finite())
    );
}

#[test]
fn an_auxiliary_with_a_vanishing_gradient_leaves_a_plain_row() {
    let mut random = Random::new(17);
    let elements = vec![
        ElementShape {
            rows: 3,
            bodies: [0, 1].into_iter().collect(),
            aux: 2,
        },
        ElementShape {
            rows: 2,
            bodies: [1].into_iter().collect(),
            aux: 0,
        },
    ];
    let mut problem = Problem::random(
        SaddleShape {
            bodies: 2,
            dof: 3,
            elements,
        },
        &mut random,
    );
    for i in 0..3 {
        problem.jac_aux[2 * i + 1] = -2.0 * problem.jac_aux[2 * i];
    }
    problem.h = vec![0.4, -0.8];
    let answer = problem.solve_with(&mut problem.factored());
    assert!(answer.residual.converged, "{:?}", answer.residual);
    let (k, rhs) = problem.dense();
    let right = k.pseudo_inverse(1e-11).unwrap() * rhs;
    assert!(relative(&answer.a, &right.rows(0, 6).into_owned()) < 1e-11);
    assert!(relative(&answer.l, &right.rows(6, 5).into_owned()) < 1e-11);
}

#[test]
fn auxiliaries_stay_exact_where_their_body_has_one_freedom() {
    // Body 0 turns about a pin; a three-row contact with two surface parameters takes its last freedom.
    let mut random = Random::new(23);
    let elements = vec![
        ElementShape {
            rows: 2,
            bodies: [0].into_iter().collect(),
            aux: 0,
        },
        ElementShape {
            rows: 3,
            bodies: [0].into_iter().collect(),
            aux: 2,
        },
    ];
    let problem = Problem::random(
        SaddleShape {
            bodies: 1,
            dof: 3,
            elements,
        },
        &mut random,
    );
    let (k, rhs) = problem.dense();
    let right = k.lu().solve(&rhs).unwrap();
    let mut saddle = problem.factored();
    assert!(saddle.factored().vanished.is_empty());
    let answer = problem.solve_with(&mut saddle);
    assert!(answer.residual.converged, "{:?}", answer.residual);
    assert!(relative(&answer.l, &right.rows(3, 5).into_owned()) < 1e-11);
    assert!(relative(&answer.s, &right.rows(8, 2).into_owned()) < 1e-11);
}

/// A chain with every joint stated twice, the second time in other units; light and heavy bars alternate.
fn doubled_chain(bars: usize, ratio: f64) -> Problem {
    let plain = chain(bars);
    let mut elements = plain.pattern.shape().elements.clone();
    elements.extend(plain.pattern.shape().elements.clone());
    let mut problem = Problem {
        pattern: Pattern::new(SaddleShape {
            bodies: bars,
            dof: 3,
            elements,
        }),
        ..plain
    };
    let again: Vec<f64> = problem.jac.iter().map(|value| value * 1000.0).collect();
    problem.jac.extend(again);
    let some: Vec<f64> = (0..3 * bars).map(|i| (i as f64 * 1.3).sin()).collect();
    problem.g = vec![0.0; 4 * bars];
    problem.pattern.j_mul(&problem.jac, &some, &mut problem.g);
    for body in (1..bars).step_by(2) {
        for k in 0..9 {
            problem.mass[9 * body + k] *= ratio;
            problem.mass_inverse[9 * body + k] /= ratio;
        }
        for k in 0..3 {
            problem.f[3 * body + k] *= ratio;
        }
    }
    problem
}

#[test]
fn long_doubled_chains_converge() {
    for (bars, ratio) in [
        (30, 1.0),
        (30, 1e-6),
        (30, 1e6),
        (300, 1.0),
        (300, 1e4),
        (3000, 1.0),
    ] {
        let problem = doubled_chain(bars, ratio);
        let mut saddle = problem.factored();
        assert_eq!(saddle.factored().vanished.len(), 2 * bars);
        let answer = problem.solve_with(&mut saddle);
        println!("bars {bars}, mass ratio {ratio}: {:?}", answer.residual);
        assert!(answer.residual.converged, "{:?}", answer.residual);
        if bars <= 30 && ratio == 1.0 {
            let (a, l) = pseudo(&problem);
            println!(
                "a {:e} l {:e}",
                relative(&answer.a, &a),
                relative(&answer.l, &l)
            );
            assert!(relative(&answer.a, &a) < 1e-13);
            assert!(relative(&answer.l, &l) < 1e-6);
        }
    }
}

#[test]
fn near_a_flat_pose_accelerations_stay_finite_and_meet_the_rows() {
    // The gradients of the closing rows turn into each other as the angle goes to zero.
    for exponent in 1..=12 {
        let mut problem = double_parallelogram(10.0_f64.powi(-exponent));
        let some: Vec<f64> = (0..12).map(|i| (i as f64 * 1.3).sin()).collect();
        let mut g = vec![0.0; 12];
        problem.pattern.j_mul(&problem.jac, &some, &mut g);
        problem.g = g;
        let mut saddle = problem.factored();
        let vanished = saddle.factored().vanished.len();
        let answer = problem.solve_with(&mut saddle);
        println!(
            "1e-{exponent}: {vanished} {:?} {:e}",
            answer.residual,
            answer.a.amax()
        );
        // Below an angle of 3e-6 the rows count as dependent, and this right-hand side contradicts them a little.
        let limit = if exponent < 6 { 1e-12 } else { 1e-7 };
        assert!(answer.residual.relative <= limit, "{:?}", answer.residual);
        assert_eq!(vanished, if exponent < 6 { 1 } else { 2 });
        assert!(
            answer.a.amax() < 1e4 && answer.l.iter().all(|l| l.is_finite()),
            "{:e}",
            answer.a.amax()
        );
    }
}

#[test]
fn a_loose_tolerance_forgives_loose_positions() {
    // One rocker is off by 1e-4: to the usual tolerance the mechanism locks, to a loose one it moves.
    let mut problem = double_parallelogram(1.0);
    let (s, c) = 1.0001_f64.sin_cos();
    for (joint, x) in [(2, -0.25), (5, 0.25)] {
        let sign = if joint == 2 { -1.0 } else { 1.0 };
        let at = problem.pattern.jac_offset(joint, 0);
        problem.jac[at + 2] = sign * -s * x;
        problem.jac[at + 5] = sign * c * x;
    }
    let shape = problem.pattern.shape().clone();
    let mut strict = Saddle::new(shape.clone());
    assert_eq!(
        strict
            .factor(&problem.mass_inverse, &problem.jac, &[])
            .rank(),
        12
    );
    let mut loose = Saddle::new(shape).with_tolerance(1e-7);
    assert_eq!(
        loose
            .factor(&problem.mass_inverse, &problem.jac, &[])
            .rank(),
        11
    );
}
