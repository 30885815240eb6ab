//! Rodriguez parameters.

use super::{Rotation, skew};
use nalgebra::{Matrix3, Quaternion, Vector3};

/// gamma = v tan(t/2): three parameters without trigonometry, infinite at half turns (Shabana 8.29).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RodriguezParameters(pub Vector3<f64>);

impl RodriguezParameters {
    /// The parameters of an orientation; none at a half turn.
    pub fn of(rotation: &Rotation) -> Option<Self> {
        let gamma = rotation.imag() / rotation.w;
        gamma.iter().all(|x| x.is_finite()).then_some(Self(gamma))
    }

    /// The orientation: b0 = 1 / sqrt(1 + gamma^2), b = b0 gamma.
    pub fn rotation(&self) -> Rotation {
        let g = self.0;
        Rotation::from_quaternion(Quaternion::new(1.0, g.x, g.y, g.z))
    }

    /// Gbar = 2 / (1 + gamma^2) (I - skew(gamma)) (Shabana 8.34).
    pub fn gbar(&self) -> Matrix3<f64> {
        (Matrix3::identity() - skew(&self.0)) * (2.0 / (1.0 + self.0.norm_squared()))
    }

    /// d(Gbar)/dt gamma' = -2 (gamma.gamma') / (1 + gamma^2) omegabar.
    pub fn gbar_rate_times(&self, rates: &Vector3<f64>) -> Vector3<f64> {
        let omegabar = self.gbar() * rates;
        omegabar * (-2.0 * self.0.dot(rates) / (1.0 + self.0.norm_squared()))
    }

    /// Rates for an angular velocity in body axes: gamma' = 1/2 (I + skew(gamma) + gamma gamma^T) omegabar.
    pub fn rates(&self, omegabar: &Vector3<f64>) -> Vector3<f64> {
        0.5 * (omegabar + self.0.cross(omegabar) + self.0 * self.0.dot(omegabar))
    }
}
