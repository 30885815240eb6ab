//! The planar joint catalogue: each kind becomes rows (its constraint subspace Phi) and free
//! coordinates (its motion subspace S).

mod cam;
mod gear;
mod placement;
mod rolling;

use super::built::Built;
use super::context::{Context, GlobalMeasure, JointPlace};
use super::names::Property;
use super::place::Place;
use crate::joint::{Measure, MeasureRow, PlanarMeasure, TimeFunction};
use crate::model::{CamFollower, JointKind};
use crate::signal::SignalKind;
use crate::system::{Coordinate, ElementData, Phase, Role};
use dalembert_expr::Dim;
pub(super) use placement::Direction;
use smallvec::{SmallVec, smallvec};
use std::f64::consts::TAU;

/// Measure between the element's first and second marker.
const fn between(kind: PlanarMeasure) -> Measure {
    Measure {
        kind,
        first: 0,
        second: 1,
    }
}

const ANGLE: Coordinate = Coordinate {
    name: "angle",
    measure: between(PlanarMeasure::Angle),
};
const DISPLACEMENT: Coordinate = Coordinate {
    name: "displacement",
    measure: between(PlanarMeasure::AlongX),
};

impl Context<'_> {
    /// Compiles the joints.
    pub fn joints(&mut self) {
        let model = self.model;
        for (index, joint) in model.joints.iter().enumerate() {
            let place = Place::new("joint", index, "joint", &joint.name);
            let Some(built) = self.joint(&joint.kind, &place) else {
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

    pub fn push_element(&mut self, name: String, role: Role, path: String, built: Built) {
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

    fn joint(&mut self, kind: &JointKind, place: &Place) -> Option<Built> {
        use PlanarMeasure::{AlongY, GroundX, GroundY};
        let minus = |kind, label| MeasureRow::minus(between(kind), 0.0, label);
        match kind {
            JointKind::Revolute { placement } => {
                let m = self.placement(placement, place, Direction::Optional)?;
                let rows = smallvec![minus(GroundX, "x"), minus(GroundY, "y")];
                Some(Built::rows("revolute", m, rows, smallvec![ANGLE]))
            }
            JointKind::Prismatic { placement } => {
                let m = self.placement(placement, place, Direction::Needed)?;
                let rows = smallvec![self.same_angle(m), minus(AlongY, "across the slide")];
                Some(Built::rows("prismatic", m, rows, smallvec![DISPLACEMENT]))
            }
            JointKind::Weld { placement } => {
                let m = self.placement(placement, place, Direction::Keep)?;
                let rows = smallvec![minus(GroundX, "x"), minus(GroundY, "y"), self.same_angle(m)];
                Some(Built::rows("weld", m, rows, SmallVec::new()))
            }
            JointKind::Distance { placement, length } => {
                let m = self.placement(placement, place, Direction::Optional)?;
                let measure = GlobalMeasure {
                    kind: PlanarMeasure::Distance,
                    first: m[0],
                    second: m[1],
                };
                let target = match length {
                    Some(l) => self.positive(l, Dim::LENGTH, "length", place, "length")?,
                    None => self.estimate(measure),
                };
                self.nonzero_distance(measure, &place.owner, &place.path)?;
                let row = MeasureRow::minus(between(PlanarMeasure::Distance), target, "length");
                Some(Built::rows("distance", m, smallvec![row], SmallVec::new()))
            }
            JointKind::PinSlot { placement } => {
                let m = self.placement(placement, place, Direction::Needed)?;
                let rows = smallvec![minus(AlongY, "across the slot")];
                Some(Built::rows(
                    "pin-slot",
                    m,
                    rows,
                    smallvec![DISPLACEMENT, ANGLE],
                ))
            }
            JointKind::Gear {
                bodies,
                carrier,
                radii,
                internal,
            } => self.gear(bodies, carrier.as_deref(), radii, *internal, place),
            JointKind::Rack {
                placement,
                radius,
                side,
            } => {
                // The rack is the second body, but its axes measure: markers (rack, pinion).
                let m = self.placement(placement, place, Direction::Needed)?;
                let radius = self.positive(radius, Dim::LENGTH, "radius", place, "radius")?;
                let line = [m[1], m[0]];
                let sign = self.side(*side, line, place)?;
                let row = self.rolling_row(line, sign * radius);
                let mut built = Built::rows("rack", line, smallvec![row], SmallVec::new());
                built.coordinates = smallvec![DISPLACEMENT, ANGLE];
                built.reaction_marker = 0;
                Some(built)
            }
            JointKind::RollingOnLine {
                placement,
                radius,
                side,
            } => {
                let m = self.placement(placement, place, Direction::Needed)?;
                let radius = self.positive(radius, Dim::LENGTH, "radius", place, "radius")?;
                let sign = self.side(*side, m, place)?;
                let rows = smallvec![
                    MeasureRow::follow(
                        between(AlongY),
                        TimeFunction::Constant(sign * radius),
                        "contact"
                    ),
                    self.rolling_row(m, sign * radius)
                ];
                Some(Built::rows(
                    "rolling-on-line",
                    m,
                    rows,
                    smallvec![DISPLACEMENT, ANGLE],
                ))
            }
            JointKind::RollingOnCircle {
                placement,
                radii,
                internal,
            } => {
                let m = self.placement(placement, place, Direction::Optional)?;
                let first = self.positive(&radii[0], Dim::LENGTH, "radius", place, "radii[0]");
                let second = self.positive(&radii[1], Dim::LENGTH, "radius", place, "radii[1]");
                let (first, second) = (first?, second?);
                self.rolling_on_circle(m, first, if *internal { -second } else { second }, place)
            }
            JointKind::Cam {
                placement,
                profile,
                follower,
                phi,
            } => {
                let need = if matches!(follower, CamFollower::Flat) {
                    Direction::Needed
                } else {
                    Direction::Optional
                };
                let m = self.placement(placement, place, need)?;
                self.cam(m, profile, follower, phi.as_ref(), place)
            }
            // Refused before.
            JointKind::Spherical { .. }
            | JointKind::Cylindrical { .. }
            | JointKind::Universal { .. }
            | JointKind::ConstantVelocity { .. }
            | JointKind::Screw { .. }
            | JointKind::Planar { .. }
            | JointKind::PointOnLine { .. }
            | JointKind::PointOnPlane { .. }
            | JointKind::PointOnCurve { .. }
            | JointKind::ParallelAxes { .. }
            | JointKind::PerpendicularAxes { .. }
            | JointKind::GearPair { .. }
            | JointKind::RackPair { .. } => None,
        }
    }

    /// Equal angles of two markers, on the turn on which the estimate is.
    fn same_angle(&self, m: [usize; 2]) -> MeasureRow {
        let now = self.pose(m[1]).angle - self.pose(m[0]).angle;
        MeasureRow::minus(
            between(PlanarMeasure::Angle),
            TAU * (now / TAU).round(),
            "angle",
        )
    }
}
