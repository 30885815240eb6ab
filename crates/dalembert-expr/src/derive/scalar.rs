//! What the evaluation of a program needs of a number.

use super::bivariate::{Bivariate, Partials};
use super::univariate::Univariate;

/// A number, plain or with derivatives.
pub(crate) trait Scalar: Copy {
    /// A number that does not change.
    fn constant(value: f64) -> Self;
    /// The plain value.
    fn value(self) -> f64;
    fn add(self, other: Self) -> Self;
    fn sub(self, other: Self) -> Self;
    fn mul(self, other: Self) -> Self;
    fn div(self, other: Self) -> Self;
    /// Multiplied by a plain number.
    fn scale(self, factor: f64) -> Self;
    /// A plain number added.
    fn offset(self, term: f64) -> Self;
    /// A function of this number, given its value and first two derivatives.
    fn chain(self, jet: [f64; 3]) -> Self;
    /// A function of two numbers, given its value and partial derivatives.
    fn chain2(self, other: Self, partials: &Partials) -> Self;

    fn univariate(self, function: Univariate) -> Self {
        self.chain(function.jet(self.value()))
    }

    fn bivariate(self, other: Self, function: Bivariate) -> Self {
        self.chain2(other, &function.partials(self.value(), other.value()))
    }
}

/// A product in which a zero wins over an infinity: a part that does not change contributes
/// nothing, however steep the function is (the square root of a constant 0).
#[inline]
pub(crate) fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

impl Scalar for f64 {
    #[inline]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline]
    fn value(self) -> f64 {
        self
    }
    #[inline]
    fn add(self, other: Self) -> Self {
        self + other
    }
    #[inline]
    fn sub(self, other: Self) -> Self {
        self - other
    }
    #[inline]
    fn mul(self, other: Self) -> Self {
        self * other
    }
    #[inline]
    fn div(self, other: Self) -> Self {
        self / other
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        self * factor
    }
    #[inline]
    fn offset(self, term: f64) -> Self {
        self + term
    }
    #[inline]
    fn chain(self, jet: [f64; 3]) -> Self {
        jet[0]
    }
    #[inline]
    fn chain2(self, _other: Self, partials: &Partials) -> Self {
        partials.f
    }
    #[inline]
    fn univariate(self, function: Univariate) -> Self {
        function.value(self)
    }
    #[inline]
    fn bivariate(self, other: Self, function: Bivariate) -> Self {
        function.value(self, other)
    }
}
