//! An axis: a range of values laid on a stretch of pixels.

use super::range::Range;
use super::ticks::Ticks;

/// An axis; `from` is the pixel of the low end, `to` that of the high end.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    pub range: Range,
    pub from: f64,
    pub to: f64,
    pub ticks: Ticks,
}

impl Axis {
    /// An axis with about one tick every `spacing` pixels.
    pub fn new(range: Range, from: f64, to: f64, spacing: f64) -> Self {
        let ticks = Ticks::new(range, (to - from).abs() / spacing);
        Self {
            range,
            from,
            to,
            ticks,
        }
    }

    /// Pixel of a finite value.
    pub fn pixel(&self, value: f64) -> f64 {
        let part = (value - self.range.low) / self.range.length();
        // Clamped so that a value far outside makes no number that drawing programs reject.
        self.from + part.clamp(-1.0, 2.0) * (self.to - self.from)
    }

    /// Is a value inside the range?
    pub fn holds(&self, value: f64) -> bool {
        (self.range.low..=self.range.high).contains(&value)
    }
}
