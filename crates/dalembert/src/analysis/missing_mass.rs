//! A note on bodies without mass: nothing loads a machine there.

use crate::space::Space;
use crate::system::System;
use crate::words::listed;

/// What a user must know of bodies without mass before trusting forces; `None` where all have some.
///
/// A body with moments of inertia alone is an approximation in use (the first link of a robot); it is told too,
/// with what does load the machine.
pub fn missing_mass<S: Space>(system: &System<S>) -> Option<String> {
    let without = || (0..system.bodies.len()).filter(|&b| system.mass_block(b)[0] == 0.0);
    let inert = |&b: &usize| system.mass_block(b).iter().any(|&entry| entry != 0.0);
    let names = |bodies: Vec<usize>| {
        let names: Vec<&str> = bodies
            .iter()
            .map(|&b| system.bodies[b].name.as_str())
            .collect();
        listed(&names)
    };
    let empty: Vec<usize> = without().filter(|b| !inert(b)).collect();
    let turning: Vec<usize> = without().filter(inert).collect();
    let mut parts = Vec::new();
    if !empty.is_empty() {
        parts.push(format!(
            "no mass is given for {}: neither gravity nor inertia loads the machine there",
            names(empty)
        ));
    }
    if !turning.is_empty() {
        parts.push(format!(
            "no mass is given for {}: only the moments of inertia load the machine there",
            names(turning)
        ));
    }
    (!parts.is_empty()).then(|| format!("warning: {}", parts.join("; ")))
}
