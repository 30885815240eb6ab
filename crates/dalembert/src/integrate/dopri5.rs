//! The method of Dormand and Prince of order 5(4) with dense output.

use super::{Ode, Stiffness};
use thiserror::Error;

// Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, table II.5.2.
const C: [f64; 7] = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
const A: [[f64; 6]; 7] = [
    [0.0; 6],
    [0.2, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [
        19372.0 / 6561.0,
        -25360.0 / 2187.0,
        64448.0 / 6561.0,
        -212.0 / 729.0,
        0.0,
        0.0,
    ],
    [
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
        0.0,
    ],
    [
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];
/// Weights of the fifth minus those of the embedded fourth order.
const E: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];
/// Weights of the dense output of order 4 (II.6.13 and following).
const D: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// Part of the tolerance that the error of one step may take.
const SHARE: f64 = 0.1;

/// Why a step could not be made.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError<E> {
    /// The step became too small for the precision of the time.
    #[error("the step became too small")]
    TooSmall {
        /// The last step tried.
        step: f64,
        /// Why the right side or the projection failed last, if that was the reason.
        cause: Option<E>,
    },
}

/// What one call of `step` did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StepReport {
    /// Attempts that were given up.
    pub rejected: usize,
}

/// Dormand-Prince 5(4): explicit Runge-Kutta of order 5 with an error estimate of order 4, PI step
/// control, dense output of order 4. Everything is allocated at the start.
#[derive(Clone, Debug)]
pub struct Dopri5 {
    /// Time of the last accepted state [s].
    pub t: f64,
    /// The last accepted state.
    pub y: Vec<f64>,
    /// Size of the next step [s].
    pub h: f64,
    /// Largest step [s].
    pub max_step: f64,
    /// Tolerance: errors of steps are held to a tenth of it, in units of the scales, because they add
    /// up over a run.
    pub tolerance: f64,
    /// Right sides evaluated.
    pub evaluations: usize,
    /// Is the step held down by stability?
    pub stiffness: Stiffness,
    k: [Vec<f64>; 7],
    stage: Vec<f64>,
    scales: Vec<f64>,
    dense: [Vec<f64>; 5],
    t_old: f64,
    h_old: f64,
    error_old: f64,
}

impl Dopri5 {
    /// Starts at (t, y); evaluates the right side once and guesses the first step.
    ///
    /// # Errors
    /// The right side cannot be evaluated at the start.
    pub fn start<O: Ode>(
        ode: &mut O,
        t: f64,
        y: &[f64],
        tolerance: f64,
        max_step: f64,
    ) -> Result<Self, O::Error> {
        let n = ode.dim();
        let zero = || vec![0.0; n];
        let mut s = Self {
            t,
            y: y.to_vec(),
            h: 0.0,
            max_step,
            tolerance,
            evaluations: 1,
            stiffness: Stiffness::default(),
            k: std::array::from_fn(|_| zero()),
            stage: zero(),
            scales: zero(),
            dense: std::array::from_fn(|_| zero()),
            t_old: t,
            h_old: 0.0,
            error_old: 1e-4,
        };
        ode.rhs(t, &s.y, &mut s.k[0])?;
        ode.scales(&s.y, &mut s.scales);
        // Hairer's guess (II.4.14): a step over which the solution changes by a small part of its
        // scale, to first and second order.
        let norm = |x: &[f64], scales: &[f64]| {
            x.iter()
                .zip(scales)
                .fold(0.0_f64, |a, (x, s)| a.max((x / s).abs()))
        };
        let d1 = norm(&s.k[0], &s.scales);
        let h0 = if d1 > 1e-10 { 0.01 / d1 } else { 1e-6 }.min(max_step);
        for ((stage, y), k) in s.stage.iter_mut().zip(&s.y).zip(&s.k[0]) {
            *stage = y + h0 * k;
        }
        let (first, rest) = s.k.split_at_mut(1);
        let d2 = match ode.rhs(t + h0, &s.stage, &mut rest[0]) {
            Ok(()) => {
                for (b, a) in rest[0].iter_mut().zip(&first[0]) {
                    *b -= a;
                }
                norm(&rest[0], &s.scales) / h0
            }
            Err(_) => 0.0,
        };
        s.evaluations += 1;
        let largest = d1.max(d2);
        let h1 = if largest <= 1e-15 {
            (h0 * 1e-3).max(1e-6)
        } else {
            (0.01 * SHARE * tolerance / largest).powf(0.2)
        };
        s.h = (100.0 * h0)
            .min(h1)
            .min(max_step)
            .max(1e-14 * t.abs().max(1e-3));
        Ok(s)
    }

    /// One accepted step, not beyond `end`.
    ///
    /// # Errors
    /// The step shrank to nothing.
    pub fn step<O: Ode>(
        &mut self,
        ode: &mut O,
        end: f64,
    ) -> Result<StepReport, StepError<O::Error>> {
        let mut report = StepReport::default();
        let mut cause = None;
        loop {
            let mut h = self.h.min(self.max_step);
            // A remainder that is too small for a step of its own is taken along.
            let last = self.t + 1.01 * h >= end;
            if last {
                h = end - self.t;
            }
            let smallest = 4.0 * f64::EPSILON * self.t.abs().max(1e-12);
            if h.is_nan() || h <= smallest {
                return Err(StepError::TooSmall { step: h, cause });
            }
            let failed = match self.try_step(ode, h) {
                Ok(error) if error <= 1.0 => {
                    match self.accept(ode, h, if last { end } else { self.t + h }, error) {
                        Ok(()) => return Ok(report),
                        Err(e) => Some(e),
                    }
                }
                Ok(error) => {
                    let factor = if error.is_finite() {
                        (0.9 * error.powf(-0.2)).clamp(0.2, 0.9)
                    } else {
                        0.2
                    };
                    self.h = h * factor;
                    None
                }
                Err(e) => Some(e),
            };
            if let Some(e) = failed {
                cause = Some(e);
                self.h = 0.25 * h;
            }
            report.rejected += 1;
        }
    }

    /// All stages of a step; the error in units of the tolerance.
    fn try_step<O: Ode>(&mut self, ode: &mut O, h: f64) -> Result<f64, O::Error> {
        for i in 1..7 {
            let (done, open) = self.k.split_at_mut(i);
            self.stage.copy_from_slice(&self.y);
            for (k, a) in done.iter().zip(A[i]) {
                if a != 0.0 {
                    axpy(h * a, k, &mut self.stage);
                }
            }
            ode.rhs(self.t + C[i] * h, &self.stage, &mut open[0])?;
            self.evaluations += 1;
        }
        ode.scales(&self.y, &mut self.scales);
        let mut worst: f64 = 0.0;
        for i in 0..self.y.len() {
            let error: f64 = (0..7).map(|s| E[s] * self.k[s][i]).sum();
            let scaled = (h * error / self.scales[i]).abs();
            if scaled.is_nan() {
                return Ok(f64::INFINITY);
            }
            worst = worst.max(scaled);
        }
        Ok(worst / (SHARE * self.tolerance))
    }

    fn accept<O: Ode>(&mut self, ode: &mut O, h: f64, t: f64, error: f64) -> Result<(), O::Error> {
        // The stage holds y1, which is also the argument of the last right side.
        let [d0, d1, d2, d3, d4] = &mut self.dense;
        for i in 0..self.y.len() {
            let (y0, y1) = (self.y[i], self.stage[i]);
            let difference = y1 - y0;
            let bend = h * self.k[0][i] - difference;
            d0[i] = y0;
            d1[i] = difference;
            d2[i] = bend;
            d3[i] = difference - h * self.k[6][i] - bend;
            d4[i] = h * (0..7).map(|s| D[s] * self.k[s][i]).sum::<f64>();
        }
        let rate = self.largest_rate(h);
        if ode.project(t, &mut self.stage)? {
            let (first, _) = self.k.split_at_mut(1);
            ode.rhs(t, &self.stage, &mut first[0])?;
            self.evaluations += 1;
        } else {
            self.k.swap(0, 6);
        }
        self.y.copy_from_slice(&self.stage);
        self.stiffness.step(self.t, h, rate);
        (self.t_old, self.h_old, self.t) = (self.t, h, t);
        // PI control (Hairer, Wanner II, IV.2) with the exponents of dopri5.
        let error = error.max(1e-10);
        let factor = 0.9 * error.powf(-0.17) * self.error_old.powf(0.04);
        self.error_old = error.max(1e-4);
        self.h = h * factor.clamp(0.2, 10.0);
        Ok(())
    }

    /// Estimate of the largest rate of the equation from the last two stages, which belong to the
    /// same time: |f(y1) - f(y6)| / |y1 - y6| in units of the scales.
    fn largest_rate(&self, h: f64) -> f64 {
        let (mut slopes, mut states) = (0.0, 0.0);
        for (i, scale) in self.scales.iter().enumerate() {
            let slope = (self.k[6][i] - self.k[5][i]) / scale;
            let weights = A[6].iter().zip(&A[5]);
            let state: f64 = weights
                .zip(&self.k)
                .map(|((last, before), k)| (last - before) * k[i])
                .sum();
            let state = h * state / scale;
            slopes += slope * slope;
            states += state * state;
        }
        if states > 0.0 {
            f64::sqrt(slopes / states)
        } else {
            0.0
        }
    }

    /// The state at a time inside the last step (order 4), without projection.
    pub fn interpolate(&self, t: f64, out: &mut [f64]) {
        let theta = if self.h_old > 0.0 {
            (t - self.t_old) / self.h_old
        } else {
            1.0
        };
        let rest = 1.0 - theta;
        let [d0, d1, d2, d3, d4] = &self.dense;
        for i in 0..out.len() {
            out[i] = d0[i] + theta * (d1[i] + rest * (d2[i] + theta * (d3[i] + rest * d4[i])));
        }
    }
}

fn axpy(a: f64, x: &[f64], y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}
