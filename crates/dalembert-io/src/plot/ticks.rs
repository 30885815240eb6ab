//! Ticks at steps of 1, 2 or 5 times a power of ten, and their labels.

use super::range::Range;

/// Ticks of an axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ticks {
    /// Value and label, ascending.
    pub marks: Vec<(f64, String)>,
    /// Labels are to be multiplied by ten to this power; 0 for none.
    pub exponent: i32,
    /// Text of a number that is to be added to the labels, where the range is far from zero.
    pub offset: Option<String>,
}

/// Labels with more significant digits than this get an offset.
const MAX_DIGITS: i32 = 6;

impl Ticks {
    /// Ticks inside a range, about `wanted` of them.
    pub fn new(range: Range, wanted: f64) -> Self {
        let (mantissa, power) = step(range.length() / wanted.max(1.0));
        let ten = 10f64.powi(power);
        let step = mantissa * ten;
        let size = range.low.abs().max(range.high.abs());

        // Far from zero labels differ only in their last digits: count from a round number then.
        let digits = decade(size) - power + 1;
        let base = if digits > MAX_DIGITS {
            let round = 10f64.powi(decade(range.length()) + 1);
            ((0.5 * (range.low + range.high)) / round).round() * round
        } else {
            0.0
        };
        let shown = (range.low - base).abs().max((range.high - base).abs());
        let exponent = exponent(shown);
        // With an exponent of 3 the step 200 is shown as 0.2: one decimal.
        let decimals = usize::try_from(exponent - power).unwrap_or(0);

        let first = ((range.low - base) / step - 1e-9).ceil();
        let last = ((range.high - base) / step + 1e-9).floor();
        // The number of ticks is about `wanted`; whole multiples of the step carry no rounding noise.
        let count = (last - first).clamp(0.0, 1000.0) as usize;
        let marks = (0..=count)
            .map(|k| {
                let multiple = first + k as f64;
                let shown = multiple * mantissa * 10f64.powi(power - exponent);
                (base + multiple * step, fixed(shown, decimals))
            })
            .collect();
        let offset = (base != 0.0).then(|| {
            let decimals = usize::try_from(-(decade(range.length()) + 1)).unwrap_or(0);
            if base.abs() >= 1e7 {
                format!("{base:e}")
            } else {
                let text = fixed(base, decimals);
                if text.contains('.') {
                    text.trim_end_matches('0').trim_end_matches('.').to_owned()
                } else {
                    text
                }
            }
        });
        Self {
            marks,
            exponent,
            offset,
        }
    }
}

/// The 1, 2 or 5 times a power of ten that is nearest to `rough` by ratio, and that power.
fn step(rough: f64) -> (f64, i32) {
    let power = decade(rough);
    let mantissa = rough / 10f64.powi(power);
    // The bounds are the geometric means of neighbours: sqrt(1*2), sqrt(2*5), sqrt(5*10).
    if mantissa < 2f64.sqrt() {
        (1.0, power)
    } else if mantissa < 10f64.sqrt() {
        (2.0, power)
    } else if mantissa < 50f64.sqrt() {
        (5.0, power)
    } else {
        (1.0, power + 1)
    }
}

/// Power of ten of the first digit.
fn decade(value: f64) -> i32 {
    if value > 0.0 && value.is_finite() {
        // Within +-324: fits.
        value.log10().floor() as i32
    } else {
        0
    }
}

/// The multiple of three to take out of numbers up to `size`: none between 0.01 and 99999.
fn exponent(size: f64) -> i32 {
    let decade = decade(size);
    if (-2..=4).contains(&decade) {
        0
    } else {
        3 * decade.div_euclid(3)
    }
}

/// A number with fixed decimals and a true minus sign; never "-0".
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| c == '0' || c == '.') => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}
