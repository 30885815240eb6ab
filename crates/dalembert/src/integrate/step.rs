//! Steps of integrators, and why they fail.

use thiserror::Error;

/// Part of the tolerance that the error of one step may take: errors add up over a run.
pub(super) const SHARE: f64 = 0.1;

/// Why a step could not be made.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError<E> {
    /// The step became too small for the precision of the time.
    #[error("the step became too small")]
    TooSmall {
        /// The last step tried.
        step: f64,
        /// Why the right side or the projection failed last, if that was the reason.
        cause: Option<E>,
    },
    /// A step of fixed size failed.
    #[error("a step of fixed size failed")]
    Fixed {
        /// The step.
        step: f64,
        /// Why the right side or the projection failed.
        cause: E,
    },
}

/// What one call of `step` did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StepReport {
    /// Attempts that were given up.
    pub rejected: usize,
}

/// The size of a step towards `end`, at most `h`, and whether it is the last one: a remainder that is too small for a step
/// of its own is taken along. None where nothing is left of the step.
pub(super) fn towards(t: f64, h: f64, end: f64) -> Option<(f64, bool)> {
    let last = t + 1.01 * h >= end;
    let h = if last { end - t } else { h };
    let smallest = 4.0 * f64::EPSILON * t.abs().max(1e-12);
    (h > smallest).then_some((h, last))
}
