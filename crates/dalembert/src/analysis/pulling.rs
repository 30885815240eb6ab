//! Contacts that would have to pull.

use crate::results::Results;
use crate::space::{Space, norm};
use crate::system::System;

/// Pulls below this part of the largest push of a contact so far are rounding.
const ROUNDING: f64 = 1e-9;
/// Pulls below this part of the largest force in the machine are rounding.
const IN_PLAY: f64 = 1e-12;

/// The force below which a pull is rounding: as the weights, the forces that act, and what moves the bodies, their kinetic
/// energy over the size of the machine [N].
fn floor<S: Space>(system: &System<S>, results: &Results) -> f64 {
    let gravity = norm(&system.gravity);
    let mass = |b: usize| system.mass[b * S::NV * S::NV];
    let weights = (0..system.bodies.len()).map(|b| mass(b) * gravity);
    let forces = results.channels.iter().filter(|c| c.unit == "N");
    let forces = forces.flat_map(|c| c.values.iter().map(|x| x.abs()));
    let kinetic = results.channel("energy.kinetic").into_iter();
    let kinetic = kinetic.flat_map(|c| c.values.iter().map(|x| x / system.size));
    let all = weights.chain(forces).chain(kinetic);
    // A value that is none has no part in it.
    IN_PLAY * all.fold(0.0, f64::max)
}

/// Normal forces of the contacts that hold both ways although their surfaces would part.
fn forces<'a, S: Space>(
    system: &'a System<S>,
    results: &'a Results,
) -> impl Iterator<Item = (&'a str, &'a [f64])> {
    let parting = system
        .elements
        .iter()
        .filter(|e| !e.element.holds_both_ways());
    parting.filter_map(|e| {
        let force = results.channel(&format!("{}.normal_force", e.name))?;
        Some((e.name.as_str(), &force.values[..]))
    })
}

/// Names the contacts of a run that would have to pull: they hold both ways, real surfaces part there.
pub(super) fn pulling<S: Space>(system: &System<S>, results: &Results) -> Vec<String> {
    let Some(time) = results.channel("time") else {
        return Vec::new();
    };
    let floor = floor(system, results);
    let contacts = forces(system, results).filter_map(|(name, force)| {
        let k = first_pull(force, floor)?;
        let (t, force) = (time.values.get(k)?, force[k]);
        Some(format!(
            "warning: from t = {t:.6} s on the contact '{name}' would have to pull (normal force {force:.3e} N): real \
             surfaces part there"
        ))
    });
    contacts.collect()
}

/// The same for poses at rest: the instants are equilibria.
pub(super) fn pulling_at_rest<S: Space>(system: &System<S>, results: &Results) -> Vec<String> {
    let all: Vec<(&str, &[f64])> = forces(system, results).collect();
    let (count, floor) = (results.len(), floor(system, results));
    let mut notes = Vec::new();
    for k in 0..count {
        for (name, force) in &all {
            let largest = force.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
            if force[k] < -(ROUNDING * largest).max(floor) {
                notes.push(format!(
                    "warning: at equilibrium {} the contact '{name}' would have to pull (normal force {:.3e} N): real surfaces \
                     part there",
                    k + 1,
                    force[k]
                ));
            }
        }
    }
    notes
}

fn first_pull(force: &[f64], floor: f64) -> Option<usize> {
    let mut largest = 0.0_f64;
    force.iter().position(|force| {
        largest = largest.max(force.abs());
        *force < -(ROUNDING * largest).max(floor)
    })
}
