//! The answer of every formulation.

/// Accelerations and multipliers at a state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// Accelerations of all velocity coordinates.
    pub a: Vec<f64>,
    /// Multipliers of all rows. Where redundant rows leave them open, the dense formulations give those of least norm
    /// in rows scaled to unit length.
    pub lambda: Vec<f64>,
    /// Largest relative residual of the equations. Large where redundant rows contradict each other.
    pub residual: f64,
}
