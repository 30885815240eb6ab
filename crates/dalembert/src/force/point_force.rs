//! A force or a moment on one body.

use super::{ForceChannel, ForceElement, ForceReport};
use crate::joint::Guarded;
use crate::signal::Coefficient;
use crate::space::{Space, Tuple, gather};
use nalgebra::Vector3;
use smallvec::SmallVec;

/// A force at the point of the first marker, or a moment (Shabana 5.39 to 5.45, 7.106 to 7.115).
#[derive(Clone, Debug)]
pub struct PointForce<S: Space> {
    /// Components: of a force along x, y (and z), or of a moment (in the plane one, counter-clockwise).
    pub components: Vec<Coefficient<S>>,
    /// Are the components in the marker's axes (a follower force)?
    pub body_axes: bool,
    /// Is it a moment, not a force?
    pub moment: bool,
}

impl<S: Space> PointForce<S> {
    /// The vector in ground axes, the power, and the vector as a wrench.
    fn wrench(&self, t: f64, markers: &[S::Marker]) -> (Vector3<f64>, f64, S::Twist) {
        let mut vector = Vector3::zeros();
        for (k, c) in self.components.iter().enumerate() {
            let place = if self.moment { S::ANGULAR[k] } else { k };
            vector[place] = c.value(t, markers);
        }
        if self.body_axes {
            vector = S::axes(&markers[0]) * vector;
        }
        let mut parts = [Vector3::zeros(); 2];
        parts[usize::from(self.moment)] = vector;
        let wrench = gather::<S>(parts);
        (vector, wrench.dot(&S::twist(&markers[0])), wrench)
    }
}

impl<S: Space> ForceElement<S> for PointForce<S> {
    fn wrenches(&self, t: f64, markers: &[S::Marker], out: &mut [S::Twist]) {
        out[0].add_scaled(1.0, &self.wrench(t, markers).2);
    }

    fn terminals(&self) -> usize {
        1
    }

    fn guarded(&self, markers: &[S::Marker], see: &mut dyn FnMut(Guarded)) {
        for c in &self.components {
            c.guarded(markers, see);
        }
    }

    fn jump(&self) -> Option<&str> {
        self.components.iter().find_map(Coefficient::jump)
    }

    fn report(&self, t: f64, markers: &[S::Marker]) -> ForceReport {
        let (vector, power, _) = self.wrench(t, markers);
        let mut values: SmallVec<[f64; 8]> = if self.moment {
            S::ANGULAR.iter().map(|&k| vector[k]).collect()
        } else {
            SmallVec::from_slice(&vector.as_slice()[..S::LINEAR])
        };
        values.push(power);
        ForceReport {
            values,
            ..ForceReport::default()
        }
    }

    fn channels(&self) -> Vec<ForceChannel> {
        let named = |suffix, unit, meaning| ForceChannel {
            suffix,
            unit,
            meaning,
        };
        let mut list = if !self.moment {
            let all = [
                named("force_x", "N", "force on the body, ground x"),
                named("force_y", "N", "force on the body, ground y"),
                named("force_z", "N", "force on the body, ground z"),
            ];
            all[..S::LINEAR].to_vec()
        } else if S::ANGULAR.len() == 1 {
            vec![named("moment", "N m", "moment on the body")]
        } else {
            vec![
                named("moment_x", "N m", "moment on the body, ground x"),
                named("moment_y", "N m", "moment on the body, ground y"),
                named("moment_z", "N m", "moment on the body, ground z"),
            ]
        };
        list.push(named("power", "W", "power into the machine"));
        list
    }
}
