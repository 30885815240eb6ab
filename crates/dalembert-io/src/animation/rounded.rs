//! Numbers rounded to seven significant digits, so that the page stays small.

use serde::ser::{SerializeSeq, Serializer};

/// Below this part of the largest number in its list, a number is rounding noise and written as 0.
const NOISE: f64 = 1e-12;

/// Rounds to seven significant digits.
fn round(value: f64) -> f64 {
    // The text of a finite number is a number; other values are refused before and pass unchanged.
    format!("{value:.6e}").parse().unwrap_or(value)
}

/// A rounded number that is written as an integer where it is one ("2", not "2.0").
struct Rounded(f64);

impl serde::Serialize for Rounded {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let value = round(self.0);
        if value.fract() == 0.0 && value.abs() < 1e9 {
            // Exact: an integer of this size fits.
            serializer.serialize_i64(value as i64)
        } else {
            serializer.serialize_f64(value)
        }
    }
}

/// Writes one number.
pub(super) fn number<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&Rounded(*value), serializer)
}

/// Writes a list of numbers.
pub(super) fn slice<S, A>(values: &A, serializer: S) -> Result<S::Ok, S::Error>
where
    S: Serializer,
    A: AsRef<[f64]>,
{
    let values = values.as_ref();
    let noise = NOISE * values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let mut list = serializer.serialize_seq(Some(values.len()))?;
    for value in values {
        let signal = if value.abs() <= noise { 0.0 } else { *value };
        list.serialize_element(&Rounded(signal))?;
    }
    list.end()
}

/// Writes a direction, or null.
pub(super) fn optional<S: Serializer>(
    values: &Option<[f64; 3]>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match values {
        Some(values) => slice(values, serializer),
        None => serializer.serialize_none(),
    }
}

/// Writes points of a plane.
pub(super) fn points<S: Serializer>(points: &[[f64; 2]], serializer: S) -> Result<S::Ok, S::Error> {
    let mut list = serializer.serialize_seq(Some(points.len()))?;
    for [x, y] in points {
        list.serialize_element(&[Rounded(*x), Rounded(*y)])?;
    }
    list.end()
}
