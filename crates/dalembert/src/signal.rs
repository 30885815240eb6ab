//! Inputs of expressions: time, and values and rates of measures between markers.

use crate::joint::{Guarded, Measure};
use crate::space::{Planar, Space};
use dalembert_expr::Program;

/// Most inputs of one expression.
pub const MAX_INPUTS: usize = 32;

/// What an input of an expression is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SignalKind {
    /// Time.
    Time,
    /// Value of the measure.
    Value,
    /// Rate of the measure.
    Rate,
}

/// One input of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Signal<S: Space = Planar> {
    /// Kind.
    pub kind: SignalKind,
    /// Measure, on the markers of the element that owns the expression; unused for time.
    pub measure: Measure<S>,
}

impl<S: Space> Signal<S> {
    /// The vector of its measure that must not vanish.
    pub fn guarded(&self, markers: &[S::Marker]) -> Option<Guarded> {
        match self.kind {
            SignalKind::Time => None,
            SignalKind::Value | SignalKind::Rate => self.measure.guarded(markers),
        }
    }

    /// Its value at a state.
    pub fn read(&self, t: f64, markers: &[S::Marker]) -> f64 {
        match self.kind {
            SignalKind::Time => t,
            SignalKind::Value => self.measure.value(markers),
            SignalKind::Rate => self.measure.evaluate(markers).rate,
        }
    }
}

/// A coefficient of a force element: a constant, or an expression of the state.
#[derive(Clone, Debug)]
pub enum Coefficient<S: Space = Planar> {
    /// A constant.
    Constant(f64),
    /// An expression with its inputs.
    Expression(Box<Program>, Vec<Signal<S>>),
    /// The negative of an expression.
    Negated(Box<Program>, Vec<Signal<S>>),
}

fn read<S: Space>(program: &Program, inputs: &[Signal<S>], t: f64, markers: &[S::Marker]) -> f64 {
    let mut values = [0.0; MAX_INPUTS];
    for (value, signal) in values.iter_mut().zip(inputs) {
        *value = signal.read(t, markers);
    }
    program.eval(&values[..inputs.len()])
}

impl<S: Space> Coefficient<S> {
    /// The coefficient with the other sign.
    #[must_use]
    pub fn negated(self) -> Self {
        match self {
            Self::Constant(x) => Self::Constant(-x),
            Self::Expression(program, inputs) => Self::Negated(program, inputs),
            Self::Negated(program, inputs) => Self::Expression(program, inputs),
        }
    }

    /// Its value at a state; markers of the element that owns it.
    pub fn value(&self, t: f64, markers: &[S::Marker]) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Expression(program, inputs) => read(program, inputs, t, markers),
            Self::Negated(program, inputs) => -read(program, inputs, t, markers),
        }
    }

    /// Shows the vectors of its inputs that must not vanish.
    pub fn guarded(&self, markers: &[S::Marker], see: &mut dyn FnMut(Guarded)) {
        match self {
            Self::Constant(_) => {}
            Self::Expression(_, inputs) | Self::Negated(_, inputs) => inputs
                .iter()
                .filter_map(|signal| signal.guarded(markers))
                .for_each(see),
        }
    }

    /// The first part of its expression whose value can jump, like "sign(x)".
    pub fn jump(&self) -> Option<&str> {
        match self {
            Self::Constant(_) => None,
            Self::Expression(program, _) | Self::Negated(program, _) => program.jumps().next(),
        }
    }

    /// The constant value, if it is one.
    pub fn constant(&self) -> Option<f64> {
        match self {
            Self::Constant(value) => Some(*value),
            Self::Expression(..) | Self::Negated(..) => None,
        }
    }
}
