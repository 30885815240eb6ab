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
        let mut roots: Vec<usize> = Vec::new();
        for body in 0..ground {
            let root = sets.root(body);
            if !roots.contains(&root) {
                roots.push(root);
            }
        }
        roots.sort_by_key(|root| *root != ground_root);
        roots
            .into_iter()
            .map(|root| {
                let mut part = Part {
                    bodies: Vec::new(),
                    grounded: root == ground_root,
                    forces: Vec::new(),
                };
                for (body, name) in self.bodies.iter().enumerate() {
                    if sets.root(body) == root {
                        part.bodies.push(name.clone());
                    }
                }
                for e in &self.edges {
                    if !matches!(e.source, EdgeSource::Force(_)) {
                        continue;
                    }
                    let (a, b) = (sets.root(node(e.tail)), sets.root(node(e.head)));
                    if a != b && (a == root || b == root) && !part.forces.contains(&e.component) {
                        part.forces.push(e.component.clone());
                    }
                }
                part
            })
            .collect()
    }
}
