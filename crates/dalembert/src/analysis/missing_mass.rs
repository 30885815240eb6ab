//! A note on bodies without mass: nothing loads a machine there.

use crate::space::Space;
use crate::system::System;
use crate::words::listed;

/// What a user must know of bodies without mass before trusting forces; `None` where all have some.
pub fn missing_mass<S: Space>(system: &System<S>) -> Option<String> {
    let without: Vec<&str> = system
        .bodies
        .iter()
        .enumerate()
        .filter(|(b, _)| system.mass_block(*b)[0] == 0.0)
        .map(|(_, body)| body.name.as_str())
        .collect();
    if without.is_empty() {
        return None;
    }
    Some(format!(
        "warning: no mass is given for {}: neither gravity nor inertia loads the machine there",
        listed(&without)
    ))
}
