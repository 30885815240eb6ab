//! Numbers with their first three derivatives.

use super::bivariate::{Partials, ThirdPartials};
use super::scalar::{Scalar, product};

/// A value and its first three derivatives by one variable.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet3 {
    pub v: f64,
    pub d: f64,
    pub dd: f64,
    pub ddd: f64,
}

impl Jet3 {
    const fn new(v: f64, d: f64, dd: f64, ddd: f64) -> Self {
        Self { v, d, dd, ddd }
    }

    /// The variable itself.
    pub(crate) const fn variable(v: f64) -> Self {
        Self::new(v, 1.0, 0.0, 0.0)
    }
}

impl Scalar for Jet3 {
    const THIRD: bool = true;

    #[inline]
    fn constant(v: f64) -> Self {
        Self::new(v, 0.0, 0.0, 0.0)
    }
    #[inline]
    fn value(self) -> f64 {
        self.v
    }
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.v + o.v, self.d + o.d, self.dd + o.dd, self.ddd + o.ddd)
    }
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.v - o.v, self.d - o.d, self.dd - o.dd, self.ddd - o.ddd)
    }
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::new(
            self.v * o.v,
            self.d * o.v + self.v * o.d,
            self.dd * o.v + 2.0 * self.d * o.d + self.v * o.dd,
            self.ddd * o.v + 3.0 * (self.dd * o.d + self.d * o.dd) + self.v * o.ddd,
        )
    }
    #[inline]
    fn div(self, o: Self) -> Self {
        // The quotient times the divisor is this number: its derivatives follow one by one.
        let v = self.v / o.v;
        let d = (self.d - product(v, o.d)) / o.v;
        let dd = (self.dd - 2.0 * product(d, o.d) - product(v, o.dd)) / o.v;
        let mixed = product(dd, o.d) + product(d, o.dd);
        let ddd = (self.ddd - 3.0 * mixed - product(v, o.ddd)) / o.v;
        Self::new(v, d, dd, ddd)
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        Self::new(
            self.v * factor,
            self.d * factor,
            self.dd * factor,
            self.ddd * factor,
        )
    }
    #[inline]
    fn offset(self, term: f64) -> Self {
        Self {
            v: self.v + term,
            ..self
        }
    }
    #[inline]
    fn chain(self, jet: [f64; 4]) -> Self {
        let [f, f1, f2, f3] = jet;
        Self::new(
            f,
            product(f1, self.d),
            product(f1, self.dd) + product(f2, self.d * self.d),
            product(f1, self.ddd)
                + 3.0 * product(f2, self.d * self.dd)
                + product(f3, self.d * self.d * self.d),
        )
    }
    #[inline]
    fn chain2(self, o: Self, p: &Partials, third: &ThirdPartials) -> Self {
        let second = product(p.aa, self.d * self.dd)
            + product(p.ab, self.d * o.dd + self.dd * o.d)
            + product(p.bb, o.d * o.dd);
        let mixed =
            product(third.aab, self.d * self.d * o.d) + product(third.abb, self.d * o.d * o.d);
        Self::new(
            p.f,
            product(p.a, self.d) + product(p.b, o.d),
            product(p.a, self.dd)
                + product(p.b, o.dd)
                + product(p.aa, self.d * self.d)
                + 2.0 * product(p.ab, self.d * o.d)
                + product(p.bb, o.d * o.d),
            product(p.a, self.ddd)
                + product(p.b, o.ddd)
                + 3.0 * (second + mixed)
                + product(third.aaa, self.d * self.d * self.d)
                + product(third.bbb, o.d * o.d * o.d),
        )
    }
}
