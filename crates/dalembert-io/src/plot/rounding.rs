//! Channels that hold nothing but rounding.

use dalembert::results::{Channel, Results};

/// A channel below this part of the largest one of its unit is rounding.
const RELATIVE: f64 = 1e-12;
/// A channel below this size (SI) is rounding.
const ABSOLUTE: f64 = 1e-13;

/// The channel as it is drawn: zero where it holds nothing but rounding beside the other channels
/// of its unit in the run. Channels that measure errors stay as they are.
pub fn rounding_as_zero(channel: &Channel, run: &Results) -> Channel {
    let mut drawn = channel.clone();
    if measures_error(&channel.name) {
        return drawn;
    }
    let scale = run
        .channels
        .iter()
        .filter(|other| other.unit == channel.unit)
        .map(largest)
        .fold(0.0, f64::max);
    if largest(channel) < ABSOLUTE.max(RELATIVE * scale) {
        for value in drawn.values.iter_mut().filter(|v| v.is_finite()) {
            *value = 0.0;
        }
    }
    drawn
}

/// The largest finite magnitude.
fn largest(channel: &Channel) -> f64 {
    let finite = channel.values.iter().filter(|v| v.is_finite());
    finite.fold(0.0, |a, v| a.max(v.abs()))
}

fn measures_error(name: &str) -> bool {
    name.starts_with("violation.") || name == "energy.balance"
}
