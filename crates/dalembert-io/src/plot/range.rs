//! The range that an axis covers.

/// A range with `low < high`, both finite and not so far out that arithmetic on them overflows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    pub low: f64,
    pub high: f64,
}

/// Magnitudes beyond this one are drawn at the edge.
const LIMIT: f64 = 1e300;

/// A spread below this part of the values' size is rounding: the values count as constant.
const CONSTANT: f64 = 1e-12;

impl Range {
    /// The range of all finite values; `None` where there is none.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut range: Option<Self> = None;
        for value in values.into_iter().filter(|v| v.is_finite()) {
            let value = value.clamp(-LIMIT, LIMIT);
            let r = range.get_or_insert(Self {
                low: value,
                high: value,
            });
            r.low = r.low.min(value);
            r.high = r.high.max(value);
        }
        range
    }

    /// Widened where the values are constant: by a tenth of them, by 1 around zero.
    pub fn opened(self) -> Self {
        let size = self.low.abs().max(self.high.abs());
        if self.high - self.low > CONSTANT * size
            && self.high - self.low > f64::MIN_POSITIVE / CONSTANT
        {
            return self;
        }
        let half = if size < f64::MIN_POSITIVE / CONSTANT {
            1.0
        } else {
            0.1 * size
        };
        let middle = 0.5 * (self.low + self.high);
        Self {
            low: middle - half,
            high: middle + half,
        }
    }

    /// Widened at both ends by a part of its length.
    pub fn padded(self, part: f64) -> Self {
        let margin = part * self.length();
        Self {
            low: self.low - margin,
            high: self.high + margin,
        }
    }

    /// Widened about its middle to a length.
    pub fn widened_to(self, length: f64) -> Self {
        let margin = 0.5 * (length - self.length()).max(0.0);
        Self {
            low: self.low - margin,
            high: self.high + margin,
        }
    }

    /// Length of the range, positive.
    pub fn length(self) -> f64 {
        self.high - self.low
    }
}
