//! Given functions of time.

use dalembert_expr::{Jet2, Program};

/// A scalar function of time with its first and second derivative.
#[derive(Clone, Debug)]
pub enum TimeFunction {
    /// A constant.
    Constant(f64),
    /// Value zero and this constant rate: a row that only fixes a velocity.
    Rate(f64),
    /// An expression of `t` alone.
    Expression(Program),
    /// start + integral of a rate, an expression of `t` alone, from `from` on.
    Integral {
        /// The rate.
        rate: Program,
        /// Value at `from`.
        start: f64,
        /// Start of the integral [s].
        from: f64,
        /// Length of a panel of the quadrature [s].
        panel: f64,
        /// Integral from `from` to the end of every panel, forward in time.
        sums: Vec<f64>,
    },
}

/// Nodes and weights of the 10-point Gauss-Legendre rule on [-1, 1], positive half
/// (Abramowitz and Stegun, table 25.4): exact to degree 19.
const GAUSS: [(f64, f64); 5] = [
    (0.148_874_338_981_631_2, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

fn eval(program: &Program, t: f64) -> f64 {
    program.eval(if program.slots().is_empty() {
        &[]
    } else {
        std::slice::from_ref(&t)
    })
}

fn gauss(rate: &Program, a: f64, b: f64) -> f64 {
    let (mid, half) = (0.5 * (a + b), 0.5 * (b - a));
    let mut sum = 0.0;
    for (x, w) in GAUSS {
        sum += w * (eval(rate, mid - half * x) + eval(rate, mid + half * x));
    }
    sum * half
}

impl TimeFunction {
    /// The integral of a rate over [from, to] in panels; more panels are added up on the way where a
    /// run goes further.
    pub fn integral(rate: Program, start: f64, from: f64, to: f64) -> Self {
        let panels = 256;
        let span = (to - from).abs().max(1e-9);
        let panel = span / panels as f64;
        let mut sums = Vec::with_capacity(panels);
        let mut sum = 0.0;
        for k in 0..panels {
            let a = from + k as f64 * panel;
            sum += gauss(&rate, a, a + panel);
            sums.push(sum);
        }
        Self::Integral {
            rate,
            start,
            from,
            panel,
            sums,
        }
    }

    /// Value and the first two derivatives.
    pub fn jet(&self, t: f64) -> Jet2 {
        match self {
            Self::Constant(value) => Jet2 {
                v: *value,
                d: 0.0,
                dd: 0.0,
            },
            Self::Rate(rate) => Jet2 {
                v: 0.0,
                d: *rate,
                dd: 0.0,
            },
            Self::Expression(program) => jet_of(program, t),
            Self::Integral {
                rate,
                start,
                from,
                panel,
                sums,
            } => {
                let derivative = jet_of(rate, t);
                Jet2 {
                    v: start + integral_value(rate, *from, *panel, sums, t),
                    d: derivative.v,
                    dd: derivative.d,
                }
            }
        }
    }
}

fn jet_of(program: &Program, t: f64) -> Jet2 {
    let seed = Jet2 {
        v: t,
        d: 1.0,
        dd: 0.0,
    };
    program.eval_jet(if program.slots().is_empty() {
        &[]
    } else {
        std::slice::from_ref(&seed)
    })
}

fn integral_value(rate: &Program, from: f64, panel: f64, sums: &[f64], t: f64) -> f64 {
    let position = (t - from) / panel;
    if position < 1.0 {
        // Before the first panel's end, and before the start of the run.
        return gauss(rate, from, t);
    }
    let full = (position.floor() as usize).min(sums.len());
    let mut a = from + full as f64 * panel;
    let mut sum = sums[full - 1];
    while a + panel < t {
        sum += gauss(rate, a, a + panel);
        a += panel;
    }
    sum + gauss(rate, a, t)
}
