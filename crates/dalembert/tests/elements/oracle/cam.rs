//! Cams and their followers.

use super::{Machine, Number, Residual, Vector, dot, turn};

/// The profiles of these tests.
#[derive(Clone, Copy)]
pub enum CamProfile {
    /// Radius 0.3 + 0.05 sin(2 phi) + 0.02 phi.
    Polar,
    /// (0.3 cos(phi) + 0.02 phi^2, 0.2 sin(phi) - 0.03 cos(2 phi)).
    Cartesian,
}

impl CamProfile {
    /// Point and tangent in the cam's axes.
    fn at<D: Number>(self, phi: D) -> (Vector<D>, Vector<D>) {
        let (s, c) = phi.sin_cos();
        let (s2, c2) = (phi * 2.0).sin_cos();
        match self {
            Self::Polar => {
                let r = s2 * 0.05 + phi * 0.02 + 0.3;
                let slope = c2 * 0.1 + 0.02;
                ([r * c, r * s], [slope * c - r * s, slope * s + r * c])
            }
            Self::Cartesian => (
                [c * 0.3 + phi * phi * 0.02, s * 0.2 - c2 * 0.03],
                [phi * 0.04 - s * 0.3, c * 0.2 + s2 * 0.06],
            ),
        }
    }
}

/// What touches the cam.
#[derive(Clone, Copy)]
pub enum Touch {
    KnifeEdge,
    Roller(f64),
    Flat,
}

/// A cam on the first body and a follower on the second.
pub struct CamOracle {
    pub bodies: [&'static str; 2],
    pub at: [[f64; 2]; 2],
    pub angles: [f64; 2],
    pub profile: CamProfile,
    pub touch: Touch,
}

impl Residual for CamOracle {
    fn rows<D: Number>(&self, machine: &Machine<D>) -> Vec<D> {
        let [cam, follower] =
            [0, 1].map(|k| machine.marker(self.bodies[k], self.at[k], self.angles[k]));
        let (point, tangent) = self.profile.at(machine.auxiliary());
        let (point, tangent) = (turn(cam.angle, point), turn(cam.angle, tangent));
        let gap = [0, 1].map(|k| cam.point[k] + point[k] - follower.point[k]);
        match self.touch {
            Touch::KnifeEdge => gap.to_vec(),
            Touch::Roller(r) => vec![(dot(gap, gap) - r * r) / (2.0 * r), dot(tangent, gap) / r],
            Touch::Flat => vec![dot(follower.ey(), gap), dot(follower.ey(), tangent)],
        }
    }

    /// The profile and the follower say all: nothing is taken from the estimate.
    fn constants(&self, _: &Machine<f64>) -> Vec<f64> {
        vec![0.0; 2]
    }
}
