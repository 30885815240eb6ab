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

/// Third partial derivatives by the two arguments a and b.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ThirdPartials {
    pub aaa: f64,
    pub aab: f64,
    pub abb: f64,
    pub bbb: f64,
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

    /// Third partial derivatives, with the conventions of [`Bivariate::partials`].
    pub(crate) fn third(self, a: f64, b: f64) -> ThirdPartials {
        match self {
            Self::Atan2 | Self::Hypot if a == 0.0 && b == 0.0 => ThirdPartials::default(),
            Self::Atan2 => {
                // The angle is the imaginary part of ln z with z = b + i a, and every derivative
                // by a is i times the one by b: all are parts of 2/z^3 = 2 exp(-3 i f)/r^3.
                let r = a.hypot(b);
                let (s, c) = (a / r, b / r);
                let sine = 2.0 * s * (3.0 * c * c - s * s) / r / r / r;
                let cosine = 2.0 * c * (c * c - 3.0 * s * s) / r / r / r;
                ThirdPartials {
                    aaa: -cosine,
                    aab: sine,
                    abb: cosine,
                    bbb: -sine,
                }
            }
            Self::Hypot => {
                let r = a.hypot(b);
                let (s, c) = (a / r, b / r);
                ThirdPartials {
                    aaa: -3.0 * s * c * c / r / r,
                    aab: c * (2.0 * s * s - c * c) / r / r,
                    abb: s * (2.0 * c * c - s * s) / r / r,
                    bbb: -3.0 * c * s * s / r / r,
                }
            }
            Self::Power => {
                let term = |c: f64, q: f64| if c == 0.0 { 0.0 } else { c * a.powf(q) };
                let aaa = term(b * (b - 1.0) * (b - 2.0), b - 3.0);
                if a == 0.0 && b > 0.0 {
                    return ThirdPartials {
                        aaa,
                        ..ThirdPartials::default()
                    };
                }
                let log = a.ln();
                ThirdPartials {
                    aaa,
                    aab: term(2.0 * b - 1.0 + b * (b - 1.0) * log, b - 2.0),
                    abb: term(log * (2.0 + b * log), b - 1.0),
                    bbb: self.value(a, b) * log * log * log,
                }
            }
        }
    }
}
