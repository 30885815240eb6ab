//! The graph as a drawing in the DOT language.

use super::{EdgeClass, Network, SpanningTree, VertexKind};
use std::fmt::Write;

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

impl Network {
    /// The graph in the DOT language; bodies are boxes of their frames. Edges of the tree, where one
    /// is given, are thick, chords are dashed.
    pub fn to_dot(&self, tree: Option<&SpanningTree>) -> String {
        let mut out = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(out, "digraph {} {{", quoted(&self.name));
        let _ = writeln!(out, "  node [shape=circle, fontsize=10];");
        for (number, body) in self.bodies.iter().enumerate() {
            let _ = writeln!(out, "  subgraph \"cluster_{number}\" {{");
            let _ = writeln!(out, "    label={};", quoted(body));
            for (k, v) in self.vertices.iter().enumerate() {
                if v.body == Some(number) {
                    let _ = writeln!(out, "    v{k} [label={}];", quoted(&v.name));
                }
            }
            let _ = writeln!(out, "  }}");
        }
        for (k, v) in self.vertices.iter().enumerate() {
            if v.body.is_none() {
                let shape = if v.kind == VertexKind::Origin {
                    ", shape=doublecircle"
                } else {
                    ""
                };
                let _ = writeln!(out, "  v{k} [label={}{shape}];", quoted(&v.name));
            }
        }
        for (number, e) in self.edges.iter().enumerate() {
            let label = match e.class {
                EdgeClass::Arm | EdgeClass::Anchor | EdgeClass::Inertia => String::new(),
                _ => e.name.clone(),
            };
            let style = match tree {
                Some(t) if t.branches.contains(&number) => ", penwidth=3",
                Some(_) => ", style=dashed",
                None => "",
            };
            let _ = writeln!(
                out,
                "  v{} -> v{} [label={}, color={}{style}];",
                e.tail,
                e.head,
                quoted(&label),
                color(e.class)
            );
        }
        out.push_str("}\n");
        out
    }
}

fn color(class: EdgeClass) -> &'static str {
    match class {
        EdgeClass::Anchor | EdgeClass::Arm => "gray",
        EdgeClass::Inertia => "black",
        EdgeClass::Joint => "blue",
        EdgeClass::Constraint => "purple",
        EdgeClass::Driver => "red",
        EdgeClass::Spring => "darkgreen",
        EdgeClass::Force => "orange",
    }
}
