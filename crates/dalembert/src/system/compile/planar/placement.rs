//! Where a joint or a force element sits on its two bodies.

use super::super::context::Context;
use super::super::geometry::Direction;
use super::super::place::Place;
use super::super::placement::Points;
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
        let Points {
            bodies: [a, b],
            at: points,
        } = self.points(p, place, true)?;
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
            at: points[k].xy(),
            angle: angles[k],
        });
        Some([self.marker(&a, &first), self.marker(&b, &second)])
    }
}
