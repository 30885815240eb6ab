//! The integrators behind one face.

use super::{
    Adams, DOP853, DOPRI5, EULER, HEUN, MIDPOINT, Ode, RK4, RungeKutta, StepError, StepReport,
    Stiffness,
};
use crate::model::Method;

/// A running integration by one of the methods.
#[derive(Clone, Debug)]
pub enum Integrator {
    /// Explicit Runge-Kutta, of fixed or controlled step.
    RungeKutta(Box<RungeKutta>),
    /// Adams-Bashforth-Moulton of variable order and step.
    Adams(Box<Adams>),
}

impl Integrator {
    /// Starts at (t, y) with steps up to `max_step`; methods of fixed step make all steps as long as that.
    ///
    /// # Errors
    /// The right side cannot be evaluated at the start.
    pub fn start<O: Ode>(
        method: Method,
        ode: &mut O,
        t: f64,
        y: &[f64],
        tolerance: f64,
        max_step: f64,
    ) -> Result<Self, O::Error> {
        let table = match method {
            Method::Euler => &EULER,
            Method::Midpoint => &MIDPOINT,
            Method::Heun => &HEUN,
            Method::Rk4 => &RK4,
            Method::Dopri5 => &DOPRI5,
            Method::Dop853 => &DOP853,
            Method::Adams => {
                let adams = Adams::start(ode, t, y, tolerance, max_step)?;
                return Ok(Self::Adams(Box::new(adams)));
            }
        };
        let fixed = method.has_fixed_steps().then_some(max_step);
        let own = RungeKutta::start(table, ode, t, y, tolerance, max_step, fixed)?;
        Ok(Self::RungeKutta(Box::new(own)))
    }

    /// Time of the last accepted state [s].
    pub fn t(&self) -> f64 {
        match self {
            Self::RungeKutta(own) => own.t,
            Self::Adams(own) => own.t,
        }
    }

    /// The last accepted state.
    pub fn y(&self) -> &[f64] {
        match self {
            Self::RungeKutta(own) => &own.y,
            Self::Adams(own) => &own.y,
        }
    }

    /// Right sides evaluated.
    pub fn evaluations(&self) -> usize {
        match self {
            Self::RungeKutta(own) => own.evaluations,
            Self::Adams(own) => own.evaluations,
        }
    }

    /// Is the step held down by stability? Only methods that judge their error by stages can tell.
    pub fn stiffness(&self) -> Stiffness {
        match self {
            Self::RungeKutta(own) => own.stiffness.clone(),
            Self::Adams(_) => Stiffness::default(),
        }
    }

    /// One accepted step, not beyond `end`.
    ///
    /// # Errors
    /// The step shrank to nothing, or a step of fixed size failed.
    pub fn step<O: Ode>(
        &mut self,
        ode: &mut O,
        end: f64,
    ) -> Result<StepReport, StepError<O::Error>> {
        match self {
            Self::RungeKutta(own) => own.step(ode, end),
            Self::Adams(own) => own.step(ode, end),
        }
    }

    /// Takes up a state that was changed from outside at the time that is reached; what was learned on the way is forgotten.
    ///
    /// # Errors
    /// The right side cannot be evaluated there.
    pub fn restart<O: Ode>(&mut self, ode: &mut O, y: &[f64]) -> Result<(), O::Error> {
        match self {
            Self::RungeKutta(own) => {
                own.y.copy_from_slice(y);
                own.restart(ode)
            }
            Self::Adams(own) => {
                own.y.copy_from_slice(y);
                own.restart(ode)
            }
        }
    }

    /// The state at a time inside the last step, without projection.
    ///
    /// # Errors
    /// The right side cannot be evaluated inside the step.
    pub fn interpolate<O: Ode>(
        &mut self,
        ode: &mut O,
        t: f64,
        out: &mut [f64],
    ) -> Result<(), O::Error> {
        match self {
            Self::RungeKutta(own) => own.interpolate(ode, t, out),
            Self::Adams(own) => {
                own.interpolate(t, out);
                Ok(())
            }
        }
    }
}
