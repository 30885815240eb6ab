//! The graph in words.

use super::{EdgeClass, Network, SpanningTree};
use crate::words::counted;
use std::fmt::Write;

/// Words for a class of edges.
pub(super) fn class_name(class: EdgeClass) -> &'static str {
    match class {
        EdgeClass::Anchor => "anchor",
        EdgeClass::Inertia => "inertia",
        EdgeClass::Arm => "arm",
        EdgeClass::Joint => "joint",
        EdgeClass::Constraint => "constraint",
        EdgeClass::Driver => "driver",
        EdgeClass::Spring => "spring",
        EdgeClass::Force => "force",
    }
}

fn signed(sign: i8, first: bool) -> &'static str {
    match (sign > 0, first) {
        (true, true) => "",
        (true, false) => " + ",
        (false, true) => "-",
        (false, false) => " - ",
    }
}

impl Network {
    /// Vertices, edges, parts and loops in words.
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(
            out,
            "Linear graph of \"{}\": {}, {}",
            self.name,
            match self.vertices.len() {
                1 => "1 vertex".to_owned(),
                n => format!("{n} vertices"),
            },
            counted(self.edges.len(), "edge")
        );
        let width = self.edges.iter().map(|e| e.name.chars().count()).max();
        let width = width.unwrap_or(0);
        for e in &self.edges {
            let _ = writeln!(
                out,
                "  {:width$}  {:10}  {} -> {}  ({})",
                e.name,
                class_name(e.class),
                self.vertices[e.tail].name,
                self.vertices[e.head].name,
                e.kind
            );
        }
        for part in self.parts() {
            let state = match (part.grounded, part.forces.is_empty()) {
                (true, _) => "joined to the ground".to_owned(),
                (false, true) => "connected to nothing, floats freely".to_owned(),
                (false, false) => format!("held only by forces ({})", part.forces.join(", ")),
            };
            let _ = writeln!(out, "Part: {}: {state}", part.bodies.join(", "));
        }
        let loops = self.loops();
        let _ = writeln!(out, "Independent closed loops: {}", loops.len());
        for own in &loops {
            let _ = writeln!(out, "  {}", own.joints.join(" - "));
        }
        out
    }
}

impl SpanningTree {
    /// Tree, cut-sets, circuits and size in words.
    pub fn to_text(&self, network: &Network) -> String {
        let mut out = String::new();
        let name = |edge: usize| network.edges[edge].name.as_str();
        let size = self.size(network);
        // Writing to a String cannot fail.
        let _ = writeln!(
            out,
            "{} formulation: {}, {}",
            self.formulation,
            counted(size.coordinates, "coordinate"),
            counted(size.rows, "constraint row")
        );
        let list = |edges: &[usize]| {
            edges
                .iter()
                .map(|&e| name(e))
                .collect::<Vec<_>>()
                .join(", ")
        };
        let _ = writeln!(out, "Tree: {}", list(&self.branches));
        let _ = writeln!(out, "Cotree: {}", list(&self.chords));
        let _ = writeln!(out, "Cut-sets (through variables sum to zero):");
        for (&branch, cut) in self.branches.iter().zip(self.cut_sets()) {
            let _ = write!(out, "  y[{}]", name(branch));
            for (chord, sign) in cut {
                let _ = write!(
                    out,
                    "{}y[{}]",
                    signed(sign, false),
                    name(self.chords[chord])
                );
            }
            let _ = writeln!(out, " = 0");
        }
        let _ = writeln!(out, "Circuits (across variables):");
        for (position, &chord) in self.chords.iter().enumerate() {
            let path = self.circuit(position);
            let _ = write!(out, "  x[{}] = ", name(chord));
            for (k, &(branch, sign)) in path.iter().enumerate() {
                let _ = write!(
                    out,
                    "{}x[{}]",
                    signed(sign, k == 0),
                    name(self.branches[branch])
                );
            }
            let _ = writeln!(out, "{}", if path.is_empty() { "0" } else { "" });
        }
        out
    }
}
