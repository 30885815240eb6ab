//! Axis and angle.

use super::cosines::direction;
use super::{OrientationError, Rotation, skew};
use nalgebra::{Matrix3, Matrix3x4, Unit, Vector3, Vector4};

/// A unit axis and the angle about it (Rodriguez formula, Shabana 8.7).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisAngle {
    /// Unit axis, the same components in ground and in body axes.
    pub axis: Vector3<f64>,
    /// Angle [rad].
    pub angle: f64,
}

impl AxisAngle {
    /// From an axis of any length.
    ///
    /// # Errors
    /// The axis has no length, or a number is not finite.
    pub fn new(axis: Vector3<f64>, angle: f64) -> Result<Self, OrientationError> {
        if !angle.is_finite() {
            return Err(OrientationError::NotFinite);
        }
        let axis = direction(axis, "the axis")?;
        Ok(Self { axis, angle })
    }

    /// The axis and the angle in [0, pi] of an orientation; the axis is x where there is no rotation (`singular`).
    pub fn of(rotation: &Rotation) -> (Self, bool) {
        let sign = if rotation.w < 0.0 { -1.0 } else { 1.0 };
        let v = sign * rotation.imag();
        let sine = v.norm();
        if sine == 0.0 {
            let axis = Vector3::x();
            return (Self { axis, angle: 0.0 }, true);
        }
        let angle = 2.0 * sine.atan2(sign * rotation.w);
        let axis = v / sine;
        (Self { axis, angle }, false)
    }

    /// The orientation.
    pub fn rotation(&self) -> Rotation {
        Rotation::from_axis_angle(&Unit::new_normalize(self.axis), self.angle)
    }

    /// Gbar for the coordinates (axis, angle): [I sin t - 2 skew(v) sin^2(t/2), v] (Shabana 8.14), for v.v' = 0.
    pub fn gbar(&self) -> Matrix3x4<f64> {
        let (s, half) = (self.angle.sin(), (0.5 * self.angle).sin());
        let block = Matrix3::identity() * s - skew(&self.axis) * (2.0 * half * half);
        let mut gbar = Matrix3x4::zeros();
        gbar.fixed_columns_mut::<3>(0).copy_from(&block);
        gbar.set_column(3, &self.axis);
        gbar
    }

    /// Rates of axis and angle for an angular velocity in body axes; none where the axis is not defined.
    ///
    /// t' = v.w; with u = w - (v.w) v, 8.14 solved for the axis: v' = (cos(t/2) u + sin(t/2) v x u) / (2 sin(t/2)).
    pub fn rates(&self, omegabar: &Vector3<f64>) -> Option<Vector4<f64>> {
        let (s, c) = (0.5 * self.angle).sin_cos();
        if s == 0.0 {
            return None;
        }
        let v = &self.axis;
        let along = v.dot(omegabar);
        let across = omegabar - along * v;
        let rate = (c * across + s * v.cross(&across)) / (2.0 * s);
        Some(Vector4::new(rate.x, rate.y, rate.z, along))
    }
}
