//! What names mean in expressions.

use super::context::{Context, GlobalMeasure};
use super::geometry::Geometry;
use crate::diagnostic::Diagnostic;
use crate::joint::MeasureKind;
use crate::model::{GROUND, JointKind, Value};
use crate::signal::SignalKind;
use crate::space::Space;
use dalembert_expr::{Dim, Function, Quantity, Resolved, Scope, UnknownName, nearest};
use indexmap::IndexMap;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

type Parameters = IndexMap<String, (f64, Quantity)>;
type Functions = HashMap<String, Arc<dyn Function>>;

/// A property of an element that expressions may use: `crank.angle`.
#[derive(Clone, Debug)]
pub(super) struct Property<S: Space> {
    pub name: String,
    pub kind: SignalKind,
    pub measure: GlobalMeasure<S>,
    pub dim: Dim,
}

/// What stands for a value that a mistake spoilt: something that is not known yet, in a slot that
/// every scope has.
const STAND_IN: Resolved = Resolved::Slot {
    index: 0,
    dim: Quantity::Free,
};

/// What a parameter means; one that a mistake spoilt is not a number.
fn parameter((value, dim): (f64, Quantity)) -> Resolved {
    if value.is_nan() {
        return STAND_IN;
    }
    Resolved::Constant { value, dim }
}

/// Parameters and tables only.
pub(super) struct ConstantScope<'a> {
    pub parameters: &'a Parameters,
    pub functions: &'a Functions,
}

fn unknown<'a>(path: &[&str], known: impl Iterator<Item = &'a str>, note: &str) -> UnknownName {
    let name = path.join(".");
    UnknownName {
        suggestions: nearest(&name, known)
            .into_iter()
            .map(str::to_owned)
            .collect(),
        note: Some(note.to_owned()),
    }
}

impl Scope for ConstantScope<'_> {
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName> {
        if let [name] = path
            && let Some(&known) = self.parameters.get(*name)
        {
            return Ok(parameter(known));
        }
        Err(unknown(
            path,
            self.parameters.keys().map(String::as_str),
            "only parameters can be used here, this number is a constant",
        ))
    }

    fn function(&self, name: &str) -> Option<Arc<dyn Function>> {
        self.functions.get(name).cloned()
    }
}

/// Parameters, tables, time and properties of elements.
pub(super) struct StateScope<'a, S: Space> {
    parameters: &'a Parameters,
    functions: &'a Functions,
    properties: &'a IndexMap<String, Vec<Property<S>>>,
    spoilt: &'a HashSet<String>,
    used: RefCell<Vec<(SignalKind, GlobalMeasure<S>)>>,
}

/// What stands for the measure of time, which has none.
fn no_measure<S: Space>() -> GlobalMeasure<S> {
    GlobalMeasure {
        kind: S::Measure::DISTANCE,
        first: 0,
        second: 0,
    }
}

impl<'a, S: Space> StateScope<'a, S> {
    /// Slot 0 is time.
    pub fn new(
        parameters: &'a Parameters,
        functions: &'a Functions,
        properties: &'a IndexMap<String, Vec<Property<S>>>,
        spoilt: &'a HashSet<String>,
    ) -> Self {
        let used = RefCell::new(vec![(SignalKind::Time, no_measure())]);
        Self {
            parameters,
            functions,
            properties,
            spoilt,
            used,
        }
    }

    /// What the slots stand for.
    pub fn into_used(self) -> Vec<(SignalKind, GlobalMeasure<S>)> {
        self.used.into_inner()
    }

    fn slot(&self, kind: SignalKind, measure: GlobalMeasure<S>) -> usize {
        let mut used = self.used.borrow_mut();
        used.iter()
            .position(|x| *x == (kind, measure))
            .unwrap_or_else(|| {
                used.push((kind, measure));
                used.len() - 1
            })
    }
}

impl<S: Space> Scope for StateScope<'_, S> {
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName> {
        match path {
            ["t"] => Ok(Resolved::Slot {
                index: 0,
                dim: Quantity::Known(Dim::TIME),
            }),
            [name] => match self.parameters.get(*name) {
                Some(&known) => Ok(parameter(known)),
                None if self.properties.contains_key(*name) => Err(UnknownName {
                    suggestions: self.properties[*name]
                        .iter()
                        .take(6)
                        .map(|p| format!("{name}.{}", p.name))
                        .collect(),
                    note: Some(format!(
                        "'{name}' is an element, a quantity of it is needed"
                    )),
                }),
                None => Err(unknown(
                    path,
                    self.parameters.keys().map(String::as_str).chain(["t"]),
                    "the name is neither t, nor a parameter, nor element.quantity",
                )),
            },
            [name, _] if self.spoilt.contains(*name) => Ok(STAND_IN),
            [name, property] => match self.properties.get(*name) {
                Some(list) => match list.iter().find(|p| p.name == *property) {
                    Some(p) => Ok(Resolved::Slot {
                        index: self.slot(p.kind, p.measure),
                        dim: Quantity::Known(p.dim),
                    }),
                    None => Err(UnknownName {
                        suggestions: nearest(property, list.iter().map(|p| p.name.as_str()))
                            .into_iter()
                            .map(|p| format!("{name}.{p}"))
                            .collect(),
                        note: Some(format!(
                            "'{name}' has: {}",
                            list.iter()
                                .map(|p| p.name.as_str())
                                .collect::<Vec<_>>()
                                .join(", ")
                        )),
                    }),
                },
                None if self.properties.is_empty() => Err(UnknownName {
                    suggestions: Vec::new(),
                    note: Some("only t and parameters can be used here".to_owned()),
                }),
                None => Err(UnknownName {
                    suggestions: nearest(name, self.properties.keys().map(String::as_str))
                        .into_iter()
                        .map(|n| format!("{n}.{property}"))
                        .collect(),
                    note: Some(format!("there is no element '{name}' with quantities")),
                }),
            },
            _ => Err(unknown(
                path,
                std::iter::empty(),
                "names have one or two parts",
            )),
        }
    }

    fn function(&self, name: &str) -> Option<Arc<dyn Function>> {
        self.functions.get(name).cloned()
    }
}

impl<S: Geometry> Context<'_, S> {
    /// Refuses a name of a parameter or table that expressions could not use, or that means
    /// something else in them.
    pub fn check_name(&mut self, name: &str, owner: &str, path: &str) {
        let taken = match name {
            "t" => Some("is the time"),
            "phi" if self.has_cam() => Some("is the angle of a cam's profile"),
            GROUND => Some("is the fixed body that always exists"),
            _ if dalembert_expr::is_reserved(name) => {
                Some("belongs to the language of expressions")
            }
            _ => None,
        };
        let (code, message) = if let Some(meaning) = taken {
            ("reserved-name", format!("{owner}: '{name}' {meaning}"))
        } else if dalembert_expr::is_identifier(name) {
            return;
        } else {
            let rule = "a name for expressions starts with a letter and has letters (a to z, A to \
                        Z), digits and underscores only";
            ("bad-name", format!("{owner}: {rule}"))
        };
        self.report(Diagnostic::error(code, path, message).help("choose another name"));
    }

    fn has_cam(&self) -> bool {
        let is_cam = |j: &crate::model::Joint| matches!(j.kind, JointKind::Cam { .. });
        self.model.joints.iter().any(is_cam)
    }

    /// Evaluates the parameters in the order of their dependence.
    pub fn parameters(&mut self) {
        for name in self.model.parameters.keys() {
            let owner = format!("parameter '{name}'");
            self.check_name(name, &owner, &format!("parameters.{name}"));
        }
        let written: IndexMap<String, (Value, String)> = self
            .model
            .parameters
            .iter()
            .map(|(k, v)| (k.clone(), (v.clone(), format!("parameters.{k}"))))
            .collect();
        let overrides = self.overrides;
        if overrides.is_empty() {
            self.evaluate_parameters(written, &HashMap::new());
            return;
        }
        let places = self.places_of(&written, overrides);
        let mut pending = written;
        for (name, value) in overrides {
            match pending.get_mut(name) {
                Some(slot) => slot.0 = value.clone(),
                None => {
                    let known: Vec<&str> = pending.keys().map(String::as_str).collect();
                    let help = super::context::suggestion(name, &known).unwrap_or_else(|| {
                        if known.is_empty() {
                            "the model has no parameters".to_owned()
                        } else {
                            format!("the parameters are: {}", known.join(", "))
                        }
                    });
                    self.report(
                        Diagnostic::error(
                            "unknown-parameter",
                            "parameters",
                            format!("there is no parameter '{name}' to be set"),
                        )
                        .help(help),
                    );
                }
            }
        }
        self.evaluate_parameters(pending, &places);
    }

    /// What the parameters that are overridden are in the model itself: another value must be of
    /// the same dimension. Mistakes in values that do not count are not reported.
    fn places_of(
        &mut self,
        written: &IndexMap<String, (Value, String)>,
        overrides: &[(String, Value)],
    ) -> HashMap<String, Dim> {
        let (told, stand_ins) = (self.diagnostics.len(), self.stand_ins);
        self.evaluate_parameters(written.clone(), &HashMap::new());
        self.diagnostics.truncate(told);
        self.stand_ins = stand_ins;
        let values = std::mem::take(&mut self.parameters);
        overrides
            .iter()
            .filter_map(|(name, _)| Some((name.clone(), values.get(name)?.1.likely()?)))
            .collect()
    }

    /// Evaluates parameters in the order of their dependence; those with a place must fit it.
    fn evaluate_parameters(
        &mut self,
        mut pending: IndexMap<String, (Value, String)>,
        places: &HashMap<String, Dim>,
    ) {
        while !pending.is_empty() {
            let ready: Vec<String> = pending
                .iter()
                .filter(|(_, (value, _))| {
                    dependencies(value).iter().all(|d| !pending.contains_key(d))
                })
                .map(|(k, _)| k.clone())
                .collect();
            let ready = if ready.is_empty() {
                // The members of a circle are then read one by one, for other mistakes in them.
                let cycle = self.report_cycle(&pending);
                for name in &cycle {
                    self.stand_in_parameter(name.clone());
                }
                cycle
            } else {
                ready
            };
            for name in ready {
                let Some((value, path)) = pending.shift_remove(&name) else {
                    continue;
                };
                let owner = format!("parameter '{name}'");
                let place = places
                    .get(&name)
                    .map_or(Quantity::Free, |dim| (*dim).into());
                match self.measured(&value, place, &owner, &path) {
                    Some((x, quantity)) => {
                        self.parameters.insert(name, (x, quantity));
                    }
                    None => self.stand_in_parameter(name),
                }
            }
        }
    }

    /// A stand-in keeps a mistake from being reported again at every use.
    fn stand_in_parameter(&mut self, name: String) {
        self.stand_ins = true;
        self.parameters.insert(name, (f64::NAN, Quantity::Free));
    }

    /// A constant for a place, and what is known of its dimension. None after a mistake, which is
    /// then reported.
    pub fn measured(
        &mut self,
        value: &Value,
        place: Quantity,
        owner: &str,
        path: &str,
    ) -> Option<(f64, Quantity)> {
        let Value::Text(text) = value else {
            let x = self.constant(value, place, owner, path)?;
            return Some((x, place));
        };
        let scope = ConstantScope {
            parameters: &self.parameters,
            functions: &self.functions,
        };
        let compiled = dalembert_expr::compile(text, &scope, place);
        let program = self.accept(compiled, owner, path)?;
        // Without variables a program is a number.
        let value = Value::Number(program.eval(&[]));
        let x = self.constant(&value, place, owner, path)?;
        Some((x, program.quantity()))
    }

    /// Reports a circle of parameters that wait for each other; returns its members.
    fn report_cycle(&mut self, pending: &IndexMap<String, (Value, String)>) -> Vec<String> {
        // Follow the dependences from the first open parameter until one repeats. Every open one
        // waits for an open one, or it would be ready.
        let mut chain: Vec<String> = pending.keys().take(1).cloned().collect();
        while let Some((value, _)) = chain.last().and_then(|last| pending.get(last)) {
            let open = |d: &String| pending.contains_key(d);
            let Some(next) = dependencies(value).into_iter().find(open) else {
                break;
            };
            if let Some(start) = chain.iter().position(|n| *n == next) {
                let mut cycle = chain[start..].to_vec();
                cycle.push(next);
                let path = format!("parameters.{}", cycle[0]);
                self.report(
                    Diagnostic::error(
                        "parameter-cycle",
                        path,
                        format!(
                            "parameters depend on each other in a circle: {}",
                            cycle.join(" -> ")
                        ),
                    )
                    .help("give one of them as a number"),
                );
                cycle.pop();
                return cycle;
            }
            chain.push(next);
        }
        pending.keys().cloned().collect()
    }
}

fn dependencies(value: &Value) -> Vec<String> {
    match value {
        Value::Number(_) => Vec::new(),
        Value::Text(text) => dalembert_expr::names(text)
            .map(|names| {
                names
                    .into_iter()
                    .filter(|(p, _)| p.len() == 1)
                    .map(|(mut p, _)| p.remove(0))
                    .collect()
            })
            .unwrap_or_default(),
    }
}
