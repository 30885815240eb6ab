//! Functions of one number and their derivatives.

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Univariate {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Log10,
    Sqrt,
    Abs,
    /// -1, 0 or 1.
    Sign,
    Floor,
    /// 0 below zero, 1 from zero on.
    Step,
    /// From 0 at 0 to 1 at 1 with two zero derivatives at both: 6 x^5 - 15 x^4 + 10 x^3.
    Smooth,
    /// A fixed whole power.
    PowInt(i32),
    /// A fixed power.
    PowReal(f64),
}

impl Univariate {
    /// Its value.
    #[inline]
    pub(crate) fn value(self, x: f64) -> f64 {
        match self {
            Self::Sin => x.sin(),
            Self::Cos => x.cos(),
            Self::Tan => x.tan(),
            Self::Asin => x.asin(),
            Self::Acos => x.acos(),
            Self::Atan => x.atan(),
            Self::Sinh => x.sinh(),
            Self::Cosh => x.cosh(),
            Self::Tanh => x.tanh(),
            Self::Exp => x.exp(),
            Self::Ln => x.ln(),
            Self::Log10 => x.log10(),
            Self::Sqrt => x.sqrt(),
            Self::Abs => x.abs(),
            Self::Sign => sign(x),
            Self::Floor => x.floor(),
            Self::Step if x.is_nan() => x,
            Self::Step => f64::from(x >= 0.0),
            Self::Smooth => smooth(x)[0],
            Self::PowInt(n) => whole_power(x, n),
            Self::PowReal(p) => x.powf(p),
        }
    }

    /// Value, first and second derivative. At a kink the derivatives are those of a flat top.
    pub(crate) fn jet(self, x: f64) -> [f64; 3] {
        let v = self.value(x);
        match self {
            Self::Sin => {
                let (s, c) = x.sin_cos();
                [s, c, -s]
            }
            Self::Cos => {
                let (s, c) = x.sin_cos();
                [c, -s, -c]
            }
            Self::Tan => {
                let d = 1.0 + v * v;
                [v, d, 2.0 * v * d]
            }
            Self::Asin => {
                let r = (1.0 - x) * (1.0 + x);
                let d = 1.0 / r.sqrt();
                [v, d, x * d / r]
            }
            Self::Acos => {
                let r = (1.0 - x) * (1.0 + x);
                let d = -1.0 / r.sqrt();
                [v, d, x * d / r]
            }
            Self::Atan => {
                let d = 1.0 / (1.0 + x * x);
                [v, d, -2.0 * x * d * d]
            }
            Self::Sinh => [v, x.cosh(), v],
            Self::Cosh => [v, x.sinh(), v],
            Self::Tanh => {
                // 1/cosh^2 keeps its digits where 1 - tanh^2 loses them.
                let c = x.cosh();
                let d = 1.0 / (c * c);
                [v, d, -2.0 * v * d]
            }
            Self::Exp => [v, v, v],
            Self::Ln => [v, 1.0 / x, -1.0 / (x * x)],
            Self::Log10 => {
                let m = std::f64::consts::LOG10_E;
                [v, m / x, -m / (x * x)]
            }
            Self::Sqrt => {
                let d = 0.5 / v;
                [v, d, -0.5 * d / x]
            }
            Self::Abs => [v, sign(x), 0.0],
            Self::Sign | Self::Floor | Self::Step => [v, 0.0, 0.0],
            Self::Smooth => smooth(x),
            Self::PowInt(n) => {
                let power = |c: f64, k: i32| if c == 0.0 { 0.0 } else { c * whole_power(x, k) };
                let p = f64::from(n);
                [
                    v,
                    power(p, n.saturating_sub(1)),
                    power(p * (p - 1.0), n.saturating_sub(2)),
                ]
            }
            Self::PowReal(p) => {
                let power = |c: f64, q: f64| if c == 0.0 { 0.0 } else { c * x.powf(q) };
                [v, power(p, p - 1.0), power(p * (p - 1.0), p - 2.0)]
            }
        }
    }
}

impl Univariate {
    /// Third derivative, with the conventions of [`Univariate::jet`].
    pub(crate) fn third(self, x: f64) -> f64 {
        match self {
            Self::Sin => -x.cos(),
            Self::Cos => x.sin(),
            Self::Tan => {
                let v = x.tan();
                let d = 1.0 + v * v;
                2.0 * d * (d + 2.0 * v * v)
            }
            Self::Asin => arc_sine_third(x),
            Self::Acos => -arc_sine_third(x),
            Self::Atan => {
                // Written so that a large x gives 0, not infinity times 0.
                let d = 1.0 / (1.0 + x * x);
                let q = x * d;
                2.0 * d * (3.0 * q * q - d * d)
            }
            Self::Sinh => x.cosh(),
            Self::Cosh => x.sinh(),
            Self::Tanh => {
                let (v, c) = (x.tanh(), x.cosh());
                let d = 1.0 / (c * c);
                2.0 * d * (2.0 * v * v - d)
            }
            Self::Exp => x.exp(),
            Self::Ln => 2.0 / (x * x * x),
            Self::Log10 => 2.0 * std::f64::consts::LOG10_E / (x * x * x),
            Self::Sqrt => 0.375 / x.sqrt() / x / x,
            Self::Abs | Self::Sign | Self::Floor | Self::Step => 0.0,
            Self::Smooth if x <= 0.0 || x >= 1.0 => 0.0,
            Self::Smooth => 60.0 * (1.0 - 6.0 * x * (1.0 - x)),
            Self::PowInt(n) => {
                let p = f64::from(n);
                match p * (p - 1.0) * (p - 2.0) {
                    0.0 => 0.0,
                    c => c * whole_power(x, n.saturating_sub(3)),
                }
            }
            Self::PowReal(p) => match p * (p - 1.0) * (p - 2.0) {
                0.0 => 0.0,
                c => c * x.powf(p - 3.0),
            },
        }
    }
}

fn arc_sine_third(x: f64) -> f64 {
    let r = (1.0 - x) * (1.0 + x);
    (1.0 + 2.0 * x * x) / (r * r * r.sqrt())
}

/// A whole power, without a call for the usual ones.
#[inline]
fn whole_power(x: f64, n: i32) -> f64 {
    match n {
        -1 => 1.0 / x,
        0 => 1.0,
        1 => x,
        2 => x * x,
        3 => x * x * x,
        _ => x.powi(n),
    }
}

fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        // Zero, or not a number.
        x + 0.0
    }
}

fn smooth(x: f64) -> [f64; 3] {
    if x <= 0.0 {
        [0.0; 3]
    } else if x >= 1.0 {
        [1.0, 0.0, 0.0]
    } else {
        let y = 1.0 - x;
        [
            x * x * x * (10.0 - x * (15.0 - 6.0 * x)),
            30.0 * x * x * y * y,
            60.0 * x * y * (y - x),
        ]
    }
}
