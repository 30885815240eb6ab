//! Points of a surface for its picture.

use super::{Surface, SurfaceShape};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Points along each parameter.
const FINE: usize = 41;

/// A grid of points of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Number of points along a.
    pub nu: usize,
    /// Number of points along b.
    pub nv: usize,
    /// Points in the frame of the surface; b runs fastest.
    pub points: Vec<[f64; 3]>,
}

impl Surface {
    /// The surface about coordinates: whole where it is bounded, else as far as a size in every direction. None where it
    /// has no finite points there.
    pub fn sheet(&self, s: &[f64], size: f64) -> Option<Sheet> {
        let around = [0.0, TAU];
        let about = |x: f64| [x - size, x + size];
        let [a, b] = self.parameters(s, 0.0);
        let [a, b] = match &self.shape {
            SurfaceShape::Plane => [about(a), about(b)],
            SurfaceShape::Sphere(_) | SurfaceShape::Ellipsoid(_) => {
                [around, [-FRAC_PI_2, FRAC_PI_2]]
            }
            SurfaceShape::Cylinder(_) => [around, about(b)],
            SurfaceShape::Cone(_, height) => [around, [0.0_f64.min(b), *height]],
            SurfaceShape::Torus(..) => [around, [-PI, PI]],
            SurfaceShape::Revolved(_) => [around, self.stretch([a, b], 1, size)],
            SurfaceShape::Expressions(..) => {
                [self.stretch([a, b], 0, size), self.stretch([a, b], 1, size)]
            }
        };
        let part =
            |[from, to]: [f64; 2], k: usize| from + (to - from) * (k as f64) / (FINE - 1) as f64;
        let points: Vec<[f64; 3]> = (0..FINE * FINE)
            .map(|k| [part(a, k / FINE), part(b, k % FINE)])
            .map(|at| self.partials(&at).of(0, 0).into())
            .collect();
        let finite = points.as_flattened().iter().all(|x| x.is_finite());
        finite.then_some(Sheet {
            nu: FINE,
            nv: FINE,
            points,
        })
    }

    /// How far a parameter may go to either side until the point is a size away; parameters have no common unit.
    fn stretch(&self, at: [f64; 2], along: usize, size: f64) -> [f64; 2] {
        let here = self.partials(&at).of(0, 0);
        let side = |sign: f64| {
            let mut reached = 0.0;
            let mut step = 1e-3;
            while step < 1e3 {
                let mut s = at;
                s[along] += sign * step;
                let way: Vector3<f64> = self.partials(&s).of(0, 0) - here;
                if !way.norm().is_finite() {
                    break;
                }
                reached = step;
                if way.norm() > size {
                    break;
                }
                step *= 1.1;
            }
            at[along] + sign * reached
        };
        [side(-1.0), side(1.0)]
    }
}
