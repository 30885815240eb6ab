//! Rank, partitions and null bases, with numbers of the book and with pseudo-random matrices.

use crate::problem::{chain, double_parallelogram};
use crate::random::Random;
use dalembert::solve::{
    RankError, analyse_rows, continue_basis, independent_rows, null_basis_lu, null_basis_qr,
    null_basis_svd, partition, partition_condition, redundant_rows,
};
use nalgebra::{DMatrix, DVector};

const TOL: f64 = 1e-10;

fn matrix(rows: &[&[f64]]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

/// A matrix of given size and rank with mixed row sizes.
fn of_rank(m: usize, n: usize, rank: usize, random: &mut Random) -> DMatrix<f64> {
    let left = DMatrix::from_vec(m, rank, random.values(m * rank));
    let right = DMatrix::from_vec(rank, n, random.values(n * rank));
    let mut c = left * right;
    for (i, mut row) in c.row_iter_mut().enumerate() {
        row *= 10.0_f64.powi((i % 4) as i32);
    }
    c
}

fn largest(m: &DMatrix<f64>) -> f64 {
    m.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

#[test]
fn shabana_example_2_10_null_space_of_a_skew_matrix() {
    // Shabana, Computational Dynamics, example 2.10: a~ x = 0 with a = (-1, 7, 1).
    let a = [-1.0, 7.0, 1.0];
    let c = matrix(&[
        &[0.0, -a[2], a[1]],
        &[a[2], 0.0, -a[0]],
        &[-a[1], a[0], 0.0],
    ]);
    let rank = analyse_rows(&c, &[1.0; 3], TOL).unwrap();
    assert_eq!(rank.rank, 2);
    let x = rank.null_space.column(0) / rank.null_space[(0, 0)];
    assert!((x - DVector::from_vec(vec![1.0, -7.0, -1.0])).norm() < 1e-13);
    assert_eq!(rank.independent, [0, 1]);
    assert_eq!(rank.redundant[0].row, 2);
    // Row 2 = -(a1 row 0 + a2 row 1) / a3
    let depends = &rank.redundant[0].depends_on;
    assert!(
        (depends[0].1 - 1.0).abs() < 1e-13 && (depends[1].1 + 7.0).abs() < 1e-13,
        "{depends:?}"
    );
    assert_eq!(rank.unique, [false, false, false]);
}

#[test]
fn shabana_example_2_12_partition() {
    // Shabana, Computational Dynamics, example 2.12: rank 2; with x1 and x3 dependent, x_d = -V x_i.
    let c = matrix(&[
        &[1.0, 1.0, 0.0, 1.0, 4.0],
        &[2.0, 2.0, 2.0, 0.0, 1.0],
        &[3.0, 3.0, 2.0, 1.0, 5.0],
    ]);
    let rank = analyse_rows(&c, &[1.0; 5], TOL).unwrap();
    assert_eq!(
        (rank.rank, rank.redundant.len(), rank.redundant[0].row),
        (2, 1, 2)
    );
    let depends = &rank.redundant[0].depends_on;
    assert!(
        depends
            .iter()
            .all(|(_, coefficient)| (coefficient - 1.0).abs() < 1e-13),
        "{depends:?}"
    );

    let split = partition(&c, &[1.0; 5], &[]).unwrap();
    assert_eq!(
        (
            split.dependent.len(),
            split.independent.len(),
            split.rows.len()
        ),
        (2, 3, 2)
    );
    assert!(split.condition < 10.0);

    let split = partition(&c, &[1.0; 5], &[1, 3, 4]).unwrap();
    assert_eq!(
        (&split.dependent[..], &split.independent[..]),
        (&[0, 2][..], &[1, 3, 4][..])
    );
    assert!(split.refused.is_empty());
    let basis = null_basis_lu(&c, &[1.0; 5], &split).unwrap();
    let v = matrix(&[&[1.0, 1.0, 4.0], &[0.0, -1.0, -3.5]]);
    assert!(largest(&(basis.select_rows(&[0, 2]) + v)) < 1e-14);
    assert_eq!(basis.select_rows(&[1, 3, 4]), DMatrix::identity(3, 3));

    // x1 and x2 have the same column: one of them can be dependent, never both.
    let split = partition(&c, &[1.0; 5], &[0, 2, 3, 4]).unwrap();
    assert!(split.dependent.contains(&1));
    assert_eq!(split.refused.len(), 1);
}

#[test]
fn shabana_example_2_20_rank_and_left_null_vector() {
    // Shabana, Computational Dynamics, example 2.20: the third column of Q1 is (0, .7071, -.7071).
    let c = matrix(&[&[2.0, 1.0], &[1.0, 0.0], &[1.0, 0.0]]);
    let rank = analyse_rows(&c, &[1.0; 2], TOL).unwrap();
    assert_eq!(rank.rank, 2);
    assert_eq!(rank.independent, [0, 1]);
    assert_eq!(rank.unique, [true, false, false]);
    let left = rank.left_null_space.column(0) * rank.left_null_space[(1, 0)].signum();
    assert!((left - DVector::from_vec(vec![0.0, 0.5_f64.sqrt(), -0.5_f64.sqrt()])).norm() < 1e-14);
}

#[test]
fn hilbert_matrices_lose_rank_only_where_the_tolerance_says_so() {
    // Shabana, Computational Dynamics, section 2.6: regular for every order, hopeless in practice from about 12 on.
    let hilbert = |n: usize| DMatrix::from_fn(n, n, |i, j| 1.0 / (i + j + 1) as f64);
    for n in 3..=8 {
        let rank = analyse_rows(&hilbert(n), &vec![1.0; n], 1e-14).unwrap();
        assert_eq!(rank.rank, n, "order {n}");
    }
    let twelve = analyse_rows(&hilbert(12), &[1.0; 12], 1e-10).unwrap();
    assert!(twelve.rank < 12, "rank {} at 1e-10", twelve.rank);
    assert_eq!(twelve.independent.len(), twelve.rank);
}

#[test]
fn double_parallelogram_has_rank_eleven() {
    let problem = double_parallelogram(1.0);
    let jac = problem.dense_jac();
    let rank = analyse_rows(&jac, &[1.0; 12], TOL).unwrap();
    assert_eq!(
        (rank.rank, rank.redundant.len(), rank.null_space.ncols()),
        (11, 1, 1)
    );
    assert!(
        rank.gap < 1e-13 && rank.condition < 100.0 && rank.in_order,
        "{} {}",
        rank.gap,
        rank.condition
    );
    assert!(largest(&(&jac * &rank.null_space)) < 1e-14);
    assert!(largest(&(rank.left_null_space.transpose() * &jac)) < 1e-14);
    // The rockers move alike, the coupler is only translated.
    let motion = rank.null_space.column(0);
    assert!((motion[2] - motion[5]).abs() < 1e-13 && (motion[2] - motion[8]).abs() < 1e-13);
    assert!(motion[11].abs() < 1e-13);
    // The dependence is stated by the rows themselves.
    let found = &rank.redundant[0];
    let mut sum = jac.row(found.row).into_owned();
    for (row, coefficient) in &found.depends_on {
        sum -= jac.row(*row) * *coefficient;
    }
    assert!(sum.norm() < 1e-13);
    // The sparse factorization agrees about the number.
    assert_eq!(redundant_rows(&problem.factored().factored()).len(), 1);
}

#[test]
fn every_basis_is_annihilated_and_spans_the_same_motions() {
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let n = 4 + random.below(10);
        let rank = 1 + random.below(n - 1);
        let m = rank + random.below(4);
        let c = of_rank(m, n, rank, &mut random);
        let scale: Vec<f64> = (0..n).map(|i| [1.0, 0.05, 20.0][i % 3]).collect();
        let split = partition(&c, &scale, &[]).unwrap();
        assert_eq!(split.dependent.len(), rank);
        let bases = [
            null_basis_lu(&c, &scale, &split).unwrap(),
            null_basis_qr(&c, &scale, TOL).unwrap(),
            null_basis_svd(&c, &scale, TOL).unwrap(),
        ];
        let unscale =
            DMatrix::from_diagonal(&DVector::from_vec(scale.iter().map(|s| 1.0 / s).collect()));
        let plain = c.clone() * unscale.clone().try_inverse().unwrap();
        let reference = &unscale * &bases[2];
        assert!(
            largest(&(reference.transpose() * &reference - DMatrix::identity(n - rank, n - rank)))
                < 1e-13
        );
        for basis in &bases {
            assert_eq!(basis.shape(), (n, n - rank));
            let scaled = &unscale * basis;
            let error = largest(&(&plain * &scaled)) / (largest(&plain) * largest(&scaled));
            assert!(error < 1e-12, "{error:e}");
            let outside = &scaled - &reference * (reference.transpose() * &scaled);
            assert!(
                largest(&outside) < 1e-10 * largest(&scaled),
                "{:e}",
                largest(&outside)
            );
        }
        let rows = independent_rows(&c, &scale, TOL).unwrap();
        assert_eq!(rows.len(), rank);
        let analysed = analyse_rows(&c, &scale, TOL).unwrap();
        assert_eq!(analysed.independent, rows);
        for redundant in &analysed.redundant {
            let mut sum = c.row(redundant.row).into_owned();
            for (row, coefficient) in &redundant.depends_on {
                sum -= c.row(*row) * *coefficient;
            }
            assert!(sum.norm() < 1e-9 * c.row(redundant.row).norm());
        }
    }
}

#[test]
fn later_rows_are_called_redundant() {
    let mut random = Random::new(4);
    let c = of_rank(9, 12, 5, &mut random);
    let rank = analyse_rows(&c, &[1.0; 12], TOL).unwrap();
    assert_eq!(rank.independent, [0, 1, 2, 3, 4]);
    assert!(rank.in_order);
}

#[test]
fn a_multiplier_outside_the_dependence_is_unique() {
    let c = matrix(&[
        &[1.0, 0.0, 0.0, 0.0],
        &[0.0, 1.0, 1.0, 0.0],
        &[0.0, 0.0, 0.0, 3.0],
        &[0.0, 2.0, 2.0, 0.0],
    ]);
    let rank = analyse_rows(&c, &[1.0; 4], TOL).unwrap();
    assert_eq!(rank.unique, [true, false, true, false]);
    assert_eq!(rank.redundant.len(), 1);
    assert_eq!(rank.redundant[0].row, 3);
    assert_eq!(rank.redundant[0].depends_on.len(), 1);
    assert!((rank.redundant[0].depends_on[0].1 - 2.0).abs() < 1e-14);
}

#[test]
fn a_row_without_gradient_is_redundant_and_depends_on_nothing() {
    let c = matrix(&[&[1.0, 0.0, 0.0], &[1e-14, 0.0, -1e-14], &[0.0, 1.0, 1.0]]);
    let rank = analyse_rows(&c, &[1.0; 3], TOL).unwrap();
    assert_eq!(rank.rank, 2);
    assert_eq!(
        (rank.redundant[0].row, rank.redundant[0].depends_on.len()),
        (1, 0)
    );
    assert_eq!(rank.unique, [true, false, true]);
}

#[test]
fn scales_decide_what_is_small() {
    // In metres this coordinate hardly counts; measured in its own unit it decides the rank.
    let c = matrix(&[&[1.0, 0.0], &[1.0, 1e-12]]);
    assert_eq!(analyse_rows(&c, &[1.0, 1.0], TOL).unwrap().rank, 1);
    assert_eq!(analyse_rows(&c, &[1.0, 1e12], TOL).unwrap().rank, 2);
}

#[test]
fn empty_and_zero_matrices_leave_everything_free() {
    for c in [DMatrix::zeros(0, 3), DMatrix::zeros(2, 3)] {
        let rank = analyse_rows(&c, &[1.0; 3], TOL).unwrap();
        assert_eq!(
            (rank.rank, rank.null_space.ncols(), rank.redundant.len()),
            (0, 3, c.nrows())
        );
        let split = partition(&c, &[1.0; 3], &[]).unwrap();
        assert_eq!((split.independent.len(), split.condition), (3, 1.0));
        assert_eq!(
            null_basis_lu(&c, &[1.0; 3], &split).unwrap(),
            DMatrix::identity(3, 3)
        );
        assert_eq!(null_basis_qr(&c, &[1.0; 3], TOL).unwrap().ncols(), 3);
        assert_eq!(null_basis_svd(&c, &[1.0; 3], TOL).unwrap().ncols(), 3);
    }
}

#[test]
fn bad_input_is_refused() {
    let mut c = DMatrix::zeros(2, 2);
    c[(1, 0)] = f64::NAN;
    assert_eq!(
        analyse_rows(&c, &[1.0; 2], TOL),
        Err(RankError::NotFinite { row: 1, column: 0 })
    );
    assert_eq!(
        analyse_rows(&c, &[1.0], TOL),
        Err(RankError::ScaleCount {
            expected: 2,
            found: 1
        })
    );
    assert_eq!(
        analyse_rows(&c, &[1.0, 0.0], TOL),
        Err(RankError::Scale { column: 1 })
    );
}

#[test]
fn a_partition_tells_when_its_coordinates_go_bad() {
    let split = partition(&matrix(&[&[1.0, 0.1]]), &[1.0; 2], &[]).unwrap();
    assert_eq!(split.dependent, [0]);
    let turned = matrix(&[&[1.0, 0.0], &[0.0, 1.0]]);
    assert_eq!(
        partition_condition(&turned, &[1.0; 2], &split).unwrap(),
        1.0
    );
    let lost = matrix(&[&[0.0, 1.0]]);
    assert!(partition_condition(&lost, &[1.0; 2], &split).unwrap() > 1e15);
    assert_eq!(
        null_basis_lu(&lost, &[1.0; 2], &split),
        Err(RankError::SingularPartition)
    );
}

#[test]
fn a_continued_basis_moves_little_and_stays_a_basis() {
    let mut random = Random::new(9);
    let c = of_rank(4, 8, 4, &mut random);
    let change = DMatrix::from_vec(4, 8, random.values(32)) * 1e-4;
    let before = null_basis_svd(&c, &[1.0; 8], TOL).unwrap();
    // The same motions in another order: a basis that jumps.
    let fresh = null_basis_qr(&(&c + &change), &[1.0; 8], TOL)
        .unwrap()
        .select_columns(&[2, 3, 0, 1]);
    let after = continue_basis(&before, &fresh).unwrap();
    assert!(largest(&((&c + &change) * &after)) < 1e-11);
    assert!(largest(&(after.transpose() * &after - DMatrix::identity(4, 4))) < 1e-13);
    assert!(
        largest(&(&after - &before)) < 1e-2,
        "{:e}",
        largest(&(&after - &before))
    );
    assert!(largest(&(&fresh - &before)) > 0.1);
    // A basis continued to itself stays.
    assert!(largest(&(continue_basis(&before, &before).unwrap() - &before)) < 1e-14);
}

#[test]
fn chain_has_full_rank_both_ways() {
    let problem = chain(30);
    let rank = analyse_rows(&problem.dense_jac(), &[1.0; 90], TOL).unwrap();
    assert_eq!(rank.rank, 60);
    assert!(rank.redundant.is_empty() && rank.unique.iter().all(|unique| *unique));
    assert!(redundant_rows(&problem.factored().factored()).is_empty());
}
