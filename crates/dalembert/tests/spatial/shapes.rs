//! Surfaces once more, from their points alone and for any kind of number: tangents come from dual numbers.

use super::oracle::{Number, Vector, cross, dot};
use dalembert::surface::{Surface, SurfaceShape};
use dalembert_expr::{Dim, Function, Program, Quantity, Resolved, Scope, UnknownName, compile};
use num_dual::Dual;
use std::sync::Arc;

#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Plane,
    Sphere(f64),
    Cylinder(f64),
    Cone(f64, f64),
    Ellipsoid([f64; 3]),
    Torus(f64, f64),
    /// r = 0.4 + 0.2 sin(2 b), z = b - 0.3 b^3.
    Revolved,
    /// (a + 0.1 b^2, b, a^2 + 2 b^2 + 0.1 sin(a b)).
    Field,
    /// (sin(b) exp(0.3 a), a, 0.3): the names in other orders, one that is not used, and a constant.
    Odd,
}

pub const ALL: [Shape; 9] = [
    Shape::Plane,
    Shape::Sphere(0.4),
    Shape::Cylinder(0.3),
    Shape::Cone(0.5, 0.9),
    Shape::Ellipsoid([0.5, 0.3, 0.2]),
    Shape::Torus(0.6, 0.2),
    Shape::Revolved,
    Shape::Field,
    Shape::Odd,
];

/// Names that are slots in their order.
struct Names(&'static [&'static str]);

impl Scope for Names {
    fn variable(&self, path: &[&str]) -> Result<Resolved, UnknownName> {
        let index = self.0.iter().position(|n| [*n] == *path);
        let slot = |index| Resolved::Slot {
            index,
            dim: Quantity::Free,
        };
        index.map(slot).ok_or_else(UnknownName::default)
    }

    fn function(&self, _: &str) -> Option<Arc<dyn Function>> {
        None
    }
}

/// An expression of some names.
pub fn program(text: &str, names: &'static [&'static str]) -> Program {
    compile(text, &Names(names), Quantity::Known(Dim::LENGTH)).unwrap()
}

impl Shape {
    /// The surface of the engine.
    pub fn surface(self, inside: bool) -> Surface {
        let of = |names: &'static [&'static str], texts: [&str; 3]| {
            let programs = texts.map(|text| program(text, names));
            let place = |p: &Program, name| p.slots().iter().position(|s| *s == name);
            let uses = programs
                .each_ref()
                .map(|p| [0, 1].map(|name| place(p, name).unwrap_or(usize::MAX)));
            SurfaceShape::Expressions(Box::new(programs), uses)
        };
        let shape = match self {
            Self::Plane => SurfaceShape::Plane,
            Self::Sphere(r) => SurfaceShape::Sphere(r),
            Self::Cylinder(r) => SurfaceShape::Cylinder(r),
            Self::Cone(r, h) => SurfaceShape::Cone(r, h),
            Self::Ellipsoid(half) => SurfaceShape::Ellipsoid(half),
            Self::Torus(r, t) => SurfaceShape::Torus(r, t),
            Self::Revolved => SurfaceShape::Revolved(Box::new([
                program("0.4 + 0.2*sin(2*b)", &["b"]),
                program("b - 0.3*b^3", &["b"]),
            ])),
            Self::Field => of(
                &["a", "b"],
                ["a + 0.1*b^2", "b", "a^2 + 2*b^2 + 0.1*sin(a*b)"],
            ),
            Self::Odd => of(&["a", "b"], ["sin(b)*exp(0.3*a)", "a", "0.3"]),
        };
        Surface { shape, inside }
    }

    /// The point of two parameters.
    pub fn at<D: Number>(self, a: D, b: D) -> Vector<D> {
        let ((sa, ca), (sb, cb)) = (a.sin_cos(), b.sin_cos());
        let around = |r: D, z: D| [r * ca, r * sa, z];
        match self {
            Self::Plane => [a, b, D::from(0.0)],
            Self::Sphere(r) => around(cb * r, sb * r),
            Self::Cylinder(r) => around(D::from(r), b),
            Self::Cone(r, h) => around((D::from(h) - b) * (r / h), b),
            Self::Ellipsoid([x, y, z]) => [cb * ca * x, cb * sa * y, sb * z],
            Self::Torus(r, t) => around(cb * t + r, sb * t),
            Self::Revolved => around((b * 2.0).sin() * 0.2 + 0.4, b - b * b * b * 0.3),
            Self::Field => [
                a + b * b * 0.1,
                b,
                a * a + b * b * 2.0 + (a * b).sin() * 0.1,
            ],
            Self::Odd => [sb * (a * 0.3).exp(), a, D::from(0.3)],
        }
    }

    /// Semi-axes of what is given by a unit vector w instead of a and b.
    pub fn semi_axes(self) -> Option<[f64; 3]> {
        match self {
            Self::Sphere(r) => Some([r; 3]),
            Self::Ellipsoid(half) => Some(half),
            _ => None,
        }
    }

    /// Number of coordinates of a point.
    pub fn count(self) -> usize {
        if self.semi_axes().is_some() { 3 } else { 2 }
    }

    /// The point of coordinates: a and b, or w.
    pub fn over<D: Number>(self, s: &[D]) -> Vector<D> {
        match self.semi_axes() {
            Some(half) => [0, 1, 2].map(|k| s[k] * half[k]),
            None => self.at(s[0], s[1]),
        }
    }

    /// A normal out of the body: the gradient of (x/A)^2 + (y/B)^2 + (z/C)^2 where there are semi-axes, in parts of its
    /// largest.
    pub fn normal_over<D: Number>(self, s: &[D], inside: bool) -> Vector<D> {
        let Some(half) = self.semi_axes() else {
            return self.normal(s[0], s[1], inside);
        };
        let least = half.iter().copied().fold(f64::INFINITY, f64::min);
        let sign = if inside { -1.0 } else { 1.0 };
        [0, 1, 2].map(|k| s[k] * (sign * least / half[k]))
    }

    /// Both tangents.
    pub fn tangents<D: Number>(self, a: D, b: D) -> [Vector<D>; 2] {
        let (one, zero) = (D::from(1.0), D::from(0.0));
        [[one, zero], [zero, one]].map(|[x, y]| {
            let (a, b) = (Dual::<D, f64>::new(a, x), Dual::<D, f64>::new(b, y));
            self.at(a, b).map(|u| u.eps)
        })
    }

    /// The normal out of the body, as long as the product of the tangents.
    pub fn normal<D: Number>(self, a: D, b: D, inside: bool) -> Vector<D> {
        let [t, s] = self.tangents(a, b);
        if inside { cross(&s, &t) } else { cross(&t, &s) }
    }

    /// The unit normal out of the body.
    pub fn unit<D: Number>(self, a: D, b: D, inside: bool) -> Vector<D> {
        let n = self.normal(a, b, inside);
        let length = dot(&n, &n).sqrt();
        n.map(|x| x / length)
    }
}
