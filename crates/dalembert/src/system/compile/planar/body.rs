//! Planar bodies.

use super::super::context::Context;
use super::super::geometry::BodyParts;
use super::super::place::Place;
use super::rotate;
use crate::model::{AxialVector, Body, Value};
use crate::space::{Planar, PlanarFrame};
use dalembert_expr::Dim;
use nalgebra::{Vector2, Vector3};
use smallvec::smallvec;

/// The number of the plane; three components have been refused before.
fn planar(vector: &AxialVector) -> Option<&Value> {
    match vector {
        AxialVector::Planar(value) => Some(value),
        AxialVector::Spatial(_) => None,
    }
}

impl Context<'_, Planar> {
    pub(super) fn planar_body(&mut self, body: &Body, place: &Place) -> BodyParts<Planar> {
        let mass = self.mass_properties(body, place);
        let origin = self.optional_point(body.position.as_ref(), place, "position");
        let origin = self.or_origin(origin).xy();
        let given = body.angle.as_ref();
        let angle = given.and_then(|angle| self.angle(angle, place, &place.key("angle")));
        let angle = angle.unwrap_or(0.0);
        let velocity = match &body.velocity {
            Some(v) => self.vector(v, Dim::VELOCITY, &place.owner, &place.key("velocity")),
            None => None,
        }
        .unwrap_or_else(Vector3::zeros)
        .xy();
        let omega = self
            .optional(
                body.angular_velocity.as_ref().and_then(planar),
                Dim::FREQUENCY,
                place,
                "angular_velocity",
            )
            .unwrap_or(0.0);
        let arm = rotate(angle, &mass.center);
        let center = origin + arm;
        let center_velocity = velocity + omega * Vector2::new(-arm.y, arm.x);
        let mut block = vec![0.0; 9];
        (block[0], block[4], block[8]) = (mass.mass, mass.mass, mass.inertia);
        let (p, a) = (body.position.is_some(), body.angle.is_some());
        let (v, w) = (body.velocity.is_some(), body.angular_velocity.is_some());
        BodyParts {
            frame: PlanarFrame { at: origin, angle },
            center: mass.center.push(0.0),
            massless: mass.mass == 0.0 || mass.inertia == 0.0,
            mass: block,
            q: smallvec![center.x, center.y, angle],
            v: smallvec![center_velocity.x, center_velocity.y, omega],
            position_known: smallvec![p, p, a],
            velocity_known: smallvec![v, v, w],
        }
    }
}
