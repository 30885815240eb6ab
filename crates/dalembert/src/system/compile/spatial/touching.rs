//! Where two surfaces come nearest, and how they touch there.

use crate::space::SpatialMarker;
use crate::surface::{Field, Surface};
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, Matrix3x2, Vector2, Vector3};

/// Points along each parameter of a first look, for one and for two surfaces.
const LOOK: [usize; 2] = [48, 16];
/// Improvements of a first look.
const STEPS: usize = 60;
/// Smaller over larger relative curvature below which surfaces touch along a line.
const LINE: f64 = 1e-9;

/// A surface in its place.
#[derive(Clone, Copy)]
pub(super) struct Placed<'a> {
    pub surface: &'a Surface,
    pub marker: &'a SpatialMarker,
}

/// How two surfaces touch.
pub(super) enum Touch {
    /// In a point.
    Point,
    /// Along a line: the number of a parameter that says where on the line.
    Line(usize),
    /// Everywhere around.
    Face,
}

impl Placed<'_> {
    /// Point and unit normal in ground axes; none at poles.
    fn at(&self, s: &[f64]) -> Option<(Vector3<f64>, Vector3<f64>)> {
        let partials = self.surface.partials(s);
        let n = self.surface.normal(&partials).value;
        let n = n.try_normalize(f64::MIN_POSITIVE)?;
        let point = self.marker.point + self.marker.axes * partials.of(0, 0);
        (point.iter().chain(n.iter()).all(|x| x.is_finite())).then(|| (point, self.marker.axes * n))
    }

    /// Parameters of a grid in the ranges that lie near a point.
    fn grid(&self, near: &Vector3<f64>, reach: f64, count: usize) -> Vec<[f64; 2]> {
        let local = self.marker.axes.tr_mul(&(near - self.marker.point));
        let [a, b] = self.surface.ranges(&local, reach);
        // The middles of cells, so that poles at the ends of a range are left out.
        let part =
            |[from, to]: [f64; 2], k: usize| from + (to - from) * (k as f64 + 0.5) / count as f64;
        let cells = (0..count * count).map(|k| [part(a, k / count), part(b, k % count)]);
        cells.collect()
    }

    /// Curvature of the surface as a tensor in ground axes, towards its normal.
    fn curvature(&self, s: &[f64]) -> Option<Matrix3<f64>> {
        let p = self.surface.partials(s);
        let n = self
            .surface
            .normal(&p)
            .value
            .try_normalize(f64::MIN_POSITIVE)?;
        let t = Matrix3x2::from_columns(&[p.of(1, 0), p.of(0, 1)]);
        let bends = Matrix2::new(
            p.of(2, 0).dot(&n),
            p.of(1, 1).dot(&n),
            p.of(1, 1).dot(&n),
            p.of(0, 2).dot(&n),
        );
        let inverse = t.tr_mul(&t).try_inverse()?;
        let tangents = self.marker.axes * t * inverse;
        Some(tangents * bends * tangents.transpose())
    }
}

/// Least squares of a residual from a start, by Levenberg's method with differences.
fn improve(start: Vec<f64>, residual: impl Fn(&[f64]) -> Option<DVector<f64>>) -> Vec<f64> {
    let mut s = start;
    let Some(mut r) = residual(&s) else {
        return s;
    };
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        let mut jacobian = DMatrix::zeros(r.len(), s.len());
        for k in 0..s.len() {
            let step = 1e-6 * (1.0 + s[k].abs());
            let mut moved = s.clone();
            moved[k] += step;
            let Some(ahead) = residual(&moved) else {
                return s;
            };
            jacobian.set_column(k, &((ahead - &r) / step));
        }
        let gradient = jacobian.tr_mul(&r);
        let mut normal = jacobian.tr_mul(&jacobian);
        for k in 0..s.len() {
            normal[(k, k)] += damping * (normal[(k, k)] + 1e-12);
        }
        let Some(step) = normal.lu().solve(&gradient) else {
            return s;
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
    s
}

/// Parameters at which a surface, moved out by a distance, comes nearest to a point.
pub(super) fn nearest_point(
    surface: Placed<'_>,
    distance: f64,
    point: &Vector3<f64>,
) -> Option<[f64; 2]> {
    let way = |s: &[f64]| {
        let (p, n) = surface.at(s)?;
        Some(p + distance * n - point)
    };
    let reach =
        surface.surface.reach().max(distance).max(1e-3) + (point - surface.marker.point).norm();
    let cells = surface.grid(point, reach, LOOK[0]);
    let merit = |s: &[f64]| way(s).map_or(f64::INFINITY, |d| d.norm_squared());
    let best = cells
        .into_iter()
        .min_by(|a, b| merit(a).total_cmp(&merit(b)))?;
    let residual = |s: &[f64]| way(s).map(|d| DVector::from_column_slice(d.as_slice()));
    let found = improve(best.to_vec(), residual);
    Some([found[0], found[1]])
}

/// Parameters at which two surfaces come nearest to touching, normals against each other.
pub(super) fn nearest_pair(pair: [Placed<'_>; 2]) -> Option<[f64; 4]> {
    let reach = pair.iter().fold(1e-3_f64, |m, p| m.max(p.surface.reach()));
    let samples = [0, 1].map(|k| {
        let (own, other) = (pair[k], pair[1 - k]);
        let cells = own.grid(&other.marker.point, 2.0 * reach, LOOK[1]);
        let seen = cells.into_iter().filter_map(|s| Some((s, own.at(&s)?)));
        seen.collect::<Vec<_>>()
    });
    let ways = |(p, n): (Vector3<f64>, Vector3<f64>), (q, m): (Vector3<f64>, Vector3<f64>)| {
        ((p - q) / reach, n + m)
    };
    let mut best = None;
    let mut least = f64::INFINITY;
    for (s, one) in &samples[0] {
        for (t, two) in &samples[1] {
            let (d, n) = ways(*one, *two);
            let merit = d.norm_squared() + n.norm_squared();
            if merit < least {
                least = merit;
                best = Some([s[0], s[1], t[0], t[1]]);
            }
        }
    }
    let residual = |s: &[f64]| {
        let (d, n) = ways(pair[0].at(&s[..2])?, pair[1].at(&s[2..])?);
        Some(DVector::from_iterator(6, d.iter().chain(n.iter()).copied()))
    };
    let found = improve(best?.to_vec(), residual);
    Some([found[0], found[1], found[2], found[3]])
}

/// How surfaces touch, by their relative curvature (Shabana 8.72: C_s has full rank where it is regular).
pub(super) fn touch(pair: [Placed<'_>; 2], s: &[f64; 4]) -> Option<Touch> {
    let own = [pair[0].curvature(&s[..2])?, pair[1].curvature(&s[2..])?];
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
    if middle > LINE * largest {
        return Some(Touch::Point);
    }
    // The line runs across the direction of curvature, in the tangent plane; it is counted on the more curved surface.
    let curved = usize::from(own[1].norm() > own[0].norm());
    let bent = svd.u?.column(svd.singular_values.imax()).into_owned();
    let p = pair[curved].surface.partials(&s[2 * curved..]);
    let n = pair[curved].surface.normal(&p).value;
    let axes = &pair[curved].marker.axes;
    let line = (axes * n).cross(&bent);
    let along = [p.of(1, 0), p.of(0, 1)].map(|t| (axes * t).normalize().dot(&line).abs());
    let along = Vector2::from(along);
    Some(Touch::Line(2 * curved + along.imax()))
}

/// Does the normal of a surface vanish at these parameters?
pub(super) fn is_pole(surface: &Surface, s: &[f64]) -> bool {
    let partials = surface.partials(s);
    let (a, b) = (Field::tangent(&partials, 0), Field::tangent(&partials, 1));
    let n = a.value.cross(&b.value).norm();
    n.is_nan() || n <= 1e-9 * a.value.norm().max(b.value.norm()).powi(2)
}
