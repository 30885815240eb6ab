//! Connected parts of a machine.

use super::union_find::UnionFind;
use super::{EdgeClass, EdgeSource, Network};
use serde::Serialize;

/// Bodies that joints, constraints and drivers connect with each other.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Part {
    /// Names of its bodies.
    pub bodies: Vec<String>,
    /// Is it connected with the ground by joints, constraints or drivers?
    pub grounded: bool,
    /// Names of the force elements between it and the ground or other parts.
    pub forces: Vec<String>,
}

impl Part {
    /// Is it connected to nothing at all?
    pub fn unconnected(&self) -> bool {
        !self.grounded && self.forces.is_empty()
    }
}

impl Network {
    /// The parts that would move apart if only joints, constraints and drivers held them; the part
    /// with the ground first.
    pub fn parts(&self) -> Vec<Part> {
        let ground = self.bodies.len();
        let node = |vertex: usize| self.vertices[vertex].body.unwrap_or(ground);
        let mut sets = UnionFind::new(ground + 1);
        for e in &self.edges {
            if matches!(
                e.class,
                EdgeClass::Joint | EdgeClass::Constraint | EdgeClass::Driver
            ) {
                sets.join(node(e.tail), node(e.head));
            }
        }
        let ground_root = sets.root(ground);
        let mut number: Vec<Option<usize>> = vec![None; ground + 1];
        let mut parts: Vec<Part> = Vec::new();
        let own: Vec<usize> = (0..=ground).map(|n| sets.root(n)).collect();
        for (body, name) in self.bodies.iter().enumerate() {
            let part = *number[own[body]].get_or_insert_with(|| {
                parts.push(Part {
                    bodies: Vec::new(),
                    grounded: own[body] == ground_root,
                    forces: Vec::new(),
                });
                parts.len() - 1
            });
            parts[part].bodies.push(name.clone());
        }
        for e in &self.edges {
            let (a, b) = (own[node(e.tail)], own[node(e.head)]);
            if !matches!(e.source, EdgeSource::Force(_)) || a == b {
                continue;
            }
            for part in [a, b].into_iter().filter_map(|root| number[root]) {
                if !parts[part].forces.contains(&e.component) {
                    parts[part].forces.push(e.component.clone());
                }
            }
        }
        parts.sort_by_key(|part| !part.grounded);
        parts
    }
}
