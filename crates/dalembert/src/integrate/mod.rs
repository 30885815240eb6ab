//! Time integration. Integrators see an ordinary differential equation with invariants; never a body.

mod adams;
mod dop853;
mod dopri5;
mod integrator;
mod norm;
mod runge_kutta;
mod step;
mod stiffness;
mod tableau;
#[cfg(test)]
mod tests;

pub use adams::{Adams, HIGHEST_ORDER};
pub use dop853::DOP853;
pub use dopri5::DOPRI5;
pub use integrator::Integrator;
pub use runge_kutta::RungeKutta;
pub use step::{StepError, StepReport};
pub use stiffness::Stiffness;
pub use tableau::{Dense, EULER, Errors, HEUN, MIDPOINT, RK4, Tableau};

/// An ordinary differential equation y' = f(t, y) whose solutions stay on a manifold.
pub trait Ode {
    /// Why an evaluation can fail.
    type Error;
    /// Number of states.
    fn dim(&self) -> usize;
    /// dy/dt.
    ///
    /// # Errors
    /// The right side cannot be evaluated here; the step is tried again shorter.
    fn rhs(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Self::Error>;
    /// Scales of the errors: what counts as 1 for every state near `y`; infinity for states that
    /// are not controlled.
    fn scales(&mut self, y: &[f64], scales: &mut [f64]);
    /// Moves an accepted state back onto the manifold. Returns whether anything changed.
    ///
    /// # Errors
    /// The manifold was not reached; the step is tried again shorter.
    fn project(&mut self, t: f64, y: &mut [f64]) -> Result<bool, Self::Error>;
}
