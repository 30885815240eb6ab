//! A force and a moment on one body.

use super::{ForceChannel, ForceElement, ForceReport};
use crate::signal::Coefficient;
use crate::space::{Planar, PlanarMarker};
use nalgebra::{Vector2, Vector3};

/// Force at the point of the first marker, and moment (Shabana 5.39 to 5.45).
#[derive(Clone, Debug)]
pub struct PointForce {
    /// Components of the force.
    pub force: [Coefficient; 2],
    /// Moment, counter-clockwise.
    pub moment: Coefficient,
    /// Are the components in the marker's axes (a follower force)?
    pub body_axes: bool,
    /// Is it declared as a moment alone?
    pub moment_only: bool,
}

impl PointForce {
    fn wrench(&self, t: f64, markers: &[PlanarMarker]) -> Vector3<f64> {
        let [x, y] = [&self.force[0], &self.force[1]].map(|c| c.value(t, markers));
        let m = &markers[0];
        let f = if self.body_axes {
            x * m.ex + y * m.ey()
        } else {
            Vector2::new(x, y)
        };
        Vector3::new(f.x, f.y, self.moment.value(t, markers))
    }
}

impl ForceElement<Planar> for PointForce {
    fn wrenches(&self, t: f64, markers: &[PlanarMarker], out: &mut [Vector3<f64>]) {
        out[0] += self.wrench(t, markers);
    }

    fn terminals(&self) -> usize {
        1
    }

    fn jump(&self) -> Option<&str> {
        let [x, y] = &self.force;
        [x, y, &self.moment].into_iter().find_map(Coefficient::jump)
    }

    fn report(&self, t: f64, markers: &[PlanarMarker]) -> ForceReport {
        let w = self.wrench(t, markers);
        let m = &markers[0];
        let power = w.x * m.velocity.x + w.y * m.velocity.y + w.z * m.omega;
        let values = if self.moment_only {
            [w.z, power, 0.0, 0.0]
        } else {
            [w.x, w.y, power, 0.0]
        };
        ForceReport {
            values,
            ..ForceReport::default()
        }
    }

    fn channels(&self) -> Vec<ForceChannel> {
        let power = ForceChannel {
            suffix: "power",
            unit: "W",
            meaning: "power into the machine",
        };
        if self.moment_only {
            let m = ForceChannel {
                suffix: "moment",
                unit: "N m",
                meaning: "moment on the body",
            };
            return vec![m, power];
        }
        vec![
            ForceChannel {
                suffix: "force_x",
                unit: "N",
                meaning: "force on the body, ground x",
            },
            ForceChannel {
                suffix: "force_y",
                unit: "N",
                meaning: "force on the body, ground y",
            },
            power,
        ]
    }
}
