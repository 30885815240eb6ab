//! The planar joint catalogue: each kind becomes rows (its constraint subspace Phi) and free
//! coordinates (its motion subspace S).

use super::super::built::Built;
use super::super::context::{Context, GlobalMeasure};
use super::super::geometry::Direction;
use super::super::place::Place;
use crate::joint::{Measure, MeasureRow, PlanarMeasure, TimeFunction};
use crate::model::{CamFollower, JointKind};
use crate::space::Planar;
use crate::system::Coordinate;
use dalembert_expr::Dim;
use smallvec::{SmallVec, smallvec};
use std::f64::consts::TAU;

/// Measure between the element's first and second marker.
pub(super) const fn between(kind: PlanarMeasure) -> Measure {
    Measure {
        kind,
        first: 0,
        second: 1,
    }
}

pub(super) const ANGLE: Coordinate = Coordinate {
    name: "angle",
    measure: between(PlanarMeasure::Angle),
};
const DISPLACEMENT: Coordinate = Coordinate {
    name: "displacement",
    measure: between(PlanarMeasure::AlongX),
};

impl Context<'_, Planar> {
    pub(super) fn planar_joint(
        &mut self,
        kind: &JointKind,
        place: &Place,
    ) -> Option<Built<Planar>> {
        use PlanarMeasure::{AlongY, GroundX, GroundY};
        let minus = |kind, label| MeasureRow::minus(between(kind), 0.0, label);
        match kind {
            JointKind::Revolute { placement } => {
                let m = self.planar_placement(placement, place, Direction::Optional)?;
                let rows = smallvec![minus(GroundX, "x"), minus(GroundY, "y")];
                Some(Built::rows("revolute", m, rows, smallvec![ANGLE]))
            }
            JointKind::Prismatic { placement } => {
                let m = self.planar_placement(placement, place, Direction::Needed)?;
                let rows = smallvec![self.same_angle(m), minus(AlongY, "across the slide")];
                Some(Built::rows("prismatic", m, rows, smallvec![DISPLACEMENT]))
            }
            JointKind::Weld { placement } => {
                let m = self.planar_placement(placement, place, Direction::Keep)?;
                let rows = smallvec![minus(GroundX, "x"), minus(GroundY, "y"), self.same_angle(m)];
                Some(Built::rows("weld", m, rows, SmallVec::new()))
            }
            JointKind::Distance { placement, length } => {
                let m = self.planar_placement(placement, place, Direction::Optional)?;
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
                let m = self.planar_placement(placement, place, Direction::Needed)?;
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
                let m = self.planar_placement(placement, place, Direction::Needed)?;
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
                let m = self.planar_placement(placement, place, Direction::Needed)?;
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
                let m = self.planar_placement(placement, place, Direction::Optional)?;
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
                let m = self.planar_placement(placement, place, need)?;
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
            | JointKind::RollingDisc { .. }
            | JointKind::RollingBall { .. }
            | JointKind::KnifeEdge { .. }
            | JointKind::SurfaceContact { .. }
            | JointKind::PointOnSurface { .. }
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
