//! B-splines: from knots and coefficients to derivatives at a point.
//!
//! C. de Boor, A Practical Guide to Splines, revised edition, chapters IX and X.

/// Largest degree.
pub(super) const DEGREE: usize = 5;

/// The B-splines of a degree that are not zero at x, which lies in [knots[at], knots[at + 1]).
///
/// Entry k belongs to the B-spline number `at - degree + k`.
pub(super) fn basis(knots: &[f64], degree: usize, at: usize, x: f64) -> [f64; DEGREE + 1] {
    let mut values = [0.0; DEGREE + 1];
    values[0] = 1.0;
    for d in 1..=degree {
        let mut carried = 0.0;
        for k in 0..d {
            let (left, right) = (knots[at + 1 + k - d], knots[at + 1 + k]);
            let part = values[k] / (right - left);
            values[k] = carried + (right - x) * part;
            carried = (x - left) * part;
        }
        values[d] = carried;
    }
    values
}

/// Taylor coefficients at x of the spline, which is a polynomial on [knots[at], knots[at + 1]).
///
/// `coefficients` are those of the `degree + 1` B-splines that are not zero there.
pub(super) fn taylor(
    knots: &[f64],
    degree: usize,
    at: usize,
    x: f64,
    mut coefficients: [f64; DEGREE + 1],
) -> [f64; DEGREE + 1] {
    let mut result = [0.0; DEGREE + 1];
    let mut factorial = 1.0;
    for (order, place) in result.iter_mut().enumerate().take(degree + 1) {
        let lower = degree - order;
        let values = basis(knots, lower, at, x);
        let terms = values.iter().zip(&coefficients).take(lower + 1);
        *place = terms.map(|(v, c)| v * c).sum::<f64>() / factorial;
        // Coefficients of the derivative, which is a spline of one degree less.
        for k in 0..lower {
            let first = at - lower + k + 1;
            let slope =
                (coefficients[k + 1] - coefficients[k]) / (knots[first + lower] - knots[first]);
            coefficients[k] = lower as f64 * slope;
        }
        factorial *= (order + 1) as f64;
    }
    result
}
