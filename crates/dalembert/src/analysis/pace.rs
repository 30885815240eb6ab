//! Does a simulation reach its end in a reasonable number of steps?

use super::stiffest::Stiffest;
use crate::integrate::Stiffness;

/// Steps at the boundary of stability, one after another, after which a run whose end is out of
/// reach is given up: a collision or another short stiff phase takes fewer.
const LONG: usize = 10_000;

/// Steps between two looks at how fast a run gets on.
const LOOK: usize = 1_000;

/// Counts the steps of a simulation against those that it may take.
#[derive(Clone, Debug)]
pub(super) struct Pace {
    most: usize,
    start: f64,
    end: f64,
    /// Time at which the present run of steps at the boundary of stability began.
    stiff_from: f64,
    /// Time at the last look at the speed of the run, and looks in a row at which it crawled.
    looked: f64,
    crawled: usize,
}

impl Pace {
    /// From `start` to `end` in at most `most` steps.
    pub fn new(start: f64, end: f64, most: usize) -> Self {
        Self {
            most,
            start,
            end,
            stiff_from: start,
            looked: start,
            crawled: 0,
        }
    }

    /// How many steps a largest step allows no fewer than, where these are too many.
    pub fn too_many(&self, max_step: f64) -> Option<f64> {
        let least = (self.end - self.start) / max_step;
        (least > self.most as f64).then_some(least)
    }

    /// Must the run end after this many steps, at time `t`?
    pub fn over(&mut self, t: f64, steps: usize, stiffness: &Stiffness) -> bool {
        if steps >= self.most {
            return true;
        }
        if stiffness.streak == 0 {
            self.stiff_from = t;
        }
        if stiffness.streak < LONG || !stiffness.streak.is_multiple_of(LONG) {
            return false;
        }
        let mean = (t - self.stiff_from) / stiffness.streak as f64;
        (self.end - t) > mean * self.most as f64
    }

    /// Has the run been so slow over the last thousands of steps that all the steps it may take would
    /// not bring it to its end?
    pub fn crawls(&mut self, t: f64, steps: usize) -> bool {
        if steps == 0 || !steps.is_multiple_of(LOOK) {
            return false;
        }
        let mean = (t - self.looked) / LOOK as f64;
        self.looked = t;
        self.crawled = if self.end - t > mean * self.most as f64 {
            self.crawled + 1
        } else {
            0
        };
        self.crawled >= 3
    }

    /// What held a run up that took `steps` steps until `t`, and what to do.
    pub fn reason(
        &self,
        t: f64,
        steps: usize,
        limits: &Limits,
        stiffness: &Stiffness,
        fastest: Option<&Stiffest>,
    ) -> String {
        let mean = (t - self.start) / steps.max(1) as f64;
        let seconds = format!(
            "simulate fewer seconds, or allow more steps (analysis.max_steps, now {})",
            self.most
        );
        if mean > 0.8 * limits.max_step {
            return format!(
                "max_step = {:e} s allows no longer steps: give a larger max_step, {seconds}",
                limits.max_step
            );
        }
        let stiff = stiffness.steps > steps / 2 || stiffness.streak >= LONG;
        let held = if stiff {
            format!(
                "its steps, {mean:.1e} s long, are held down by stability, not by the tolerance: the equations are stiff"
            )
        } else {
            format!("its steps were {mean:.1e} s long")
        };
        match fastest {
            // An element that is much slower than the steps is not to blame.
            Some(f) if f.rate * mean > 0.01 => {
                format!("{held}; {}: {}, {seconds}", f.blame(), f.remedy(stiff))
            }
            _ if stiff && limits.baumgarte => format!(
                "{held}; give smaller Baumgarte parameters or stabilization = \"projection\", {seconds}"
            ),
            _ => format!("{held}; enlarge the tolerance, {seconds}"),
        }
    }

    /// The note on a run that was stiff on its way and yet came through.
    pub fn note(steps: usize, stiffness: &Stiffness, fastest: Option<&Stiffest>) -> Option<String> {
        let since = stiffness.since?;
        // A short run or a short stiff phase costs little.
        if stiffness.steps < LONG / 2 || 5 * stiffness.steps < steps {
            return None;
        }
        let who = fastest.map_or_else(String::new, |f| format!("; {}", f.blame()));
        Some(format!(
            "warning: stiff from t = {since:.6} s on: {} of {steps} steps were held down by stability, not by the tolerance{who}",
            stiffness.steps
        ))
    }
}

/// What else may limit the steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Largest step [s].
    pub max_step: f64,
    /// Do the constraints decay by Baumgarte's method?
    pub baumgarte: bool,
}

impl Stiffest {
    /// "the fastest element is the damping of 'bumper' (spring-damper), 1.2e7 1/s"
    fn blame(&self) -> String {
        let part = if self.damping { "damping" } else { "stiffness" };
        format!(
            "the fastest motion is that of the {part} of {}, {:.1e} 1/s",
            self.element, self.rate
        )
    }

    fn remedy(&self, stiff: bool) -> &'static str {
        match (self.damping, stiff) {
            (true, _) => "give it less damping",
            (false, true) => "make it softer",
            (false, false) => "make it softer, enlarge the tolerance",
        }
    }
}
