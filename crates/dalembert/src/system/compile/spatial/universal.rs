//! Hooke's joint, and joints with an axis on each body.

use super::super::built::Built;
use super::super::context::{Context, GlobalMeasure};
use super::super::place::Place;
use super::super::placement::Points;
use super::axes::with_x;
use super::joint_rows::{chain, row, together};
use crate::diagnostic::Diagnostic;
use crate::joint::SpatialMeasure::{Angle, Dot};
use crate::joint::{Measure, MeasureRows};
use crate::model::{Placement, Point};
use crate::space::Spatial;
use crate::space::orientation::Axis;
use crate::system::Coordinate;
use nalgebra::Vector3;
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

impl Context<'_, Spatial> {
    /// The axis of the first body and that of the second, each in its own body's frame.
    pub(super) fn two_axes(
        &mut self,
        p: &Placement,
        second: Option<&Point>,
        points: &Points<Spatial>,
        place: &Place,
    ) -> Option<[Vector3<f64>; 2]> {
        let of = |k: usize, d: Vector3<f64>| points.bodies[k].frame.axes.tr_mul(&d);
        match (&p.axes, &p.axis, second) {
            (Some(axes), None, None) => {
                let [a, b] = [0, 1].map(|k| self.direction(&axes[k], place, &format!("axes[{k}]")));
                Some([a?, b?])
            }
            (None, Some(first), Some(second)) => {
                let a = self.direction(first, place, "axis");
                let b = self.direction(second, place, "second_axis");
                Some([of(0, a?), of(1, b?)])
            }
            _ => {
                self.report(
                    Diagnostic::error(
                        "no-direction",
                        &place.path,
                        format!("{}: it needs an axis on each of its bodies", place.owner),
                    )
                    .help(
                        "give axes = [[x, y, z], [x, y, z]] (in each body's frame), or axis and second_axis (ground axes)",
                    ),
                );
                None
            }
        }
    }

    /// Hooke's joint: the centre, and an axis a of the first body across an axis b of the second (Shabana 7.181).
    ///
    /// Markers: e has z = a, f has x = b; angle_1 turns the cross about a. For angle_2, about b, the frames change their
    /// parts: g on the second body has z = -b, h on the first has x = a. Both are zero in the estimate.
    pub(super) fn universal(
        &mut self,
        p: &Placement,
        second: Option<&Point>,
        place: &Place,
    ) -> Option<Built<Spatial>> {
        if p.x_axis.is_some() || p.x_axes.is_some() {
            self.report(
                Diagnostic::error(
                    "placed-twice",
                    &place.path,
                    format!("{}: the axes of the cross say how it stands", place.owner),
                )
                .help("leave x_axis and x_axes out; both angles are zero in the initial estimate"),
            );
            return None;
        }
        let points = self.points(p, place, true)?;
        let [a, b] = self.two_axes(p, second, &points, place)?;
        let [first, other] = [0, 1].map(|k: usize| points.bodies[k].frame.axes);
        // Each axis as the other body sees it in the estimate.
        let (b_seen, a_seen) = (first.tr_mul(&(other * b)), other.tr_mul(&(first * a)));
        let frames = with_x(&a, &b_seen).zip(with_x(&-b, &a_seen));
        let Some((e, g)) = frames else {
            self.report(
                Diagnostic::error(
                    "zero-axis",
                    &place.path,
                    format!(
                        "{}: its two axes have the same direction in the initial estimate",
                        place.owner
                    ),
                )
                .help("the axes of a cross stand at right angles: correct them, or the estimate"),
            );
            return None;
        };
        let f = with_x(&g.column(0).into_owned(), &b)?;
        let h = with_x(&e.column(0).into_owned(), &a)?;
        let mut markers: SmallVec<[usize; 4]> = SmallVec::new();
        for (k, axes) in [(0, e), (1, f), (1, g), (0, h)] {
            let frame = crate::space::SpatialFrame {
                at: points.at[k],
                axes,
            };
            markers.push(self.marker(&points.bodies[k], &frame));
        }
        let angle = |name, first, second| Coordinate {
            name,
            measure: Measure {
                kind: Angle(Axis::Z),
                first,
                second,
            },
        };
        let coordinates: SmallVec<[Coordinate<Spatial>; 2]> =
            smallvec![angle("angle_1", 0, 1), angle("angle_2", 2, 3)];
        for c in &coordinates {
            self.count_turns(GlobalMeasure {
                kind: c.measure.kind,
                first: markers[c.measure.first],
                second: markers[c.measure.second],
            });
        }
        let cross = row(Dot(Axis::Z, Axis::X), "angle of the cross");
        Some(Built {
            kind: "universal",
            element: Arc::new(MeasureRows {
                markers: 4,
                rows: chain([together(), smallvec![cross]]),
                alike: SmallVec::new(),
            }),
            markers,
            coordinates,
            auxiliary_start: SmallVec::new(),
            reaction_marker: 1,
        })
    }
}
