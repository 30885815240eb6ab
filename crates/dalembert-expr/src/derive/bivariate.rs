//! Functions of two numbers and their derivatives.

/// A function of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bivariate {
    /// Angle of the direction (b, a).
    Atan2,
    /// sqrt(a^2 + b^2).
    Hypot,
    /// a^b.
    Power,
}

/// Value and partial derivatives by the two arguments a and b.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Partials {
    pub f: f64,
    pub a: f64,
    pub b: f64,
    pub aa: f64,
    pub ab: f64,
    pub bb: f64,
}

impl Bivariate {
    /// Its value.
    #[inline]
    pub(crate) fn value(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Atan2 => a.atan2(b),
            Self::Hypot => a.hypot(b),
            Self::Power => a.powf(b),
        }
    }

    /// Value and partial derivatives. At the origin, where an angle or a distance has none, they
    /// are taken as zero.
    pub(crate) fn partials(self, a: f64, b: f64) -> Partials {
        let f = self.value(a, b);
        let flat = Partials {
            f,
            a: 0.0,
            b: 0.0,
            aa: 0.0,
            ab: 0.0,
            bb: 0.0,
        };
        match self {
            Self::Atan2 | Self::Hypot if a == 0.0 && b == 0.0 => flat,
            Self::Atan2 => {
                let r = a.hypot(b);
                let (s, c) = (a / r, b / r);
                Partials {
                    f,
                    a: c / r,
                    b: -s / r,
                    aa: -2.0 * s * c / r / r,
                    ab: (s - c) * (s + c) / r / r,
                    bb: 2.0 * s * c / r / r,
                }
            }
            Self::Hypot => {
                let (s, c) = (a / f, b / f);
                Partials {
                    f,
                    a: s,
                    b: c,
                    aa: c * c / f,
                    ab: -s * c / f,
                    bb: s * s / f,
                }
            }
            Self::Power => {
                let term = |c: f64, q: f64| if c == 0.0 { 0.0 } else { c * a.powf(q) };
                // 0^b stays 0 when b moves, as long as b is positive.
                let (log, slope) = if a == 0.0 && b > 0.0 {
                    (0.0, 0.0)
                } else {
                    (a.ln(), term(1.0, b - 1.0))
                };
                Partials {
                    f,
                    a: term(b, b - 1.0),
                    b: f * log,
                    aa: term(b * (b - 1.0), b - 2.0),
                    ab: slope * (1.0 + b * log),
                    bb: f * log * log,
                }
            }
        }
    }
}
