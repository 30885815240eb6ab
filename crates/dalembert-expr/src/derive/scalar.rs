//! What the evaluation of a program needs of a number.

use super::bivariate::{Bivariate, Partials, ThirdPartials};
use super::univariate::Univariate;

/// A number, plain or with derivatives.
pub(crate) trait Scalar: Copy {
    /// Are third derivatives of functions wanted? Where not, they are not computed.
    const THIRD: bool = false;

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
    /// A function of this number, given its value and first three derivatives; the third one
    /// counts only where [`Scalar::THIRD`] is set.
    fn chain(self, jet: [f64; 4]) -> Self;
    /// A function of two numbers, given its value and partial derivatives; the third ones count
    /// only where [`Scalar::THIRD`] is set.
    fn chain2(self, other: Self, partials: &Partials, third: &ThirdPartials) -> Self;

    fn univariate(self, function: Univariate) -> Self {
        let x = self.value();
        let [v, d, dd] = function.jet(x);
        let ddd = if Self::THIRD { function.third(x) } else { 0.0 };
        self.chain([v, d, dd, ddd])
    }

    fn bivariate(self, other: Self, function: Bivariate) -> Self {
        let (a, b) = (self.value(), other.value());
        let third = if Self::THIRD {
            function.third(a, b)
        } else {
            ThirdPartials::default()
        };
        self.chain2(other, &function.partials(a, b), &third)
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
    fn chain(self, jet: [f64; 4]) -> Self {
        jet[0]
    }
    #[inline]
    fn chain2(self, _other: Self, partials: &Partials, _third: &ThirdPartials) -> Self {
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
