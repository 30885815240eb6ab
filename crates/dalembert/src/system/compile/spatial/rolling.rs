//! Wheels, balls and blades on a plane.

use super::super::built::Built;
use super::super::context::Context;
use super::super::place::Place;
use super::axes::with_z;
use super::placement::Zero::OfBodies;
use crate::diagnostic::Diagnostic;
use crate::joint::{ConstraintElement, KnifeEdge, RollingOnPlane};
use crate::model::{Placement, Point, Value};
use crate::space::Spatial;
use dalembert_expr::Dim;
use smallvec::SmallVec;
use std::sync::Arc;

fn on_plane(
    kind: &'static str,
    element: impl ConstraintElement<Spatial> + 'static,
    m: [usize; 2],
) -> Built<Spatial> {
    Built {
        kind,
        element: Arc::new(element),
        markers: SmallVec::from_slice(&m),
        coordinates: SmallVec::new(),
        auxiliary_start: SmallVec::new(),
        reaction_marker: 1,
    }
}

impl Context<'_, Spatial> {
    /// A wheel of a radius whose rim is a ring with a rounding; its centre line rolls.
    pub(super) fn rolling_disc(
        &mut self,
        placement: &Placement,
        second_axis: Option<&Point>,
        radius: &Value,
        rounding: Option<&Value>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let radius = self.positive(radius, Dim::LENGTH, "radius", place, "radius");
        let rounding = match rounding {
            Some(r) => self.positive(r, Dim::LENGTH, "rounding", place, "rounding"),
            None => Some(0.0),
        };
        let points = self.points(placement, place, true)?;
        let [a, b] = self.two_axes(placement, second_axis, &points, place)?;
        let m = self.two_frames(&points, [with_z(&a)?, with_z(&b)?]);
        let (radius, rounding) = (radius?, rounding?);
        if rounding >= radius {
            self.report(
                Diagnostic::error(
                    "bad-ring",
                    place.key("rounding"),
                    format!(
                        "{}: the rounding is not smaller than the radius of the wheel",
                        place.owner
                    ),
                )
                .help("use kind = \"rolling-ball\" for a ball, or correct the radii"),
            );
            return None;
        }
        self.lies_flat(m, place)?;
        let wheel = RollingOnPlane {
            radius: radius - rounding,
            rounding,
        };
        Some(on_plane("rolling-disc", wheel, m))
    }

    /// A ball of a radius.
    pub(super) fn rolling_ball(
        &mut self,
        placement: &Placement,
        radius: &Value,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let rounding = self.positive(radius, Dim::LENGTH, "radius", place, "radius");
        let m = self.sit(placement, place, true, OfBodies)?;
        let ball = RollingOnPlane {
            radius: 0.0,
            rounding: rounding?,
        };
        Some(on_plane("rolling-ball", ball, m))
    }

    /// A blade that does not slip sideways.
    pub(super) fn knife_edge(
        &mut self,
        placement: &Placement,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        let m = self.sit(placement, place, true, OfBodies)?;
        Some(on_plane("knife-edge", KnifeEdge, m))
    }

    /// Refuses a wheel that lies flat on its plane in the estimate: it then touches everywhere.
    fn lies_flat(&mut self, m: [usize; 2], place: &Place) -> Option<()> {
        let [n, a] = m.map(|k| self.pose(k).axes.column(2).into_owned());
        if self.stand_ins || n.cross(&a).norm() > 1e-9 {
            return Some(());
        }
        self.report(
            Diagnostic::error(
                "zero-axis",
                &place.path,
                format!(
                    "{}: the wheel lies flat on its plane in the initial estimate",
                    place.owner
                ),
            )
            .help("correct its axle, or the estimate of its orientation"),
        );
        None
    }
}
