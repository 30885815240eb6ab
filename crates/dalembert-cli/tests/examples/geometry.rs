//! Closed forms of linkages: intersections of circles.

use std::f64::consts::TAU;

/// A point of the plane [m].
pub type Point = [f64; 2];

/// A point at a distance and an angle from another one.
pub fn from(origin: Point, distance: f64, angle: f64) -> Point {
    [
        origin[0] + distance * angle.cos(),
        origin[1] + distance * angle.sin(),
    ]
}

/// Angle of the line from a to b.
pub fn angle(a: Point, b: Point) -> f64 {
    (b[1] - a[1]).atan2(b[0] - a[0])
}

/// Where the circle about `a` meets that about `b`, on the left of the line from a to b.
pub fn meet(a: Point, a_radius: f64, b: Point, b_radius: f64) -> Point {
    let d = (b[0] - a[0]).hypot(b[1] - a[1]);
    // Law of cosines in the triangle of the two centres and the point.
    let turn = ((a_radius * a_radius + d * d - b_radius * b_radius) / (2.0 * a_radius * d)).acos();
    from(a, a_radius, angle(a, b) + turn)
}

/// The angle, moved by whole turns to be nearest to another one.
pub fn near(angle: f64, other: f64) -> f64 {
    angle + TAU * ((other - angle) / TAU).round()
}
