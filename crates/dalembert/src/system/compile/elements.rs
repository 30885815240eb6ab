//! Joints and what every compiled element has.

use super::built::Built;
use super::context::{Context, GlobalMeasure, JointPlace};
use super::geometry::Geometry;
use super::names::Property;
use super::place::Place;
use crate::joint::MeasureKind;
use crate::signal::SignalKind;
use crate::system::{ElementData, Phase, Role};
use dalembert_expr::Dim;
use smallvec::SmallVec;

impl<S: Geometry> Context<'_, S> {
    /// Compiles the joints.
    pub fn joints(&mut self) {
        let model = self.model;
        for (index, joint) in model.joints.iter().enumerate() {
            let place = Place::new("joint", index, "joint", &joint.name);
            let Some(built) = S::joint(self, &joint.kind, &place) else {
                self.spoilt.insert(joint.name.clone());
                continue;
            };
            self.joint_places.insert(
                joint.name.clone(),
                JointPlace {
                    markers: built.markers.clone(),
                    coordinates: built.coordinates.clone(),
                },
            );
            self.joint_properties(&joint.name);
            self.push_element(joint.name.clone(), Role::Joint, place.path, built);
        }
    }

    pub fn push_element(&mut self, name: String, role: Role, path: String, built: Built<S>) {
        self.elements.push(ElementData {
            name,
            role,
            kind: built.kind.to_owned(),
            path,
            phase: Phase::Always,
            element: built.element,
            markers: built.markers,
            reaction_marker: built.reaction_marker,
            axes_marker: 0,
            coordinates: built.coordinates,
            auxiliary_start: built.auxiliary_start,
            scale: 1.0,
            bodies: SmallVec::new(),
            slots: SmallVec::new(),
            rows: 0..0,
            aux: 0..0,
        });
    }

    fn joint_properties(&mut self, name: &str) {
        let place = &self.joint_places[name];
        let mut list = Vec::new();
        for c in &place.coordinates {
            let measure = GlobalMeasure {
                kind: c.measure.kind,
                first: place.markers[c.measure.first],
                second: place.markers[c.measure.second],
            };
            let (dim, rate) = if c.measure.kind.is_angle() {
                (Dim::NONE, Dim::FREQUENCY)
            } else {
                (Dim::LENGTH, Dim::VELOCITY)
            };
            list.push(Property {
                name: c.name.to_owned(),
                kind: SignalKind::Value,
                measure,
                dim,
            });
            list.push(Property {
                name: format!("{}_rate", c.name),
                kind: SignalKind::Rate,
                measure,
                dim: rate,
            });
        }
        self.properties.insert(name.to_owned(), list);
    }
}
