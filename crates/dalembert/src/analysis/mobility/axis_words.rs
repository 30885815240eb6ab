//! Axes of motions in words.

use crate::space::Screw;
use crate::words::{listed, readable};
use nalgebra::{Matrix3, Vector3};

/// Parts of a direction, and of the machine's size, below this are rounding.
const ROUNDING: f64 = 1e-6;

/// What a body does that can move along and about these axes. `word` is what it does where it only moves: it "moves" or
/// "slides".
pub(super) fn axis_words(word: &str, screws: &[Screw], size: f64) -> String {
    if let Some(every) = every_way(screws, size) {
        return every;
    }
    let list: Vec<String> = screws.iter().map(|s| one(word, s, size)).collect();
    listed(&list)
}

fn one(word: &str, screw: &Screw, size: f64) -> String {
    let along = direction(&screw.direction);
    let Some(p) = screw.point else {
        let word = if word == "slides" { word } else { "moves" };
        return format!("{word} along {along}");
    };
    let about = format!("about {along} through {}", point(&p, size));
    if pure_turn(screw, size) {
        format!("turns {about}")
    } else {
        format!("screws {about}, {} m a radian", readable(screw.pitch))
    }
}

/// Is the pitch only rounding?
fn pure_turn(screw: &Screw, size: f64) -> bool {
    screw.pitch.abs() <= ROUNDING * size
}

/// Three independent motions of one kind.
fn every_way(screws: &[Screw], size: f64) -> Option<String> {
    let [a, b, c] = screws else { return None };
    let volume = a.direction.cross(&b.direction).dot(&c.direction);
    if volume.abs() <= ROUNDING {
        return None;
    }
    match (a.point, b.point, c.point) {
        (None, None, None) => Some("moves every way".to_owned()),
        (Some(_), Some(_), Some(_)) if screws.iter().all(|s| pure_turn(s, size)) => {
            let p = common_point(screws, size)?;
            Some(format!("turns every way about {}", point(&p, size)))
        }
        _ => None,
    }
}

/// The point through which all axes go: sum of (1 - d d^T) (x - p) = 0 over the axes, by least squares.
fn common_point(screws: &[Screw], size: f64) -> Option<Vector3<f64>> {
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for screw in screws {
        let across = Matrix3::identity() - screw.direction * screw.direction.transpose();
        matrix += across;
        right += across * screw.point?;
    }
    let common = matrix.try_inverse()? * right;
    let off = |s: &Screw| {
        s.point
            .is_none_or(|p| (common - p).cross(&s.direction).norm() > ROUNDING * size)
    };
    (!screws.iter().any(off)).then_some(common)
}

/// A direction with three digits; its sense means nothing, so the first component is positive.
fn direction(d: &Vector3<f64>) -> String {
    let first = d.iter().find(|x| x.abs() > ROUNDING);
    let sign = if first.is_some_and(|x| *x < 0.0) {
        -1.0
    } else {
        1.0
    };
    // Adding zero turns a negative zero into a plain one.
    let digit = |x: f64| (sign * x * 1e3).round() / 1e3 + 0.0;
    format!("({}, {}, {})", digit(d.x), digit(d.y), digit(d.z))
}

fn point(p: &Vector3<f64>, size: f64) -> String {
    let number = |x: f64| readable(if x.abs() <= ROUNDING * size { 0.0 } else { x });
    format!("({}, {}, {})", number(p.x), number(p.y), number(p.z))
}

#[cfg(test)]
mod tests {
    use super::axis_words;
    use crate::space::Screw;
    use nalgebra::Vector3;

    fn screw(point: [f64; 3], linear: [f64; 3], angular: [f64; 3]) -> Screw {
        let [p, v, w] = [point, linear, angular].map(Vector3::from);
        Screw::new(&p, &v, &w).unwrap()
    }

    #[test]
    fn single_axes() {
        let words = |s: Screw| axis_words("moves and turns", &[s], 1.0);
        assert_eq!(
            words(screw([1.0, 2.0, 3.0], [0.0, -3.0, 4.0], [0.0; 3])),
            "moves along (0, 0.6, -0.8)"
        );
        // The axis is a metre beside the point.
        assert_eq!(
            words(screw([0.0, 0.0, 3.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0])),
            "turns about (0, 0, 1) through (-1, 0, 3)"
        );
        assert_eq!(
            words(screw([0.0; 3], [0.0, 0.0, -0.5], [0.0, 0.0, -2.0])),
            "screws about (0, 0, 1) through (0, 0, 0), 0.25 m a radian"
        );
    }

    #[test]
    fn several_axes() {
        let about = |p: [f64; 3], w: [f64; 3]| screw(p, [0.0; 3], w);
        let along = |v: [f64; 3]| screw([0.0; 3], v, [0.0; 3]);
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // Three axes that meet in (1, 2, 3), each given by another of its points.
        let meet = [
            about([5.0, 2.0, 3.0], x),
            about([1.0, -7.0, 3.0], y),
            about([1.0, 2.0, 0.0], z),
        ];
        assert_eq!(
            axis_words("turns", &meet, 1.0),
            "turns every way about (1, 2, 3)"
        );
        assert_eq!(
            axis_words("moves", &[x, y, z].map(along), 1.0),
            "moves every way"
        );
        let pass = [meet[0], meet[1], about([1.0, 2.5, 0.0], z)];
        assert_eq!(
            axis_words("turns", &pass, 1.0),
            "turns about (1, 0, 0) through (5, 2, 3), turns about (0, 1, 0) through (1, -7, 3) and turns about (0, 0, 1) through (1, 2.5, 0)"
        );
        assert_eq!(
            axis_words("moves and turns", &[about([0.0; 3], z), along(x)], 1.0),
            "turns about (0, 0, 1) through (0, 0, 0) and moves along (1, 0, 0)"
        );
    }
}
