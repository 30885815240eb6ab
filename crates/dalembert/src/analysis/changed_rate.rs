//! A rate that could not stay as it was stated.

use std::fmt;

/// A rate at the start that the constraints, the drivers or other rates do not allow.
#[derive(Clone, Debug, PartialEq)]
pub struct ChangedRate {
    /// What was stated: "the initial rate of A.angle", "the velocity of rod (centre of mass)".
    pub what: String,
    /// As it was stated, by components, in SI units.
    pub stated: Vec<f64>,
    /// As it is.
    pub found: Vec<f64>,
    /// "m/s", "rad/s"; empty for others.
    pub unit: &'static str,
}

/// Six digits; rounding beside the larger of two values is zero.
fn components(values: &[f64], least: f64) -> String {
    let number = |x: &f64| {
        let digits = format!("{:.5e}", if x.abs() <= least { 0.0 } else { *x });
        // Written and read once more, the shortest form of these digits appears.
        digits
            .parse::<f64>()
            .map_or(digits, |short| format!("{short}"))
    };
    match values {
        [one] => number(one),
        _ => {
            let list: Vec<String> = values.iter().map(number).collect();
            format!("({})", list.join(", "))
        }
    }
}

impl ChangedRate {
    /// What was stated, and what there is instead.
    fn instead(&self, instead: &str) -> String {
        let all = self.stated.iter().chain(&self.found);
        let least = 1e-9 * all.fold(0.0_f64, |m, x| m.max(x.abs()));
        let unit = if self.unit.is_empty() { "" } else { " " };
        format!(
            "{} cannot hold: stated {}{unit}{}, {instead} {}{unit}{}",
            self.what,
            components(&self.stated, least),
            self.unit,
            components(&self.found, least),
            self.unit
        )
    }

    /// In words, for a rate that must hold.
    pub(super) fn conflict(&self) -> String {
        self.instead("the nearest that fits the others is")
    }
}

impl fmt::Display for ChangedRate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.instead("changed to"))
    }
}
