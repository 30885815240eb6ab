//! Scalar measures between two markers of the plane.

use super::{MeasureKind, Measured};
use crate::space::{Planar, PlanarMarker};
use nalgebra::{Vector2, Vector3};

/// Which scalar is measured from the first marker (a) to the second (b).
///
/// d = r_b - r_a; e_x, e_y are the axes of the first marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PlanarMeasure {
    /// d . X of the ground [m].
    GroundX,
    /// d . Y of the ground [m].
    GroundY,
    /// Angle of b minus angle of a, counting turns [rad].
    Angle,
    /// d . e_x of the first marker [m].
    AlongX,
    /// d . e_y of the first marker [m].
    AlongY,
    /// |d| [m]; its gradient needs |d| > 0.
    Distance,
}

impl PlanarMeasure {
    /// Is the value an angle?
    pub fn is_angle(self) -> bool {
        self == Self::Angle
    }

    /// Value alone.
    pub fn value(self, a: &PlanarMarker, b: &PlanarMarker) -> f64 {
        let d = b.point - a.point;
        match self {
            Self::GroundX => d.x,
            Self::GroundY => d.y,
            Self::Angle => b.angle - a.angle,
            Self::AlongX => a.ex.dot(&d),
            Self::AlongY => a.ey().dot(&d),
            Self::Distance => d.norm(),
        }
    }

    /// Value, rate, gradients and bias.
    ///
    /// AlongX: xi = e_x.d, xi' = e_x.d' + w_a eta, bias = 2 w_a e_y.d' - w_a^2 xi.
    /// AlongY: eta = e_y.d, eta' = e_y.d' - w_a xi, bias = -2 w_a e_x.d' - w_a^2 eta.
    /// Distance: l = |d|, l' = n.d', bias = (d'.d' - l'^2) / l (Shabana 5.64 to 5.66).
    pub fn evaluate(self, a: &PlanarMarker, b: &PlanarMarker) -> Measured {
        let d = b.point - a.point;
        let dv = b.velocity - a.velocity;
        let plain = |n: Vector2<f64>, value: f64, bias: f64, turn: f64| Measured {
            value,
            rate: n.dot(&dv) + turn * a.omega,
            bias,
            first: Vector3::new(-n.x, -n.y, turn),
            second: Vector3::new(n.x, n.y, 0.0),
        };
        match self {
            Self::GroundX => plain(Vector2::x(), d.x, 0.0, 0.0),
            Self::GroundY => plain(Vector2::y(), d.y, 0.0, 0.0),
            Self::Angle => Measured {
                value: b.angle - a.angle,
                rate: b.omega - a.omega,
                bias: 0.0,
                first: Vector3::new(0.0, 0.0, -1.0),
                second: Vector3::new(0.0, 0.0, 1.0),
            },
            Self::AlongX => {
                let (ex, ey) = (a.ex, a.ey());
                let (xi, eta) = (ex.dot(&d), ey.dot(&d));
                let bias = 2.0 * a.omega * ey.dot(&dv) - a.omega * a.omega * xi;
                plain(ex, xi, bias, eta)
            }
            Self::AlongY => {
                let (ex, ey) = (a.ex, a.ey());
                let (xi, eta) = (ex.dot(&d), ey.dot(&d));
                let bias = -2.0 * a.omega * ex.dot(&dv) - a.omega * a.omega * eta;
                plain(ey, eta, bias, -xi)
            }
            Self::Distance => {
                let l = d.norm();
                // The direction of coincident points is undefined: no gradient. The compiler of
                // models refuses such estimates, and analyses end where points meet.
                if l == 0.0 {
                    return Measured::default();
                }
                let n = d / l;
                let rate = n.dot(&dv);
                plain(n, l, (dv.norm_squared() - rate * rate) / l, 0.0)
            }
        }
    }
}

impl MeasureKind<Planar> for PlanarMeasure {
    const DISTANCE: Self = Self::Distance;

    fn is_angle(self) -> bool {
        self.is_angle()
    }

    fn is_length(self) -> bool {
        !self.is_angle()
    }

    fn value(self, a: &PlanarMarker, b: &PlanarMarker) -> f64 {
        self.value(a, b)
    }

    fn evaluate(self, a: &PlanarMarker, b: &PlanarMarker) -> Measured {
        self.evaluate(a, b)
    }
}
