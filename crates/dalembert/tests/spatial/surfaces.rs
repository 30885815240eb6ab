//! Derivatives of surfaces and of vectors over them.

use super::oracle::{Number, Vector};
use super::shapes::{ALL, Shape};
use super::*;
use dalembert::surface::{Field, Partials, Surface};
use nalgebra::Vector3;
use num_dual::{Dual64, HyperDual64, HyperHyperDual64};

/// A few roundings of terms of the size of the largest entry; third derivatives of expressions are differences of such.
const EXACT: f64 = 2e-14;

/// The derivative of a point of orders (i, j), i + j <= 3.
fn derivative(shape: Shape, s: [f64; 2], i: usize, j: usize) -> [f64; 3] {
    // The first i directions go along a, the next j along b.
    let part = |k: usize, second: bool| {
        let along = k < i + j && (k >= i) == second;
        f64::from(u8::from(along))
    };
    let of = |x: f64, second: bool| {
        let mut d = HyperHyperDual64::from(x);
        d.eps1 = part(0, second);
        d.eps2 = part(1, second);
        d.eps3 = part(2, second);
        d
    };
    let u = shape.at(of(s[0], false), of(s[1], true));
    u.map(|x| match i + j {
        0 => x.re,
        1 => x.eps1,
        2 => x.eps1eps2,
        _ => x.eps1eps2eps3,
    })
}

fn parameters(source: &mut Random) -> [f64; 2] {
    // Away from poles of spheres at b = pi/2 and from the apex of the cone at b = 0.9.
    [source.uniform(-3.0, 3.0), source.uniform(-0.8, 0.8)]
}

#[test]
fn partial_derivatives() {
    let mut source = Random::new(SEED);
    for shape in ALL {
        for _ in 0..5 {
            let s = parameters(&mut source);
            let found = shape.surface(false).partials(&s);
            for order in 0..4 {
                for j in 0..=order {
                    let i = order - j;
                    near(
                        &format!("{shape:?}, orders {i} and {j}"),
                        found.of(i, j).as_slice(),
                        &derivative(shape, s, i, j),
                        EXACT,
                    );
                }
            }
        }
    }
}

/// A field against a function of the parameters: value, first and second derivatives.
fn check(what: &str, field: &Field, s: [f64; 2], of: &impl Over) {
    near(what, field.value.as_slice(), &of.at(s[0], s[1]), EXACT);
    let unit = |k: usize, i: usize| f64::from(u8::from(k == i));
    for k in 0..2 {
        let slope = of.at(Dual64::new(s[0], unit(k, 0)), Dual64::new(s[1], unit(k, 1)));
        let slope = slope.map(|x| x.eps);
        near(
            &format!("{what}, by {k}"),
            field.by[k].as_slice(),
            &slope,
            EXACT,
        );
        for l in 0..2 {
            let number = |x: f64, i: usize| HyperDual64::new(x, unit(k, i), unit(l, i), 0.0);
            let bend = of.at(number(s[0], 0), number(s[1], 1));
            let bend = bend.map(|x| x.eps1eps2);
            near(
                &format!("{what}, by {k} and {l}"),
                field.second[k][l].as_slice(),
                &bend,
                EXACT,
            );
        }
    }
}

/// A vector over a surface for any kind of number.
trait Over {
    fn at<D: Number>(&self, a: D, b: D) -> Vector<D>;
}

struct Tangent(Shape, usize);
struct Unit(Shape, bool);
struct Normal(Shape, bool);
struct Offset(Shape, f64);

impl Over for Tangent {
    fn at<D: Number>(&self, a: D, b: D) -> Vector<D> {
        self.0.tangents(a, b)[self.1]
    }
}
impl Over for Unit {
    fn at<D: Number>(&self, a: D, b: D) -> Vector<D> {
        self.0.unit(a, b, self.1)
    }
}
impl Over for Normal {
    fn at<D: Number>(&self, a: D, b: D) -> Vector<D> {
        self.0.normal(a, b, self.1)
    }
}
impl Over for Offset {
    fn at<D: Number>(&self, a: D, b: D) -> Vector<D> {
        let (u, n) = (self.0.at(a, b), self.0.unit(a, b, false));
        [0, 1, 2].map(|k| u[k] + n[k] * self.1)
    }
}

#[test]
fn vectors_over_surfaces() {
    let mut source = Random::new(SEED + 1);
    for shape in ALL {
        for inside in [false, true] {
            let s = parameters(&mut source);
            let surface: Surface = shape.surface(inside);
            let partials: Partials = surface.partials(&s);
            let normal = surface.normal(&partials);
            for k in 0..2 {
                let tangent = Field::tangent(&partials, k);
                check(
                    &format!("{shape:?}: tangent {k}"),
                    &tangent,
                    s,
                    &Tangent(shape, k),
                );
            }
            let what = format!("{shape:?}, inside {inside}");
            check(
                &format!("{what}: normal"),
                &normal,
                s,
                &Normal(shape, inside),
            );
            check(
                &format!("{what}: unit"),
                &normal.unit(),
                s,
                &Unit(shape, inside),
            );
            if !inside {
                let offset = Field::point(&partials).plus(0.3, &normal.unit());
                check(&format!("{what}: offset"), &offset, s, &Offset(shape, 0.3));
            }
        }
    }
}

/// Normals point out of bodies, away from what the body fills.
#[test]
fn normals_point_out() {
    for (shape, s, out) in [
        (Shape::Plane, [0.3, 0.2], [0.0, 0.0, 1.0]),
        (Shape::Sphere(0.4), [0.0, 0.0], [1.0, 0.0, 0.0]),
        (Shape::Cylinder(0.3), [0.0, 0.7], [1.0, 0.0, 0.0]),
        (Shape::Cone(0.5, 0.9), [0.0, 0.2], [0.9, 0.0, 0.5]),
        (
            Shape::Ellipsoid([0.5, 0.3, 0.2]),
            [0.0, 0.0],
            [1.0, 0.0, 0.0],
        ),
        (
            Shape::Torus(0.6, 0.2),
            [0.0, std::f64::consts::FRAC_PI_2],
            [0.0, 0.0, 1.0],
        ),
    ] {
        for inside in [false, true] {
            let surface = shape.surface(inside);
            let n = surface.normal(&surface.partials(&s)).unit().value;
            let sign = if inside { -1.0 } else { 1.0 };
            let out = Vector3::from(out).normalize() * sign;
            assert!((n - out).amax() < 1e-15, "{shape:?}: {n}");
        }
    }
}
