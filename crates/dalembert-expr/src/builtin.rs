//! The functions and constants of the language.

use crate::derive::bivariate::Bivariate;
use crate::derive::scalar::Scalar;
use crate::derive::univariate::Univariate;

/// A function of the language.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Builtin {
    pub name: &'static str,
    /// How it is written, for messages.
    pub usage: &'static str,
    /// Least number of arguments.
    pub least: usize,
    /// Largest number of arguments.
    pub most: usize,
    pub rule: Rule,
    pub operation: Operation,
}

/// What a function asks of the dimensions of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rule {
    /// Plain numbers or angles; so is the value.
    Plain,
    /// The same dimension for all; so is the value.
    Same,
    /// The same dimension for all; the value is a plain number.
    Ratio,
    /// Any; the value has its square root.
    Root,
    /// A condition, then two of the same dimension; so is the value.
    Choice,
}

/// What a function computes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Operation {
    Univariate(Univariate),
    Bivariate(Bivariate),
    Min,
    Max,
    Mod,
    Blend,
    If,
}

const fn one(name: &'static str, usage: &'static str, rule: Rule, function: Univariate) -> Builtin {
    let operation = Operation::Univariate(function);
    many(name, usage, 1, 1, rule, operation)
}

const fn many(
    name: &'static str,
    usage: &'static str,
    least: usize,
    most: usize,
    rule: Rule,
    operation: Operation,
) -> Builtin {
    Builtin {
        name,
        usage,
        least,
        most,
        rule,
        operation,
    }
}

/// Most arguments of `min` and `max`.
const MANY: usize = 16;

const BUILTINS: &[Builtin] = &[
    one("sin", "sin(x)", Rule::Plain, Univariate::Sin),
    one("cos", "cos(x)", Rule::Plain, Univariate::Cos),
    one("tan", "tan(x)", Rule::Plain, Univariate::Tan),
    one("asin", "asin(x)", Rule::Plain, Univariate::Asin),
    one("acos", "acos(x)", Rule::Plain, Univariate::Acos),
    one("atan", "atan(x)", Rule::Plain, Univariate::Atan),
    one("sinh", "sinh(x)", Rule::Plain, Univariate::Sinh),
    one("cosh", "cosh(x)", Rule::Plain, Univariate::Cosh),
    one("tanh", "tanh(x)", Rule::Plain, Univariate::Tanh),
    one("exp", "exp(x)", Rule::Plain, Univariate::Exp),
    one("ln", "ln(x)", Rule::Plain, Univariate::Ln),
    one("log10", "log10(x)", Rule::Plain, Univariate::Log10),
    one("floor", "floor(x)", Rule::Plain, Univariate::Floor),
    one("sqrt", "sqrt(x)", Rule::Root, Univariate::Sqrt),
    one("abs", "abs(x)", Rule::Same, Univariate::Abs),
    one("sign", "sign(x)", Rule::Ratio, Univariate::Sign),
    one("step", "step(x)", Rule::Ratio, Univariate::Step),
    many(
        "atan2",
        "atan2(y, x)",
        2,
        2,
        Rule::Ratio,
        Operation::Bivariate(Bivariate::Atan2),
    ),
    many(
        "hypot",
        "hypot(x, y)",
        2,
        2,
        Rule::Same,
        Operation::Bivariate(Bivariate::Hypot),
    ),
    many("min", "min(a, b)", 2, MANY, Rule::Same, Operation::Min),
    many("max", "max(a, b)", 2, MANY, Rule::Same, Operation::Max),
    many("mod", "mod(a, b)", 2, 2, Rule::Same, Operation::Mod),
    many(
        "blend",
        "blend(x, x0, x1)",
        3,
        3,
        Rule::Ratio,
        Operation::Blend,
    ),
    many(
        "if",
        "if(condition, value, otherwise)",
        3,
        3,
        Rule::Choice,
        Operation::If,
    ),
];

impl Builtin {
    /// The function of this name.
    pub(crate) fn named(name: &str) -> Option<&'static Self> {
        BUILTINS.iter().find(|builtin| builtin.name == name)
    }

    /// All function names.
    pub(crate) fn names() -> impl Iterator<Item = &'static str> {
        BUILTINS.iter().map(|builtin| builtin.name)
    }

    /// The number of arguments in words.
    pub(crate) fn arity(&self) -> String {
        match (self.least, self.most) {
            (1, 1) => "1 argument".to_owned(),
            (n, m) if n == m => format!("{n} arguments"),
            (n, m) => format!("{n} to {m} arguments"),
        }
    }
}

/// The value of a named constant.
pub(crate) fn constant(name: &str) -> Option<f64> {
    match name {
        "pi" => Some(std::f64::consts::PI),
        "tau" => Some(std::f64::consts::TAU),
        _ => None,
    }
}

/// Does a name mean something in the language itself (`pi`, `sin`, `if`, `and`)?
///
/// A parameter or a table of such a name could not be used without backticks.
pub fn is_reserved(name: &str) -> bool {
    matches!(name, "and" | "or" | "not")
        || constant(name).is_some()
        || Builtin::named(name).is_some()
}

/// The smaller of two numbers, with its derivatives; the first one where they are equal.
#[inline]
pub(crate) fn min<S: Scalar>(a: S, b: S) -> S {
    let (x, y) = (a.value(), b.value());
    if x <= y || x.is_nan() { a } else { b }
}

/// The larger of two numbers, with its derivatives; the first one where they are equal.
#[inline]
pub(crate) fn max<S: Scalar>(a: S, b: S) -> S {
    let (x, y) = (a.value(), b.value());
    if x >= y || x.is_nan() { a } else { b }
}

/// The remainder a - b floor(a/b), which has the sign of b.
#[inline]
pub(crate) fn modulo<S: Scalar>(a: S, b: S) -> S {
    a.sub(b.scale((a.value() / b.value()).floor()))
}

/// From 0 at `from` to 1 at `to`, by the quintic with two zero derivatives at both ends.
#[inline]
pub(crate) fn blend<S: Scalar>(x: S, from: S, to: S) -> S {
    if from.value() == to.value() {
        return S::constant(Univariate::Step.value(x.value() - from.value()));
    }
    let fraction = x.sub(from).div(to.sub(from));
    fraction.univariate(Univariate::Smooth)
}
