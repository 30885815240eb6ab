//! Given functions of time.

use dalembert_expr::{Jet2, Program};

/// A scalar function of time with its first and second derivative.
///
/// Small, because every constraint row has one and nearly all are constants.
#[derive(Clone, Debug)]
pub enum TimeFunction {
    /// A constant.
    Constant(f64),
    /// Value zero and this constant rate: a row that only fixes a velocity.
    Rate(f64),
    /// An expression of `t` alone.
    Expression(Box<Program>),
    /// The integral of a rate.
    Integral(Box<RateIntegral>),
}

/// start + integral of a rate, an expression of `t` alone, from the first break on.
#[derive(Clone, Debug)]
pub struct RateIntegral {
    rate: Program,
    /// Value at the first break.
    start: f64,
    /// Ends of the panels of the quadrature, ascending; the first is the start [s].
    breaks: Vec<f64>,
    /// Integral from the start to every break.
    sums: Vec<f64>,
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

/// First panels of an integral: enough to see a rate that repeats over the run.
const PANELS: usize = 64;
/// A panel is halved at most so often: at a kink of the rate the error halves each time.
const HALVINGS: usize = 44;
/// Most panels: a rate that needs more changes too often over the run to be resolved.
const MOST_PANELS: usize = 1 << 20;

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
    /// The integral of a rate over [from, to]: panels of a 10-point rule, halved until both halves
    /// add up to the whole to rounding. None where the rate cannot be resolved.
    pub fn integral(rate: Program, start: f64, from: f64, to: f64) -> Option<Self> {
        let width = (to - from) / PANELS as f64;
        let (mut breaks, mut sums) = (vec![from], vec![0.0]);
        // Panels still to be done, the next one last: end and depth.
        let mut open: Vec<(f64, usize)> = (1..=PANELS)
            .rev()
            .map(|k| {
                (
                    if k == PANELS {
                        to
                    } else {
                        from + k as f64 * width
                    },
                    0,
                )
            })
            .collect();
        let (mut at, mut sum, mut scale) = (from, 0.0_f64, 0.0_f64);
        while let Some((end, depth)) = open.pop() {
            let mid = 0.5 * (at + end);
            let whole = gauss(&rate, at, end);
            let halves = gauss(&rate, at, mid) + gauss(&rate, mid, end);
            scale = scale.max(sum.abs()).max(halves.abs());
            let good = (whole - halves).abs() <= 1e-15 * scale + f64::MIN_POSITIVE;
            if good || depth == HALVINGS || mid <= at || mid >= end {
                sum += halves;
                at = end;
                breaks.push(at);
                sums.push(sum);
            } else {
                open.push((end, depth + 1));
                open.push((mid, depth + 1));
            }
            if breaks.len() + open.len() > MOST_PANELS || !sum.is_finite() {
                return None;
            }
        }
        Some(Self::Integral(Box::new(RateIntegral {
            rate,
            start,
            breaks,
            sums,
        })))
    }

    /// Value and the first two derivatives.
    pub fn jet(&self, t: f64) -> Jet2 {
        match self {
            Self::Constant(value) => Jet2::constant(*value),
            Self::Rate(rate) => Jet2::new(0.0, *rate, 0.0),
            Self::Expression(program) => jet_of(program, t),
            Self::Integral(integral) => integral.jet(t),
        }
    }
}

impl RateIntegral {
    fn jet(&self, t: f64) -> Jet2 {
        let derivative = jet_of(&self.rate, t);
        // The last break that is not behind t; before the start the first panel goes on
        // backwards, behind the end the last one forwards.
        let k = self.breaks.partition_point(|b| *b <= t).saturating_sub(1);
        let value = self.start + self.sums[k] + gauss(&self.rate, self.breaks[k], t);
        Jet2::new(value, derivative.v, derivative.d)
    }
}

fn jet_of(program: &Program, t: f64) -> Jet2 {
    let seed = Jet2::time(t);
    program.eval_jet(if program.slots().is_empty() {
        &[]
    } else {
        std::slice::from_ref(&seed)
    })
}
