//! Explicit Runge-Kutta methods as tables of coefficients.

/// An explicit Runge-Kutta method.
#[derive(Debug)]
pub struct Tableau {
    /// Its name.
    pub name: &'static str,
    /// Order of a step.
    pub order: u32,
    /// Times of the stages in a step of size 1.
    pub c: &'static [f64],
    /// Weights of the stages before each stage.
    pub a: &'static [&'static [f64]],
    /// Weights of the step.
    pub b: &'static [f64],
    /// How it judges its error.
    pub errors: Errors,
    /// How it fills the step in between.
    pub dense: Dense,
}

/// How a method estimates the error of a step.
#[derive(Debug)]
pub enum Errors {
    /// Not at all: the user chooses the step.
    None,
    /// By a method of lower order: the difference of the weights, with the slope at the end as the last one.
    Embedded {
        /// Weights.
        weights: &'static [f64],
        /// Order of the estimate plus one.
        power: f64,
    },
    /// By two methods, which stretches the estimate where they disagree (Hairer, Norsett, Wanner I, II.10).
    Twice {
        /// Weights of the error of high order.
        high: &'static [f64],
        /// Weights of the error of low order.
        low: &'static [f64],
        /// Order of the estimate plus one.
        power: f64,
    },
}

/// How a method gives the solution inside a step.
#[derive(Debug)]
pub enum Dense {
    /// The cubic with the values and slopes of the ends.
    Cubic,
    /// The cubic plus products of theta^2 and (1 - theta)^2 with combinations of the slopes.
    More {
        /// Times of stages that only the inside needs.
        c: &'static [f64],
        /// Their weights: of the stages, of the slope at the end, and of those before.
        a: &'static [&'static [f64]],
        /// Weights of each combination, of all these slopes.
        d: &'static [&'static [f64]],
    },
}

/// Explicit Euler.
pub const EULER: Tableau = Tableau {
    name: "euler",
    order: 1,
    c: &[0.0],
    a: &[&[]],
    b: &[1.0],
    errors: Errors::None,
    dense: Dense::Cubic,
};

/// The explicit midpoint rule.
pub const MIDPOINT: Tableau = Tableau {
    name: "midpoint",
    order: 2,
    c: &[0.0, 0.5],
    a: &[&[], &[0.5]],
    b: &[0.0, 1.0],
    errors: Errors::None,
    dense: Dense::Cubic,
};

/// Heun's method: an Euler step, then the mean of the slopes of both ends.
pub const HEUN: Tableau = Tableau {
    name: "heun",
    order: 2,
    c: &[0.0, 1.0],
    a: &[&[], &[1.0]],
    b: &[0.5, 0.5],
    errors: Errors::None,
    dense: Dense::Cubic,
};

/// The classical method of Runge and Kutta.
pub const RK4: Tableau = Tableau {
    name: "rk4",
    order: 4,
    c: &[0.0, 0.5, 0.5, 1.0],
    a: &[&[], &[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    b: &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
    errors: Errors::None,
    dense: Dense::Cubic,
};
