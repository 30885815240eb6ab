//! Bodies and traces.

use super::context::{BodyPlace, Context, GlobalMeasure, rotate};
use super::names::Property;
use super::place::Place;
use crate::joint::{MeasureRow, MeasureRows, PlanarMeasure};
use crate::model::{AxialVector, HeldCoordinate, Value};
use crate::signal::SignalKind;
use crate::space::PlanarFrame;
use crate::system::{BodyData, ElementData, Phase, Role, TraceData};
use dalembert_expr::Dim;
use nalgebra::Vector2;
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

/// The number of the plane; three components have been refused before.
pub(super) fn planar(vector: &AxialVector) -> Option<&Value> {
    match vector {
        AxialVector::Planar(value) => Some(value),
        AxialVector::Spatial(_) => None,
    }
}

/// How much less a coordinate counts in the assembly where its user gave no estimate.
const UNSAID: f64 = 1e-4;

impl Context<'_> {
    /// Resolves the bodies: mass properties, estimates, frame markers, held coordinates.
    pub fn bodies(&mut self) {
        let model = self.model;
        for (index, body) in model.bodies.iter().enumerate() {
            let place = Place::new("body", index, "body", &body.name);
            let mass = self.mass_properties(body, &place);
            let origin = self.optional_point(body.position.as_ref(), &place, "position");
            let origin = self.or_origin(origin);
            let angle = self
                .optional(body.angle.as_ref(), Dim::NONE, &place, "angle")
                .unwrap_or(0.0);
            let velocity = match &body.velocity {
                Some(v) => self.vector(v, Dim::VELOCITY, &place.owner, &place.key("velocity")),
                None => None,
            }
            .unwrap_or_else(Vector2::zeros);
            let omega = self
                .optional(
                    body.angular_velocity.as_ref().and_then(planar),
                    Dim::FREQUENCY,
                    &place,
                    "angular_velocity",
                )
                .unwrap_or(0.0);
            let number = (!body.fixed).then_some(self.bodies.len());
            let own = BodyPlace {
                body: number,
                origin,
                angle,
                center: mass.center,
            };
            self.places.insert(body.name.clone(), own.clone());
            if number.is_none() {
                let marker = self.marker(&own, Vector2::zeros(), 0.0);
                self.point_properties(&body.name, marker);
                continue;
            }
            let arm = rotate(angle, &mass.center);
            let center = origin + arm;
            let center_velocity = velocity + omega * Vector2::new(-arm.y, arm.x);
            self.q.extend([center.x, center.y, angle]);
            self.v.extend([center_velocity.x, center_velocity.y, omega]);
            let weigh = |given: bool| if given { 1.0 } else { UNSAID };
            let (p, a) = (weigh(body.position.is_some()), weigh(body.angle.is_some()));
            self.position_weight.extend([p, p, a]);
            let (p, a) = (
                weigh(body.velocity.is_some()),
                weigh(body.angular_velocity.is_some()),
            );
            self.velocity_weight.extend([p, p, a]);
            self.mass.extend([
                mass.mass,
                0.0,
                0.0,
                0.0,
                mass.mass,
                0.0,
                0.0,
                0.0,
                mass.inertia,
            ]);
            let frame_marker = self.marker(&own, Vector2::zeros(), 0.0);
            let center_marker = self.marker(&own, mass.center, 0.0);
            self.bodies.push(BodyData {
                name: body.name.clone(),
                index,
                frame: PlanarFrame {
                    at: -mass.center,
                    angle: 0.0,
                },
                frame_marker,
                center_marker,
                massless: mass.mass == 0.0 || mass.inertia == 0.0,
            });
            self.point_properties(&body.name, frame_marker);
            for name in &body.hold {
                self.hold(&body.name, *name, frame_marker, &place);
            }
        }
    }

    fn hold(&mut self, body: &str, name: HeldCoordinate, marker: usize, place: &Place) {
        let (kind, label) = match name {
            HeldCoordinate::X => (PlanarMeasure::GroundX, "x"),
            HeldCoordinate::Y => (PlanarMeasure::GroundY, "y"),
            HeldCoordinate::Angle => (PlanarMeasure::Angle, "angle"),
            // Refused before.
            HeldCoordinate::Z | HeldCoordinate::Orientation => return,
        };
        let measure = GlobalMeasure {
            kind,
            first: 0,
            second: marker,
        };
        let value = self.estimate(measure);
        self.start_element(
            format!("held {body}.{label}"),
            place.key("hold"),
            measure,
            value,
            Phase::StartPosition,
        );
    }

    /// A row that holds at the start only: measure = value (its rate = value for velocities).
    pub fn start_element(
        &mut self,
        name: String,
        path: String,
        measure: GlobalMeasure,
        value: f64,
        phase: Phase,
    ) {
        let local = crate::joint::Measure {
            kind: measure.kind,
            first: 0,
            second: 1,
        };
        let target = match phase {
            // C_t = -rate at every time: the velocity row reads measure' = rate.
            Phase::StartVelocity => crate::joint::TimeFunction::Rate(value),
            Phase::Always | Phase::StartPosition => crate::joint::TimeFunction::Constant(value),
        };
        self.elements.push(ElementData {
            name,
            role: Role::Start,
            kind: "start".to_owned(),
            path,
            phase,
            element: Arc::new(MeasureRows {
                markers: 2,
                rows: smallvec![MeasureRow::follow(local, target, "value")],
            }),
            markers: smallvec![measure.first, measure.second],
            reaction_marker: 1,
            axes_marker: 0,
            coordinates: SmallVec::new(),
            auxiliary_start: SmallVec::new(),
            scale: 1.0,
            bodies: SmallVec::new(),
            slots: SmallVec::new(),
            rows: 0..0,
            aux: 0..0,
        });
    }

    /// What expressions may ask of a body or a trace.
    fn point_properties(&mut self, name: &str, marker: usize) {
        let of = |name: &str, kind, measure, dim| Property {
            name: name.to_owned(),
            kind,
            measure: GlobalMeasure {
                kind: measure,
                first: 0,
                second: marker,
            },
            dim,
        };
        use PlanarMeasure::{Angle, GroundX, GroundY};
        use SignalKind::{Rate, Value};
        self.properties.insert(
            name.to_owned(),
            vec![
                of("x", Value, GroundX, Dim::LENGTH),
                of("y", Value, GroundY, Dim::LENGTH),
                of("angle", Value, Angle, Dim::NONE),
                of("vx", Rate, GroundX, Dim::VELOCITY),
                of("vy", Rate, GroundY, Dim::VELOCITY),
                of("omega", Rate, Angle, Dim::FREQUENCY),
            ],
        );
    }

    /// Resolves the traces.
    pub fn traces(&mut self) {
        let model = self.model;
        for (index, trace) in model.traces.iter().enumerate() {
            let place = Place::new("trace", index, "trace", &trace.name);
            let body = self.place(&trace.body, &place.owner, &place.key("body"));
            let at = self.optional_point(trace.at.as_ref(), &place, "at");
            let angle = self
                .optional(trace.angle.as_ref(), Dim::NONE, &place, "angle")
                .unwrap_or(0.0);
            let observer = trace.relative_to.as_ref().map(|name| {
                let own = self.place(name, &place.owner, &place.key("relative_to"));
                (self.marker(&own, Vector2::zeros(), 0.0), name.clone())
            });
            let at = self.or_origin(at);
            let marker = self.marker(&body, at, angle);
            self.point_properties(&trace.name, marker);
            self.trace_list.push(TraceData {
                name: trace.name.clone(),
                marker,
                observer,
            });
        }
    }
}
