//! Interpolating splines as polynomials, piece by piece.

use super::SplineError;
use super::banded::{self, Banded};
use super::basis::{self, DEGREE};

/// Coefficients of (x - x_i)^0, (x - x_i)^1, ... on the piece from x_i to x_{i+1}.
pub(super) type Piece = [f64; DEGREE + 1];

/// Straight lines.
pub(super) fn linear(x: &[f64], y: &[f64]) -> Vec<Piece> {
    let pieces = x.windows(2).zip(y.windows(2)).map(|(x, y)| {
        let mut piece = [0.0; DEGREE + 1];
        piece[0] = y[0];
        piece[1] = (y[1] - y[0]) / (x[1] - x[0]);
        piece
    });
    pieces.collect()
}

/// The spline of an odd degree with all interior knots but the outermost (degree - 1)/2 ones on
/// either side ("not a knot"), so that a polynomial of that degree is reproduced.
pub(super) fn open(x: &[f64], y: &[f64], degree: usize) -> Result<Vec<Piece>, SplineError> {
    let n = x.len();
    if n <= degree + 1 {
        return Ok(polynomial(x, y));
    }
    let skipped = degree.div_ceil(2);
    let mut knots = vec![x[0]; degree + 1];
    knots.extend_from_slice(&x[skipped..n - skipped]);
    knots.extend(std::iter::repeat_n(x[n - 1], degree + 1));
    // The interval of knots that holds x; the last one holds the end too.
    let interval = |x: f64| (knots.partition_point(|k| *k <= x) - 1).min(n - 1);
    let mut matrix = Banded::new(n);
    for (row, &x) in x.iter().enumerate() {
        let at = interval(x);
        let values = basis::basis(&knots, degree, at, x);
        for (k, &value) in values.iter().take(degree + 1).enumerate() {
            // Outside of the band only zeros occur: a B-spline is not zero only between its
            // knots, which include at most `degree` points beside its own.
            if value != 0.0 && !matrix.set(row, at - degree + k, value) {
                return Err(SplineError::Unsolvable);
            }
        }
    }
    matrix.factor();
    let mut coefficients = y.to_vec();
    matrix.solve(&mut coefficients);
    let pieces = (0..n - 1).map(|i| {
        let at = interval(x[i]);
        let mut local = [0.0; DEGREE + 1];
        local[..=degree].copy_from_slice(&coefficients[at - degree..=at]);
        let mut piece = basis::taylor(&knots, degree, at, x[i], local);
        piece[0] = y[i];
        piece
    });
    Ok(pieces.collect())
}

/// The spline of an odd degree with a knot at every point, closed over the period.
pub(super) fn periodic(x: &[f64], y: &[f64], degree: usize) -> Vec<Piece> {
    let count = x.len() - 1;
    let period = x[count] - x[0];
    // Knots around the corner, `degree` beyond both ends: knot number i + degree is x_i.
    let knot = |i: isize| {
        let n = count as isize;
        x[i.rem_euclid(n) as usize] + i.div_euclid(n) as f64 * period
    };
    let wide = degree as isize;
    let knots: Vec<f64> = (-wide..=count as isize + wide).map(knot).collect();
    // At a knot the first `degree` of the B-splines of its interval are not zero.
    let half = (degree - 1) / 2;
    let rows: Vec<_> = (0..count)
        .map(|i| basis::basis(&knots, degree, i + degree, x[i]))
        .collect();
    // Unknown i belongs to the B-spline whose middle knot is x_i, number i + half: row i is then
    // centred on its diagonal.
    let centred = banded::solve_cyclic(half, |i, k| rows[i][k], &y[..count]);
    let pieces = (0..count).map(|i| {
        let local = std::array::from_fn(|k| match k <= degree {
            true => centred[(i + k + count - half) % count],
            false => 0.0,
        });
        let mut piece = basis::taylor(&knots, degree, i + degree, x[i], local);
        piece[0] = y[i];
        piece
    });
    pieces.collect()
}

/// The one polynomial through up to six points, expanded about every point.
fn polynomial(x: &[f64], y: &[f64]) -> Vec<Piece> {
    let n = x.len();
    // Newton's divided differences.
    let mut newton = y.to_vec();
    for order in 1..n {
        for i in (order..n).rev() {
            newton[i] = (newton[i] - newton[i - 1]) / (x[i] - x[i - order]);
        }
    }
    let pieces = (0..n - 1).map(|i| {
        // Horner's scheme on polynomials in (x - x_i).
        let mut piece = [0.0; DEGREE + 1];
        for k in (0..n).rev() {
            let shift = x[i] - x[k];
            for power in (1..=DEGREE).rev() {
                piece[power] = piece[power] * shift + piece[power - 1];
            }
            piece[0] = piece[0] * shift + newton[k];
        }
        piece[0] = y[i];
        piece
    });
    pieces.collect()
}
