//! Attraction by a fixed point.

use super::{ForceChannel, ForceElement, ForceReport};
use crate::space::{Planar, PlanarMarker};
use nalgebra::{Vector2, Vector3};

/// Newton's attraction of a body by a fixed point: F = -m mu d/|d|^3, d from the point to the
/// centre of mass (the first marker).
#[derive(Clone, Debug)]
pub struct PointGravity {
    /// Mass of the body [kg].
    pub mass: f64,
    /// Gravitational parameter [m^3/s^2].
    pub mu: f64,
    /// Attracting point, ground axes [m].
    pub center: Vector2<f64>,
}

impl PointGravity {
    fn force(&self, markers: &[PlanarMarker]) -> (Vector2<f64>, f64) {
        let d = markers[0].point - self.center;
        let r = d.norm();
        (-self.mass * self.mu / (r * r * r) * d, r)
    }
}

impl ForceElement<Planar> for PointGravity {
    fn wrenches(&self, _t: f64, markers: &[PlanarMarker], out: &mut [Vector3<f64>]) {
        let (f, _) = self.force(markers);
        out[0] += Vector3::new(f.x, f.y, 0.0);
    }

    fn terminals(&self) -> usize {
        1
    }

    fn report(&self, _t: f64, markers: &[PlanarMarker]) -> ForceReport {
        let (f, r) = self.force(markers);
        let power = f.dot(&markers[0].velocity);
        ForceReport {
            potential: -self.mass * self.mu / r,
            potential_rate: -power,
            values: [r, f.norm(), power, 0.0],
        }
    }

    fn channels(&self) -> Vec<ForceChannel> {
        vec![
            ForceChannel {
                suffix: "length",
                unit: "m",
                meaning: "distance from the attracting point",
            },
            ForceChannel {
                suffix: "force",
                unit: "N",
                meaning: "attraction",
            },
            ForceChannel {
                suffix: "power",
                unit: "W",
                meaning: "power into the machine",
            },
        ]
    }
}
