//! Adams-Bashforth-Moulton of variable order and step.

use super::norm::{axpy, largest, norm};
use super::step::{SHARE, towards};
use super::{Ode, StepError, StepReport};

/// Highest order of the predictor.
pub const HIGHEST_ORDER: usize = 12;

/// Values and differences kept: one for each order, and one more to judge the next one.
const KEPT: usize = HIGHEST_ORDER + 2;

/// Adams methods on a variable grid: predict by Adams-Bashforth of order k, evaluate, correct by Adams-Moulton of order
/// k + 1, evaluate (PECE).
///
/// The interpolation polynomials of the right side are kept as modified divided differences Phi_j, in which constant steps
/// leave the plain backward differences (Krogh; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I,
/// III.5.6 to 5.11; order and step as in Shampine and Gordon, Computer Solution of Ordinary Differential Equations).
/// Starts itself with order 1 and small steps. Everything is allocated at the start.
#[derive(Clone, Debug)]
pub struct Adams {
    /// Time of the last accepted state [s].
    pub t: f64,
    /// The last accepted state.
    pub y: Vec<f64>,
    /// Size of the next step [s].
    pub h: f64,
    /// Largest step [s].
    pub max_step: f64,
    /// Tolerance: errors of steps are held to a tenth of it, in units of the scales.
    pub tolerance: f64,
    /// Highest order of the predictor that is used.
    pub max_order: usize,
    /// Order of the predictor of the next step.
    pub order: usize,
    /// Right sides evaluated.
    pub evaluations: usize,
    /// Times of the last states, the newest first.
    times: [f64; KEPT],
    /// How many of them belong to this run of the history.
    known: usize,
    /// Phi_j at the last state.
    phi: Vec<Vec<f64>>,
    /// beta_j Phi_j: the differences extrapolated to the end of the step.
    star: Vec<Vec<f64>>,
    predicted: Vec<f64>,
    slope: Vec<f64>,
    /// Phi_k at the predicted state.
    change: Vec<f64>,
    scales: Vec<f64>,
    /// Order raises and steps double until the first obstacle.
    starting: bool,
    /// Steps of the same size so far.
    same: usize,
    /// Order of the last step.
    last_order: usize,
    last_step: f64,
}

/// What a predicted step promises.
#[derive(Clone, Copy)]
struct Trial {
    /// Error in units of what is allowed.
    error: f64,
    /// Estimates of the error at orders k, k - 1 in the same units.
    here: f64,
    below: f64,
    /// Is the order below no worse?
    lower: bool,
}

impl Adams {
    /// Starts at (t, y); evaluates the right side twice and guesses the first step.
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
            max_order: HIGHEST_ORDER,
            order: 1,
            evaluations: 0,
            times: [t; KEPT],
            known: 1,
            phi: (0..KEPT).map(|_| zero()).collect(),
            star: (0..KEPT).map(|_| zero()).collect(),
            predicted: zero(),
            slope: zero(),
            change: zero(),
            scales: zero(),
            starting: true,
            same: 0,
            last_order: 1,
            last_step: 0.0,
        };
        s.restart(ode)?;
        Ok(s)
    }

    /// Forgets the history, as after a change of `y` that is no motion.
    ///
    /// # Errors
    /// The right side cannot be evaluated here.
    pub fn restart<O: Ode>(&mut self, ode: &mut O) -> Result<(), O::Error> {
        ode.rhs(self.t, &self.y, &mut self.phi[0])?;
        self.evaluations += 1;
        ode.scales(&self.y, &mut self.scales);
        let speed = norm(&self.phi[0], &self.scales);
        // Order 1 errs by h^2 y'' / 2; nothing is known of y'', so the step is small, and doubles as long as it may.
        let allowed = SHARE * self.tolerance;
        let first = if speed > 1e-10 {
            0.25 * allowed.sqrt() / speed
        } else {
            1e-3 * allowed.sqrt()
        };
        self.h = first.min(self.max_step).max(1e-14 * self.t.abs().max(1e-3));
        self.times = [self.t; KEPT];
        (self.known, self.order, self.last_order) = (1, 1, 1);
        (self.starting, self.same, self.last_step) = (true, 0, 0.0);
        Ok(())
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
            let wanted = self.h.min(self.max_step);
            let Some((h, last)) = towards(self.t, wanted, end) else {
                return Err(StepError::TooSmall {
                    step: wanted,
                    cause,
                });
            };
            if h == self.last_step {
                self.same += 1;
            } else {
                self.same = 1;
            }
            let next = if last { end } else { self.t + h };
            let failed = match self.predict(ode, h, next) {
                Ok(trial) if trial.error <= 1.0 => match self.correct(ode, h, next, trial) {
                    Ok(()) => return Ok(report),
                    Err(e) => Some(e),
                },
                Ok(trial) => {
                    if trial.lower && self.order > 1 {
                        self.order -= 1;
                    }
                    None
                }
                Err(e) => Some(e),
            };
            self.starting = false;
            self.h = if failed.is_some() { 0.25 * h } else { 0.5 * h };
            cause = failed.or(cause);
            report.rejected += 1;
            self.last_step = 0.0;
            if report.rejected > 2 {
                // The history is of no use here.
                self.order = 1;
            }
        }
    }

    /// Predicts the state at the end of a step and evaluates there.
    fn predict<O: Ode>(&mut self, ode: &mut O, h: f64, next: f64) -> Result<Trial, O::Error> {
        let k = self.order;
        let g = weights(&self.times, next, h, k);
        let mut beta = 1.0;
        for j in 0..k.min(self.known) {
            if j > 0 {
                beta *= (next - self.times[j - 1]) / (self.times[0] - self.times[j]);
            }
            for (star, phi) in self.star[j].iter_mut().zip(&self.phi[j]) {
                *star = beta * phi;
            }
        }
        self.predicted.copy_from_slice(&self.y);
        for (g, star) in g.iter().zip(&self.star[..k]) {
            axpy(h * g, star, &mut self.predicted);
        }
        ode.rhs(next, &self.predicted, &mut self.slope)?;
        self.evaluations += 1;
        self.change.copy_from_slice(&self.slope);
        for star in &self.star[..k] {
            axpy(-1.0, star, &mut self.change);
        }
        ode.scales(&self.y, &mut self.scales);
        let allowed = SHARE * self.tolerance;
        let size = |x: f64| h * x / allowed;
        let change = norm(&self.change, &self.scales);
        let sigma = uneven(&self.times, next, h, k);
        let here = size(sigma[k] * moulton(k) * change);
        let (mut below, mut lower) = (0.0, false);
        if k > 1 {
            let one =
                (0..self.y.len()).map(|i| (self.change[i] + self.star[k - 1][i]) / self.scales[i]);
            below = size(sigma[k - 1] * moulton(k - 1) * largest(one));
            if k > 2 {
                let two = (0..self.y.len()).map(|i| {
                    (self.change[i] + self.star[k - 1][i] + self.star[k - 2][i]) / self.scales[i]
                });
                let two = size(sigma[k - 2] * moulton(k - 2) * largest(two));
                lower = below.max(two) <= here;
            } else {
                lower = below <= 0.5 * here;
            }
        }
        let error = size((g[k - 1] - g[k]) * change);
        Ok(Trial {
            error: if error.is_nan() { f64::INFINITY } else { error },
            here,
            below,
            lower,
        })
    }

    /// Corrects the predicted state, moves it onto the manifold, and chooses order and step of the next step.
    fn correct<O: Ode>(
        &mut self,
        ode: &mut O,
        h: f64,
        next: f64,
        trial: Trial,
    ) -> Result<(), O::Error> {
        let k = self.order;
        let g = weights(&self.times, next, h, k);
        axpy(h * g[k], &self.change, &mut self.predicted);
        ode.project(next, &mut self.predicted)?;
        ode.rhs(next, &self.predicted, &mut self.slope)?;
        self.evaluations += 1;
        // The difference above the order, where the grid allows it: what the next order would leave.
        let judged = self.same > k && self.known > k && k < self.max_order;
        if judged {
            let mut beta = 1.0;
            for j in 1..=k {
                beta *= (next - self.times[j - 1]) / (self.times[0] - self.times[j]);
            }
            for (star, phi) in self.star[k].iter_mut().zip(&self.phi[k]) {
                *star = beta * phi;
            }
        }
        // Phi_j at the new state, from the old ones.
        self.phi[0].copy_from_slice(&self.slope);
        for j in 1..=k + usize::from(judged) {
            let (done, open) = self.phi.split_at_mut(j);
            for (i, phi) in open[0].iter_mut().enumerate() {
                *phi = done[j - 1][i] - self.star[j - 1][i];
            }
        }
        self.times.copy_within(..KEPT - 1, 1);
        self.times[0] = next;
        self.known = (self.known + 1).min(k + 1 + usize::from(judged));
        self.y.copy_from_slice(&self.predicted);
        self.t = next;
        (self.last_order, self.last_step) = (k, h);
        let mut error = trial.here;
        if trial.lower || k == self.max_order {
            self.starting = false;
        }
        if trial.lower {
            self.order = k - 1;
            error = trial.below;
        } else if self.starting {
            self.order = k + 1;
        } else if judged {
            let allowed = SHARE * self.tolerance;
            let above = h * moulton(k + 1) * norm(&self.phi[k + 1], &self.scales) / allowed;
            if k > 1 && trial.below <= trial.here.min(above) {
                self.order = k - 1;
                error = trial.below;
            } else if above < if k > 1 { trial.here } else { 0.5 * trial.here } {
                self.order = k + 1;
                error = above;
            }
        }
        // Steps stay as they are or double: equal steps let the order rise.
        let power = (self.order + 1) as f64;
        self.h = if self.starting || error <= 0.5 * 2.0_f64.powf(-power) {
            2.0 * h
        } else if error <= 0.5 {
            h
        } else {
            h * (0.5 / error).powf(1.0 / power).clamp(0.5, 0.9)
        };
        Ok(())
    }

    /// The state at a time inside the last step, without projection: y and the polynomial of the slopes, integrated.
    pub fn interpolate(&self, t: f64, out: &mut [f64]) {
        let h = t - self.t;
        let terms = self.last_order + 1;
        // Repeated integrals of the products (s - x_0) ... (s - x_(j-1)), each over its value where the next point counts.
        let mut w = [0.0; KEPT + 1];
        for (i, w) in w.iter_mut().enumerate() {
            *w = 1.0 / (i + 1) as f64;
        }
        out.copy_from_slice(&self.y[..out.len()]);
        let mut before = 0.0;
        for j in 0..terms {
            if j > 0 {
                let span = self.times[0] - self.times[j];
                let (near, far) = ((h + before) / span, h / span);
                for i in 0..terms - j {
                    w[i] = near * w[i] - far * w[i + 1];
                }
                before = span;
            }
            for (out, phi) in out.iter_mut().zip(&self.phi[j]) {
                *out += h * w[0] * phi;
            }
        }
    }
}

/// Weights g_0 .. g_k of the differences in a step (III.5.10).
fn weights(times: &[f64; KEPT], next: f64, h: f64, k: usize) -> [f64; KEPT] {
    let mut c = [0.0; KEPT + 1];
    for (q, c) in c.iter_mut().enumerate() {
        *c = 1.0 / (q + 1) as f64;
    }
    let mut g = [0.0; KEPT];
    g[0] = 1.0;
    for j in 1..=k {
        let part = h / (next - times[j - 1]);
        for q in 0..=k - j {
            c[q] -= c[q + 1] * part;
        }
        g[j] = c[0];
    }
    g
}

/// How much the differences of uneven steps count against even ones.
fn uneven(times: &[f64; KEPT], next: f64, h: f64, k: usize) -> [f64; KEPT] {
    let mut sigma = [1.0; KEPT];
    for i in 1..=k {
        sigma[i] = i as f64 * h / (next - times[i - 1]) * sigma[i - 1];
    }
    sigma
}

/// |gamma*_k|: the error constants of Adams-Moulton (III.1.11).
fn moulton(k: usize) -> f64 {
    let mut gamma = [0.0; KEPT];
    gamma[0] = 1.0;
    for m in 1..=k {
        gamma[m] = -(0..m).map(|j| gamma[j] / (m + 1 - j) as f64).sum::<f64>();
    }
    gamma[k].abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Even steps leave the coefficients of Adams-Bashforth and Adams-Moulton (Shabana 6.11; Hairer, Norsett, Wanner I,
    /// III.1).
    #[test]
    fn even_steps_have_the_classical_coefficients() {
        let bashforth = [
            1.0,
            1.0 / 2.0,
            5.0 / 12.0,
            3.0 / 8.0,
            251.0 / 720.0,
            95.0 / 288.0,
            19_087.0 / 60_480.0,
            5_257.0 / 17_280.0,
            1_070_017.0 / 3_628_800.0,
        ];
        let corrector = [
            1.0,
            1.0 / 2.0,
            1.0 / 12.0,
            1.0 / 24.0,
            19.0 / 720.0,
            3.0 / 160.0,
            863.0 / 60_480.0,
            275.0 / 24_192.0,
            33_953.0 / 3_628_800.0,
        ];
        let times: [f64; KEPT] = std::array::from_fn(|i| -0.1 * i as f64);
        let g = weights(&times, 0.1, 0.1, 8);
        for k in 0..=8 {
            assert!((g[k] - bashforth[k]).abs() < 1e-15, "{k}: {}", g[k]);
            assert!(
                (moulton(k) - corrector[k]).abs() < 1e-16,
                "{k}: {}",
                moulton(k)
            );
        }
        let sigma = uneven(&times, 0.1, 0.1, 8);
        assert!(sigma[..=8].iter().all(|s| (s - 1.0).abs() < 1e-14));
    }
}
