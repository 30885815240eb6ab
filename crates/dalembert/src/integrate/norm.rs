//! Norms of states in units of their scales.

/// The largest of `x / scales`; NaN if any is.
pub(super) fn norm(x: &[f64], scales: &[f64]) -> f64 {
    largest(x.iter().zip(scales).map(|(x, s)| x / s))
}

/// The largest size; NaN if any is.
pub(super) fn largest(x: impl Iterator<Item = f64>) -> f64 {
    x.fold(0.0, |most: f64, x| {
        let x = x.abs();
        if x > most || x.is_nan() { x } else { most }
    })
}

/// y += a x
pub(super) fn axpy(a: f64, x: &[f64], y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}
