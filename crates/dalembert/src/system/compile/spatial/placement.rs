//! Where a joint or a force element sits on its two bodies in space.

use super::super::context::{Context, GlobalMeasure};
use super::super::geometry::Direction;
use super::super::place::Place;
use super::super::placement::Points;
use super::axes::{unit, with_x, with_z};
use crate::diagnostic::Diagnostic;
use crate::joint::SpatialMeasure;
use crate::model::{Placement, Point};
use crate::space::orientation::Axis;
use crate::space::{Spatial, SpatialFrame};
use dalembert_expr::Quantity;
use nalgebra::{Matrix3, Vector3};

/// How the second frame is turned about the joint's z axis where nobody says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Zero {
    /// As the axes of its own body have it: the joint's angle is that between the bodies.
    OfBodies,
    /// As the first frame is in the estimate: nothing turns about the axis, or it starts at zero.
    OfEstimate,
}

impl Context<'_, Spatial> {
    /// Markers of a placement on its two bodies.
    pub(super) fn spatial_placement(
        &mut self,
        p: &Placement,
        place: &Place,
        direction: Direction,
    ) -> Option<[usize; 2]> {
        let points = self.points(p, place, true)?;
        let zero = if direction == Direction::Needed {
            Zero::OfBodies
        } else {
            Zero::OfEstimate
        };
        let axes = self.directions(p, &points, place, direction == Direction::Needed, zero)?;
        Some(self.two_frames(&points, axes))
    }

    pub(super) fn two_frames(
        &mut self,
        points: &Points<Spatial>,
        axes: [Matrix3<f64>; 2],
    ) -> [usize; 2] {
        [0, 1].map(|k| {
            let frame = SpatialFrame {
                at: points.at[k],
                axes: axes[k],
            };
            self.marker(&points.bodies[k], &frame)
        })
    }

    /// A direction of any length, so also of any dimension, like the difference of two points; refuses one without length.
    pub(super) fn direction(
        &mut self,
        given: &Point,
        place: &Place,
        key: &str,
    ) -> Option<Vector3<f64>> {
        let d = self.components_of(given, Quantity::Free, &place.owner, &place.key(key))?;
        let found = unit(&d);
        if found.is_none() {
            self.report(
                Diagnostic::error(
                    "zero-axis",
                    place.key(key),
                    format!("{}: the direction has zero length", place.owner),
                )
                .help("give a direction like [0, 0, 1]"),
            );
        }
        found
    }

    /// A direction in each body's frame: from `axes` in those, or from `axis` in ground axes at the estimate.
    fn both(
        &mut self,
        axis: Option<&Point>,
        axes: Option<&[Point; 2]>,
        keys: [&str; 2],
        points: &Points<Spatial>,
        place: &Place,
    ) -> Option<Option<[Vector3<f64>; 2]>> {
        match (axis, axes) {
            (None, None) => Some(None),
            (Some(axis), None) => {
                let d = self.direction(axis, place, keys[0])?;
                Some(Some(
                    [0, 1].map(|k: usize| points.bodies[k].frame.axes.tr_mul(&d)),
                ))
            }
            (None, Some(axes)) => {
                let [a, b] =
                    [0, 1].map(|k| self.direction(&axes[k], place, &format!("{}[{k}]", keys[1])));
                Some(Some([a?, b?]))
            }
            (Some(_), Some(_)) => {
                self.report(
                    Diagnostic::error(
                        "placed-twice",
                        &place.path,
                        format!(
                            "{}: both '{}' and '{}' are given",
                            place.owner, keys[0], keys[1]
                        ),
                    )
                    .help("give one of them"),
                );
                None
            }
        }
    }

    /// Axes of the joint's frame in the frame of each body.
    pub(super) fn directions(
        &mut self,
        p: &Placement,
        points: &Points<Spatial>,
        place: &Place,
        needed: bool,
        zero: Zero,
    ) -> Option<[Matrix3<f64>; 2]> {
        let z = self.both(
            p.axis.as_ref(),
            p.axes.as_ref(),
            ["axis", "axes"],
            points,
            place,
        )?;
        let x = self.both(
            p.x_axis.as_ref(),
            p.x_axes.as_ref(),
            ["x_axis", "x_axes"],
            points,
            place,
        )?;
        if z.is_none() && (p.direction.is_some() || p.angles.is_some()) {
            // Keys of the plane, which have been reported.
            return None;
        }
        if z.is_none() && (needed || x.is_some()) {
            self.report(
                Diagnostic::error(
                    "no-direction",
                    &place.path,
                    format!("{}: the direction of its axis is missing", place.owner),
                )
                .help(
                    "give axis = [x, y, z] (ground axes) or axes = [[x, y, z], [x, y, z]] (in each body's frame)",
                ),
            );
            return None;
        }
        let [a, b] = [0, 1].map(|k: usize| points.bodies[k].frame.axes);
        let Some(z) = z else {
            // The axes of the first body; in the second those that have the same directions in the estimate.
            return Some([Matrix3::identity(), b.tr_mul(&a)]);
        };
        let Some(x) = x else {
            let first = with_z(&z[0])?;
            let second = match zero {
                Zero::OfBodies => with_z(&z[1])?,
                Zero::OfEstimate => {
                    let seen = b.tr_mul(&(a * first.column(0)));
                    // Where the estimate has it along the axis, any direction is as good.
                    with_x(&z[1], &seen).or_else(|| with_z(&z[1]))?
                }
            };
            return Some([first, second]);
        };
        match (with_x(&z[0], &x[0]), with_x(&z[1], &x[1])) {
            (Some(first), Some(second)) => Some([first, second]),
            _ => {
                self.report(
                    Diagnostic::error(
                        "zero-axis",
                        &place.path,
                        format!("{}: its x axis lies along its z axis", place.owner),
                    )
                    .help("give an x axis that stands across the joint's axis"),
                );
                None
            }
        }
    }

    /// The angle of a second body seen from a first, about an axis of the first, counting turns.
    pub(super) fn angle_about(
        &mut self,
        bodies: &[String; 2],
        axis: Option<&Point>,
        place: &Place,
    ) -> Option<GlobalMeasure<Spatial>> {
        let bodies = self.two_bodies(bodies, place)?;
        let Some(axis) = axis else {
            self.report(
                Diagnostic::error(
                    "no-direction",
                    &place.path,
                    format!("{}: an angle in space needs its axis", place.owner),
                )
                .help("give axis = [x, y, z] (ground axes at the initial estimate)"),
            );
            return None;
        };
        let d = self.direction(axis, place, "axis")?;
        let points = Points {
            bodies,
            at: [Vector3::zeros(); 2],
        };
        let z = [0, 1].map(|k: usize| points.bodies[k].frame.axes.tr_mul(&d));
        let axes = [with_z(&z[0])?, with_z(&z[1])?];
        let [first, second] = self.two_frames(&points, axes);
        let m = GlobalMeasure {
            kind: SpatialMeasure::Angle(Axis::Z),
            first,
            second,
        };
        self.count_turns(m);
        Some(m)
    }
}
