//! What the compiler knows while it goes through a model.

use super::geometry::Geometry;
use super::names::{ConstantScope, Property, StateScope};
use super::place::Place;
use super::{Compiled, Options, wrong_space};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::joint::{Measure, MeasureKind, TimeFunction};
use crate::model::{GROUND, Model, Point, Value};
use crate::signal::{Coefficient, MAX_INPUTS, Signal, SignalKind};
use crate::space::Space;
use crate::system::{
    BodyData, Coordinate, ElementData, ForceData, MarkerData, State, System, TraceData, TurnData,
};
use dalembert_expr::{Dim, ExprError, Function, Program, Quantity};
use indexmap::IndexMap;
use nalgebra::Vector3;
use smallvec::SmallVec;
use std::collections::{HashMap, HashSet};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A body or the ground, as placements need it.
#[derive(Clone, Debug)]
pub(super) struct BodyPlace<S: Space> {
    /// Movable body, or none.
    pub body: Option<usize>,
    /// Estimate of the user's frame, ground axes.
    pub frame: S::Frame,
    /// Centre of mass in the user's frame.
    pub center: Vector3<f64>,
}

impl<S: Geometry> BodyPlace<S> {
    /// The ground.
    pub fn ground() -> Self {
        Self {
            body: None,
            frame: S::frame(&Vector3::zeros()),
            center: Vector3::zeros(),
        }
    }
}

/// A joint, as quantities and actuators need it.
#[derive(Clone, Debug)]
pub(super) struct JointPlace<S: Space> {
    pub markers: SmallVec<[usize; 4]>,
    pub coordinates: SmallVec<[Coordinate<S>; 2]>,
}

/// A measure between two markers of the system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GlobalMeasure<S: Space> {
    pub kind: S::Measure,
    pub first: usize,
    pub second: usize,
}

pub(super) struct Context<'m, S: Space> {
    pub model: &'m Model,
    pub overrides: &'m [(String, Value)],
    pub diagnostics: Vec<Diagnostic>,
    /// Does anything stand in for what a mistake spoilt? Then what follows from values and places
    /// may be untrue, and only what is wrong in itself is reported.
    pub stand_ins: bool,
    pub parameters: IndexMap<String, (f64, Quantity)>,
    pub functions: HashMap<String, Arc<dyn Function>>,
    pub options: Options,
    pub gravity: Vector3<f64>,
    pub places: IndexMap<String, BodyPlace<S>>,
    pub joint_places: IndexMap<String, JointPlace<S>>,
    /// Distances of the spring-dampers, by name.
    pub spring_measures: HashMap<String, GlobalMeasure<S>>,
    pub properties: IndexMap<String, Vec<Property<S>>>,
    /// Elements that could not be compiled; expressions that use them are not to blame.
    pub spoilt: HashSet<String>,
    pub bodies: Vec<BodyData<S>>,
    pub markers: Vec<MarkerData<S>>,
    pub elements: Vec<ElementData<S>>,
    pub force_elements: Vec<ForceData<S>>,
    pub trace_list: Vec<TraceData>,
    pub mass: Vec<f64>,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub position_weight: Vec<f64>,
    pub velocity_weight: Vec<f64>,
    /// Angles that count turns by memory, and where they start.
    pub turns: Vec<TurnData<S>>,
    pub turn_start: Vec<f64>,
    /// Those whose start is stated.
    pub turns_stated: HashSet<usize>,
}

impl<'m, S: Geometry> Context<'m, S> {
    pub fn new(model: &'m Model, overrides: &'m [(String, Value)]) -> Self {
        let mut places = IndexMap::new();
        places.insert(GROUND.to_owned(), BodyPlace::ground());
        Self {
            model,
            overrides,
            diagnostics: Vec::new(),
            stand_ins: false,
            parameters: IndexMap::new(),
            functions: HashMap::new(),
            options: Options::default(),
            gravity: S::GRAVITY,
            places,
            joint_places: IndexMap::new(),
            spring_measures: HashMap::new(),
            properties: IndexMap::new(),
            spoilt: HashSet::new(),
            bodies: Vec::new(),
            // Marker 0 is the ground's own frame.
            markers: vec![MarkerData {
                body: None,
                frame: S::frame(&Vector3::zeros()),
            }],
            elements: Vec::new(),
            force_elements: Vec::new(),
            trace_list: Vec::new(),
            mass: Vec::new(),
            q: Vec::new(),
            v: Vec::new(),
            position_weight: Vec::new(),
            velocity_weight: Vec::new(),
            turns: Vec::new(),
            turn_start: Vec::new(),
            turns_stated: HashSet::new(),
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

    /// An angle of a frame; a doubt where it looks like degrees.
    pub fn angle(&mut self, value: &Value, place: &Place, path: &str) -> Option<f64> {
        let x = self.number(value, Dim::NONE, &place.owner, path)?;
        if matches!(value, Value::Number(_)) && x.abs() > TAU && x.fract() == 0.0 {
            let said = format!("{}: the angle {x} is read as radians", place.owner);
            self.report(
                Diagnostic::warning("radians", path, said)
                    .help(format!("write \"{x} deg\" for degrees, or \"{x} rad\"")),
            );
        }
        Some(x)
    }

    /// A point or vector, of as many components as the space has; z is zero in the plane.
    pub fn vector(
        &mut self,
        point: &Point,
        dim: Dim,
        owner: &str,
        path: &str,
    ) -> Option<Vector3<f64>> {
        self.components_of(point, Quantity::Known(dim), owner, path)
    }

    /// As [`Self::vector`], for a quantity that may have any dimension.
    pub fn components_of(
        &mut self,
        point: &Point,
        quantity: Quantity,
        owner: &str,
        path: &str,
    ) -> Option<Vector3<f64>> {
        if point.len() != S::LINEAR {
            self.report(
                Diagnostic::error(
                    "wrong-length",
                    path,
                    format!(
                        "{owner}: expected {} components in a {} model, found {}",
                        S::LINEAR,
                        S::NAME,
                        point.len()
                    ),
                )
                .help(if S::LINEAR == 2 {
                    "write [x, y]"
                } else {
                    "write [x, y, z]"
                }),
            );
            return None;
        }
        let mut out = Vector3::zeros();
        let mut whole = true;
        for (k, value) in point.iter().enumerate() {
            match self.constant(value, quantity, owner, &format!("{path}[{k}]")) {
                Some(x) => out[k] = x,
                None => whole = false,
            }
        }
        whole.then_some(out)
    }

    pub fn optional_point(
        &mut self,
        point: Option<&Point>,
        place: &Place,
        key: &str,
    ) -> Option<Vector3<f64>> {
        match point {
            Some(p) => self.vector(p, Dim::LENGTH, &place.owner, &place.key(key)),
            None => Some(Vector3::zeros()),
        }
    }

    /// A point, or the origin where a mistake in it has been reported.
    pub fn or_origin(&mut self, point: Option<Vector3<f64>>) -> Vector3<f64> {
        point.unwrap_or_else(|| {
            self.stand_ins = true;
            Vector3::zeros()
        })
    }

    /// The body of a name; reports an unknown one, for which the ground stands in so that the rest
    /// of the element is looked at too.
    pub fn place(&mut self, name: &str, owner: &str, path: &str) -> BodyPlace<S> {
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
        BodyPlace::ground()
    }

    /// A new marker: a frame in a body's own frame.
    pub fn marker(&mut self, place: &BodyPlace<S>, frame: &S::Frame) -> usize {
        let frame = match place.body {
            Some(_) => S::from_center(frame, &place.center),
            None => S::compose(&place.frame, frame),
        };
        self.markers.push(MarkerData {
            body: place.body,
            frame,
        });
        self.markers.len() - 1
    }

    /// Pose (at the estimate, with estimated velocities) of a marker.
    pub fn pose(&self, marker: usize) -> S::Marker {
        let m = &self.markers[marker];
        let mut pose = match m.body {
            Some(b) => S::marker(
                &m.frame,
                &S::pose(&self.q[b * S::NQ..(b + 1) * S::NQ]),
                &self.v[b * S::NV..(b + 1) * S::NV],
            ),
            None => S::ground_marker(&m.frame),
        };
        if let Some(k) = self.turns.iter().position(|t| t.second == marker) {
            S::set_turn(&mut pose, self.turn_start[k]);
        }
        pose
    }

    pub fn estimate(&self, m: GlobalMeasure<S>) -> f64 {
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
        let (no_properties, none_spoilt) = (IndexMap::<_, Vec<Property<S>>>::new(), HashSet::new());
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
    ) -> Option<(Program, Vec<Signal<S>>)> {
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
                        kind: S::Measure::DISTANCE,
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
    ) -> Coefficient<S> {
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

    /// Goes through the whole model.
    pub fn compile(mut self) -> Result<Compiled<S>, Diagnostics> {
        self.diagnostics = wrong_space::check(self.model);
        self.stand_ins = !self.diagnostics.is_empty();
        self.parameters();
        self.tables();
        self.options();
        self.bodies();
        self.traces();
        self.joints();
        self.springs();
        self.constraints();
        self.drivers();
        self.forces();
        self.initial();
        self.finish()
    }

    /// Ends the compilation: the system, or all mistakes.
    fn finish(mut self) -> Result<Compiled<S>, Diagnostics> {
        if self.bodies.is_empty() && self.diagnostics.is_empty() {
            self.report(
                Diagnostic::error("no-bodies", "body", "the model has no movable body")
                    .help("add a [[body]]"),
            );
        }
        if self.diagnostics.iter().any(Diagnostic::is_error) {
            return Err(Diagnostics(self.diagnostics));
        }
        self.wind_alike();
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
            self.gravity.as_slice()[..S::LINEAR].to_vec(),
        );
        system.turns = self.turns;
        for e in &system.elements {
            self.q.extend_from_slice(&e.auxiliary_start);
            self.v.extend(e.auxiliary_start.iter().map(|_| 0.0));
        }
        self.q.extend(self.turn_start);
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

/// "did you mean 'crank'?", where a known name is near.
pub(super) fn suggestion(name: &str, known: &[&str]) -> Option<String> {
    dalembert_expr::nearest(name, known.iter().copied())
        .first()
        .map(|best| format!("did you mean '{best}'?"))
}
