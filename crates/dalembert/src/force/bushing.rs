//! Bushings.

use super::{ForceChannel, ForceElement, ForceReport};
use crate::joint::PlanarMeasure;
use crate::space::{Planar, PlanarMarker};
use nalgebra::{Matrix3, Vector3};

/// A bushing: generalized force -(K rho + C rho') on the pose rho = (x, y, angle) of the second
/// marker in the axes of the first; Q = (d rho/dq)^T of that, so action equals reaction.
#[derive(Clone, Debug)]
pub struct Bushing {
    /// K, in the units N/m, N/rad, N m/m, N m/rad of its entries.
    pub stiffness: Matrix3<f64>,
    /// C.
    pub damping: Matrix3<f64>,
}

const COORDINATES: [PlanarMeasure; 3] = [
    PlanarMeasure::AlongX,
    PlanarMeasure::AlongY,
    PlanarMeasure::Angle,
];

impl Bushing {
    fn state(markers: &[PlanarMarker]) -> (Vector3<f64>, Vector3<f64>) {
        let m = COORDINATES.map(|k| k.evaluate(&markers[0], &markers[1]));
        (
            Vector3::new(m[0].value, m[1].value, m[2].value),
            Vector3::new(m[0].rate, m[1].rate, m[2].rate),
        )
    }
}

impl ForceElement<Planar> for Bushing {
    fn wrenches(&self, _t: f64, markers: &[PlanarMarker], out: &mut [Vector3<f64>]) {
        let (pose, rate) = Self::state(markers);
        let force = -(self.stiffness * pose + self.damping * rate);
        for (k, kind) in COORDINATES.into_iter().enumerate() {
            let m = kind.evaluate(&markers[0], &markers[1]);
            out[0] += force[k] * m.first;
            out[1] += force[k] * m.second;
        }
    }

    fn report(&self, _t: f64, markers: &[PlanarMarker]) -> ForceReport {
        let (pose, rate) = Self::state(markers);
        // Only the symmetric part of K has a potential.
        let symmetric = 0.5 * (self.stiffness + self.stiffness.transpose());
        let elastic = symmetric * pose;
        let force = -(self.stiffness * pose + self.damping * rate);
        ForceReport {
            potential: 0.5 * pose.dot(&elastic),
            potential_rate: rate.dot(&elastic),
            values: [force.x, force.y, force.z, force.dot(&rate)],
        }
    }

    fn channels(&self) -> Vec<ForceChannel> {
        vec![
            ForceChannel {
                suffix: "force_x",
                unit: "N",
                meaning: "force on the second body along the first body's joint x axis",
            },
            ForceChannel {
                suffix: "force_y",
                unit: "N",
                meaning: "force on the second body along the first body's joint y axis",
            },
            ForceChannel {
                suffix: "moment",
                unit: "N m",
                meaning: "moment on the second body at its point",
            },
            ForceChannel {
                suffix: "power",
                unit: "W",
                meaning: "power into the machine",
            },
        ]
    }
}
