//! Regular saddle systems against dense LU.

use crate::problem::{PlanarRevolute, Problem, chain, relative};
use crate::random::Random;
use dalembert::solve::{ElementShape, SaddleShape};

/// A random connected graph: a tree of elements plus a few loops, with as many rows as leave freedom.
fn random_shape(bodies: usize, dof: usize, loops: usize, random: &mut Random) -> SaddleShape {
    let mut elements = Vec::new();
    for body in 0..bodies {
        let mut on = vec![body];
        if body > 0 && random.below(4) > 0 {
            on.push(random.below(body));
        }
        let rows = 1 + random.below(dof - 1);
        let aux = if random.below(3) == 0 {
            random.below(rows)
        } else {
            0
        };
        elements.push(ElementShape {
            rows,
            bodies: on.into_iter().collect(),
            aux,
        });
    }
    for _ in 0..loops {
        let (first, second) = (random.below(bodies), random.below(bodies - 1));
        let second = if second >= first { second + 1 } else { second };
        elements.push(ElementShape {
            rows: 1,
            bodies: [first, second].into_iter().collect(),
            aux: 0,
        });
    }
    SaddleShape {
        bodies,
        dof,
        elements,
    }
}

#[test]
fn random_systems_agree_with_dense_lu() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let dof = [2, 3, 6][random.below(3)];
        let bodies = 2 + random.below(12);
        let loops = random.below(2);
        let shape = random_shape(bodies, dof, loops, &mut random);
        let problem = Problem::random(shape, &mut random);
        let (k, rhs) = problem.dense();
        let condition = {
            let values = k.clone().svd(false, false).singular_values;
            values.max() / values.min()
        };
        if condition > 1e4 {
            continue;
        }
        let right = k.lu().solve(&rhs).unwrap();
        let mut saddle = problem.factored();
        assert!(saddle.factored().vanished.is_empty());
        assert!(saddle.factored().zero.is_empty());
        let answer = problem.solve_with(&mut saddle);
        assert!(answer.residual.converged, "{:?}", answer.residual);
        let (n, m) = (answer.a.len(), answer.l.len());
        let found = rhs.len();
        let mut all = nalgebra::DVector::zeros(found);
        all.rows_mut(0, n).copy_from(&answer.a);
        all.rows_mut(n, m).copy_from(&answer.l);
        all.rows_mut(n + m, found - n - m).copy_from(&answer.s);
        let error = relative(&all, &right);
        assert!(error < 1e-11, "error {error:e}, condition {condition:e}");
    }
}

#[test]
fn at_least_half_of_the_random_systems_are_compared() {
    let compared = (0..60)
        .filter(|&seed| {
            let mut random = Random::new(seed);
            let dof = [2, 3, 6][random.below(3)];
            let bodies = 2 + random.below(12);
            let loops = random.below(2);
            let shape = random_shape(bodies, dof, loops, &mut random);
            let values = Problem::random(shape, &mut random)
                .dense()
                .0
                .svd(false, false)
                .singular_values;
            values.max() / values.min() <= 1e4
        })
        .count();
    assert!(compared >= 30, "{compared}");
}

#[test]
fn chain_agrees_with_dense_lu() {
    let problem = chain(40);
    let (k, rhs) = problem.dense();
    let right = k.lu().solve(&rhs).unwrap();
    let answer = problem.solve_with(&mut problem.factored());
    assert!(answer.residual.converged, "{:?}", answer.residual);
    assert!(relative(&answer.a, &right.rows(0, 120).into_owned()) < 1e-11);
    assert!(relative(&answer.l, &right.rows(120, 80).into_owned()) < 1e-11);
}

#[test]
fn long_chain_meets_its_equations_and_fills_linearly() {
    let problem = chain(3000);
    let mut saddle = problem.factored();
    assert!(saddle.factored().vanished.is_empty());
    let answer = problem.solve_with(&mut saddle);
    assert!(answer.residual.converged, "{:?}", answer.residual);
    let mut ja = vec![0.0; 6000];
    saddle.j_mul(answer.a.as_slice(), &mut ja);
    let largest = answer.a.amax();
    assert!(ja.iter().all(|value| value.abs() < 1e-12 * largest));
    // One 2 x 2 diagonal block a bar, and one block between neighbours: no fill at all.
    assert_eq!(saddle.factor_len(), 4 * 3000 + 4 * 2999);
}

#[test]
fn rounding_of_large_joint_forces_is_not_refined_in_vain() {
    // A long stretched chain that spins: the forces of neighbouring joints cancel on each bar but for a part of 1e-4.
    // A sweep would cost a third of the whole evaluation and gain nothing.
    let bars = 4000;
    let bodies = vec![(1.0, 1.0 / 12.0, 0.0); bars];
    let joints: Vec<_> = (0..bars)
        .map(|j| PlanarRevolute {
            i: j.checked_sub(1),
            at_i: (0.5, 0.0),
            j: Some(j),
            at_j: (-0.5, 0.0),
        })
        .collect();
    let mut problem = Problem::planar(&bodies, &joints);
    for (k, g) in problem.g.iter_mut().enumerate() {
        *g = if k % 2 == 0 { 1.0 } else { 0.0 };
    }
    let answer = problem.solve_with(&mut problem.factored());
    assert_eq!(answer.residual.sweeps, 0, "{:?}", answer.residual);
    assert!(answer.residual.converged, "{:?}", answer.residual);
    // What is left is rounding of the largest force.
    let bound = 1e-15 * answer.l.amax() / problem.f.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
    assert!(
        answer.residual.relative < bound,
        "{:?} {bound}",
        answer.residual
    );
}

#[test]
fn a_repeated_body_and_a_ground_body_are_understood() {
    let mut random = Random::new(5);
    let elements = vec![
        ElementShape {
            rows: 2,
            bodies: [0, 0].into_iter().collect(),
            aux: 0,
        },
        ElementShape {
            rows: 1,
            bodies: [1, 99, 0].into_iter().collect(),
            aux: 0,
        },
    ];
    let problem = Problem::random(
        SaddleShape {
            bodies: 2,
            dof: 3,
            elements,
        },
        &mut random,
    );
    let (k, rhs) = problem.dense();
    let right = k.lu().solve(&rhs).unwrap();
    let answer = problem.solve_with(&mut problem.factored());
    assert!(relative(&answer.a, &right.rows(0, 6).into_owned()) < 1e-12);
    assert!(relative(&answer.l, &right.rows(6, 3).into_owned()) < 1e-12);
}

#[test]
fn products_with_the_jacobian_agree_with_the_dense_ones() {
    let mut random = Random::new(11);
    let shape = random_shape(6, 6, 2, &mut random);
    let problem = Problem::random(shape, &mut random);
    let saddle = problem.factored();
    let jac = problem.dense_jac();
    let v = random.values(problem.pattern.coordinates());
    let l = random.values(problem.pattern.rows());
    let mut jv = vec![7.0; l.len()];
    saddle.j_mul(&v, &mut jv);
    assert!(relative(&jv.into(), &(&jac * nalgebra::DVector::from_vec(v.clone()))) < 1e-14);
    let mut jtl = v.clone();
    saddle.jt_mul(&l, &mut jtl);
    let right = nalgebra::DVector::from_vec(v) + jac.transpose() * nalgebra::DVector::from_vec(l);
    assert!(relative(&jtl.into(), &right) < 1e-14);
}

#[test]
fn an_empty_system_has_an_empty_answer() {
    let problem = Problem::random(SaddleShape::default(), &mut Random::new(1));
    let answer = problem.solve_with(&mut problem.factored());
    assert!(answer.residual.converged);
    assert_eq!(answer.a.len() + answer.l.len() + answer.s.len(), 0);
}

#[test]
fn a_free_body_obeys_newton() {
    let problem = Problem::random(
        SaddleShape {
            bodies: 3,
            dof: 6,
            elements: vec![],
        },
        &mut Random::new(3),
    );
    let answer = problem.solve_with(&mut problem.factored());
    let right = problem
        .dense_mass()
        .lu()
        .solve(&problem.f.clone().into())
        .unwrap();
    assert!(relative(&answer.a, &right) < 1e-12);
}

#[test]
fn numbers_that_are_not_finite_are_reported() {
    let mut problem = chain(3);
    problem.f[1] = f64::NAN;
    let answer = problem.solve_with(&mut problem.factored());
    assert!(!answer.residual.converged);
    assert_eq!(answer.residual.relative, f64::INFINITY);
}

#[test]
fn unequal_masses_do_not_look_like_dependence() {
    for (bars, ratio) in [(300, 1e-6), (300, 1e6), (2000, 1e3)] {
        let mut problem = chain(bars);
        for body in (1..bars).step_by(2) {
            for k in 0..9 {
                problem.mass[9 * body + k] *= ratio;
                problem.mass_inverse[9 * body + k] /= ratio;
            }
        }
        let mut saddle = problem.factored();
        assert!(
            saddle.factored().vanished.is_empty(),
            "{:e}",
            saddle.factored().smallest
        );
        let answer = problem.solve_with(&mut saddle);
        assert!(
            answer.residual.converged && answer.residual.relative < 1e-13,
            "{:?}",
            answer.residual
        );
    }
}

#[test]
fn a_body_with_many_elements_and_a_tree_of_bodies_are_solved() {
    let mut random = Random::new(77);
    // A hub with 40 arms, each arm with two more bodies.
    let mut elements = Vec::new();
    for arm in 0..40 {
        let first = 1 + 3 * arm;
        for on in [[0, first], [first, first + 1], [first, first + 2]] {
            elements.push(ElementShape {
                rows: 5,
                bodies: on.into_iter().collect(),
                aux: 0,
            });
        }
    }
    let problem = Problem::random(
        SaddleShape {
            bodies: 121,
            dof: 6,
            elements,
        },
        &mut random,
    );
    let mut saddle = problem.factored();
    assert!(saddle.factored().vanished.is_empty());
    let answer = problem.solve_with(&mut saddle);
    assert!(answer.residual.relative < 1e-13, "{:?}", answer.residual);
    let (k, rhs) = problem.dense();
    let right = k.lu().solve(&rhs).unwrap();
    assert!(relative(&answer.a, &right.rows(0, 726).into_owned()) < 1e-10);
}
