//! Values of operators and functions on constants.

use crate::builtin::{self, Operation};
use crate::derive::bivariate::Bivariate;
use crate::derive::univariate::Univariate;
use crate::syntax::tree::Binary;

/// The value of an operator on constants.
pub(super) fn fold(operator: Binary, a: f64, b: f64) -> f64 {
    match operator {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide => a / b,
        Binary::Power => power(b).map_or_else(|| Bivariate::Power.value(a, b), |p| p.value(a)),
        Binary::Less => f64::from(a < b),
        Binary::LessEqual => f64::from(a <= b),
        Binary::Greater => f64::from(a > b),
        Binary::GreaterEqual => f64::from(a >= b),
        Binary::Equal => f64::from(a == b),
        Binary::NotEqual => f64::from(a != b),
        Binary::And => f64::from(a != 0.0 && b != 0.0),
        Binary::Or => f64::from(a != 0.0 || b != 0.0),
    }
}

/// A fixed power as a function of its base. Small whole powers are products.
pub(crate) fn power(exponent: f64) -> Option<Univariate> {
    if !exponent.is_finite() {
        return None;
    }
    Some(if exponent.fract() == 0.0 && exponent.abs() <= 16.0 {
        Univariate::PowInt(exponent as i32)
    } else {
        Univariate::PowReal(exponent)
    })
}

/// The value of a function on constants.
pub(super) fn apply(operation: Operation, values: &[f64]) -> f64 {
    match (operation, values) {
        (Operation::Univariate(f), [x]) => f.value(*x),
        (Operation::Bivariate(f), [a, b]) => f.value(*a, *b),
        (Operation::Mod, [a, b]) => builtin::modulo(*a, *b),
        (Operation::Blend, [x, from, to]) => builtin::blend(*x, *from, *to),
        (Operation::Min, [first, rest @ ..]) => rest.iter().copied().fold(*first, builtin::min),
        (Operation::Max, [first, rest @ ..]) => rest.iter().copied().fold(*first, builtin::max),
        // The number of arguments has been checked, and `if` has its own rule.
        _ => f64::NAN,
    }
}
