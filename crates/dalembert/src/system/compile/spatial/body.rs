//! Spatial bodies.

use super::super::context::Context;
use super::super::geometry::BodyParts;
use super::super::place::Place;
use crate::model::{Axes, AxialVector, Body};
use crate::space::orientation::rotation_of;
use crate::space::{Spatial, SpatialFrame};
use dalembert_expr::Dim;
use nalgebra::Vector3;
use smallvec::{SmallVec, smallvec};

/// Part of the largest moment of inertia below which another is none: a thin rod that stands askew in its frame.
const NO_INERTIA: f64 = 1e-12;

impl Context<'_, Spatial> {
    pub(super) fn spatial_body(&mut self, body: &Body, place: &Place) -> BodyParts<Spatial> {
        let mass = self.solid_mass(body, place);
        let origin = self.optional_point(body.position.as_ref(), place, "position");
        let origin = self.or_origin(origin);
        let axes = self.axes_of(body.orientation.as_ref(), place, "orientation");
        let velocity = match &body.velocity {
            Some(v) => self.vector(v, Dim::VELOCITY, &place.owner, &place.key("velocity")),
            None => None,
        }
        .unwrap_or_else(Vector3::zeros);
        let given = match &body.angular_velocity {
            Some(AxialVector::Spatial(values)) => {
                let path = place.key("angular_velocity");
                self.numbers(values, Dim::FREQUENCY, place, &path)
            }
            // A single number has been refused before.
            Some(AxialVector::Planar(_)) | None => None,
        };
        let given = Vector3::from(given.unwrap_or_default());
        let omegabar = if body.angular_velocity_axes == Some(Axes::Body) {
            given
        } else {
            axes.tr_mul(&given)
        };
        let arm = axes * mass.center;
        let center = origin + arm;
        let center_velocity = velocity + (axes * omegabar).cross(&arm);
        let b = rotation_of(&axes);
        let mut block = vec![0.0; 36];
        for k in 0..3 {
            block[7 * k] = mass.mass;
            for j in 0..3 {
                block[6 * (k + 3) + j + 3] = mass.inertia[(k, j)];
            }
        }
        let moments = mass.inertia.symmetric_eigenvalues();
        let (p, a) = (body.position.is_some(), body.orientation.is_some());
        let (v, w) = (body.velocity.is_some(), body.angular_velocity.is_some());
        let known = |linear, angular| {
            SmallVec::from_buf([linear, linear, linear, angular, angular, angular])
        };
        BodyParts {
            frame: SpatialFrame { at: origin, axes },
            center: mass.center,
            massless: mass.mass == 0.0 || moments.min() <= NO_INERTIA * moments.max(),
            mass: block,
            q: smallvec![center.x, center.y, center.z, b.w, b.i, b.j, b.k],
            v: smallvec![
                center_velocity.x,
                center_velocity.y,
                center_velocity.z,
                omegabar.x,
                omegabar.y,
                omegabar.z
            ],
            position_known: known(p, a),
            velocity_known: known(v, w),
        }
    }
}
