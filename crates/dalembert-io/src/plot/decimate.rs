//! Thinning of long curves to what pixels can show.

use super::svg::Point;

/// Most points that a curve in the plane keeps.
const MAX_POINTS: usize = 8000;

/// Thins a curve whose x never falls: of every column (`width` pixels wide) it keeps the first, the
/// lowest, the highest and the last point, in their order.
pub(super) fn by_column(points: &[Point], width: f64) -> Vec<Point> {
    let column = |p: &Point| (p.0 / width).floor();
    let mut kept = Vec::new();
    for group in points.chunk_by(|a, b| column(a) == column(b)) {
        let mut low = 0;
        let mut high = 0;
        for (k, p) in group.iter().enumerate() {
            if p.1 < group[low].1 {
                low = k;
            }
            if p.1 > group[high].1 {
                high = k;
            }
        }
        let mut keep = [0, low.min(high), low.max(high), group.len() - 1].to_vec();
        keep.dedup();
        kept.extend(keep.into_iter().map(|k| group[k]));
    }
    kept
}

/// Thins any curve: points closer to the last kept one than a quarter pixel go, and where that
/// leaves too many, the distance doubles until it does not. The ends and the points that reach
/// furthest left, right, up and down stay.
pub(super) fn by_distance(points: &[Point]) -> Vec<Point> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let extremes = extremes(points);
    let mut distance = 0.25;
    loop {
        let mut kept = vec![points[0]];
        let mut last = points[0];
        for (k, p) in points.iter().enumerate().skip(1) {
            let far = (p.0 - last.0).hypot(p.1 - last.1) >= distance;
            if far || k == points.len() - 1 || extremes.contains(&k) {
                kept.push(*p);
                last = *p;
            }
        }
        if kept.len() <= MAX_POINTS {
            return kept;
        }
        distance *= 2.0;
    }
}

/// Drops points that lie on the straight line between their neighbours to a twentieth of a pixel
/// (Ramer 1972, Douglas and Peucker 1973).
pub(super) fn straighten(points: &[Point]) -> Vec<Point> {
    const TOLERANCE: f64 = 0.05;
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[points.len() - 1] = true;
    let mut open = vec![(0, points.len() - 1)];
    while let Some((a, b)) = open.pop() {
        let mut worst = (0.0, a);
        for k in a + 1..b {
            let distance = to_segment(points[k], points[a], points[b]);
            if distance > worst.0 {
                worst = (distance, k);
            }
        }
        if worst.0 > TOLERANCE {
            keep[worst.1] = true;
            open.push((a, worst.1));
            open.push((worst.1, b));
        }
    }
    let kept = points.iter().zip(keep);
    kept.filter(|(_, k)| *k).map(|(p, _)| *p).collect()
}

/// Distance of a point to a segment.
fn to_segment(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let square = dx * dx + dy * dy;
    let along = if square > 0.0 {
        (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (p.0 - a.0 - along * dx).hypot(p.1 - a.1 - along * dy)
}

/// Places of the points furthest left, right, up and down.
fn extremes(points: &[Point]) -> [usize; 4] {
    let mut best = [0; 4];
    for (k, p) in points.iter().enumerate() {
        let better = [
            p.0 < points[best[0]].0,
            p.0 > points[best[1]].0,
            p.1 < points[best[2]].1,
            p.1 > points[best[3]].1,
        ];
        for (place, is_better) in best.iter_mut().zip(better) {
            if is_better {
                *place = k;
            }
        }
    }
    best
}
