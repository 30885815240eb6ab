//! The spatial joint catalogue: each kind becomes rows (its constraint subspace Phi) and free coordinates (its motion
//! subspace S), made of the primitives of Shabana 7.10.
//!
//! The joint's axis is z of its frames (e on the first body, f on the second).

use super::super::built::Built;
use super::super::context::{Context, GlobalMeasure};
use super::super::place::Place;
use super::axes::with_z;
use super::joint_rows::{
    ANGLE, DISPLACEMENT, Row, alike, between, built, chain, not_twisted, on_axis, parallel, row,
    standing, together,
};
use super::placement::Zero;
use crate::joint::{MeasureRow, MeasureTerm, SpatialMeasure, TimeFunction};
use crate::model::{JointKind, Placement};
use crate::space::Spatial;
use crate::space::orientation::Axis;
use SpatialMeasure::{Along, Angle, Distance, Dot};
use dalembert_expr::Dim;
use smallvec::{SmallVec, smallvec};
use std::f64::consts::TAU;

impl Context<'_, Spatial> {
    pub(super) fn spatial_joint(
        &mut self,
        kind: &JointKind,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        use Zero::{OfBodies, OfEstimate};
        Some(match kind {
            JointKind::Spherical { placement } => {
                let m = self.sit(placement, place, false, OfEstimate)?;
                built("spherical", m, together(), &[], SmallVec::new())
            }
            JointKind::Revolute { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                self.turns(m);
                let rows = chain([together(), parallel()]);
                built("revolute", m, rows, &[Axis::Z], smallvec![ANGLE])
            }
            JointKind::Cylindrical { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                self.turns(m);
                let rows = chain([on_axis(), parallel()]);
                built(
                    "cylindrical",
                    m,
                    rows,
                    &[Axis::Z],
                    smallvec![ANGLE, DISPLACEMENT],
                )
            }
            JointKind::Prismatic { placement } => {
                let m = self.sit(placement, place, true, OfEstimate)?;
                let rows = chain([on_axis(), alike()]);
                built(
                    "prismatic",
                    m,
                    rows,
                    &[Axis::X, Axis::Z],
                    smallvec![DISPLACEMENT],
                )
            }
            JointKind::Weld { placement } => {
                let m = self.sit(placement, place, false, OfEstimate)?;
                let rows = chain([together(), alike()]);
                built("weld", m, rows, &[Axis::X, Axis::Z], SmallVec::new())
            }
            JointKind::Universal {
                placement,
                second_axis,
            } => self.universal(placement, second_axis.as_ref(), place)?,
            JointKind::ConstantVelocity { placement } => {
                let m = self.sit(placement, place, true, OfEstimate)?;
                // The turn from one shaft to the other has its axis across both: e_x.f_y = e_y.f_x.
                let mut twist = row(Dot(Axis::X, Axis::Y), "twist");
                twist.terms.push(MeasureTerm {
                    factor: 1.0,
                    measure: between(Dot(Axis::Y, Axis::X)),
                });
                let rows = chain([together(), smallvec![twist]]);
                standing("constant-velocity", m, rows, not_twisted(), SmallVec::new())
            }
            JointKind::Screw { placement, pitch } => {
                let pitch = self.number(pitch, Dim::LENGTH, &place.owner, &place.key("pitch"));
                let m = self.sit(placement, place, true, OfBodies)?;
                self.turns(m);
                let rows = chain([on_axis(), parallel(), smallvec![self.thread(m, pitch?)]]);
                built("screw", m, rows, &[Axis::Z], smallvec![ANGLE])
            }
            JointKind::Planar { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                let lifted = row(Along(Axis::Z), "off the plane");
                let rows = chain([smallvec![lifted], parallel()]);
                built("planar", m, rows, &[Axis::Z], SmallVec::new())
            }
            JointKind::Distance { placement, length } => {
                let m = self.sit(placement, place, false, OfEstimate)?;
                let measure = GlobalMeasure {
                    kind: Distance,
                    first: m[0],
                    second: m[1],
                };
                let target = match length {
                    Some(l) => self.positive(l, Dim::LENGTH, "length", place, "length")?,
                    None => self.estimate(measure),
                };
                self.nonzero_distance(measure, &place.owner, &place.path)?;
                let rows = smallvec![MeasureRow::minus(between(Distance), target, "length")];
                built("distance", m, rows, &[], SmallVec::new())
            }
            JointKind::PointOnLine { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                built("point-on-line", m, on_axis(), &[], smallvec![DISPLACEMENT])
            }
            JointKind::PointOnPlane { placement } => {
                let m = self.sit(placement, place, true, OfBodies)?;
                let rows = smallvec![row(Along(Axis::Z), "off the plane")];
                built("point-on-plane", m, rows, &[], SmallVec::new())
            }
            JointKind::PointOnCurve {
                placement,
                curve,
                u,
            } => self.point_on_curve(placement, curve, u.as_ref(), place)?,
            JointKind::ParallelAxes { placement } => {
                let points = self.points(placement, place, false)?;
                let axes = self.directions(placement, &points, place, true, OfBodies)?;
                let m = self.two_frames(&points, axes);
                built("parallel-axes", m, parallel(), &[Axis::Z], SmallVec::new())
            }
            JointKind::PerpendicularAxes {
                placement,
                second_axis,
            } => {
                let points = self.points(placement, place, false)?;
                let [a, b] = self.two_axes(placement, second_axis.as_ref(), &points, place)?;
                let axes = [with_z(&a)?, with_z(&b)?];
                let m = self.two_frames(&points, axes);
                let rows = smallvec![row(Dot(Axis::Z, Axis::Z), "angle of the axes")];
                built("perpendicular-axes", m, rows, &[], SmallVec::new())
            }
            JointKind::RollingDisc {
                placement,
                second_axis,
                radius,
                rounding,
            } => self.rolling_disc(
                placement,
                second_axis.as_ref(),
                radius,
                rounding.as_ref(),
                place,
            )?,
            JointKind::RollingBall { placement, radius } => {
                self.rolling_ball(placement, radius, place)?
            }
            JointKind::KnifeEdge { placement } => self.knife_edge(placement, place)?,
            JointKind::SurfaceContact {
                placement,
                surfaces,
                parameters,
            } => self.surface_contact(placement, surfaces, parameters.as_ref(), place)?,
            JointKind::PointOnSurface {
                placement,
                surface,
                parameters,
            } => self.point_on_surface(placement, surface, parameters.as_ref(), place)?,
            JointKind::GearPair { joints, ratio } => self.gear_pair(joints, ratio, place)?,
            JointKind::RackPair { joints, radius } => self.rack_pair(joints, radius, place)?,
            // Refused before.
            JointKind::PinSlot { .. }
            | JointKind::Gear { .. }
            | JointKind::Rack { .. }
            | JointKind::Cam { .. }
            | JointKind::RollingOnLine { .. }
            | JointKind::RollingOnCircle { .. } => return None,
        })
    }

    /// Markers of a joint.
    pub(super) fn sit(
        &mut self,
        placement: &Placement,
        place: &Place,
        needed: bool,
        zero: Zero,
    ) -> Option<[usize; 2]> {
        let points = self.points(placement, place, true)?;
        let axes = self.directions(placement, &points, place, needed, zero)?;
        Some(self.two_frames(&points, axes))
    }

    /// Makes the angle of a joint count turns.
    fn turns(&mut self, m: [usize; 2]) {
        self.count_turns(GlobalMeasure {
            kind: Angle(Axis::Z),
            first: m[0],
            second: m[1],
        });
    }

    /// Along - pitch/(2 pi) angle = constant, the value of the estimate (Shabana 3.8, screw).
    fn thread(&self, m: [usize; 2], pitch: f64) -> Row {
        let mut row = row(Along(Axis::Z), "thread");
        row.terms.push(MeasureTerm {
            factor: pitch / TAU,
            measure: between(Angle(Axis::Z)),
        });
        let poses = m.map(|k| self.pose(k));
        row.target = TimeFunction::Constant(row.sum(&poses));
        row
    }
}
