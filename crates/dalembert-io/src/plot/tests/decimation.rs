//! Thinning keeps what can be seen.

use crate::plot::decimate::{by_column, by_distance, straighten};
use crate::plot::svg::Point;

/// A pixel curve of 100000 points with two lone spikes.
fn spiky() -> Vec<Point> {
    let mut points: Vec<Point> = (0..100_000)
        .map(|k| {
            let x = f64::from(k) * 0.007;
            (x, 200.0 + 50.0 * (x * 13.0).sin())
        })
        .collect();
    points[31_415].1 = 7.25;
    points[27_182].1 = 391.5;
    points
}

fn extremes(points: &[Point]) -> (f64, f64) {
    points
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| {
            (l.min(p.1), h.max(p.1))
        })
}

#[test]
fn columns_keep_first_lowest_highest_and_last() {
    let points = spiky();
    let kept = by_column(&points, 0.5);
    assert!(kept.len() <= 4 * 1401, "{}", kept.len());
    assert_eq!(extremes(&kept), extremes(&points));
    assert!(kept.contains(&points[31_415]) && kept.contains(&points[27_182]));
    assert_eq!(kept.first(), points.first());
    assert_eq!(kept.last(), points.last());
    assert!(kept.windows(2).all(|w| w[0].0 < w[1].0));
    // In every column the extremes are those of all points there.
    for column in [0.0, 100.0, 380.5] {
        let inside = |p: &&Point| p.0 >= column && p.0 < column + 0.5;
        let all: Vec<Point> = points.iter().filter(inside).copied().collect();
        let few: Vec<Point> = kept.iter().filter(inside).copied().collect();
        assert_eq!(extremes(&few), extremes(&all));
    }
}

#[test]
fn straight_pieces_collapse_and_corners_stay() {
    let mut points: Vec<Point> = (0..=1000)
        .map(|k| (f64::from(k), 2.0 * f64::from(k)))
        .collect();
    points.extend((1..=1000).map(|k| (1000.0 + f64::from(k), 2000.0 - f64::from(k))));
    assert_eq!(
        straighten(&points),
        [(0.0, 0.0), (1000.0, 2000.0), (2000.0, 1000.0)]
    );
    let spiky = by_column(&spiky(), 0.5);
    let kept = straighten(&spiky);
    assert!(kept.len() < spiky.len());
    assert_eq!(extremes(&kept), extremes(&spiky));
    // A closed curve begins and ends at one point: nothing is lost there.
    let square = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)];
    assert_eq!(straighten(&square), square);
}

#[test]
fn plane_curves_keep_their_extent_and_stay_small() {
    // A path that never comes back to a pixel quickly: every step is longer than the threshold.
    let points: Vec<Point> = (0..100_000)
        .map(|k| {
            let a = f64::from(k) * 0.7;
            (300.0 + 290.0 * (a * 1.01).cos(), 200.0 + 190.0 * a.sin())
        })
        .collect();
    let kept = by_distance(&points);
    assert!(kept.len() <= 8000, "{}", kept.len());
    assert_eq!(extremes(&kept), extremes(&points));
    let turned = |p: &[Point]| extremes(&p.iter().map(|p| (p.1, p.0)).collect::<Vec<_>>());
    assert_eq!(turned(&kept), turned(&points));
    assert_eq!(kept.first(), points.first());
    assert_eq!(kept.last(), points.last());
}
