//! Rolling without slipping on a plane: discs, wheels, balls.

use super::{
    ConstraintElement, ConstraintInput, ConstraintOutput, ContactForce, Guarded, Lost, RowLabel,
    RowUnit,
};
use crate::space::{Spatial, SpatialMarker, join};
use nalgebra::Vector3;
use std::ops::Range;

/// A wheel of the second marker on the plane of the first.
///
/// The plane goes through the point o of the first marker, across n, its z axis. The wheel has its centre c at the second
/// marker and its axis a along z of that; its rim is a circle of radius r, rounded by a radius R around it (a torus; a thin
/// disc has R = 0, a ball r = 0).
/// With s = n.a, w = n - s a, u = w/|w| (in the wheel's plane, away from the ground), the contact is
/// P = c - r u - R n and the rows are
///   n.(c - o) - r |w| - R = 0                     (contact; position)
///   e_k.(v_wheel(P) - v_plane(P)) = 0, k = x, y   (no slip; velocity)
/// with v(P) the velocity of the material point there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingOnPlane {
    /// r [m].
    pub radius: f64,
    /// R [m].
    pub rounding: f64,
}

/// A vector with its rates where the accelerations of the markers vanish.
#[derive(Clone, Copy)]
struct Moving {
    value: Vector3<f64>,
    rate: Vector3<f64>,
    second: Vector3<f64>,
}

/// A vector that turns.
fn turning(value: Vector3<f64>, omega: &Vector3<f64>) -> Moving {
    let rate = omega.cross(&value);
    Moving {
        value,
        rate,
        second: omega.cross(&rate),
    }
}

impl RollingOnPlane {
    /// r |w| and its second rate, r u and its rate.
    fn rim(&self, n: &Moving, a: &Moving) -> ([f64; 2], [Vector3<f64>; 2]) {
        if self.radius == 0.0 {
            return ([0.0; 2], [Vector3::zeros(); 2]);
        }
        let s = n.value.dot(&a.value);
        let s1 = n.rate.dot(&a.value) + n.value.dot(&a.rate);
        let s2 = n.second.dot(&a.value) + 2.0 * n.rate.dot(&a.rate) + n.value.dot(&a.second);
        let w = n.value - s * a.value;
        let w1 = n.rate - s1 * a.value - s * a.rate;
        let length = w.norm();
        // |w|^2 = 1 - s^2.
        let l1 = -s * s1 / length;
        let l2 = -(s1 * s1 + s * s2 + l1 * l1) / length;
        let u = w / length;
        let u1 = (w1 - l1 * u) / length;
        let r = self.radius;
        ([r * length, r * l2], [r * u, r * u1])
    }
}

impl ConstraintElement<Spatial> for RollingOnPlane {
    /// n x a, the sine of the tilt: where it vanishes u has no direction. A ball has no rim.
    fn guarded(&self, markers: &[SpatialMarker], see: &mut dyn FnMut(Guarded)) {
        if self.radius == 0.0 {
            return;
        }
        let [n, a] = [0, 1].map(|k| {
            let m = &markers[k];
            turning(m.axes.column(2).into_owned(), &m.omega)
        });
        see(Guarded {
            vector: n.value.cross(&a.value),
            rate: n.rate.cross(&a.value) + n.value.cross(&a.rate),
            limit: Guarded::DIGITS,
            lost: Lost::Contact,
        });
    }

    fn labels(&self) -> Vec<RowLabel> {
        ["contact", "no slip along x", "no slip along y"]
            .map(|text| RowLabel {
                text: text.to_owned(),
                unit: RowUnit::Length,
            })
            .to_vec()
    }

    fn velocity_rows(&self) -> Range<usize> {
        1..3
    }

    /// The wheel pushes where the multiplier of its height is negative: C rises with the height.
    fn contact(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        multipliers: &[f64],
    ) -> Option<ContactForce> {
        let (plane, wheel) = (&input.markers[0], &input.markers[1]);
        let n = turning(plane.axes.column(2).into_owned(), &plane.omega);
        let a = turning(wheel.axes.column(2).into_owned(), &wheel.omega);
        let (_, [u, _]) = self.rim(&n, &a);
        Some(ContactForce {
            normal: -multipliers[0],
            point: wheel.point - u - self.rounding * n.value,
        })
    }

    fn evaluate(
        &self,
        input: &ConstraintInput<'_, Spatial>,
        out: &mut ConstraintOutput<'_, Spatial>,
    ) {
        let (plane, wheel) = (&input.markers[0], &input.markers[1]);
        let n = turning(plane.axes.column(2).into_owned(), &plane.omega);
        let a = turning(wheel.axes.column(2).into_owned(), &wheel.omega);
        let ([height, height2], [u, u1]) = self.rim(&n, &a);
        let d = wheel.point - plane.point;
        let d1 = wheel.velocity - plane.velocity;
        out.value[0] = n.value.dot(&d) - height - self.rounding;
        // d|w| = -(s/|w|) ds, ds = (n x a).(turn of the plane - turn of the wheel).
        let s = n.value.dot(&a.value);
        let tilt = if height > 0.0 {
            self.radius * self.radius * s / height
        } else {
            0.0
        };
        let turn = tilt * n.value.cross(&a.value);
        out.gradient[0] = join(&-n.value, &(n.value.cross(&d) + turn));
        out.gradient[1] = join(&n.value, &-turn);
        out.bias[0] = n.second.dot(&d) + 2.0 * n.rate.dot(&d1) - height2;
        // From the wheel's centre, and from the plane's point, to the contact.
        let (arm, arm1) = (-u - self.rounding * n.value, -u1 - self.rounding * n.rate);
        let (from, from1) = (d + arm, d1 + arm1);
        let slip =
            wheel.velocity + wheel.omega.cross(&arm) - plane.velocity - plane.omega.cross(&from);
        let slip1 = wheel.omega.cross(&arm1) - plane.omega.cross(&from1);
        for k in 0..2 {
            let e = turning(plane.axes.column(k).into_owned(), &plane.omega);
            let at = 2 * (k + 1);
            out.gradient[at] = join(&-e.value, &-from.cross(&e.value));
            out.gradient[at + 1] = join(&e.value, &arm.cross(&e.value));
            out.bias[k + 1] = e.rate.dot(&slip) + e.value.dot(&slip1);
        }
    }
}
