//! Explicit Runge-Kutta methods with fixed or controlled steps.

use super::norm::{axpy, largest, norm};
use super::step::{SHARE, towards};
use super::{Dense, Errors, Ode, StepError, StepReport, Stiffness, Tableau};

/// Integration by an explicit Runge-Kutta method: PI step control where the method judges its error, steps of one size
/// otherwise. Everything is allocated at the start.
#[derive(Clone, Debug)]
pub struct RungeKutta {
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
    method: &'static Tableau,
    /// Slopes: of the stages, at the end of the step, and of the stages that the dense output adds.
    k: Vec<Vec<f64>>,
    /// Slope at the last accepted state.
    slope: Vec<f64>,
    stage: Vec<f64>,
    scales: Vec<f64>,
    /// Terms of the dense output.
    dense: Vec<Vec<f64>>,
    /// Are all of them there?
    filled: bool,
    t_old: f64,
    h_old: f64,
    error_old: f64,
}

impl RungeKutta {
    /// Starts at (t, y); `step` is the size of all steps for methods that do not judge their error, and a first guess, if
    /// any, for the others.
    ///
    /// # Errors
    /// The right side cannot be evaluated at the start.
    pub fn start<O: Ode>(
        method: &'static Tableau,
        ode: &mut O,
        t: f64,
        y: &[f64],
        tolerance: f64,
        max_step: f64,
        step: Option<f64>,
    ) -> Result<Self, O::Error> {
        let n = ode.dim();
        let zero = || vec![0.0; n];
        let (more, terms) = match method.dense {
            Dense::Cubic => (0, 4),
            Dense::More { c, d, .. } => (c.len(), 4 + d.len()),
        };
        let mut s = Self {
            t,
            y: y.to_vec(),
            h: 0.0,
            max_step,
            tolerance,
            evaluations: 0,
            stiffness: Stiffness::default(),
            method,
            k: (0..method.c.len() + 1 + more).map(|_| zero()).collect(),
            slope: zero(),
            stage: zero(),
            scales: zero(),
            dense: (0..terms).map(|_| zero()).collect(),
            filled: true,
            t_old: t,
            h_old: 0.0,
            error_old: 1e-4,
        };
        s.restart(ode)?;
        s.h = match step {
            Some(h) => h.min(max_step),
            None => s.first_step(ode),
        };
        Ok(s)
    }

    /// Takes up a state that was changed from outside.
    ///
    /// # Errors
    /// The right side cannot be evaluated here.
    pub fn restart<O: Ode>(&mut self, ode: &mut O) -> Result<(), O::Error> {
        self.evaluations += 1;
        ode.rhs(self.t, &self.y, &mut self.slope)
    }

    /// Hairer's guess (II.4.14): a step over which the solution changes by a small part of its scale, to first and second
    /// order.
    fn first_step<O: Ode>(&mut self, ode: &mut O) -> f64 {
        ode.scales(&self.y, &mut self.scales);
        let d1 = norm(&self.slope, &self.scales);
        let h0 = if d1 > 1e-10 { 0.01 / d1 } else { 1e-6 }.min(self.max_step);
        self.stage.copy_from_slice(&self.y);
        axpy(h0, &self.slope, &mut self.stage);
        let d2 = match ode.rhs(self.t + h0, &self.stage, &mut self.k[0]) {
            Ok(()) => {
                axpy(-1.0, &self.slope, &mut self.k[0]);
                norm(&self.k[0], &self.scales) / h0
            }
            Err(_) => 0.0,
        };
        self.evaluations += 1;
        let largest = d1.max(d2);
        let h1 = if largest <= 1e-15 {
            (h0 * 1e-3).max(1e-6)
        } else {
            (0.01 * SHARE * self.tolerance / largest).powf(1.0 / f64::from(self.method.order))
        };
        (100.0 * h0)
            .min(h1)
            .min(self.max_step)
            .max(1e-14 * self.t.abs().max(1e-3))
    }

    /// One accepted step, not beyond `end`.
    ///
    /// # Errors
    /// The step shrank to nothing, or a step of fixed size failed.
    pub fn step<O: Ode>(
        &mut self,
        ode: &mut O,
        end: f64,
    ) -> Result<StepReport, StepError<O::Error>> {
        let mut report = StepReport::default();
        let mut cause = None;
        loop {
            let wanted = self.h.min(self.max_step);
            let Some((h, last)) = towards(self.t, wanted, end) else {
                return Err(StepError::TooSmall {
                    step: wanted,
                    cause,
                });
            };
            let failed = match self.try_step(ode, h) {
                Ok(error) if error <= 1.0 => {
                    match self.accept(ode, h, if last { end } else { self.t + h }, error) {
                        Ok(()) => return Ok(report),
                        Err(e) => Some(e),
                    }
                }
                Ok(error) => {
                    let factor = if error.is_finite() {
                        (0.9 * error.powf(-1.0 / self.power())).clamp(0.2, 0.9)
                    } else {
                        0.2
                    };
                    self.h = h * factor;
                    None
                }
                Err(e) => Some(e),
            };
            if let Some(e) = failed {
                if matches!(self.method.errors, Errors::None) {
                    return Err(StepError::Fixed { step: h, cause: e });
                }
                cause = Some(e);
                self.h = 0.25 * h;
            }
            report.rejected += 1;
        }
    }

    fn power(&self) -> f64 {
        match self.method.errors {
            Errors::None => 1.0,
            Errors::Embedded { power, .. } | Errors::Twice { power, .. } => power,
        }
    }

    /// All stages of a step; the error in units of the tolerance.
    fn try_step<O: Ode>(&mut self, ode: &mut O, h: f64) -> Result<f64, O::Error> {
        let stages = self.method.c.len();
        self.k[0].copy_from_slice(&self.slope);
        for i in 1..stages {
            let (done, open) = self.k.split_at_mut(i);
            self.stage.copy_from_slice(&self.y);
            for (k, &a) in done.iter().zip(self.method.a[i]) {
                if a != 0.0 {
                    axpy(h * a, k, &mut self.stage);
                }
            }
            ode.rhs(self.t + self.method.c[i] * h, &self.stage, &mut open[0])?;
            self.evaluations += 1;
        }
        self.stage.copy_from_slice(&self.y);
        for (k, &b) in self.k.iter().zip(self.method.b) {
            if b != 0.0 {
                axpy(h * b, k, &mut self.stage);
            }
        }
        let judged = |weights: &[f64], k: &[Vec<f64>], scales: &[f64]| {
            let error = |i: usize| -> f64 {
                weights.iter().zip(k).map(|(w, k)| w * k[i]).sum::<f64>() / scales[i]
            };
            largest((0..scales.len()).map(error))
        };
        let error = match self.method.errors {
            Errors::None => return Ok(0.0),
            Errors::Embedded { weights, .. } => {
                // The weights reach the slope at the end.
                ode.rhs(self.t + h, &self.stage, &mut self.k[stages])?;
                self.evaluations += 1;
                ode.scales(&self.y, &mut self.scales);
                judged(weights, &self.k, &self.scales)
            }
            Errors::Twice { high, low, .. } => {
                ode.scales(&self.y, &mut self.scales);
                let high = judged(high, &self.k, &self.scales);
                let low = judged(low, &self.k, &self.scales);
                if high == 0.0 {
                    0.0
                } else {
                    high * high / high.hypot(0.1 * low)
                }
            }
        };
        let error = h * error / (SHARE * self.tolerance);
        Ok(if error.is_nan() { f64::INFINITY } else { error })
    }

    fn accept<O: Ode>(&mut self, ode: &mut O, h: f64, t: f64, error: f64) -> Result<(), O::Error> {
        let stages = self.method.c.len();
        if !matches!(self.method.errors, Errors::Embedded { .. }) {
            ode.rhs(t, &self.stage, &mut self.k[stages])?;
            self.evaluations += 1;
        }
        // The stage holds y1, and the slope there is known: the cubic of the step.
        let [d0, d1, d2, d3] = &mut self.dense[..4] else {
            unreachable!("start() makes four terms at least")
        };
        for i in 0..self.y.len() {
            let (y0, y1) = (self.y[i], self.stage[i]);
            let difference = y1 - y0;
            let bend = h * self.k[0][i] - difference;
            d0[i] = y0;
            d1[i] = difference;
            d2[i] = bend;
            d3[i] = difference - h * self.k[stages][i] - bend;
        }
        let rate = self.largest_rate(h);
        if ode.project(t, &mut self.stage)? {
            ode.rhs(t, &self.stage, &mut self.slope)?;
            self.evaluations += 1;
        } else {
            self.slope.copy_from_slice(&self.k[stages]);
        }
        self.filled = false;
        self.y.copy_from_slice(&self.stage);
        self.stiffness.step(self.t, h, rate);
        (self.t_old, self.h_old, self.t) = (self.t, h, t);
        if matches!(self.method.errors, Errors::None) {
            return Ok(());
        }
        // PI control (Hairer, Wanner II, IV.2) with the exponents of dopri5, for methods of higher order in proportion.
        let error = error.max(1e-10);
        let part = 5.0 / self.power();
        let factor = 0.9 * error.powf(-0.17 * part) * self.error_old.powf(0.04 * part);
        self.error_old = error.max(1e-4);
        self.h = h * factor.clamp(0.2, 10.0);
        Ok(())
    }

    /// Estimate of the largest rate of the equation from the last stage and the end of the step, where both belong to the
    /// same time: |f(y1) - f(ys)| / |y1 - ys| in units of the scales.
    fn largest_rate(&self, h: f64) -> f64 {
        let stages = self.method.c.len();
        if self.method.c[stages - 1] < 1.0 || stages == 1 {
            return 0.0;
        }
        let (mut slopes, mut states) = (0.0, 0.0);
        let last = self.method.a[stages - 1];
        for (i, scale) in self.scales.iter().enumerate() {
            let slope = (self.k[stages][i] - self.k[stages - 1][i]) / scale;
            let mut state = self.method.b[stages - 1] * self.k[stages - 1][i];
            for ((b, a), k) in self.method.b.iter().zip(last).zip(&self.k) {
                state += (b - a) * k[i];
            }
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

    /// The state at a time inside the last step, without projection. Some methods evaluate the right side for it, once a
    /// step.
    ///
    /// # Errors
    /// The right side cannot be evaluated inside the step.
    pub fn interpolate<O: Ode>(
        &mut self,
        ode: &mut O,
        t: f64,
        out: &mut [f64],
    ) -> Result<(), O::Error> {
        if !self.filled {
            self.fill(ode)?;
            self.filled = true;
        }
        let theta = if self.h_old > 0.0 {
            (t - self.t_old) / self.h_old
        } else {
            1.0
        };
        // d0 + theta (d1 + (1 - theta) (d2 + theta (d3 + ...)))
        let first = &self.dense[0];
        let factor = |term: usize| if term % 2 == 1 { theta } else { 1.0 - theta };
        for (i, out) in out.iter_mut().enumerate() {
            let terms = self.dense.iter().enumerate().skip(1).rev();
            let sum = terms.fold(0.0, |sum, (term, d)| factor(term) * (d[i] + sum));
            *out = first[i] + sum;
        }
        Ok(())
    }

    /// Adds the higher terms of the dense output.
    fn fill<O: Ode>(&mut self, ode: &mut O) -> Result<(), O::Error> {
        let Dense::More { c, a, d } = self.method.dense else {
            return Ok(());
        };
        let h = self.h_old;
        let known = self.method.c.len() + 1;
        for (number, (c, a)) in c.iter().zip(a).enumerate() {
            let (done, open) = self.k.split_at_mut(known + number);
            self.stage.copy_from_slice(&self.dense[0]);
            for (k, &a) in done.iter().zip(*a) {
                if a != 0.0 {
                    axpy(h * a, k, &mut self.stage);
                }
            }
            ode.rhs(self.t_old + c * h, &self.stage, &mut open[0])?;
            self.evaluations += 1;
        }
        for (term, d) in self.dense[4..].iter_mut().zip(d) {
            term.fill(0.0);
            for (k, &d) in self.k.iter().zip(*d) {
                if d != 0.0 {
                    axpy(h * d, k, term);
                }
            }
        }
        Ok(())
    }
}
