//! Bodies and traces.

use super::context::{BodyPlace, Context, GlobalMeasure};
use super::geometry::Geometry;
use super::place::Place;
use crate::joint::{Measure, MeasureRow, MeasureRows, TimeFunction};
use crate::model::HeldCoordinate;
use crate::system::{BodyData, ElementData, Phase, Role, TraceData};
use nalgebra::Vector3;
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

/// How much less a coordinate counts in the assembly where its user gave no estimate.
const UNSAID: f64 = 1e-4;

impl<S: Geometry> Context<'_, S> {
    /// Resolves the bodies: mass properties, estimates, frame markers, held coordinates.
    pub fn bodies(&mut self) {
        let model = self.model;
        for (index, body) in model.bodies.iter().enumerate() {
            let place = Place::new("body", index, "body", &body.name);
            let parts = S::body(self, body, &place);
            let number = (!body.fixed).then_some(self.bodies.len());
            let own = BodyPlace {
                body: number,
                frame: parts.frame,
                center: parts.center,
            };
            let frame = S::frame(&Vector3::zeros());
            self.places.insert(body.name.clone(), own.clone());
            if number.is_none() {
                let marker = self.marker(&own, &frame);
                self.point_properties(&body.name, marker);
                continue;
            }
            self.q.extend(parts.q);
            self.v.extend(parts.v);
            let weigh = |known: bool| if known { 1.0 } else { UNSAID };
            self.position_weight
                .extend(parts.position_known.into_iter().map(weigh));
            self.velocity_weight
                .extend(parts.velocity_known.into_iter().map(weigh));
            self.mass.extend(parts.mass);
            let frame_marker = self.marker(&own, &frame);
            let center_marker = self.marker(&own, &S::frame(&parts.center));
            self.bodies.push(BodyData {
                name: body.name.clone(),
                index,
                frame: S::from_center(&frame, &parts.center),
                frame_marker,
                center_marker,
                massless: parts.massless,
            });
            self.point_properties(&body.name, frame_marker);
            for name in &body.hold {
                self.hold(&body.name, *name, frame_marker, &place);
            }
        }
    }

    fn hold(&mut self, body: &str, name: HeldCoordinate, marker: usize, place: &Place) {
        let first = if name == HeldCoordinate::Orientation {
            // Seen from the estimate itself, the directions of small turns are plain.
            let frame = self.places[body].frame;
            self.marker(&BodyPlace::ground(), &frame)
        } else {
            0
        };
        for kind in S::held(name) {
            let measure = GlobalMeasure {
                kind,
                first,
                second: marker,
            };
            let value = self.estimate(measure);
            self.start_element(
                format!("held {body}.{}", name.label()),
                place.key("hold"),
                measure,
                value,
                Phase::StartPosition,
            );
        }
    }

    /// A row that holds at the start only: measure = value (its rate = value for velocities).
    pub fn start_element(
        &mut self,
        name: String,
        path: String,
        measure: GlobalMeasure<S>,
        value: f64,
        phase: Phase,
    ) {
        let local = Measure {
            kind: measure.kind,
            first: 0,
            second: 1,
        };
        let target = match phase {
            // C_t = -rate at every time: the velocity row reads measure' = rate.
            Phase::StartVelocity => TimeFunction::Rate(value),
            Phase::Always | Phase::StartPosition => TimeFunction::Constant(value),
        };
        self.elements.push(ElementData {
            name,
            role: Role::Start,
            kind: "start".to_owned(),
            path,
            phase,
            element: Arc::new(MeasureRows::new(
                2,
                smallvec![MeasureRow::follow(local, target, "value")],
            )),
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
        self.properties
            .insert(name.to_owned(), S::point_properties(marker));
    }

    /// Resolves the traces.
    pub fn traces(&mut self) {
        let model = self.model;
        for (index, trace) in model.traces.iter().enumerate() {
            let place = Place::new("trace", index, "trace", &trace.name);
            let body = self.place(&trace.body, &place.owner, &place.key("body"));
            let frame = S::trace(self, trace, &place);
            let observer = trace.relative_to.as_ref().map(|name| {
                let own = self.place(name, &place.owner, &place.key("relative_to"));
                let marker = self.marker(&own, &S::frame(&Vector3::zeros()));
                (marker, name.clone())
            });
            let marker = self.marker(&body, &frame);
            self.point_properties(&trace.name, marker);
            self.trace_list.push(TraceData {
                name: trace.name.clone(),
                marker,
                observer,
            });
        }
    }
}
