//! Numbers as text that reads back exactly.

use std::fmt::Write;

/// Writes the shortest decimal text that reads back as exactly `value`, in `buffer` (cleared first); nothing for a gap.
pub(super) fn shortest(value: f64, buffer: &mut String) {
    buffer.clear();
    if value.is_nan() {
        return;
    }
    let magnitude = value.abs();
    // Both notations are the shortest digits; the exponent only replaces long rows of zeros.
    // Writing to a String cannot fail.
    let _ = if magnitude == 0.0 || (1e-5..1e16).contains(&magnitude) {
        write!(buffer, "{value}")
    } else {
        write!(buffer, "{value:e}")
    };
}
