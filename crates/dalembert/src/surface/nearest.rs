//! Where two surfaces come nearest, and how they touch there.

use super::{Coordinates, Surface, SurfaceShape};
use crate::joint::Regularity;
use crate::space::SpatialMarker;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

/// Points along each parameter of a first look, for one and for two surfaces.
const LOOK: [usize; 2] = [48, 16];
/// Places of a first look that are improved.
const BEST: usize = 4;
/// Improvements of a first look.
const STEPS: usize = 60;
/// Smaller over larger relative curvature below which surfaces touch along a line.
const LINE: f64 = 1e-9;
/// How much of the reach a place may lie farther away if it lies lower.
const LOWER: f64 = 1e-6;
/// Smaller over larger relative curvature at which a ball fits well.
const WELL: f64 = 0.05;
/// What is left of ways, in parts of the reach, and of normals where surfaces come near each other with normals that oppose:
/// perpendicular ones alone leave as much.
const NEAR: f64 = 1.4;
/// Smaller relative curvature in parts of the reach's inverse at which surfaces touch in a point, however curved they are
/// across, as far as rounding can tell.
const BENT: [f64; 2] = [1e-5, 1e-13];
/// Normals, in parts of the usual length of t_a x t_b, that count as vanished.
const POLE: f64 = 1e-6;

/// A surface in its place.
#[derive(Clone, Copy)]
pub struct Placed<'a> {
    /// The surface.
    pub surface: &'a Surface,
    /// Its frame.
    pub marker: &'a SpatialMarker,
}

/// How two surfaces touch.
pub enum Touch {
    /// In a point.
    Point,
    /// Along a line: the number of a coordinate that says where on the line.
    Line(usize),
    /// Everywhere around.
    Face,
}

impl Placed<'_> {
    /// Coordinates on the surface: w gets its unit length.
    fn settled(&self, s: &[f64]) -> Coordinates {
        let mut s = Coordinates::from_slice(s);
        if self.surface.is_round() {
            let length = s.iter().map(|x| x * x).sum::<f64>().sqrt();
            if length > 0.0 {
                s.iter_mut().for_each(|x| *x /= length);
            }
        }
        s
    }

    /// Point and unit normal in ground axes; none at poles.
    fn at(&self, s: &[f64]) -> Option<(Vector3<f64>, Vector3<f64>)> {
        let around = self.surface.around(&self.settled(s));
        let n = around.normal.value.try_normalize(f64::MIN_POSITIVE)?;
        let point = self.marker.point + self.marker.axes * around.point.value;
        (point.iter().chain(n.iter()).all(|x| x.is_finite())).then(|| (point, self.marker.axes * n))
    }

    /// Coordinates of a grid in the ranges that lie near a point.
    fn grid(&self, near: &Vector3<f64>, reach: f64, count: usize) -> Vec<Coordinates> {
        let local = self.marker.axes.tr_mul(&(near - self.marker.point));
        let [a, b] = self.surface.ranges(&local, reach);
        // The middles of cells, so that poles at the ends of a range are left out.
        let part =
            |[from, to]: [f64; 2], k: usize| from + (to - from) * (k as f64 + 0.5) / count as f64;
        let cells = (0..count * count).map(|k| [part(a, k / count), part(b, k % count)]);
        cells.map(|ab| self.surface.coordinates(ab)).collect()
    }

    /// Curvature in ground axes, towards the normal positive; none at poles.
    pub fn curvature(&self, s: &[f64]) -> Option<Matrix3<f64>> {
        let own = self.surface.curvature(s)?;
        Some(self.marker.axes * own * self.marker.axes.transpose())
    }

    /// How far the surface reaches from its frame: where it is given by formulas, half of its places lie nearer [m].
    fn extent(&self) -> f64 {
        if !matches!(
            self.surface.shape,
            SurfaceShape::Revolved(_) | SurfaceShape::Expressions(..)
        ) {
            return self.surface.reach();
        }
        let cells = self.grid(&self.marker.point, 0.0, LOOK[1]);
        let ways = cells
            .iter()
            .map(|s| self.surface.around(s).point.value.norm());
        let mut ways: Vec<f64> = ways.filter(|x| x.is_finite()).collect();
        ways.sort_by(f64::total_cmp);
        ways.get(ways.len() / 2).copied().unwrap_or(0.0)
    }

    /// Does a ball of a radius touch the surface here without running into it around, its smaller relative curvature more than
    /// a part of the larger? Points fit everywhere.
    fn fits(&self, s: &[f64], radius: f64, margin: f64) -> bool {
        if radius == 0.0 {
            return true;
        }
        let around = self.surface.around(s);
        let (Some(n), Some(own)) = (
            around.normal.value.try_normalize(f64::MIN_POSITIVE),
            self.surface.curvature(s),
        ) else {
            return false;
        };
        // Both relative curvatures bend away from the ball.
        let relative = own - (Matrix3::identity() - n * n.transpose()) / radius;
        relative.trace() < 0.0 && Regularity::flatness(&relative) > margin
    }

    /// Do the parameters have a pole at these coordinates, or next to them?
    pub fn is_pole(&self, s: &[f64]) -> bool {
        let Some(here) = self.surface.regularity(s) else {
            return false;
        };
        let near = self.marker.point;
        let cells = self.grid(&near, self.surface.reach(), LOOK[1]);
        let mut usual: Vec<f64> = cells
            .iter()
            .filter_map(|s| Some(self.surface.regularity(s)?.norm()))
            .filter(|x| x.is_finite())
            .collect();
        usual.sort_by(f64::total_cmp);
        let usual = usual.get(usual.len() / 2).copied().unwrap_or(0.0);
        let here = here.norm();
        here.is_nan() || here <= POLE * usual
    }
}

/// Least squares of a residual from a start, by Levenberg's method with differences.
fn improve(start: Vec<f64>, residual: impl Fn(&[f64]) -> Option<DVector<f64>>) -> (Vec<f64>, f64) {
    let mut s = start;
    let Some(mut r) = residual(&s) else {
        return (s, f64::INFINITY);
    };
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        let mut jacobian = DMatrix::zeros(r.len(), s.len());
        for k in 0..s.len() {
            let step = 1e-6 * (1.0 + s[k].abs());
            let mut moved = s.clone();
            moved[k] += step;
            let Some(ahead) = residual(&moved) else {
                return (s, r.norm());
            };
            jacobian.set_column(k, &((ahead - &r) / step));
        }
        let gradient = jacobian.tr_mul(&r);
        let mut normal = jacobian.tr_mul(&jacobian);
        for k in 0..s.len() {
            normal[(k, k)] += damping * (normal[(k, k)] + 1e-12);
        }
        let Some(step) = normal.lu().solve(&gradient) else {
            break;
        };
        let moved: Vec<f64> = s.iter().zip(step.iter()).map(|(s, d)| s - d).collect();
        match residual(&moved) {
            Some(better) if better.norm() < r.norm() => {
                let gain = r.norm() - better.norm();
                let done = gain <= 1e-14 * r.norm();
                (s, r) = (moved, better);
                damping *= 0.2;
                if done {
                    break;
                }
            }
            _ => damping *= 10.0,
        }
        if damping > 1e12 {
            break;
        }
    }
    let left = r.norm();
    (s, left)
}

/// Coordinates at which a surface, moved out by a distance, comes nearest to a point; of places that are equally near the
/// lowest, along `down`.
pub fn nearest_point(
    surface: Placed<'_>,
    distance: f64,
    point: &Vector3<f64>,
    down: &Vector3<f64>,
) -> Option<Coordinates> {
    let way = |s: &[f64]| {
        let (p, n) = surface.at(s)?;
        Some(p + distance * n - point)
    };
    let reach =
        surface.surface.reach().max(distance).max(1e-3) + (point - surface.marker.point).norm();
    let cells = surface.grid(point, reach, LOOK[0]);
    let merit = |s: &[f64]| {
        way(s).map_or(f64::INFINITY, |d| {
            d.norm_squared() - LOWER * reach * d.dot(down)
        })
    };
    let least = |a: &&Coordinates, b: &&Coordinates| merit(a).total_cmp(&merit(b));
    let residual = |s: &[f64]| way(s).map(|d| DVector::from_column_slice(d.as_slice()));
    let improved = |s: &Coordinates| surface.settled(&improve(s.to_vec(), residual).0);
    let nearest = cells.iter().min_by(least).map(improved)?;
    if surface.fits(&nearest, distance, 0.0) {
        return Some(nearest);
    }
    // Where a ball runs into the surface beside the contact its equations hold, but lead nowhere: then from where it fits
    // well.
    let fitting = cells.iter().filter(|s| surface.fits(s, distance, WELL));
    let Some(best) = fitting.min_by(least) else {
        return Some(nearest);
    };
    let found = improved(best);
    Some(if surface.fits(&found, distance, WELL) {
        found
    } else {
        best.clone()
    })
}

/// Coordinates at which two surfaces come nearest to touching, normals against each other: those of the first, then those
/// of the second.
pub fn nearest_pair(pair: [Placed<'_>; 2]) -> Option<[Coordinates; 2]> {
    let reach = pair.iter().fold(1e-3_f64, |m, p| m.max(p.extent()));
    let samples = [0, 1].map(|k| {
        let (own, other) = (pair[k], pair[1 - k]);
        let cells = own.grid(&other.marker.point, 2.0 * reach, LOOK[1]);
        let seen = cells.into_iter().filter_map(|s| {
            let at = own.at(&s)?;
            Some((s, at))
        });
        seen.collect::<Vec<_>>()
    });
    let ways = |(p, n): (Vector3<f64>, Vector3<f64>), (q, m): (Vector3<f64>, Vector3<f64>)| {
        ((p - q) / reach, n + m)
    };
    let split = pair[0].surface.count();
    let residual = |s: &[f64]| {
        let (d, n) = ways(pair[0].at(&s[..split])?, pair[1].at(&s[split..])?);
        Some(DVector::from_iterator(6, d.iter().chain(n.iter()).copied()))
    };
    let improved = |(i, j): (usize, usize)| {
        let start = [&samples[0][i].0[..], &samples[1][j].0].concat();
        let (s, left) = improve(start, residual);
        let one = pair[0].settled(&s[..split]);
        ([one, pair[1].settled(&s[split..])], left)
    };
    let least = |found: Vec<([Coordinates; 2], f64)>| {
        let least = found.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
        least.map(|(s, _)| s)
    };
    let merit = |i: usize, j: usize| {
        let (d, n) = ways(samples[0][i].1, samples[1][j].1);
        d.norm_squared() + n.norm_squared()
    };
    let counts = [samples[0].len(), samples[1].len()];
    let best = first_look(counts, merit, |_, _| true);
    let nearest = least(best.into_iter().map(improved).collect())?;
    let crosses = |s: [&[f64]; 2]| {
        let own = [0, 1].map(|k| pair[k].curvature(s[k]));
        matches!(own, [Some(one), Some(two)] if Regularity::crossing(&[one, two]).is_some())
    };
    if !crosses(nearest.each_ref().map(|s| &s[..])) {
        return Some(nearest);
    }
    // Where surfaces run into each other beside the contact they do not touch: then from where they fit.
    let fit = |i: usize, j: usize| !crosses([&samples[0][i].0, &samples[1][j].0]);
    let fitting = first_look(counts, merit, fit);
    let found = fitting.into_iter().map(improved);
    let found = found.filter(|(s, left)| *left < NEAR && !crosses([&s[0], &s[1]]));
    Some(least(found.collect()).unwrap_or(nearest))
}

/// The best pairs of a first look, one for each of the first, among those that are allowed.
fn first_look(
    counts: [usize; 2],
    merit: impl Fn(usize, usize) -> f64,
    allowed: impl Fn(usize, usize) -> bool,
) -> Vec<(usize, usize)> {
    let mut best: Vec<(f64, usize, usize)> = Vec::new();
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            let merit = merit(i, j);
            // The best of a few first points, so that they lie apart.
            let last = best.iter().position(|(_, k, _)| *k == i);
            let worst = match last {
                Some(k) => best[k].0,
                None if best.len() >= BEST => best[best.len() - 1].0,
                None => f64::INFINITY,
            };
            if merit >= worst || !allowed(i, j) {
                continue;
            }
            match last {
                Some(k) => best[k] = (merit, i, j),
                None => best.push((merit, i, j)),
            }
        }
        best.sort_by(|a, b| a.0.total_cmp(&b.0));
        best.truncate(BEST);
    }
    best.into_iter().map(|(_, i, j)| (i, j)).collect()
}

/// How surfaces touch, by their relative curvature (Shabana 8.72: C_s has full rank where it is regular).
pub fn touch(pair: [Placed<'_>; 2], s: [&[f64]; 2]) -> Option<Touch> {
    let own = [pair[0].curvature(s[0])?, pair[1].curvature(s[1])?];
    let relative = own[0] + own[1];
    let svd = relative.svd(true, true);
    let (largest, middle) = {
        let mut sizes: Vec<f64> = svd.singular_values.iter().copied().collect();
        sizes.sort_by(|a, b| b.total_cmp(a));
        (sizes[0], sizes[1])
    };
    let reach = pair.iter().fold(1e-3_f64, |m, p| m.max(p.surface.reach()));
    if largest * reach < LINE {
        return Some(Touch::Face);
    }
    let bent = middle * reach > BENT[0] && middle > BENT[1] * largest;
    if bent || middle > LINE * largest {
        return Some(Touch::Point);
    }
    // The line runs across the direction of curvature, in the tangent plane; it is counted on the more curved surface.
    let curved = usize::from(own[1].norm() > own[0].norm());
    let bent = svd.u?.column(svd.singular_values.imax()).into_owned();
    let around = pair[curved].surface.around(s[curved]);
    let line = pair[curved]
        .marker
        .axes
        .tr_mul(&bent)
        .cross(&around.normal.value);
    // The coordinate that changes most along the line.
    let changes = around.point.by[..pair[curved].surface.count()].iter();
    let changes = changes.map(|u| u.dot(&line).abs() / u.norm());
    let along = DVector::from_iterator(pair[curved].surface.count(), changes).imax();
    let first = if curved == 0 {
        0
    } else {
        pair[0].surface.count()
    };
    Some(Touch::Line(first + along))
}
