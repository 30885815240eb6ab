//! Numbers with one mixed second derivative.

use super::bivariate::{Partials, ThirdPartials};
use super::scalar::{Scalar, product};

/// A value, its derivatives along two directions, and its mixed second derivative.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HyperDual {
    pub v: f64,
    pub x: f64,
    pub y: f64,
    pub xy: f64,
}

impl Scalar for HyperDual {
    #[inline]
    fn constant(v: f64) -> Self {
        Self {
            v,
            x: 0.0,
            y: 0.0,
            xy: 0.0,
        }
    }
    #[inline]
    fn value(self) -> f64 {
        self.v
    }
    #[inline]
    fn add(self, o: Self) -> Self {
        Self {
            v: self.v + o.v,
            x: self.x + o.x,
            y: self.y + o.y,
            xy: self.xy + o.xy,
        }
    }
    #[inline]
    fn sub(self, o: Self) -> Self {
        self.add(o.scale(-1.0))
    }
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self {
            v: self.v * o.v,
            x: self.x * o.v + self.v * o.x,
            y: self.y * o.v + self.v * o.y,
            xy: self.xy * o.v + self.x * o.y + self.y * o.x + self.v * o.xy,
        }
    }
    #[inline]
    fn div(self, o: Self) -> Self {
        let v = self.v / o.v;
        let x = (self.x - product(v, o.x)) / o.v;
        let y = (self.y - product(v, o.y)) / o.v;
        let mixed = product(x, o.y) + product(y, o.x) + product(v, o.xy);
        Self {
            v,
            x,
            y,
            xy: (self.xy - mixed) / o.v,
        }
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        Self {
            v: self.v * factor,
            x: self.x * factor,
            y: self.y * factor,
            xy: self.xy * factor,
        }
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
        Self {
            v: jet[0],
            x: product(jet[1], self.x),
            y: product(jet[1], self.y),
            xy: product(jet[1], self.xy) + product(jet[2], self.x * self.y),
        }
    }
    #[inline]
    fn chain2(self, o: Self, p: &Partials, _third: &ThirdPartials) -> Self {
        Self {
            v: p.f,
            x: product(p.a, self.x) + product(p.b, o.x),
            y: product(p.a, self.y) + product(p.b, o.y),
            xy: product(p.a, self.xy)
                + product(p.b, o.xy)
                + product(p.aa, self.x * self.y)
                + product(p.ab, self.x * o.y + self.y * o.x)
                + product(p.bb, o.x * o.y),
        }
    }
}
