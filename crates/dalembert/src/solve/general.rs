//! The saddle system with a mass matrix that may be singular: bodies without mass or inertia.

use super::pattern::Pattern;
use super::rank::{from_faer, to_faer};
use super::residual::Rhs;
use super::shape::SaddleShape;
use faer::Side;
use faer::linalg::solvers::Solve;
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

/// Pivots or eigenvalues below this part of the largest one count as zero.
const ZERO: f64 = 1e-10;

/// Largest relative residual of a solution.
const CONSISTENT: f64 = 1e-9;

/// Solution of a saddle system whose mass matrix may be singular.
#[derive(Clone, Debug, PartialEq)]
pub struct GeneralSolution {
    /// Accelerations.
    pub a: Vec<f64>,
    /// Multipliers; of least norm in scaled rows where they are not unique.
    pub l: Vec<f64>,
    /// Auxiliaries.
    pub s: Vec<f64>,
    /// Number of multipliers that are not determined: redundant rows.
    pub redundant: usize,
    /// Largest residual over the largest term of the scaled equations.
    pub residual: f64,
}

/// A motion that no mass and no row resists.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMotion {
    /// Coordinates that move, with their parts; the largest of all parts is one.
    pub coordinates: Vec<(usize, f64)>,
    /// Auxiliaries that move.
    pub auxiliaries: Vec<(usize, f64)>,
}

/// Why a saddle system has no unique acceleration.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SingularKkt {
    /// Some coordinates have neither mass nor constraint: their accelerations are not determined.
    #[error("{} without mass and constraint", crate::words::counted(motions.len(), "motion"))]
    FreeCoordinates {
        /// One entry a motion.
        motions: Vec<FreeMotion>,
    },
    /// The right-hand side contradicts dependent equations.
    #[error("dependent equations contradict each other: relative residual {residual:e}")]
    Inconsistent {
        /// Largest residual over the largest term.
        residual: f64,
    },
    /// An input is not a finite number.
    #[error("the system has a value that is not finite")]
    NotFinite,
    /// The eigenvalues could not be found.
    #[error("the eigenvalues of the system did not converge")]
    NoConvergence,
}

/// Solves `[M J^T 0; J 0 Js; 0 Js^T 0] [a; l; s] = [f; g; h]` where M is only positive semidefinite.
///
/// Values are laid out as for [`Saddle`](super::Saddle); `mass` has one row-major `dof x dof` block a body. Dense: the cost is the cube of the number of
/// unknowns. LU with full pivoting where the system is regular, eigenvectors where it is not.
pub fn solve_general(
    shape: SaddleShape,
    mass: &[f64],
    jac: &[f64],
    jac_aux: &[f64],
    rhs: Rhs<'_>,
) -> Result<GeneralSolution, SingularKkt> {
    let pattern = Pattern::new(shape);
    let (n, m) = (pattern.coordinates(), pattern.rows());
    let k = dense(&pattern, mass, jac, jac_aux);
    let b = DVector::from_vec([rhs.f, rhs.g, rhs.h].concat());
    if k.iter().chain(b.iter()).any(|value| !value.is_finite()) {
        return Err(SingularKkt::NotFinite);
    }
    let scale = equilibrate(&k);
    let scaled = DMatrix::from_fn(k.nrows(), k.ncols(), |i, j| scale[i] * k[(i, j)] * scale[j]);
    let right = b.component_mul(&scale);
    let (x, residual, redundant) = match regular(&scaled, &right) {
        Some((x, residual)) => (x, residual, 0),
        None => singular(&scaled, &right, &scale, n, m)?,
    };
    if residual.is_nan() || residual > CONSISTENT {
        return Err(SingularKkt::Inconsistent { residual });
    }
    let x = x.component_mul(&scale);
    let part = |from: usize, count: usize| x.as_slice()[from..from + count].to_vec();
    Ok(GeneralSolution {
        a: part(0, n),
        l: part(n, m),
        s: part(n + m, pattern.aux()),
        redundant,
        residual,
    })
}

/// The whole matrix.
fn dense(pattern: &Pattern, mass: &[f64], jac: &[f64], jac_aux: &[f64]) -> DMatrix<f64> {
    let (n, m) = (pattern.coordinates(), pattern.rows());
    let dof = pattern.shape().dof;
    let mut k = DMatrix::zeros(n + m + pattern.aux(), n + m + pattern.aux());
    for body in 0..pattern.shape().bodies {
        for i in 0..dof {
            for j in 0..dof {
                k[(body * dof + i, body * dof + j)] = mass[(body * dof + i) * dof + j];
            }
        }
    }
    let mut add = |row: usize, column: usize, value: f64| {
        k[(row, column)] += value;
        k[(column, row)] += value;
    };
    for block in &pattern.incidences {
        for i in 0..block.rows {
            for c in 0..dof {
                add(
                    n + block.row + i,
                    block.body * dof + c,
                    jac[block.jac + i * dof + c],
                );
            }
        }
    }
    for (e, element) in pattern.shape().elements.iter().enumerate() {
        for i in 0..element.rows {
            for c in 0..element.aux {
                let value = jac_aux[pattern.jac_aux_offset(e) + i * element.aux + c];
                add(
                    n + pattern.row_offset(e) + i,
                    n + m + pattern.aux_offset(e) + c,
                    value,
                );
            }
        }
    }
    k
}

/// Symmetric scaling that brings the largest entry of each row near one (Ruiz).
fn equilibrate(k: &DMatrix<f64>) -> DVector<f64> {
    let mut scale = DVector::from_element(k.nrows(), 1.0);
    for _ in 0..10 {
        let largest: Vec<f64> = (0..k.nrows())
            .map(|i| {
                (0..k.ncols()).fold(0.0_f64, |l, j| l.max((k[(i, j)] * scale[j]).abs())) * scale[i]
            })
            .collect();
        for (scale, largest) in scale.iter_mut().zip(largest) {
            if largest > 0.0 {
                *scale /= largest.sqrt();
            }
        }
    }
    scale
}

/// LU with full pivoting and refinement; nothing if a pivot is too small.
fn regular(k: &DMatrix<f64>, b: &DVector<f64>) -> Option<(DVector<f64>, f64)> {
    if b.is_empty() {
        return Some((b.clone(), 0.0));
    }
    let lu = to_faer(k).full_piv_lu();
    let pivots = (0..b.len()).map(|i| lu.U()[(i, i)].abs());
    let (least, most) = pivots.fold((f64::INFINITY, 0.0_f64), |(least, most), p| {
        (least.min(p), most.max(p))
    });
    if least.is_nan() || least <= ZERO * most {
        return None;
    }
    let solve = |b: &DVector<f64>| {
        let column = faer::Mat::from_fn(b.len(), 1, |i, _| b[i]);
        from_faer(lu.solve(&column).as_ref()).column(0).into_owned()
    };
    Some(refine(k, b, solve))
}

/// Least-norm solution by eigenvectors, with the number of undetermined multipliers.
fn singular(
    k: &DMatrix<f64>,
    b: &DVector<f64>,
    scale: &DVector<f64>,
    n: usize,
    m: usize,
) -> Result<(DVector<f64>, f64, usize), SingularKkt> {
    let eigen = to_faer(k)
        .self_adjoint_eigen(Side::Lower)
        .map_err(|_| SingularKkt::NoConvergence)?;
    let vectors = from_faer(eigen.U());
    let values: Vec<f64> = (0..b.len()).map(|i| eigen.S()[i]).collect();
    let largest = values
        .iter()
        .fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let null: Vec<usize> = (0..b.len())
        .filter(|&i| values[i].abs() <= ZERO * largest)
        .collect();
    // For M >= 0 the null space is the sum of motions (a, 0, s) with M a = 0 and of multipliers (0, l, 0).
    let mut motions = vectors.select_columns(&null);
    motions.rows_mut(n, m).fill(0.0);
    let svd = super::rank::Svd::new(&motions).map_err(|_| SingularKkt::NoConvergence)?;
    let free: Vec<FreeMotion> = (0..svd.values.len())
        .filter(|&i| svd.values[i] > 1e-3)
        .map(|i| free_motion(&svd.u.column(i).component_mul(scale), n, m))
        .collect();
    if !free.is_empty() {
        return Err(SingularKkt::FreeCoordinates { motions: free });
    }
    let solve = |b: &DVector<f64>| {
        let mut parts = vectors.tr_mul(b);
        for (part, value) in parts.iter_mut().zip(&values) {
            *part = if value.abs() > ZERO * largest {
                *part / value
            } else {
                0.0
            };
        }
        &vectors * parts
    };
    let (x, residual) = refine(k, b, solve);
    Ok((x, residual, null.len()))
}

/// Names the coordinates of a motion.
fn free_motion(vector: &DVector<f64>, n: usize, m: usize) -> FreeMotion {
    let largest = vector.iter().fold(
        0.0_f64,
        |largest: f64, x| if x.abs() > largest.abs() { *x } else { largest },
    );
    let list = |from: usize, to: usize| -> Vec<(usize, f64)> {
        (from..to)
            .map(|i| (i - from, vector[i] / largest))
            .filter(|(_, part)| part.abs() > 1e-9)
            .collect()
    };
    FreeMotion {
        coordinates: list(0, n),
        auxiliaries: list(n + m, vector.len()),
    }
}

/// Solves and corrects as long as that helps; returns the solution and its relative residual.
fn refine(
    k: &DMatrix<f64>,
    b: &DVector<f64>,
    solve: impl Fn(&DVector<f64>) -> DVector<f64>,
) -> (DVector<f64>, f64) {
    let measure = |x: &DVector<f64>| {
        let rest = b - k * x;
        let term = b.amax().max(x.amax());
        let relative = if term > 0.0 { rest.amax() / term } else { 0.0 };
        (rest, relative)
    };
    let mut x = solve(b);
    let (mut rest, mut relative) = measure(&x);
    for _ in 0..4 {
        let next = &x + solve(&rest);
        let (next_rest, next_relative) = measure(&next);
        if next_relative.is_nan() || next_relative >= relative {
            break;
        }
        (x, rest, relative) = (next, next_rest, next_relative);
    }
    (x, relative)
}
