//! Where a joint or a force element sits on its two bodies.

use super::super::context::Context;
use super::super::geometry::Direction;
use super::super::place::Place;
use super::rotate;
use crate::diagnostic::Diagnostic;
use crate::model::Placement;
use crate::space::{Planar, PlanarFrame};
use dalembert_expr::Dim;

impl Context<'_, Planar> {
    /// Markers of a placement on its two bodies.
    pub(super) fn planar_placement(
        &mut self,
        p: &Placement,
        place: &Place,
        direction: Direction,
    ) -> Option<[usize; 2]> {
        let [a, b] = [0, 1].map(|k| {
            self.place(
                &p.bodies[k],
                &place.owner,
                &place.key(&format!("bodies[{k}]")),
            )
        });
        // Empty names stand for a mistake that is known already.
        if p.bodies[0] == p.bodies[1] && !p.bodies[0].is_empty() {
            self.report(
                Diagnostic::error(
                    "same-body",
                    place.key("bodies"),
                    format!("{}: both bodies are '{}'", place.owner, p.bodies[0]),
                )
                .help("name two different bodies"),
            );
            return None;
        }
        let points = match (&p.at, &p.point) {
            (Some(at), None) => {
                let [x, y] = [0, 1].map(|k| {
                    self.vector(
                        &at[k],
                        Dim::LENGTH,
                        &place.owner,
                        &place.key(&format!("at[{k}]")),
                    )
                });
                [self.or_origin(x).xy(), self.or_origin(y).xy()]
            }
            (None, Some(point)) => {
                let point = self.vector(point, Dim::LENGTH, &place.owner, &place.key("point"));
                let point = self.or_origin(point).xy();
                [&a, &b].map(|body| rotate(-body.frame.angle, &(point - body.frame.at)))
            }
            (given, _) => {
                let (code, text) = if given.is_some() {
                    ("placed-twice", "both 'at' and 'point' are given")
                } else {
                    ("not-placed", "neither 'at' nor 'point' is given")
                };
                self.report(
                    Diagnostic::error(code, &place.path, format!("{}: {text}", place.owner))
                        .help("give at = [[x, y], [x, y]] (a point in each body's frame) or point = [x, y] (ground axes)"),
                );
                return None;
            }
        };
        let angles = match (&p.angles, &p.direction) {
            (Some(angles), None) => {
                let [x, y] = [0, 1].map(|k| {
                    self.number(
                        &angles[k],
                        Dim::NONE,
                        &place.owner,
                        &place.key(&format!("angles[{k}]")),
                    )
                });
                [x?, y?]
            }
            (None, Some(d)) => {
                let d = self.vector(d, Dim::NONE, &place.owner, &place.key("direction"))?;
                if d.norm() == 0.0 {
                    self.report(
                        Diagnostic::error(
                            "zero-axis",
                            place.key("direction"),
                            format!("{}: the direction has zero length", place.owner),
                        )
                        .help("give a direction like [1, 0]"),
                    );
                    return None;
                }
                let angle = d.y.atan2(d.x);
                [angle - a.frame.angle, angle - b.frame.angle]
            }
            (Some(_), Some(_)) => {
                self.report(
                    Diagnostic::error(
                        "placed-twice",
                        &place.path,
                        format!("{}: both 'angles' and 'direction' are given", place.owner),
                    )
                    .help("give one of them"),
                );
                return None;
            }
            (None, None) => match direction {
                Direction::Optional => [0.0, 0.0],
                Direction::Keep => [0.0, a.frame.angle - b.frame.angle],
                Direction::Needed => {
                    self.report(
                        Diagnostic::error("no-direction", &place.path, format!("{}: its direction is missing", place.owner))
                            .help("give direction = [x, y] (ground axes) or angles = [a, b] (of the axis in each body's frame)"),
                    );
                    return None;
                }
            },
        };
        let [first, second] = [0, 1].map(|k| PlanarFrame {
            at: points[k],
            angle: angles[k],
        });
        Some([self.marker(&a, &first), self.marker(&b, &second)])
    }
}
