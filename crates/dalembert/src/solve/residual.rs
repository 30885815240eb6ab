//! Right-hand side and quality of a solution of the saddle system.

/// Right-hand side of the saddle system.
#[derive(Clone, Copy, Debug)]
pub struct Rhs<'a> {
    /// Generalized forces, one for each coordinate.
    pub f: &'a [f64],
    /// Right-hand side of the constraint rows (Q_d at acceleration level).
    pub g: &'a [f64],
    /// Right-hand side of the auxiliary rows `Js^T l = h`; usually zero.
    pub h: &'a [f64],
}

/// Quality of a solution of the saddle system.
///
/// Every equation is measured in one unit, the square root of energy over time squared: forces by the square root of
/// the inverse mass, rows by their own `J M^-1 J^T`. So the number does not depend on units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// Largest residual over the largest term of all equations; infinite if anything is not finite.
    pub relative: f64,
    /// The same without the rows that are reported as vanished: where they contradict the others, this stays small.
    pub kept: f64,
    /// Corrections that were applied after the first solution.
    pub sweeps: usize,
    /// Whether the residual is below 1e-11 (the goal is 1e-13). If not, the right-hand side contradicts dependent rows:
    /// the answer then obeys the rows that are not reported as vanished, or all of them in the mean.
    pub converged: bool,
}
