//! Options of the analyses, resolved.

use super::context::Context;
use super::geometry::Geometry;
use crate::analysis::Recording;
use crate::diagnostic::Diagnostic;
use crate::model::{Method, Stabilization, Value};
use crate::space::orientation::OrientationSet;
use crate::words::readable;
use dalembert_expr::Dim;
use nalgebra::Vector3;

/// Options of the analyses, as numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Start time [s].
    pub start: f64,
    /// End time [s].
    pub end: f64,
    /// Time between written results [s].
    pub step: f64,
    /// Relative error tolerance.
    pub tolerance: f64,
    /// Method of the integration.
    pub integrator: Method,
    /// Largest integration step [s]; the step itself for methods with steps of one size.
    pub max_step: f64,
    /// Most integration steps.
    pub max_steps: usize,
    /// How constraints are kept.
    pub stabilization: Stabilization,
    /// Baumgarte's alpha and beta [1/s].
    pub baumgarte: [f64; 2],
    /// Most Newton iterations.
    pub max_iterations: usize,
    /// Joints whose actuators produce the driven motion in `inverse`.
    pub actuators: Vec<String>,
    /// Independent coordinates chosen by the user.
    pub independent: Vec<String>,
    /// What runs write.
    pub recording: Recording,
}

/// Most integration steps where the model gives no number: a minute or so of a small machine, a
/// thousand times what most runs take.
const MAX_STEPS: usize = 1_000_000;

impl Default for Options {
    fn default() -> Self {
        Self {
            start: 0.0,
            end: 1.0,
            step: 0.01,
            tolerance: 1e-8,
            integrator: Method::default(),
            max_step: f64::INFINITY,
            max_steps: MAX_STEPS,
            stabilization: Stabilization::Projection,
            baumgarte: [50.0, 50.0],
            max_iterations: 50,
            actuators: Vec::new(),
            independent: Vec::new(),
            recording: Recording::default(),
        }
    }
}

impl Options {
    /// Instants of the written results: start, start + step, ..., end.
    pub fn instants(&self) -> Vec<f64> {
        // At least the start and the end are written.
        if self.step >= self.end - self.start {
            return vec![self.start, self.end];
        }
        let steps = ((self.end - self.start) / self.step * (1.0 + 1e-12)).floor() as usize;
        let mut times: Vec<f64> = (0..=steps)
            .map(|k| self.start + k as f64 * self.step)
            .collect();
        if let Some(last) = times.last_mut() {
            if (self.end - *last).abs() <= 1e-9 * self.step {
                *last = self.end;
            } else {
                times.push(self.end);
            }
        }
        times
    }
}

impl<S: Geometry> Context<'_, S> {
    /// The set of coordinates in which orientations are written.
    fn output_orientation(&mut self) -> OrientationSet {
        let Some(name) = &self.model.output.orientation else {
            return OrientationSet::default();
        };
        name.parse().unwrap_or_else(|_| {
            self.report(
                Diagnostic::error(
                    "bad-orientation",
                    "output.orientation",
                    format!("output: '{name}' is not a set of coordinates for orientations"),
                )
                .help(
                    "write \"euler-parameters\", \"axis-angle\", \"rodriguez\", \"direction-cosines\" or a sequence \
                     of Euler angles like \"euler-zxz\"",
                ),
            );
            OrientationSet::default()
        })
    }

    /// The point about which momenta are written.
    fn momentum_point(&mut self) -> Option<[f64; 3]> {
        let point = self.model.output.momentum_about.as_ref()?;
        let found = self.vector(point, Dim::LENGTH, "output", "output.momentum_about")?;
        Some(found.into())
    }

    /// Resolves the options and gravity.
    pub fn options(&mut self) {
        let model = self.model;
        let a = &model.analysis;
        let owner = "analysis";
        let mut number = |value: &Option<Value>, dim: Dim, key: &str| {
            value
                .as_ref()
                .and_then(|v| self.number(v, dim, owner, &format!("analysis.{key}")))
        };
        let start = number(&a.start, Dim::TIME, "start").unwrap_or(0.0);
        let end = number(&a.end, Dim::TIME, "end").unwrap_or(start + 1.0);
        let step = number(&a.step, Dim::TIME, "step").unwrap_or((end - start) / 100.0);
        let tolerance = number(&a.tolerance, Dim::NONE, "tolerance").unwrap_or(1e-8);
        let max_step = number(&a.max_step, Dim::TIME, "max_step").unwrap_or(f64::INFINITY);
        let fixed_step = number(&a.fixed_step, Dim::TIME, "fixed_step");
        let integrator = a.integrator.unwrap_or_default();
        let mut baumgarte = [50.0, 50.0];
        if let Some(values) = &a.baumgarte {
            for (k, value) in values.iter().enumerate() {
                let path = format!("analysis.baumgarte[{k}]");
                if let Some(x) = self.number(value, Dim::FREQUENCY, owner, &path) {
                    baumgarte[k] = x;
                }
            }
        }
        let mut check = |good: bool, key: &str, message: &str, help: &str| {
            if !good {
                let d = Diagnostic::error(
                    "bad-option",
                    format!("analysis.{key}"),
                    format!("analysis: {message}"),
                );
                self.report(d.help(help));
            }
        };
        check(
            end > start,
            "end",
            &format!(
                "end ({} s) is not after start ({} s)",
                readable(end),
                readable(start)
            ),
            "give a later end",
        );
        check(
            step > 0.0,
            "step",
            "step must be positive",
            "give a positive step",
        );
        check(
            (1e-14..=0.1).contains(&tolerance),
            "tolerance",
            &format!("tolerance {tolerance} is not between 1e-14 and 0.1"),
            "1e-8 suits most machines",
        );
        let fixed = integrator.has_fixed_steps();
        let name = integrator.name();
        check(
            !fixed || a.fixed_step.is_some(),
            "integrator",
            &format!("{name} makes steps of one size, which is missing"),
            "give fixed_step, like \"1 ms\"",
        );
        check(
            fixed || a.fixed_step.is_none(),
            "fixed_step",
            &format!("{name} chooses its steps by the tolerance, and has no fixed_step"),
            "leave fixed_step out, or choose integrator = \"rk4\"; max_step limits the steps",
        );
        check(
            !fixed || a.max_step.is_none(),
            "max_step",
            &format!("{name} makes steps of one size"),
            "leave max_step out: fixed_step is the step",
        );
        check(
            fixed_step.is_none_or(|h| h > 0.0),
            "fixed_step",
            "fixed_step must be positive",
            "give a positive fixed_step",
        );
        check(
            max_step > 0.0,
            "max_step",
            "max_step must be positive",
            "give a positive max_step",
        );
        check(
            a.max_steps != Some(0),
            "max_steps",
            "max_steps must be positive",
            "give a positive max_steps, or leave it out",
        );
        check(
            baumgarte.iter().all(|x| *x > 0.0),
            "baumgarte",
            "alpha and beta must be positive",
            "50 and 50 per second is a usual choice",
        );
        if !(end - start).is_finite() {
            check(
                false,
                "end",
                "the time from start to end is not a finite number",
                "give times of a usual size",
            );
        } else if step > 0.0 && (end - start) / step > 1e7 {
            check(
                false,
                "step",
                "more than ten million instants would be written",
                "give a larger step",
            );
        }
        self.options = super::Options {
            start,
            end,
            step,
            tolerance,
            integrator,
            max_step: fixed_step.unwrap_or(max_step),
            max_steps: a.max_steps.map_or(MAX_STEPS, |n| n as usize),
            stabilization: a.stabilization.unwrap_or_default(),
            baumgarte,
            max_iterations: a.max_iterations.unwrap_or(50) as usize,
            actuators: a.actuators.clone(),
            independent: a.independent.clone(),
            recording: Recording {
                orientation: self.output_orientation(),
                momentum_about: self.momentum_point(),
            },
        };
        if let Some(g) = &model.info.gravity {
            self.gravity = self
                .vector(g, Dim::ACCELERATION, "model", "model.gravity")
                .unwrap_or_else(Vector3::zeros);
        }
    }
}
