//! Euler parameters.

use super::{OrientationError, Rotation, skew};
use nalgebra::{Matrix3, Matrix3x4, Quaternion, Vector3, Vector4};

/// b0 = cos(t/2), b = v sin(t/2): four parameters of unit norm, regular everywhere (Shabana 8.15).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerParameters(pub Vector4<f64>);

/// How far the norm of given parameters may be from one: digits of the fourth place, as books print them.
const NORM: f64 = 1e-3;

impl EulerParameters {
    /// The parameters of an orientation, scalar first.
    pub fn of(rotation: &Rotation) -> Self {
        Self(Vector4::new(rotation.w, rotation.i, rotation.j, rotation.k))
    }

    /// The orientation; the norm is made one.
    ///
    /// # Errors
    /// A number is not finite, or the norm is off by more than rounding of printed digits (1e-3).
    pub fn rotation(&self) -> Result<Rotation, OrientationError> {
        let norm = self.0.norm();
        if !norm.is_finite() {
            return Err(OrientationError::NotFinite);
        }
        if (norm - 1.0).abs() > NORM {
            return Err(OrientationError::NotUnit { norm });
        }
        let b = self.0;
        Ok(Rotation::from_quaternion(Quaternion::new(
            b[0], b[1], b[2], b[3],
        )))
    }

    /// G = 2 [-b, b0 I + skew(b)] (Shabana 8.22).
    pub fn g(&self) -> Matrix3x4<f64> {
        self.matrix(1.0)
    }

    /// Gbar = 2 [-b, b0 I - skew(b)] (Shabana 8.24).
    pub fn gbar(&self) -> Matrix3x4<f64> {
        self.matrix(-1.0)
    }

    fn matrix(&self, sign: f64) -> Matrix3x4<f64> {
        let b = self.0;
        let vector = Vector3::new(b[1], b[2], b[3]);
        let block = Matrix3::identity() * b[0] + skew(&vector) * sign;
        let mut matrix = Matrix3x4::zeros();
        matrix.set_column(0, &(-2.0 * vector));
        matrix.fixed_columns_mut::<3>(1).copy_from(&(2.0 * block));
        matrix
    }

    /// Rates for an angular velocity in body axes: Gbar^T omegabar / 4 (Shabana 8.26), at every orientation.
    pub fn rates(&self, omegabar: &Vector3<f64>) -> Vector4<f64> {
        0.25 * self.gbar().transpose() * omegabar
    }
}
