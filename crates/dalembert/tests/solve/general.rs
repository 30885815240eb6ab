//! Systems with massless bodies.

use crate::problem::{Problem, chain, double_parallelogram, relative};
use crate::random::Random;
use dalembert::solve::{ElementShape, Rhs, SaddleShape, SingularKkt, solve_general};

fn solve(problem: &Problem) -> Result<dalembert::solve::GeneralSolution, SingularKkt> {
    let rhs = Rhs {
        f: &problem.f,
        g: &problem.g,
        h: &problem.h,
    };
    solve_general(
        problem.pattern.shape().clone(),
        &problem.mass,
        &problem.jac,
        &problem.jac_aux,
        rhs,
    )
}

#[test]
fn with_masses_it_agrees_with_the_sparse_solver() {
    let mut random = Random::new(31);
    let elements = vec![
        ElementShape {
            rows: 3,
            bodies: [0, 1].into_iter().collect(),
            aux: 1,
        },
        ElementShape {
            rows: 2,
            bodies: [1, 2].into_iter().collect(),
            aux: 0,
        },
    ];
    let problem = Problem::random(
        SaddleShape {
            bodies: 3,
            dof: 3,
            elements,
        },
        &mut random,
    );
    let answer = problem.solve_with(&mut problem.factored());
    let general = solve(&problem).unwrap();
    assert_eq!(general.redundant, 0);
    assert!(general.residual < 1e-14);
    assert!(relative(&general.a.into(), &answer.a) < 1e-12);
    assert!(relative(&general.l.into(), &answer.l) < 1e-12);
    assert!(relative(&general.s.into(), &answer.s) < 1e-12);
}

#[test]
fn a_massless_link_between_masses_is_solved() {
    // Bar 1 of a chain of three weighs nothing, but both its ends are held; its own angle is given by the rows.
    let mut problem = chain(3);
    problem.mass[9..18].fill(0.0);
    problem.f[3..6].fill(0.0);
    let general = solve(&problem).unwrap();
    assert!(general.residual < 1e-14);
    let (k, rhs) = problem.dense();
    let right = k.lu().solve(&rhs).unwrap();
    assert!(relative(&general.a.into(), &right.rows(0, 9).into_owned()) < 1e-11);
    assert!(relative(&general.l.into(), &right.rows(9, 6).into_owned()) < 1e-11);
}

#[test]
fn a_massless_bar_that_may_turn_freely_is_named() {
    // The last bar of a chain without mass: its angle and its end move freely together.
    let mut problem = chain(2);
    problem.mass[9..18].fill(0.0);
    problem.f[3..6].fill(0.0);
    let Err(SingularKkt::FreeCoordinates { motions }) = solve(&problem) else {
        panic!("not singular")
    };
    assert_eq!(motions.len(), 1);
    let coordinates: Vec<usize> = motions[0]
        .coordinates
        .iter()
        .map(|(coordinate, _)| *coordinate)
        .collect();
    assert_eq!(coordinates, [3, 4, 5]);
    // The motion satisfies the rows: it is a turn about the pin.
    let mut v = vec![0.0; 6];
    for &(coordinate, part) in &motions[0].coordinates {
        v[coordinate] = part;
    }
    let jv = problem.dense_jac() * nalgebra::DVector::from_vec(v);
    assert!(jv.norm() < 1e-13);
    assert_eq!(motions[0].coordinates[2].1, 1.0);
}

#[test]
fn redundant_rows_are_counted_and_accelerations_are_right() {
    let problem = double_parallelogram(1.0);
    let general = solve(&problem).unwrap();
    assert_eq!(general.redundant, 1);
    let answer = problem.solve_with(&mut problem.factored());
    assert!(relative(&general.a.into(), &answer.a) < 1e-12);
}

#[test]
fn contradicting_rows_are_refused() {
    let mut problem = double_parallelogram(1.0);
    problem.g = (0..12).map(|i| (i as f64).cos()).collect();
    assert!(
        matches!(solve(&problem), Err(SingularKkt::Inconsistent { residual }) if residual > 1e-3)
    );
}

#[test]
fn values_that_are_not_finite_are_refused() {
    let mut problem = chain(2);
    problem.jac[0] = f64::INFINITY;
    assert_eq!(solve(&problem), Err(SingularKkt::NotFinite));
}

#[test]
fn units_do_not_change_the_verdict() {
    // The same chain in millimetres and tonnes: rows and coordinates change their sizes, nothing else.
    let mut problem = chain(3);
    for value in problem.mass.iter_mut() {
        *value *= 1e-9;
    }
    for value in problem.f.iter_mut() {
        *value *= 1e-9;
    }
    let general = solve(&problem).unwrap();
    let right = chain(3);
    let answer = right.solve_with(&mut right.factored());
    assert!(relative(&general.a.into(), &answer.a) < 1e-12);
}

#[test]
fn an_empty_system_is_solved() {
    let general = solve(&Problem::random(
        SaddleShape::default(),
        &mut Random::new(2),
    ))
    .unwrap();
    assert_eq!(general.a.len() + general.l.len() + general.s.len(), 0);
}

#[test]
fn hilbert_matrix_is_inverted() {
    // Shabana, Computational Dynamics, section 2.6: the inverse of the Hilbert matrix of order 5 has whole entries.
    let inverse = [
        [25.0, -300.0, 1050.0, -1400.0, 630.0],
        [-300.0, 4800.0, -18900.0, 26880.0, -12600.0],
        [1050.0, -18900.0, 79380.0, -117600.0, 56700.0],
        [-1400.0, 26880.0, -117600.0, 179200.0, -88200.0],
        [630.0, -12600.0, 56700.0, -88200.0, 44100.0],
    ];
    let mass: Vec<f64> = (0..25).map(|k| 1.0 / (k / 5 + k % 5 + 1) as f64).collect();
    for (column, right) in inverse.iter().enumerate() {
        let mut f = [0.0; 5];
        f[column] = 1.0;
        let shape = SaddleShape {
            bodies: 1,
            dof: 5,
            elements: vec![],
        };
        let solution = solve_general(
            shape,
            &mass,
            &[],
            &[],
            Rhs {
                f: &f,
                g: &[],
                h: &[],
            },
        )
        .unwrap();
        for (a, right) in solution.a.iter().zip(right) {
            assert!(
                (a - right).abs() < 1e-11 * 476_607.0 * right.abs().min(1.0),
                "{a} {right}"
            );
        }
    }
}
