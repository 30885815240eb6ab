//! Functions of one variable given by points.

mod banded;
mod basis;
mod error;
mod fit;

pub use error::SplineError;

use crate::{Function, Quantity};
use fit::Piece;

/// A piecewise polynomial through given points.
///
/// - [`Spline::linear`]: straight lines; the first derivative jumps at the points.
/// - [`Spline::cubic`]: two continuous derivatives; the end conditions are "not a knot", so that
///   every cubic polynomial is reproduced. Three points give the parabola through them.
/// - [`Spline::quintic`]: four continuous derivatives; the two outermost inner points on either
///   side are not knots, so that every quintic polynomial is reproduced.
///
/// A periodic table repeats itself; the cubic and the quintic one are smooth there too.
/// Beside the points of a table that is not periodic the value of the nearest end holds and the
/// derivatives are zero: the table says nothing there, and an extrapolated polynomial would run
/// away. A derivative that is not zero at an end therefore jumps there.
#[derive(Clone, Debug)]
pub struct Spline {
    x: Vec<f64>,
    pieces: Vec<Piece>,
    /// Value at the last point.
    last: f64,
    periodic: bool,
    dims: (Quantity, Quantity),
}

impl Spline {
    /// Straight lines through at least 2 points.
    pub fn linear(x: &[f64], y: &[f64], periodic: bool) -> Result<Self, SplineError> {
        Self::new(x, y, periodic, 2, |x, y| Ok(fit::linear(x, y)))
    }

    /// The cubic spline through at least 3 points, 4 where it is periodic.
    pub fn cubic(x: &[f64], y: &[f64], periodic: bool) -> Result<Self, SplineError> {
        if periodic {
            return Self::new(x, y, true, 4, |x, y| Ok(fit::periodic(x, y, 3)));
        }
        Self::new(x, y, false, 3, |x, y| fit::open(x, y, 3))
    }

    /// The quintic spline through at least 6 points.
    pub fn quintic(x: &[f64], y: &[f64], periodic: bool) -> Result<Self, SplineError> {
        Self::new(x, y, periodic, 6, |x, y| match periodic {
            true => Ok(fit::periodic(x, y, 5)),
            false => fit::open(x, y, 5),
        })
    }

    /// The same curve with the dimensions of its argument and its value.
    #[must_use]
    pub fn with_dims(mut self, argument: Quantity, value: Quantity) -> Self {
        self.dims = (argument, value);
        self
    }

    /// First and last argument.
    pub fn range(&self) -> (f64, f64) {
        (self.x[0], self.x[self.x.len() - 1])
    }

    /// Does it repeat?
    pub fn is_periodic(&self) -> bool {
        self.periodic
    }

    fn new(
        x: &[f64],
        y: &[f64],
        periodic: bool,
        least: usize,
        fit: impl Fn(&[f64], &[f64]) -> Result<Vec<Piece>, SplineError>,
    ) -> Result<Self, SplineError> {
        check(x, y, periodic, least)?;
        let pieces = fit(x, y)?;
        if pieces.iter().flatten().any(|c| !c.is_finite()) {
            return Err(SplineError::Unsolvable);
        }
        Ok(Self {
            x: x.to_vec(),
            pieces,
            last: y[y.len() - 1],
            periodic,
            dims: (Quantity::Free, Quantity::Free),
        })
    }

    /// The argument within one period.
    fn wrap(&self, x: f64) -> f64 {
        let (first, last) = self.range();
        if !self.periodic || (first..last).contains(&x) {
            return x;
        }
        let period = last - first;
        let wrapped = x - period * ((x - first) / period).floor();
        // Rounding can lead to either end.
        wrapped.clamp(first, last)
    }
}

impl Function for Spline {
    fn jet(&self, x: f64) -> [f64; 4] {
        if !x.is_finite() {
            return [f64::NAN; 4];
        }
        let x = self.wrap(x);
        let (first, last) = self.range();
        if x < first {
            return [self.pieces[0][0], 0.0, 0.0, 0.0];
        }
        if x > last {
            return [self.last, 0.0, 0.0, 0.0];
        }
        let above = self.x.partition_point(|knot| *knot <= x);
        let piece = (above - 1).min(self.pieces.len() - 1);
        let [c0, c1, c2, c3, c4, c5] = self.pieces[piece];
        let h = x - self.x[piece];
        [
            c0 + h * (c1 + h * (c2 + h * (c3 + h * (c4 + h * c5)))),
            c1 + h * (2.0 * c2 + h * (3.0 * c3 + h * (4.0 * c4 + h * 5.0 * c5))),
            2.0 * c2 + h * (6.0 * c3 + h * (12.0 * c4 + h * 20.0 * c5)),
            6.0 * c3 + h * (24.0 * c4 + h * 60.0 * c5),
        ]
    }

    fn dims(&self) -> (Quantity, Quantity) {
        self.dims
    }
}

/// A periodic table must close to this part of its largest value.
const CLOSED: f64 = 1e-12;

fn check(x: &[f64], y: &[f64], periodic: bool, least: usize) -> Result<(), SplineError> {
    let (x_count, y_count) = (x.len(), y.len());
    if x_count != y_count {
        return Err(SplineError::Lengths {
            x: x_count,
            y: y_count,
        });
    }
    if x_count < least {
        return Err(SplineError::TooFew {
            given: x_count,
            least,
        });
    }
    let bad = |i: &usize| !(x[*i].is_finite() && y[*i].is_finite());
    if let Some(i) = (0..x_count).find(bad) {
        return Err(SplineError::NotFinite { point: i + 1 });
    }
    if let Some(i) = (1..x_count).find(|i| x[*i] <= x[i - 1]) {
        return Err(SplineError::NotIncreasing { point: i + 1 });
    }
    let (first, last) = (y[0], y[y_count - 1]);
    let largest = y.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    if periodic && (last - first).abs() > CLOSED * largest {
        return Err(SplineError::NotPeriodic { first, last });
    }
    Ok(())
}
