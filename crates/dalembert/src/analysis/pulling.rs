//! Contacts that would have to pull.

use crate::joint::ConstraintInput;
use crate::space::Space;
use crate::system::{System, Workspace};

/// Pulls below this part of the largest push of a contact are rounding.
const ROUNDING: f64 = 1e-9;

/// Watches the contacts of a machine: they hold both ways, real surfaces part where they would have to pull.
#[derive(Clone, Debug, Default)]
pub(super) struct Pulling {
    contacts: Vec<Contact>,
}

/// What was seen of a contact.
#[derive(Clone, Debug)]
struct Contact {
    name: String,
    /// Its largest force so far.
    largest: f64,
    /// Time and force of the first pull.
    pull: Option<(f64, f64)>,
}

impl Pulling {
    /// Looks at the multipliers of the workspace at a time.
    pub fn look<S: Space>(&mut self, system: &System<S>, ws: &Workspace<S>, t: f64) {
        let forces = system.elements.iter().filter_map(|e| {
            let input = ConstraintInput {
                t,
                markers: &ws.seen(&e.markers),
                s: &ws.s[e.aux.clone()],
                s_rate: &ws.s_rate[e.aux.clone()],
            };
            let contact = e.element.contact(&input, &ws.lambda[e.rows.clone()])?;
            Some((e.name.as_str(), contact.normal))
        });
        for (k, (name, force)) in forces.enumerate() {
            if k == self.contacts.len() {
                self.contacts.push(Contact {
                    name: name.to_owned(),
                    largest: 0.0,
                    pull: None,
                });
            }
            let seen = &mut self.contacts[k];
            seen.largest = seen.largest.max(force.abs());
            if seen.pull.is_none() && force < -ROUNDING * seen.largest {
                seen.pull = Some((t, force));
            }
        }
    }

    /// What a user must know.
    pub fn notes(&self) -> Vec<String> {
        let pulls = self.contacts.iter().filter_map(|contact| {
            let (name, (t, force)) = (&contact.name, contact.pull?);
            Some(format!(
                "warning: from t = {t:.6} s on the contact '{name}' would have to pull (normal force {force:.3e} N): real \
                 surfaces part there"
            ))
        });
        pulls.collect()
    }
}
