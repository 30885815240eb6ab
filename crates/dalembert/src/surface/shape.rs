//! The surfaces.

use super::{Field, Partials};
use dalembert_expr::Program;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Form of a surface in its own frame, by two parameters a and b; lengths in metres.
#[derive(Clone, Debug)]
pub enum SurfaceShape {
    /// (a, b, 0); free on the side of +z.
    Plane,
    /// R (cos b cos a, cos b sin a, sin b).
    Sphere(f64),
    /// (R cos a, R sin a, b).
    Cylinder(f64),
    /// Radius R at z = 0, apex at z = h: (r cos a, r sin a, b), r = R (1 - b/h).
    Cone(f64, f64),
    /// (A cos b cos a, B cos b sin a, C sin b).
    Ellipsoid([f64; 3]),
    /// (r cos a, r sin a, t sin b), r = R + t cos b.
    Torus(f64, f64),
    /// (r(b) cos a, r(b) sin a, z(b)); expressions of b alone.
    Revolved(Box<[Program; 2]>),
    /// x, y, z as expressions of a and b, in this order; which of them each one uses.
    Expressions(Box<[Program; 3]>, [[usize; 2]; 3]),
}

/// A surface of a body. Its normal points out of the body: t_a x t_b, or against it where the body lies around the surface.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Form.
    pub shape: SurfaceShape,
    /// Does the body lie around the surface (a bowl, a hole)?
    pub inside: bool,
}

/// Derivatives of the cosine and the sine.
fn circle(angle: f64) -> [[f64; 2]; 4] {
    let (s, c) = angle.sin_cos();
    [[c, s], [-s, c], [-c, -s], [s, -c]]
}

fn of_one(program: &Program, x: f64) -> [f64; 4] {
    if program.slots().is_empty() {
        return [program.eval(&[]), 0.0, 0.0, 0.0];
    }
    program.eval_third(&[x])
}

/// Partial derivatives of an expression of two parameters, ordered as (i, j).
fn of_two(program: &Program, uses: [usize; 2], at: [f64; 2]) -> [[f64; 4]; 4] {
    // `uses` are the places of the parameters among the program's inputs; one that it does not use lies behind them.
    let n = program.slots().len();
    let mut values = [0.0; 2];
    for (k, place) in uses.into_iter().enumerate() {
        if place < n {
            values[place] = at[k];
        }
    }
    let along = |a: f64, b: f64| {
        let mut direction = [0.0; 2];
        for (place, x) in uses.into_iter().zip([a, b]) {
            if place < n {
                direction[place] = x;
            }
        }
        program.eval_along(&values[..n], &direction[..n])
    };
    let (x, y) = (along(1.0, 0.0), along(0.0, 1.0));
    let (sum, difference) = (along(1.0, 1.0), along(1.0, -1.0));
    let mut out = [[0.0; 4]; 4];
    for order in 0..4 {
        out[order][0] = x[order];
        out[0][order] = y[order];
    }
    // (d_a + d_b)^2 - (d_a - d_b)^2 = 4 d_a d_b, and so on for the third powers.
    out[1][1] = (sum[2] - difference[2]) / 4.0;
    out[1][2] = (sum[3] + difference[3] - 2.0 * x[3]) / 6.0;
    out[2][1] = (sum[3] - difference[3] - 2.0 * y[3]) / 6.0;
    out
}

fn revolved(r: [f64; 4], z: [f64; 4], a: f64) -> Partials {
    let around = circle(a);
    Partials::new(|i, j| {
        let [c, s] = around[i];
        Vector3::new(r[j] * c, r[j] * s, if i == 0 { z[j] } else { 0.0 })
    })
}

impl Surface {
    /// The point of two parameters and its derivatives.
    pub fn partials(&self, s: &[f64]) -> Partials {
        let (a, b) = (s[0], s[1]);
        match &self.shape {
            SurfaceShape::Plane => Partials::new(|i, j| match (i, j) {
                (0, 0) => Vector3::new(a, b, 0.0),
                (1, 0) => Vector3::x(),
                (0, 1) => Vector3::y(),
                _ => Vector3::zeros(),
            }),
            SurfaceShape::Sphere(radius) => {
                let up = circle(b);
                revolved(up.map(|x| radius * x[0]), up.map(|x| radius * x[1]), a)
            }
            SurfaceShape::Cylinder(radius) => {
                revolved([*radius, 0.0, 0.0, 0.0], [b, 1.0, 0.0, 0.0], a)
            }
            SurfaceShape::Cone(radius, height) => {
                let slope = -radius / height;
                revolved([radius + slope * b, slope, 0.0, 0.0], [b, 1.0, 0.0, 0.0], a)
            }
            SurfaceShape::Ellipsoid(half) => {
                let (around, up) = (circle(a), circle(b));
                Partials::new(|i, j| {
                    let ([ca, sa], [cb, sb]) = (around[i], up[j]);
                    let z = if i == 0 { half[2] * sb } else { 0.0 };
                    Vector3::new(half[0] * cb * ca, half[1] * cb * sa, z)
                })
            }
            SurfaceShape::Torus(radius, tube) => {
                let up = circle(b);
                let mut r = up.map(|x| tube * x[0]);
                r[0] += radius;
                revolved(r, up.map(|x| tube * x[1]), a)
            }
            SurfaceShape::Revolved(profile) => {
                let [r, z] = &**profile;
                revolved(of_one(r, b), of_one(z, b), a)
            }
            SurfaceShape::Expressions(programs, uses) => {
                let all: [[[f64; 4]; 4]; 3] =
                    std::array::from_fn(|k| of_two(&programs[k], uses[k], [a, b]));
                Partials::new(|i, j| Vector3::new(all[0][i][j], all[1][i][j], all[2][i][j]))
            }
        }
    }

    /// The normal out of the body by the parameters a and b, of the length of t_a x t_b; it vanishes at poles.
    pub fn normal(&self, partials: &Partials) -> Field {
        let (a, b) = (Field::tangent(partials, 0), Field::tangent(partials, 1));
        if self.inside {
            b.cross(&a)
        } else {
            a.cross(&b)
        }
    }

    /// Radius of a ball, whose contacts need no parameters; none for other surfaces, and for hollow balls.
    pub fn ball(&self) -> Option<f64> {
        match self.shape {
            SurfaceShape::Sphere(radius) if !self.inside => Some(radius),
            _ => None,
        }
    }

    /// Ranges of the parameters in which a contact is looked for, near a point of the surface's frame; `reach` is how far
    /// the other body reaches from there [m].
    pub fn ranges(&self, near: &Vector3<f64>, reach: f64) -> [[f64; 2]; 2] {
        let around = [0.0, TAU];
        let about = |x: f64| [x - reach, x + reach];
        match &self.shape {
            SurfaceShape::Plane => [about(near.x), about(near.y)],
            SurfaceShape::Sphere(_) | SurfaceShape::Ellipsoid(_) => {
                [around, [-FRAC_PI_2, FRAC_PI_2]]
            }
            SurfaceShape::Cylinder(_) => [around, about(near.z)],
            SurfaceShape::Cone(_, height) => {
                // Behind the apex lies another cone.
                let [from, to] = about(near.z);
                [around, [from.min(height - reach), to.min(*height)]]
            }
            SurfaceShape::Torus(..) => [around, [-PI, PI]],
            SurfaceShape::Revolved(_) => [around, [-reach.max(1.0), reach.max(1.0)]],
            SurfaceShape::Expressions(..) => {
                let r = reach.max(1.0);
                [[-r, r], [-r, r]]
            }
        }
    }

    /// How far the surface reaches from its frame's origin, where it is bounded [m].
    pub fn reach(&self) -> f64 {
        match &self.shape {
            SurfaceShape::Plane | SurfaceShape::Revolved(_) | SurfaceShape::Expressions(..) => 0.0,
            SurfaceShape::Sphere(r) | SurfaceShape::Cylinder(r) => *r,
            SurfaceShape::Cone(r, h) => r.max(*h),
            SurfaceShape::Ellipsoid(half) => half.iter().fold(0.0, |m, x| m.max(*x)),
            SurfaceShape::Torus(radius, tube) => radius + tube,
        }
    }
}
