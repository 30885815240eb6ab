//! A row that says nothing new.

use crate::space::Space;
use crate::system::{Role, System};
use crate::words::listed;
use serde::Serialize;
use std::fmt;

/// A row of an element that follows from other elements.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Dependence {
    /// "joint", "constraint", "driver".
    pub role: &'static str,
    /// Name of the element.
    pub element: String,
    /// Kind of the element.
    pub kind: String,
    /// Label of the row.
    pub row: String,
    /// Names of the elements that it follows from; empty where the row has no gradient, or where
    /// the machine is too large to tell.
    pub depends_on: Vec<String>,
    /// Does the row act on nothing that can move?
    pub without_effect: bool,
}

impl Dependence {
    pub(super) fn new<S: Space>(
        system: &System<S>,
        row: usize,
        others: &[(usize, f64)],
        without_effect: bool,
    ) -> Self {
        let reference = &system.row_refs()[row];
        let e = &system.elements[reference.element];
        let mut depends_on: Vec<String> = Vec::new();
        for &(other, _) in others {
            let name = &system.elements[system.row_refs()[other].element].name;
            if *name != e.name && !depends_on.contains(name) {
                depends_on.push(name.clone());
            }
        }
        Self {
            role: role_name(e.role),
            element: e.name.clone(),
            kind: e.kind.clone(),
            row: reference.label.text.clone(),
            depends_on,
            without_effect,
        }
    }
}

/// The word for a role.
pub(super) fn role_name(role: Role) -> &'static str {
    match role {
        Role::Joint => "joint",
        Role::Constraint => "constraint",
        Role::Driver => "driver",
        Role::Start => "initial condition",
    }
}

impl fmt::Display for Dependence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} {} ({}): {}",
            self.role, self.element, self.kind, self.row
        )?;
        if self.without_effect {
            f.write_str(" acts on nothing that can move")
        } else if self.depends_on.is_empty() {
            f.write_str(" follows from the other rows")
        } else {
            write!(f, " follows from {}", listed(&self.depends_on))
        }
    }
}
