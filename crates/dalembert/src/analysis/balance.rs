//! Runs whose energies do not add up.

use crate::results::Results;
use crate::words::readable;

/// Part of the energies in play that a run may lose unseen: far above what any sensible tolerance leaves.
const VISIBLE: f64 = 1e-3;

/// A warning where the energy balance of a run is off by a visible part of the energies in play.
pub(super) fn unbalanced(results: &Results) -> Option<String> {
    let values = |name: &str| Some(&results.channel(name)?.values);
    let largest = |list: &[f64]| list.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let (balance, time) = (values("energy.balance")?, values("time")?);
    let potential = values("energy.potential")?;
    let first = potential.first()?;
    let moved = potential.iter().map(|x| x - first).collect::<Vec<f64>>();
    let own = largest(values("energy.kinetic")?) + largest(&moved);
    if own == 0.0 {
        // Massless machines have no energies that could be lost: their work goes from driver to load.
        return None;
    }
    let scale = own + largest(values("energy.work")?);
    let worst = largest(balance);
    let from = balance.iter().position(|x| x.abs() > VISIBLE * scale)?;
    Some(format!(
        "warning: the energies do not add up: the balance is off by {} J, {} % of the energies in play, from t = {} s on; \
         look for a singular pose or a jump near there, and repeat the run with a smaller tolerance",
        readable(worst),
        readable(100.0 * worst / scale),
        readable(*time.get(from)?)
    ))
}
