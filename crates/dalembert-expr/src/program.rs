//! Compiled expressions.

use crate::builtin;
use crate::derive::dual::Dual;
use crate::derive::hyper_dual::HyperDual;
use crate::derive::jet2::Jet2;
use crate::derive::jet3::Jet3;
use crate::derive::scalar::Scalar;
use crate::emit::Code;
use crate::instruction::Instruction;
use crate::{ExprError, Quantity};
use std::ops::Range;

/// Values that a program may hold at once.
pub(crate) const DEEPEST: usize = 64;
/// Values that nearly every program holds at most: these evaluate with a small stack.
const SHALLOW: usize = 8;
/// Directions of one sweep of a gradient.
const SWEEP: usize = 4;

/// A compiled expression: evaluates without allocation, with exact derivatives.
///
/// A value need not be finite (`1/t` at 0): look at what comes out, and ask
/// [`Program::first_non_finite`] for the place.
#[derive(Clone, Debug)]
pub struct Program {
    text: String,
    quantity: Quantity,
    code: Code,
    doubts: Vec<ExprError>,
}

impl Program {
    pub(crate) fn new(text: &str, quantity: Quantity, code: Code, doubts: Vec<ExprError>) -> Self {
        Self {
            doubts,
            text: text.to_owned(),
            quantity,
            code,
        }
    }

    /// The text that it was compiled from.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What is known of its dimension; that of its place where the text leaves it open.
    pub fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// Places where dimensions agree only if a number without a unit that divides has one: likely
    /// mistakes.
    pub fn doubts(&self) -> &[ExprError] {
        &self.doubts
    }

    /// Its value, where no variable takes part.
    pub fn constant(&self) -> Option<f64> {
        match self.code.instructions.as_slice() {
            [Instruction::Constant(value)] => Some(*value),
            _ => None,
        }
    }

    /// The scope's numbers of the variables in use, ascending. Values are given in this order.
    pub fn slots(&self) -> &[usize] {
        &self.code.slots
    }

    /// The parts of the text whose value can jump: `sign`, `step`, `floor`, `mod`, and comparisons,
    /// which an `if` decides by. (An `if` need not jump: both values may agree at the change.)
    pub fn jumps(&self) -> impl Iterator<Item = &str> {
        let code = self.code.instructions.iter().zip(&self.code.spans);
        code.filter(|(instruction, _)| instruction.can_jump())
            .filter_map(|(_, span)| self.text.get(span.clone()))
    }

    /// How many values it holds at once at most.
    pub fn stack_depth(&self) -> usize {
        self.code.depth
    }

    /// Its value, in SI.
    pub fn eval(&self, values: &[f64]) -> f64 {
        self.run(|k| values.get(k).copied().unwrap_or(f64::NAN))
    }

    /// Its value, and its derivative by every value.
    ///
    /// `out` has one place for every value.
    pub fn gradient(&self, values: &[f64], out: &mut [f64]) -> f64 {
        let mut result = None;
        for first in (0..self.slots().len()).step_by(SWEEP) {
            let dual: Dual<SWEEP> = self.run(|k| Dual {
                v: values.get(k).copied().unwrap_or(f64::NAN),
                d: std::array::from_fn(|n| f64::from(k == first + n)),
            });
            for (n, place) in out.iter_mut().skip(first).take(SWEEP).enumerate() {
                *place = dual.d[n];
            }
            result = Some(dual.v);
        }
        result.unwrap_or_else(|| self.eval(values))
    }

    /// Its value, its gradient, and its second derivatives row by row.
    pub fn hessian(&self, values: &[f64], gradient: &mut [f64], hessian: &mut [f64]) -> f64 {
        let size = self.slots().len();
        for i in 0..size {
            for j in 0..=i {
                let result: HyperDual = self.run(|k| HyperDual {
                    v: values.get(k).copied().unwrap_or(f64::NAN),
                    x: f64::from(k == i),
                    y: f64::from(k == j),
                    xy: 0.0,
                });
                for place in [i * size + j, j * size + i] {
                    if let Some(place) = hessian.get_mut(place) {
                        *place = result.xy;
                    }
                }
            }
        }
        self.gradient(values, gradient)
    }

    /// Its value and time derivatives, from those of the values.
    pub fn eval_jet(&self, values: &[Jet2]) -> Jet2 {
        let missing = Jet2::constant(f64::NAN);
        self.run(|k| values.get(k).copied().unwrap_or(missing))
    }

    /// Its value and first three derivatives by its first value, which is most useful where it
    /// has only one: the profile of a cam. All derivatives are zero where it has none.
    pub fn eval_third(&self, values: &[f64]) -> [f64; 4] {
        let result: Jet3 = self.run(|k| {
            let value = values.get(k).copied().unwrap_or(f64::NAN);
            if k == 0 {
                Jet3::variable(value)
            } else {
                Jet3::constant(value)
            }
        });
        [result.v, result.d, result.dd, result.ddd]
    }

    /// Its value and first three derivatives along a direction in the space of its values.
    pub fn eval_along(&self, values: &[f64], direction: &[f64]) -> [f64; 4] {
        let result: Jet3 = self.run(|k| {
            let value = values.get(k).copied().unwrap_or(f64::NAN);
            let mut jet = Jet3::constant(value);
            jet.d = direction.get(k).copied().unwrap_or(0.0);
            jet
        });
        [result.v, result.d, result.dd, result.ddd]
    }

    /// The place in the text of the first part that has no finite value.
    pub fn first_non_finite(&self, values: &[f64]) -> Option<Range<usize>> {
        let mut place = None;
        let load = |k: usize| values.get(k).copied().unwrap_or(f64::NAN);
        self.interpret::<f64, DEEPEST>(load, |at, value| {
            if !value.is_finite() && place.is_none() {
                place = Some(self.code.spans[at].clone());
            }
        });
        place
    }

    #[inline]
    fn run<S: Scalar>(&self, load: impl Fn(usize) -> S) -> S {
        if self.code.depth <= SHALLOW {
            self.interpret::<S, SHALLOW>(load, |_, _| {})
        } else {
            self.interpret::<S, DEEPEST>(load, |_, _| {})
        }
    }

    /// Runs the instructions on a stack of N values, a power of two; the uppermost one is apart.
    #[inline]
    fn interpret<S: Scalar, const N: usize>(
        &self,
        load: impl Fn(usize) -> S,
        mut seen: impl FnMut(usize, f64),
    ) -> S {
        use Instruction as I;
        let mut stack = [S::constant(0.0); N];
        let mut height = 0_usize;
        let mut top = S::constant(0.0);
        // The compiler of expressions keeps the height below N: the masks only tell rustc so.
        macro_rules! push {
            ($value:expr) => {{
                let value = $value;
                stack[height & (N - 1)] = top;
                height += 1;
                top = value;
            }};
        }
        macro_rules! below {
            () => {{
                height = height.wrapping_sub(1);
                stack[height & (N - 1)]
            }};
        }
        let truth = |value: bool| S::constant(f64::from(value));
        let code = self.code.instructions.as_slice();
        let mut at = 0_usize;
        while let Some(instruction) = code.get(at) {
            match *instruction {
                I::Constant(value) => push!(S::constant(value)),
                I::Slot(k) => push!(load(k as usize)),
                I::Add => top = below!().add(top),
                I::Subtract => top = below!().sub(top),
                I::Multiply => top = below!().mul(top),
                I::Divide => top = below!().div(top),
                I::SubtractFrom => top = top.sub(below!()),
                I::DivideInto => top = top.div(below!()),
                I::AddSlot(k) => top = top.add(load(k as usize)),
                I::SubtractSlot(k) => top = top.sub(load(k as usize)),
                I::MultiplySlot(k) => top = top.mul(load(k as usize)),
                I::DivideSlot(k) => top = top.div(load(k as usize)),
                I::AddConstant(c) => top = top.offset(c),
                I::MultiplyConstant(c) => top = top.scale(c),
                I::DivideConstant(c) => top = top.div(S::constant(c)),
                I::FromConstant(c) => top = S::constant(c).sub(top),
                I::OverConstant(c) => top = S::constant(c).div(top),
                I::Negate => top = top.scale(-1.0),
                I::Univariate(function) => top = top.univariate(function),
                I::Bivariate(function) => top = below!().bivariate(top, function),
                I::Compare(comparison) => {
                    top = truth(comparison.holds(below!().value(), top.value()));
                }
                I::And => {
                    let left = below!().value() != 0.0;
                    top = truth(left && top.value() != 0.0);
                }
                I::Or => {
                    let left = below!().value() != 0.0;
                    top = truth(left || top.value() != 0.0);
                }
                I::Not => top = truth(top.value() == 0.0),
                I::Min => top = builtin::min(below!(), top),
                I::Max => top = builtin::max(below!(), top),
                I::Mod => top = builtin::modulo(below!(), top),
                I::Blend => {
                    let from = below!();
                    top = builtin::blend(below!(), from, top);
                }
                I::Table(number) => {
                    top = top.chain(self.code.tables[number as usize].jet(top.value()));
                }
                I::Unless(goal) => {
                    let condition = top.value() != 0.0;
                    top = below!();
                    if !condition {
                        at = goal as usize;
                        continue;
                    }
                }
                I::Jump(goal) => {
                    at = goal as usize;
                    continue;
                }
            }
            seen(at, top.value());
            at += 1;
        }
        top
    }
}
