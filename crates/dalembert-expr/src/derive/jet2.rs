//! Numbers with their first and second time derivative.

use super::bivariate::{Partials, ThirdPartials};
use super::scalar::{Scalar, product};

/// A value and its first and second derivative along time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Jet2 {
    /// Value.
    pub v: f64,
    /// First derivative.
    pub d: f64,
    /// Second derivative.
    pub dd: f64,
}

impl Jet2 {
    /// A value that does not change.
    pub const fn constant(v: f64) -> Self {
        Self { v, d: 0.0, dd: 0.0 }
    }

    /// Time itself: its rate is 1.
    pub const fn time(t: f64) -> Self {
        Self {
            v: t,
            d: 1.0,
            dd: 0.0,
        }
    }

    /// A position, its velocity and its acceleration.
    pub const fn new(v: f64, d: f64, dd: f64) -> Self {
        Self { v, d, dd }
    }
}

impl Scalar for Jet2 {
    #[inline]
    fn constant(v: f64) -> Self {
        Self::constant(v)
    }
    #[inline]
    fn value(self) -> f64 {
        self.v
    }
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.v + o.v, self.d + o.d, self.dd + o.dd)
    }
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.v - o.v, self.d - o.d, self.dd - o.dd)
    }
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::new(
            self.v * o.v,
            self.d * o.v + self.v * o.d,
            self.dd * o.v + 2.0 * self.d * o.d + self.v * o.dd,
        )
    }
    #[inline]
    fn div(self, o: Self) -> Self {
        let v = self.v / o.v;
        let d = (self.d - product(v, o.d)) / o.v;
        let dd = (self.dd - 2.0 * product(d, o.d) - product(v, o.dd)) / o.v;
        Self::new(v, d, dd)
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        Self::new(self.v * factor, self.d * factor, self.dd * factor)
    }
    #[inline]
    fn offset(self, term: f64) -> Self {
        Self::new(self.v + term, self.d, self.dd)
    }
    #[inline]
    fn chain(self, jet: [f64; 4]) -> Self {
        Self::new(
            jet[0],
            product(jet[1], self.d),
            product(jet[1], self.dd) + product(jet[2], self.d * self.d),
        )
    }
    #[inline]
    fn chain2(self, o: Self, p: &Partials, _third: &ThirdPartials) -> Self {
        Self::new(
            p.f,
            product(p.a, self.d) + product(p.b, o.d),
            product(p.a, self.dd)
                + product(p.b, o.dd)
                + product(p.aa, self.d * self.d)
                + 2.0 * product(p.ab, self.d * o.d)
                + product(p.bb, o.d * o.d),
        )
    }
}
