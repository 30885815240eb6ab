//! Surfaces around a point, by coordinates that have no poles where a form allows it.

use super::{Field, Surface, SurfaceShape};
use nalgebra::{Matrix2, Matrix3, Matrix3x2, Vector3};
use smallvec::SmallVec;
use std::f64::consts::TAU;

/// Coordinates of a point of a surface: a and b, or the unit vector w.
pub type Coordinates = SmallVec<[f64; 3]>;

/// A surface around one of its points.
#[derive(Clone, Copy, Debug)]
pub struct Around {
    /// The point.
    pub point: Field,
    /// A normal out of the body; its length has no meaning.
    pub normal: Field,
    /// Tangents along a and b; none for surfaces whose coordinates are w.
    pub tangents: Option<[Field; 2]>,
}

impl Surface {
    /// Semi-axes of a sphere or an ellipsoid. No two parameters cover these without poles, so their points are given by a
    /// unit vector w, u = (A w_x, B w_y, C w_z), with |w| = 1 as a row of its own.
    fn semi_axes(&self) -> Option<Vector3<f64>> {
        match &self.shape {
            SurfaceShape::Sphere(r) => Some(Vector3::repeat(*r)),
            SurfaceShape::Ellipsoid(half) => Some(Vector3::from(*half)),
            _ => None,
        }
    }

    /// Are its points given by the unit vector w instead of a and b?
    pub fn is_round(&self) -> bool {
        self.semi_axes().is_some()
    }

    /// Names of the coordinates.
    pub fn coordinate_names(&self) -> &'static [&'static str] {
        if self.is_round() {
            &["wx", "wy", "wz"]
        } else {
            &["a", "b"]
        }
    }

    /// Number of coordinates of a point.
    pub fn count(&self) -> usize {
        self.coordinate_names().len()
    }

    /// Coordinates of the point of the parameters a and b.
    pub fn coordinates(&self, [a, b]: [f64; 2]) -> Coordinates {
        if self.is_round() {
            let ((sa, ca), (sb, cb)) = (a.sin_cos(), b.sin_cos());
            SmallVec::from_slice(&[cb * ca, cb * sa, sb])
        } else {
            SmallVec::from_slice(&[a, b])
        }
    }

    /// The parameters a and b of coordinates, a on the turn nearest to a value. At the poles of w, where every a is right,
    /// it is that value.
    pub fn parameters(&self, s: &[f64], near: f64) -> [f64; 2] {
        if !self.is_round() {
            return [s[0], s[1]];
        }
        let across = s[0].hypot(s[1]);
        let a = if across > 0.0 { s[1].atan2(s[0]) } else { near };
        [a + TAU * ((near - a) / TAU).round(), s[2].atan2(across)]
    }

    /// Point, normal and tangents at coordinates.
    pub fn around(&self, s: &[f64]) -> Around {
        if let Some(half) = self.semi_axes() {
            let w = Vector3::new(s[0], s[1], s[2]);
            // w_x/A and so on, of about unit length.
            let out = if self.inside { -half.min() } else { half.min() };
            return Around {
                point: Field::scaled(&half, &w),
                normal: Field::scaled(&half.map(|x| out / x), &w),
                tangents: None,
            };
        }
        let partials = self.partials(s);
        Around {
            point: Field::point(&partials),
            normal: self.normal(&partials),
            tangents: Some([0, 1].map(|k| Field::tangent(&partials, k))),
        }
    }

    /// The normal by a and b as they are, which vanishes at poles and turns round behind them, in parts of the largest
    /// square of a tangent; none where the coordinates have no poles.
    pub fn regularity(&self, s: &[f64]) -> Option<Vector3<f64>> {
        let [a, b] = self.around(s).tangents?.map(|t| t.value);
        let largest = a.norm_squared().max(b.norm_squared());
        Some(a.cross(&b) / largest)
    }

    /// The side of the axis on which a surface of revolution is swept, +1 or -1: behind a pole or an apex it changes, and
    /// with it the side to which the normal points. Always 1 for others.
    pub fn sense(&self, s: &[f64]) -> f64 {
        match &self.shape {
            SurfaceShape::Cone(..) | SurfaceShape::Revolved(_) => {
                let u = self.partials(s).of(0, 0);
                let (sin, cos) = s[0].sin_cos();
                (cos * u.x + sin * u.y).signum()
            }
            _ => 1.0,
        }
    }

    /// Curvature at coordinates, as a tensor in the axes of the surface: towards the normal it is positive. None at poles.
    pub fn curvature(&self, s: &[f64]) -> Option<Matrix3<f64>> {
        if let Some(half) = self.semi_axes() {
            // The unit normal turns by P D^-2 du / |D^-1 w|, with D the semi-axes and P the part along the surface.
            let w = Vector3::new(s[0], s[1], s[2]).try_normalize(f64::MIN_POSITIVE)?;
            let steep = w.component_div(&half);
            let length = steep.norm();
            let n = steep / length;
            let along = Matrix3::identity() - n * n.transpose();
            let turn = Matrix3::from_diagonal(&half.map(|x| 1.0 / (x * x * length)));
            let sign = if self.inside { 1.0 } else { -1.0 };
            return Some(sign * along * turn * along);
        }
        let p = self.partials(s);
        let n = self.normal(&p).value.try_normalize(f64::MIN_POSITIVE)?;
        let t = Matrix3x2::from_columns(&[p.of(1, 0), p.of(0, 1)]);
        let bends = Matrix2::new(
            p.of(2, 0).dot(&n),
            p.of(1, 1).dot(&n),
            p.of(1, 1).dot(&n),
            p.of(0, 2).dot(&n),
        );
        let tangents = t * t.tr_mul(&t).try_inverse()?;
        Some(tangents * bends * tangents.transpose())
    }
}
