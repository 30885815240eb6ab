//! What the compiler knows while it goes through a model.

use super::names::{ConstantScope, Property, StateScope};
use super::place::Place;
use super::{Compiled, Options};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::joint::{Measure, PlanarMeasure, TimeFunction};
use crate::model::{GROUND, Model, Point, Value};
use crate::signal::{Coefficient, MAX_INPUTS, Signal, SignalKind};
use crate::space::{Planar, PlanarFrame, PlanarMarker, Space};
use crate::system::{
    BodyData, Coordinate, ElementData, ForceData, MarkerData, State, System, TraceData,
};
use dalembert_expr::{Dim, ExprError, Function, Program, Quantity};
use indexmap::IndexMap;
use nalgebra::Vector2;
use smallvec::SmallVec;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// A body or the ground, as placements need it.
#[derive(Clone, Debug)]
pub(super) struct BodyPlace {
    /// Movable body, or none.
    pub body: Option<usize>,
    /// Estimate of the user's frame: origin and angle, ground axes.
    pub origin: Vector2<f64>,
    pub angle: f64,
    /// Centre of mass in the user's frame.
    pub center: Vector2<f64>,
}

/// A joint, as quantities and actuators need it.
#[derive(Clone, Debug)]
pub(super) struct JointPlace {
    pub markers: SmallVec<[usize; 4]>,
    pub coordinates: SmallVec<[Coordinate; 2]>,
}

/// A measure between two markers of the system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GlobalMeasure {
    pub kind: PlanarMeasure,
    pub first: usize,
    pub second: usize,
}

pub(super) struct Context<'m> {
    pub model: &'m Model,
    pub overrides: &'m [(String, Value)],
    pub diagnostics: Vec<Diagnostic>,
    /// Does anything stand in for what a mistake spoilt? Then what follows from values and places
    /// may be untrue, and only what is wrong in itself is reported.
    pub stand_ins: bool,
    pub parameters: IndexMap<String, (f64, Quantity)>,
    pub functions: HashMap<String, Arc<dyn Function>>,
    pub options: Options,
    pub gravity: Vector2<f64>,
    pub places: IndexMap<String, BodyPlace>,
    pub joint_places: IndexMap<String, JointPlace>,
    /// Distances of the spring-dampers, by name.
    pub spring_measures: HashMap<String, GlobalMeasure>,
    pub properties: IndexMap<String, Vec<Property>>,
    /// Elements that could not be compiled; expressions that use them are not to blame.
    pub spoilt: HashSet<String>,
    pub bodies: Vec<BodyData<Planar>>,
    pub markers: Vec<MarkerData<Planar>>,
    pub elements: Vec<ElementData<Planar>>,
    pub force_elements: Vec<ForceData<Planar>>,
    pub trace_list: Vec<TraceData>,
    pub mass: Vec<f64>,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub position_weight: Vec<f64>,
    pub velocity_weight: Vec<f64>,
}

impl<'m> Context<'m> {
    pub fn new(model: &'m Model, overrides: &'m [(String, Value)]) -> Self {
        let mut places = IndexMap::new();
        places.insert(
            GROUND.to_owned(),
            BodyPlace {
                body: None,
                origin: Vector2::zeros(),
                angle: 0.0,
                center: Vector2::zeros(),
            },
        );
        Self {
            model,
            overrides,
            diagnostics: Vec::new(),
            stand_ins: false,
            parameters: IndexMap::new(),
            functions: HashMap::new(),
            options: Options::default(),
            gravity: Vector2::new(0.0, -9.81),
            places,
            joint_places: IndexMap::new(),
            spring_measures: HashMap::new(),
            properties: IndexMap::new(),
            spoilt: HashSet::new(),
            bodies: Vec::new(),
            // Marker 0 is the ground's own frame.
            markers: vec![MarkerData {
                body: None,
                frame: PlanarFrame::default(),
            }],
            elements: Vec::new(),
            force_elements: Vec::new(),
            trace_list: Vec::new(),
            mass: Vec::new(),
            q: Vec::new(),
            v: Vec::new(),
            position_weight: Vec::new(),
            velocity_weight: Vec::new(),
        }
    }

    pub fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    pub fn report_expression(&mut self, owner: &str, path: &str, errors: Vec<ExprError>) {
        for e in errors {
            let message = format!("{owner}: {}", e.message);
            self.report(
                Diagnostic::error(e.code, path, message)
                    .span(e.span)
                    .help(e.help),
            );
        }
    }

    /// A compiled expression; reports its mistakes, or what is doubtful in it.
    pub fn accept(
        &mut self,
        compiled: Result<Program, Vec<ExprError>>,
        owner: &str,
        path: &str,
    ) -> Option<Program> {
        let program = match compiled {
            Ok(program) => program,
            Err(errors) => {
                self.report_expression(owner, path, errors);
                return None;
            }
        };
        for e in program.doubts() {
            let message = format!("{owner}: {}", e.message);
            let doubt = Diagnostic::warning(e.code, path, message)
                .span(e.span.clone())
                .help(e.help.as_str());
            // Some values are read twice, for the machine and for its picture.
            if !self.diagnostics.contains(&doubt) {
                self.report(doubt);
            }
        }
        Some(program)
    }

    /// A constant of a dimension. None after a mistake, which is then reported.
    pub fn number(&mut self, value: &Value, dim: Dim, owner: &str, path: &str) -> Option<f64> {
        self.constant(value, Quantity::Known(dim), owner, path)
    }

    pub fn constant(
        &mut self,
        value: &Value,
        quantity: Quantity,
        owner: &str,
        path: &str,
    ) -> Option<f64> {
        let x = match value {
            Value::Number(x) => *x,
            Value::Text(text) => {
                let scope = ConstantScope {
                    parameters: &self.parameters,
                    functions: &self.functions,
                };
                let compiled = dalembert_expr::compile(text, &scope, quantity);
                let program = self.accept(compiled, owner, path)?;
                // Only stand-ins have slots here.
                if !program.slots().is_empty() {
                    return None;
                }
                program.constant().unwrap_or_else(|| program.eval(&[]))
            }
        };
        if x.is_nan() && self.stand_ins {
            return None;
        }
        if !x.is_finite() {
            self.report(
                Diagnostic::error(
                    "not-finite",
                    path,
                    format!("{owner}: the value is not a finite number"),
                )
                .help("give a finite number"),
            );
            return None;
        }
        Some(x)
    }

    /// A constant that must be positive.
    pub fn positive(
        &mut self,
        value: &Value,
        dim: Dim,
        what: &str,
        place: &Place,
        key: &str,
    ) -> Option<f64> {
        let x = self.number(value, dim, &place.owner, &place.key(key))?;
        if x > 0.0 {
            return Some(x);
        }
        self.report(
            Diagnostic::error(
                "not-positive",
                place.key(key),
                format!("{}: {what} is {x}, it must be positive", place.owner),
            )
            .help(format!("give a positive {what}")),
        );
        None
    }

    pub fn optional(
        &mut self,
        value: Option<&Value>,
        dim: Dim,
        place: &Place,
        key: &str,
    ) -> Option<f64> {
        let value = value?;
        self.number(value, dim, &place.owner, &place.key(key))
    }

    /// A point or vector of two components.
    pub fn vector(
        &mut self,
        point: &Point,
        dim: Dim,
        owner: &str,
        path: &str,
    ) -> Option<Vector2<f64>> {
        if point.len() != 2 {
            self.report(
                Diagnostic::error(
                    "wrong-length",
                    path,
                    format!(
                        "{owner}: expected 2 components in a planar model, found {}",
                        point.len()
                    ),
                )
                .help("write [x, y]"),
            );
            return None;
        }
        let x = self.number(&point[0], dim, owner, &format!("{path}[0]"));
        let y = self.number(&point[1], dim, owner, &format!("{path}[1]"));
        Some(Vector2::new(x?, y?))
    }

    pub fn optional_point(
        &mut self,
        point: Option<&Point>,
        place: &Place,
        key: &str,
    ) -> Option<Vector2<f64>> {
        match point {
            Some(p) => self.vector(p, Dim::LENGTH, &place.owner, &place.key(key)),
            None => Some(Vector2::zeros()),
        }
    }

    /// A point, or the origin where a mistake in it has been reported.
    pub fn or_origin(&mut self, point: Option<Vector2<f64>>) -> Vector2<f64> {
        point.unwrap_or_else(|| {
            self.stand_ins = true;
            Vector2::zeros()
        })
    }

    /// The body of a name; reports an unknown one, for which the ground stands in so that the rest
    /// of the element is looked at too.
    pub fn place(&mut self, name: &str, owner: &str, path: &str) -> BodyPlace {
        if let Some(p) = self.places.get(name) {
            return p.clone();
        }
        let known: Vec<&str> = self.places.keys().map(String::as_str).collect();
        let help = suggestion(name, &known)
            .unwrap_or_else(|| format!("the bodies are: {}", known.join(", ")));
        self.report(
            Diagnostic::error(
                "unknown-body",
                path,
                format!("{owner}: there is no body '{name}'"),
            )
            .help(help),
        );
        self.stand_ins = true;
        BodyPlace {
            body: None,
            origin: Vector2::zeros(),
            angle: 0.0,
            center: Vector2::zeros(),
        }
    }

    /// A new marker: a frame at a point of a body's own frame.
    pub fn marker(&mut self, place: &BodyPlace, at: Vector2<f64>, angle: f64) -> usize {
        let frame = match place.body {
            Some(_) => PlanarFrame {
                at: at - place.center,
                angle,
            },
            None => PlanarFrame {
                at: place.origin + rotate(place.angle, &at),
                angle: place.angle + angle,
            },
        };
        self.markers.push(MarkerData {
            body: place.body,
            frame,
        });
        self.markers.len() - 1
    }

    /// Pose (at the estimate, with estimated velocities) of a marker.
    pub fn pose(&self, marker: usize) -> PlanarMarker {
        let m = &self.markers[marker];
        match m.body {
            Some(b) => Planar::marker(
                &m.frame,
                &Planar::pose(&self.q[3 * b..3 * b + 3]),
                &self.v[3 * b..3 * b + 3],
            ),
            None => Planar::ground_marker(&m.frame),
        }
    }

    pub fn estimate(&self, m: GlobalMeasure) -> f64 {
        m.kind.value(&self.pose(m.first), &self.pose(m.second))
    }

    /// A function of time alone.
    pub fn time_function(
        &mut self,
        value: &Value,
        dim: Dim,
        owner: &str,
        path: &str,
    ) -> Option<TimeFunction> {
        match value {
            Value::Number(_) => self
                .number(value, dim, owner, path)
                .map(TimeFunction::Constant),
            Value::Text(_) => {
                let program = self.time_program(value, dim, owner, path)?;
                Some(match program.constant() {
                    Some(x) => TimeFunction::Constant(x),
                    None => TimeFunction::Expression(Box::new(program)),
                })
            }
        }
    }

    /// A program of time alone.
    pub fn time_program(
        &mut self,
        value: &Value,
        dim: Dim,
        owner: &str,
        path: &str,
    ) -> Option<Program> {
        let text = text_of(value);
        let (no_properties, none_spoilt) = (IndexMap::new(), HashSet::new());
        let scope = StateScope::new(
            &self.parameters,
            &self.functions,
            &no_properties,
            &none_spoilt,
        );
        let compiled = dalembert_expr::compile(&text, &scope, Quantity::Known(dim));
        self.accept(compiled, owner, path)
    }

    /// A program of time and of quantities of elements; its inputs refer to `markers`, which grows
    /// by the markers that the expression needs.
    pub fn state_program(
        &mut self,
        value: &Value,
        dim: Quantity,
        owner: &str,
        path: &str,
        markers: &mut SmallVec<[usize; 4]>,
    ) -> Option<(Program, Vec<Signal>)> {
        let text = text_of(value);
        let scope = StateScope::new(
            &self.parameters,
            &self.functions,
            &self.properties,
            &self.spoilt,
        );
        let compiled = dalembert_expr::compile(&text, &scope, dim);
        let used = scope.into_used();
        let program = self.accept(compiled, owner, path)?;
        if program.slots().len() > MAX_INPUTS {
            self.report(
                Diagnostic::error(
                    "too-many-inputs",
                    path,
                    format!("{owner}: the expression uses {} quantities, at most {MAX_INPUTS} are possible", program.slots().len()),
                )
                .help("split it into several elements"),
            );
            return None;
        }
        let mut local = |global: usize| {
            markers
                .iter()
                .position(|&m| m == global)
                .unwrap_or_else(|| {
                    markers.push(global);
                    markers.len() - 1
                })
        };
        let inputs = program
            .slots()
            .iter()
            .map(|&slot| {
                let (kind, m) = used[slot];
                let measure = if kind == SignalKind::Time {
                    Measure {
                        kind: PlanarMeasure::Angle,
                        first: 0,
                        second: 0,
                    }
                } else {
                    Measure {
                        kind: m.kind,
                        first: local(m.first),
                        second: local(m.second),
                    }
                };
                Signal { kind, measure }
            })
            .collect();
        Some((program, inputs))
    }

    /// A coefficient of a force element.
    pub fn coefficient(
        &mut self,
        value: Option<&Value>,
        default: f64,
        dim: Dim,
        place: &Place,
        key: &str,
        markers: &mut SmallVec<[usize; 4]>,
    ) -> Coefficient {
        let path = place.key(key);
        match value {
            None => Coefficient::Constant(default),
            Some(value @ Value::Number(_)) => Coefficient::Constant(
                self.number(value, dim, &place.owner, &path)
                    .unwrap_or(default),
            ),
            Some(value @ Value::Text(_)) => {
                match self.state_program(value, Quantity::Known(dim), &place.owner, &path, markers)
                {
                    None => Coefficient::Constant(default),
                    Some((program, inputs)) => match program.constant() {
                        Some(x) => Coefficient::Constant(x),
                        None => Coefficient::Expression(Box::new(program), inputs),
                    },
                }
            }
        }
    }

    /// Ends the compilation: the system, or all mistakes.
    pub fn finish(mut self) -> Result<Compiled, Diagnostics> {
        if self.bodies.is_empty() && self.diagnostics.is_empty() {
            self.report(
                Diagnostic::error("no-bodies", "body", "the model has no movable body")
                    .help("add a [[body]]"),
            );
        }
        if self.diagnostics.iter().any(Diagnostic::is_error) {
            return Err(Diagnostics(self.diagnostics));
        }
        let mut drawing = self.drawing();
        let outlines = self.outlines();
        let mut system = System::new(
            self.model.info.name.clone(),
            self.bodies,
            self.markers,
            self.elements,
            self.force_elements,
            self.trace_list,
            self.mass,
            vec![self.gravity.x, self.gravity.y],
        );
        for e in &system.elements {
            self.q.extend_from_slice(&e.auxiliary_start);
            self.v.extend(e.auxiliary_start.iter().map(|_| 0.0));
        }
        system.estimate = State {
            t: self.options.start,
            q: self.q,
            v: self.v,
        };
        system.position_weight = self.position_weight;
        system.velocity_weight = self.velocity_weight;
        system.set_size();
        system.set_masses();
        system.set_row_scales();
        drawing.add_elements(&system, &outlines);
        Ok(Compiled {
            drawing,
            system,
            options: self.options,
            parameters: self
                .parameters
                .into_iter()
                .map(|(k, (x, _))| (k, x))
                .collect(),
            warnings: self.diagnostics,
        })
    }
}

/// A value as the text of an expression.
pub(super) fn text_of(value: &Value) -> String {
    match value {
        Value::Number(x) => format!("{x:?}"),
        Value::Text(text) => text.clone(),
    }
}

/// Turns a vector by an angle.
pub(super) fn rotate(angle: f64, a: &Vector2<f64>) -> Vector2<f64> {
    let (s, c) = angle.sin_cos();
    Vector2::new(c * a.x - s * a.y, s * a.x + c * a.y)
}

/// "did you mean 'crank'?", where a known name is near.
pub(super) fn suggestion(name: &str, known: &[&str]) -> Option<String> {
    dalembert_expr::nearest(name, known.iter().copied())
        .first()
        .map(|best| format!("did you mean '{best}'?"))
}
