//! Constraints that are not joints.

use super::built::Built;
use super::context::{Context, GlobalMeasure};
use super::geometry::Geometry;
use super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::joint::{
    ExpressionRows, Measure, MeasureRow, MeasureRows, MeasureTerm, TimeFunction, VelocityRows,
};
use crate::model::{ConstraintKind, Value};
use crate::signal::{Signal, SignalKind};
use crate::system::Role;
use dalembert_expr::{Program, Quantity};
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

impl<S: Geometry> Context<'_, S> {
    /// Compiles the constraints.
    pub fn constraints(&mut self) {
        let model = self.model;
        for (index, constraint) in model.constraints.iter().enumerate() {
            let place = Place::new("constraint", index, "constraint", &constraint.name);
            if let Some(built) = self.constraint(&constraint.kind, &place) {
                self.push_element(constraint.name.clone(), Role::Constraint, place.path, built);
            }
        }
    }

    fn constraint(&mut self, kind: &ConstraintKind, place: &Place) -> Option<Built<S>> {
        match kind {
            ConstraintKind::Fixed { quantity, value } => {
                let m = self.quantity(quantity, &place.owner, &place.key("quantity"));
                let dim = Self::quantity_dim(quantity);
                let value = match (value, m) {
                    (Some(v), _) => self.number(v, dim, &place.owner, &place.key("value")),
                    (None, m) => m.map(|m| self.estimate(m)),
                };
                let (m, value) = (m?, value?);
                self.start_near(m, value);
                Some(measure_rows(
                    "fixed coordinate",
                    &[(1.0, m)],
                    TimeFunction::Constant(value),
                    "value",
                ))
            }
            ConstraintKind::Coupler { terms, value } => {
                let mut list = Vec::new();
                let mut whole = true;
                for (k, term) in terms.iter().enumerate() {
                    let path = place.key(&format!("terms[{k}]"));
                    let factor = self.constant(
                        &term.factor,
                        Quantity::Free,
                        &place.owner,
                        &format!("{path}.factor"),
                    );
                    let m = self.quantity(&term.quantity, &place.owner, &path);
                    match (factor, m) {
                        (Some(factor), Some(m)) => list.push((factor, m)),
                        _ => whole = false,
                    }
                }
                if terms.is_empty() {
                    self.report(
                        Diagnostic::error(
                            "no-terms",
                            place.key("terms"),
                            format!("{}: it has no terms", place.owner),
                        )
                        .help(
                            "give terms = [{ factor = 1, kind = \"angle\", joint = \"A\" }, ...]",
                        ),
                    );
                    return None;
                }
                let value = match value {
                    Some(v) => self.constant(v, Quantity::Free, &place.owner, &place.key("value")),
                    None => Some(list.iter().map(|(f, m)| f * self.estimate(*m)).sum()),
                };
                if !whole {
                    return None;
                }
                Some(measure_rows(
                    "coupler",
                    &list,
                    TimeFunction::Constant(value?),
                    "sum",
                ))
            }
            ConstraintKind::Velocity { expression } => self.velocity_constraint(expression, place),
            ConstraintKind::Expression { expression } => {
                let mut markers = SmallVec::new();
                let path = place.key("expression");
                let (program, inputs) = self.state_program(
                    expression,
                    Quantity::Free,
                    &place.owner,
                    &path,
                    &mut markers,
                )?;
                if inputs.iter().any(|s| s.kind == SignalKind::Rate) {
                    self.report(
                        Diagnostic::error(
                            "velocity-constraint",
                            path,
                            format!(
                                "{}: a constraint expression must not use velocities",
                                place.owner
                            ),
                        )
                        .help("use positions, angles and t only, or kind = \"velocity\" for a constraint on velocities"),
                    );
                    return None;
                }
                let timely = inputs.iter().all(|s| s.kind == SignalKind::Time);
                if timely && self.stand_ins {
                    return None;
                }
                if timely {
                    self.report(
                        Diagnostic::error(
                            "empty-constraint",
                            path,
                            format!(
                                "{}: the expression uses no coordinate of the machine",
                                place.owner
                            ),
                        )
                        .help("use coordinates like crank.angle or slider.x"),
                    );
                    return None;
                }
                let count = markers.len();
                Some(Built {
                    kind: "user constraint",
                    element: Arc::new(ExpressionRows {
                        program,
                        inputs,
                        markers: count,
                    }),
                    markers,
                    coordinates: SmallVec::new(),
                    auxiliary_start: SmallVec::new(),
                    reaction_marker: count - 1,
                })
            }
        }
    }
}

/// Do the slopes of a program by its rates stay the same when the rates change?
fn linear_in_rates<S: Geometry>(program: &Program, inputs: &[Signal<S>]) -> bool {
    let n = inputs.len();
    let rates: Vec<bool> = inputs.iter().map(|s| s.kind == SignalKind::Rate).collect();
    // No special numbers: parts of a golden turn.
    let number = |k: usize| 0.3 + (0.618_033_988_749_895 * k as f64).fract();
    (0..3).all(|attempt| {
        let slopes = |other: usize| {
            let values: Vec<f64> = (0..n)
                .map(|k| number(n * attempt + k + if rates[k] { 1 + 31 * other } else { 1 }))
                .collect();
            let mut slopes = vec![0.0; n];
            program.gradient(&values, &mut slopes);
            slopes
        };
        let (first, second) = (slopes(0), slopes(1));
        let pairs = first.iter().zip(&second).zip(&rates);
        let mut pairs = pairs.filter(|(_, rate)| **rate);
        pairs.all(|((a, b), _)| {
            (a - b).abs() <= 1e-9 * (a.abs() + b.abs()) || a.is_nan() || b.is_nan()
        })
    })
}

impl<S: Geometry> Context<'_, S> {
    /// A row that is linear in velocities.
    fn velocity_constraint(&mut self, expression: &Value, place: &Place) -> Option<Built<S>> {
        let mut markers = SmallVec::new();
        let path = place.key("expression");
        let owner = &place.owner;
        let found = self.state_program(expression, Quantity::Free, owner, &path, &mut markers)?;
        let (program, inputs) = found;
        if !inputs.iter().any(|s| s.kind == SignalKind::Rate) {
            if !self.stand_ins {
                self.report(
                    Diagnostic::error(
                        "empty-constraint",
                        path,
                        format!("{owner}: the expression uses no velocity of the machine"),
                    )
                    .help(
                        "use velocities like body.vx or joint.angle_rate, or kind = \"expression\" for positions",
                    ),
                );
            }
            return None;
        }
        if !linear_in_rates(&program, &inputs) {
            self.report(
                Diagnostic::error(
                    "not-linear",
                    path,
                    format!("{owner}: the expression is not linear in the velocities"),
                )
                .help("write a sum of velocities times functions of positions and t"),
            );
            return None;
        }
        let count = markers.len();
        Some(Built {
            kind: "velocity constraint",
            element: Arc::new(VelocityRows {
                program,
                inputs,
                markers: count,
            }),
            markers,
            coordinates: SmallVec::new(),
            auxiliary_start: SmallVec::new(),
            reaction_marker: count - 1,
        })
    }
}

/// One row: sum of factor * measure = f(t).
pub(super) fn measure_rows<S: Geometry>(
    kind: &'static str,
    terms: &[(f64, GlobalMeasure<S>)],
    target: TimeFunction,
    label: &str,
) -> Built<S> {
    let mut markers: SmallVec<[usize; 4]> = SmallVec::new();
    let mut local = |global: usize| {
        markers
            .iter()
            .position(|&m| m == global)
            .unwrap_or_else(|| {
                markers.push(global);
                markers.len() - 1
            })
    };
    let terms: SmallVec<[MeasureTerm<S>; 1]> = terms
        .iter()
        .map(|&(factor, m)| MeasureTerm {
            factor,
            measure: Measure {
                kind: m.kind,
                first: local(m.first),
                second: local(m.second),
            },
        })
        .collect();
    let row = MeasureRow {
        terms,
        target,
        label: label.to_owned(),
    };
    let count = markers.len();
    Built {
        kind,
        element: Arc::new(MeasureRows::new(count, smallvec![row])),
        markers,
        coordinates: SmallVec::new(),
        auxiliary_start: SmallVec::new(),
        reaction_marker: count - 1,
    }
}
