//! Attraction by a fixed point.

use super::{ForceChannel, ForceElement, ForceReport};
use crate::space::{Space, Tuple, gather, spread};
use nalgebra::Vector3;
use smallvec::smallvec;

/// Newton's attraction of a body by a fixed point: F = -m mu d/|d|^3, d from the point to the
/// centre of mass (the first marker).
#[derive(Clone, Debug)]
pub struct PointGravity {
    /// Mass of the body [kg].
    pub mass: f64,
    /// Gravitational parameter [m^3/s^2].
    pub mu: f64,
    /// Attracting point, ground axes [m].
    pub center: Vector3<f64>,
}

impl PointGravity {
    fn force<S: Space>(&self, markers: &[S::Marker]) -> (Vector3<f64>, f64) {
        let d = Vector3::from(S::point(&markers[0])) - self.center;
        let r = d.norm();
        (-self.mass * self.mu / (r * r * r) * d, r)
    }
}

impl<S: Space> ForceElement<S> for PointGravity {
    fn wrenches(&self, _t: f64, markers: &[S::Marker], out: &mut [S::Twist]) {
        let (f, _) = self.force::<S>(markers);
        out[0].add_scaled(1.0, &gather::<S>([f, Vector3::zeros()]));
    }

    fn terminals(&self) -> usize {
        1
    }

    fn report(&self, _t: f64, markers: &[S::Marker]) -> ForceReport {
        let (f, r) = self.force::<S>(markers);
        let power = f.dot(&spread::<S>(&S::twist(&markers[0]))[0]);
        ForceReport {
            potential: -self.mass * self.mu / r,
            potential_rate: -power,
            values: smallvec![r, f.norm(), power],
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
