//! Numbers with some first derivatives.

use super::bivariate::{Partials, ThirdPartials};
use super::scalar::{Scalar, product};

/// A value and its derivatives along N directions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dual<const N: usize> {
    pub v: f64,
    pub d: [f64; N],
}

impl<const N: usize> Dual<N> {
    #[inline]
    fn with(v: f64, d: impl FnMut(usize) -> f64) -> Self {
        Self {
            v,
            d: std::array::from_fn(d),
        }
    }
}

impl<const N: usize> Scalar for Dual<N> {
    #[inline]
    fn constant(v: f64) -> Self {
        Self { v, d: [0.0; N] }
    }
    #[inline]
    fn value(self) -> f64 {
        self.v
    }
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::with(self.v + o.v, |k| self.d[k] + o.d[k])
    }
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::with(self.v - o.v, |k| self.d[k] - o.d[k])
    }
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::with(self.v * o.v, |k| self.d[k] * o.v + self.v * o.d[k])
    }
    #[inline]
    fn div(self, o: Self) -> Self {
        let q = self.v / o.v;
        Self::with(q, |k| (self.d[k] - product(q, o.d[k])) / o.v)
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        Self::with(self.v * factor, |k| self.d[k] * factor)
    }
    #[inline]
    fn offset(self, term: f64) -> Self {
        Self {
            v: self.v + term,
            d: self.d,
        }
    }
    #[inline]
    fn chain(self, jet: [f64; 4]) -> Self {
        Self::with(jet[0], |k| product(jet[1], self.d[k]))
    }
    #[inline]
    fn chain2(self, o: Self, p: &Partials, _third: &ThirdPartials) -> Self {
        Self::with(p.f, |k| product(p.a, self.d[k]) + product(p.b, o.d[k]))
    }
}
