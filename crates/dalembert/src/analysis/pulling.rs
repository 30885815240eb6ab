//! Contacts that would have to pull.

use crate::results::Results;

/// Pulls below this part of the largest push of a contact so far are rounding.
const ROUNDING: f64 = 1e-9;

/// Names the contacts of a run that would have to pull: they hold both ways, real surfaces part there.
pub(super) fn pulling(results: &Results) -> Vec<String> {
    let Some(time) = results.channel("time") else {
        return Vec::new();
    };
    let contacts = results.channels.iter().filter_map(|c| {
        let name = c.name.strip_suffix(".normal_force")?;
        let mut largest = 0.0_f64;
        let pulls = |(_, force): &(&f64, &f64)| {
            largest = largest.max(force.abs());
            **force < -ROUNDING * largest
        };
        let (t, force) = time.values.iter().zip(&c.values).find(pulls)?;
        Some(format!(
            "warning: from t = {t:.6} s on the contact '{name}' would have to pull (normal force {force:.3e} N): real \
             surfaces part there"
        ))
    });
    contacts.collect()
}
