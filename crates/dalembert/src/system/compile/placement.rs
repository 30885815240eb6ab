//! Bodies and points of placements.

use super::context::{BodyPlace, Context};
use super::geometry::Geometry;
use super::place::Place;
use crate::diagnostic::Diagnostic;
use crate::model::Placement;
use crate::space::Space;
use dalembert_expr::Dim;
use nalgebra::Vector3;

/// The two bodies of a placement, and its point in the frame of each.
pub(super) struct Points<S: Space> {
    pub bodies: [BodyPlace<S>; 2],
    pub at: [Vector3<f64>; 2],
}

impl<S: Geometry> Context<'_, S> {
    /// Two different bodies by their names.
    pub fn two_bodies(&mut self, names: &[String; 2], place: &Place) -> Option<[BodyPlace<S>; 2]> {
        let bodies = [0, 1].map(|k| {
            let path = place.key(&format!("bodies[{k}]"));
            self.place(&names[k], &place.owner, &path)
        });
        // Empty names stand for a mistake that is known already.
        if names[0] == names[1] && !names[0].is_empty() {
            self.report(
                Diagnostic::error(
                    "same-body",
                    place.key("bodies"),
                    format!("{}: both bodies are '{}'", place.owner, names[0]),
                )
                .help("name two different bodies"),
            );
            return None;
        }
        Some(bodies)
    }

    /// Bodies and points of a placement; where points do not matter they may be left out.
    pub fn points(&mut self, p: &Placement, place: &Place, needed: bool) -> Option<Points<S>> {
        let bodies = self.two_bodies(&p.bodies, place)?;
        let at = match (&p.at, &p.point) {
            (Some(at), None) => [0, 1]
                .map(|k| {
                    let path = place.key(&format!("at[{k}]"));
                    self.vector(&at[k], Dim::LENGTH, &place.owner, &path)
                })
                .map(|point| self.or_origin(point)),
            (None, Some(point)) => {
                let point = self.vector(point, Dim::LENGTH, &place.owner, &place.key("point"));
                let point = self.or_origin(point);
                bodies
                    .each_ref()
                    .map(|body| S::seen_from(&body.frame, &point))
            }
            (None, None) if !needed => [Vector3::zeros(); 2],
            (given, _) => {
                let (code, text) = if given.is_some() {
                    ("placed-twice", "both 'at' and 'point' are given")
                } else {
                    ("not-placed", "neither 'at' nor 'point' is given")
                };
                let help = if S::LINEAR == 2 {
                    "give at = [[x, y], [x, y]] (a point in each body's frame) or point = [x, y] (ground axes)"
                } else {
                    "give at = [[x, y, z], [x, y, z]] (a point in each body's frame) or point = [x, y, z] (ground axes)"
                };
                let message = format!("{}: {text}", place.owner);
                self.report(Diagnostic::error(code, &place.path, message).help(help));
                return None;
            }
        };
        Some(Points { bodies, at })
    }
}
