//! Quantities that a run keeps.

use crate::results::{Channel, Results};

/// Part of its size to which a quantity that stays is kept: better than the default tolerance leaves, far above rounding.
const KEPT: f64 = 1e-6;
/// Changes below this part of the size are rounding.
const ROUNDING: f64 = 1e-14;

/// Names the momenta and energies that stayed as they were over a run, with the largest change relative to their size;
/// none where the run has no such quantity.
pub(super) fn conserved(results: &Results) -> Option<String> {
    let energy = results.channel("energy.total").into_iter();
    let names = [
        "x",
        "y",
        "z",
        "angular",
        "angular_x",
        "angular_y",
        "angular_z",
    ];
    let momenta: Vec<&Channel> = names
        .iter()
        .filter_map(|n| results.channel(&format!("momentum.{n}")))
        .collect();
    let largest = |c: &Channel| c.values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    // A component counts beside the whole vector: one that is zero within rounding says nothing.
    let size = |c: &Channel| -> f64 {
        let angular = c.name.contains("angular");
        let family = momenta
            .iter()
            .filter(|m| m.name.contains("angular") == angular);
        family.map(|m| largest(m)).fold(0.0, f64::max)
    };
    let kept = |c: &Channel, size: f64| -> Option<f64> {
        let first = *c.values.first()?;
        let change = c
            .values
            .iter()
            .fold(0.0_f64, |m, x| m.max((x - first).abs()));
        (first.abs() > KEPT * size && change <= KEPT * size).then(|| change / size)
    };
    let mut names = Vec::new();
    let mut worst = 0.0_f64;
    for c in energy {
        if let Some(change) = kept(c, largest(c)) {
            names.push(c.name.as_str());
            worst = worst.max(change);
        }
    }
    for c in &momenta {
        if let Some(change) = kept(c, size(c)) {
            names.push(c.name.as_str());
            worst = worst.max(change);
        }
    }
    (!names.is_empty() && results.len() > 2).then(|| {
        let how = if worst < ROUNDING {
            "to rounding".to_owned()
        } else {
            format!("to {worst:.1e} of their size")
        };
        format!("conserved {how}: {}", names.join(", "))
    })
}
