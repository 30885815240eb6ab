//! Circles that roll on lines and on circles.

use super::super::built::Built;
use super::super::context::Context;
use super::super::place::Place;
use super::joints::{ANGLE, between};
use crate::diagnostic::Diagnostic;
use crate::joint::{MeasureRow, MeasureTerm, PlanarMeasure, RollingOnCircle, TimeFunction};
use crate::model::Side;
use crate::space::Planar;
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

impl Context<'_, Planar> {
    /// Rolling without slip of the second marker's circle on the first marker's x axis:
    /// xi + sigma r phi = constant, sigma = +1 where the circle lies to the left (Shabana, rack and
    /// pinion, with the sign by side).
    pub(super) fn rolling_row(&self, m: [usize; 2], signed_radius: f64) -> MeasureRow {
        let mut row = MeasureRow {
            terms: smallvec![
                MeasureTerm {
                    factor: 1.0,
                    measure: between(PlanarMeasure::AlongX)
                },
                MeasureTerm {
                    factor: signed_radius,
                    measure: between(PlanarMeasure::Angle)
                }
            ],
            target: TimeFunction::Constant(0.0),
            label: "no slip".to_owned(),
        };
        let poses = m.map(|k| self.pose(k));
        row.target = TimeFunction::Constant(row.sum(&poses));
        row
    }

    /// +1 to the left of the first marker's x axis, -1 to the right.
    pub(super) fn side(&mut self, side: Option<Side>, m: [usize; 2], place: &Place) -> Option<f64> {
        if let Some(side) = side {
            return Some(if side == Side::Left { 1.0 } else { -1.0 });
        }
        let eta = PlanarMeasure::AlongY.value(&self.pose(m[0]), &self.pose(m[1]));
        if eta == 0.0 && self.stand_ins {
            return None;
        }
        if eta == 0.0 {
            self.report(
                Diagnostic::error(
                    "side-unknown",
                    &place.path,
                    format!(
                        "{}: the centre of the circle lies on the line in the initial estimate",
                        place.owner
                    ),
                )
                .help("give side = \"left\" or \"right\", or move the estimate"),
            );
            return None;
        }
        Some(eta.signum())
    }

    pub(super) fn rolling_on_circle(
        &mut self,
        m: [usize; 2],
        first: f64,
        second: f64,
        place: &Place,
    ) -> Option<Built<Planar>> {
        let distance = first + second;
        if distance == 0.0 {
            self.report(
                Diagnostic::error(
                    "zero-length",
                    place.key("radii"),
                    format!(
                        "{}: circles of equal radius cannot roll inside each other",
                        place.owner
                    ),
                )
                .help("make one radius smaller"),
            );
            return None;
        }
        let [a, b] = m.map(|k| self.pose(k));
        let d = distance.signum() * (b.point - a.point);
        if d.norm() == 0.0 && self.stand_ins {
            return None;
        }
        if d.norm() == 0.0 {
            self.report(
                Diagnostic::error(
                    "zero-length",
                    &place.path,
                    format!(
                        "{}: the centres of the circles coincide in the initial estimate",
                        place.owner
                    ),
                )
                .help("move the estimate of one body"),
            );
            return None;
        }
        let psi = d.y.atan2(d.x);
        let constant = first * (psi - a.angle) + second * (psi - b.angle);
        Some(Built {
            kind: "rolling-on-circle",
            element: Arc::new(RollingOnCircle {
                first,
                second,
                constant,
            }),
            markers: SmallVec::from_slice(&m),
            coordinates: smallvec![ANGLE],
            auxiliary_start: smallvec![psi],
            reaction_marker: 1,
        })
    }
}
