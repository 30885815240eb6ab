//! Does an equilibrium return after a push?

use super::motions::Motions;
use super::problem::Problem;
use super::solution::Solution;
use crate::analysis::AnalysisError;
use crate::analysis::mobility::{FreeMotion, describe, with_axis};
use crate::solve::RankError;
use crate::solve::rank::Svd;
use crate::space::{Space, Tuple};
use faer::{Mat, Side};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// What an equilibrium does after a small push.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stability {
    /// Every free motion is pushed back; also where nothing can move.
    Stable,
    /// No free motion is pushed away, but at least one is not pushed back either.
    Neutral,
    /// At least one free motion is pushed away.
    Unstable,
}

/// What the reduced stiffness K_r = -B^T (dF/dq) B says.
#[derive(Clone, Debug)]
pub(super) struct Verdict {
    pub stability: Stability,
    /// Eigenvalues of the symmetric part of K_r, ascending.
    pub eigenvalues: Vec<f64>,
    /// Is K_r symmetric to the accuracy of its differences?
    pub symmetric: bool,
    /// Number of neutral motions.
    pub neutral: usize,
    /// Neutral and unstable motions in words.
    pub motions: Vec<String>,
    /// The motion that is pushed away hardest, scaled.
    pub away: Option<DVector<f64>>,
}

/// Parts of the largest force and of the largest stiffness below which a stiffness is zero: central
/// differences are good to some 1e-10 of them.
const NEUTRAL: (f64, f64) = (1e-7, 1e-9);

/// Judges the equilibrium of a solution.
pub(super) fn judge<S: Space>(
    problem: &mut Problem<'_, S>,
    solution: &Solution,
) -> Result<Verdict, AnalysisError> {
    problem.evaluate(&solution.q)?;
    let motions = Motions::new(problem)?;
    let scale = problem.force_scale();
    let k = problem.stiffness(&solution.q, &solution.lambda, &motions.basis)?;
    let k = motions.basis.transpose() * k;
    let asymmetry = (&k - k.transpose()).amax();
    let (values, vectors) = principal(problem, &k)?;
    let zero = NEUTRAL.0 * scale + NEUTRAL.1 * values.amax();
    // A machine without any force has zero stiffness and a zero threshold.
    let flat: Vec<usize> = (0..values.len())
        .filter(|&j| values[j].abs() <= zero)
        .collect();
    let neutral = &motions.basis * vectors.select_columns(&flat);
    let mut verdict = Verdict {
        neutral: flat.len(),
        stability: Stability::Stable,
        symmetric: asymmetry <= 1e-6 * k.amax() + NEUTRAL.0 * scale,
        eigenvalues: values.iter().copied().collect(),
        motions: Vec::new(),
        away: None,
    };
    problem.evaluate(&solution.q)?;
    for (j, h) in values.iter().enumerate() {
        if *h >= -zero {
            continue;
        }
        let motion = &motions.basis * vectors.column(j);
        let text = in_words(problem, &motion);
        verdict.stability = Stability::Unstable;
        verdict.motions.push(format!("unstable: {text}"));
        verdict.away.get_or_insert(motion);
    }
    if verdict.neutral > 0 {
        if verdict.stability == Stability::Stable {
            verdict.stability = Stability::Neutral;
        }
        verdict.motions.extend(along(problem, neutral));
    }
    Ok(verdict)
}

/// The directions in which poses of equilibrium go on from one, orthonormal in scaled coordinates.
///
/// Rows that hold velocities only carry forces, but no pose is out of their reach: a rolling coin comes to stand anywhere.
/// With P the motions that the other rows leave, and B those that all rows leave, it is the null space of B^T K P.
pub(super) fn neutral_directions<S: Space>(
    problem: &mut Problem<'_, S>,
    q: &[f64],
) -> Result<DMatrix<f64>, AnalysisError> {
    problem.evaluate(q)?;
    let jacobian = problem.jacobian();
    let motions = Motions::of(problem, &jacobian)?;
    let scale = problem.force_scale();
    let lambda = motions.multipliers(&problem.forces());
    let velocity_rows = problem.system.velocity_rows();
    let poses = if velocity_rows.is_empty() {
        motions.basis.clone()
    } else {
        Motions::of(problem, &jacobian.remove_rows_at(velocity_rows))?.basis
    };
    let k = problem.stiffness(q, &lambda, &poses)?;
    let svd = Svd::new(&(motions.basis.transpose() * k)).map_err(|e| problem.rank_error(e))?;
    let largest = svd.values.first().copied().unwrap_or(0.0);
    let zero = NEUTRAL.0 * scale + NEUTRAL.1 * largest;
    let rank = svd.values.iter().filter(|s| **s > zero).count();
    Ok(&poses * svd.v.columns(rank, poses.ncols() - rank))
}

/// Neutral motions (scaled, at the evaluated pose) by the names of coordinates that can be chosen at
/// will, and the bodies that move with them.
fn along<S: Space>(problem: &Problem<'_, S>, mut neutral: DMatrix<f64>) -> Vec<String> {
    for (mut row, unit) in neutral.row_iter_mut().zip(problem.unit.iter()) {
        row *= *unit;
    }
    let found = describe(problem.system, &problem.ws, &neutral);
    let words = |m: &FreeMotion| {
        let mut bodies: Vec<String> = m
            .bodies
            .iter()
            .take(6)
            .map(|b| format!("{} {}", b.body, b.motion))
            .collect();
        if m.bodies.len() > 6 {
            let more = m.bodies.len() - 6;
            let (s, verb) = if more == 1 { ("y", "s") } else { ("ies", "") };
            bodies.push(format!("{more} more bod{s} move{verb}"));
        }
        // A contact parameter alone moves no body.
        if bodies.is_empty() {
            bodies.push("no body moves".to_owned());
        }
        format!(
            "neutral along {}: {}",
            m.coordinates.join(", "),
            bodies.join(", ")
        )
    };
    found.iter().map(words).collect()
}

/// Eigenvalues, ascending, and eigenvectors of the symmetric part of a matrix.
pub(super) fn principal<S: Space>(
    problem: &Problem<'_, S>,
    k: &DMatrix<f64>,
) -> Result<(DVector<f64>, DMatrix<f64>), AnalysisError> {
    let n = k.nrows();
    if n == 0 {
        return Ok((DVector::zeros(0), DMatrix::zeros(0, 0)));
    }
    let symmetric = 0.5 * (k + k.transpose());
    if symmetric.iter().any(|x| !x.is_finite()) {
        return Err(problem.rank_error(RankError::NoConvergence));
    }
    let eigen = Mat::from_fn(n, n, |i, j| symmetric[(i, j)])
        .self_adjoint_eigen(Side::Lower)
        .map_err(|_| problem.rank_error(RankError::NoConvergence))?;
    let (values, vectors) = (eigen.S(), eigen.U());
    Ok((
        DVector::from_fn(n, |i, _| values[i]),
        DMatrix::from_fn(n, n, |i, j| vectors[(i, j)]),
    ))
}

/// A scaled motion at the evaluated pose in words: which bodies take part and how, the greatest first.
pub(super) fn in_words<S: Space>(problem: &Problem<'_, S>, motion: &DVector<f64>) -> String {
    let system = problem.system;
    let sizes = problem.moves_and_turns(motion);
    let mut parts: Vec<(f64, String)> = Vec::new();
    for (b, body) in system.bodies.iter().enumerate() {
        let [shift, turn] = sizes[b];
        let turns = turn > 1e-3 * shift;
        let mut own = S::Twist::zero();
        let counted = if turns { S::NV } else { S::LINEAR };
        for (k, x) in own.as_mut_slice()[..counted].iter_mut().enumerate() {
            *x = motion[S::NV * b + k] * problem.unit[S::NV * b + k];
        }
        let what = match with_axis(system, &problem.ws, b, &own) {
            Some(words) => words,
            None if turns => "turns".to_owned(),
            None => {
                let linear = &motion.as_slice()[S::NV * b..][..S::LINEAR];
                // The sense of a motion means nothing: x is made positive.
                let sign = if linear[0] < -1e-9 * shift { -1.0 } else { 1.0 };
                let digits = linear
                    .iter()
                    .map(|x| format!("{:.3}", sign * x / shift + 0.0));
                format!("moves along ({})", digits.collect::<Vec<_>>().join(", "))
            }
        };
        parts.push((shift.max(turn), format!("{} {what}", body.name)));
    }
    parts.sort_by(|a, b| b.0.total_cmp(&a.0));
    let largest = parts.first().map_or(0.0, |p| p.0);
    parts.retain(|p| p.0 > 0.1 * largest);
    let more = parts.len().saturating_sub(6);
    parts.truncate(6);
    let mut words: Vec<String> = parts.into_iter().map(|p| p.1).collect();
    if more > 0 {
        words.push(match more {
            1 => "1 more body moves".to_owned(),
            n => format!("{n} more bodies move"),
        });
    }
    words.join(", ")
}
