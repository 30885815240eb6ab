//! Formulations: choices of a spanning tree.

use super::{Edge, EdgeClass};
use serde::Serialize;
use std::fmt;

/// A choice of spanning tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Formulation {
    /// Tree of inertia edges: absolute coordinates, all joints are chords (Shabana's augmented
    /// formulation).
    Absolute,
    /// Tree of joints: joint coordinates, joints in the cotree are the cuts of closed loops.
    Joint,
}

impl fmt::Display for Formulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Absolute => "absolute",
            Self::Joint => "joint",
        })
    }
}

impl Formulation {
    /// Rank of an edge in Kruskal's order: smaller goes into the tree first.
    pub(super) fn priority(self, edge: &Edge) -> (usize, usize) {
        use EdgeClass::{Anchor, Arm, Constraint, Driver, Force, Inertia, Joint, Spring};
        let order = match self {
            Self::Absolute => [
                Anchor, Inertia, Arm, Joint, Constraint, Spring, Driver, Force,
            ],
            Self::Joint => [
                Anchor, Arm, Joint, Inertia, Constraint, Spring, Driver, Force,
            ],
        };
        let place = order
            .iter()
            .position(|class| *class == edge.class)
            .unwrap_or(order.len());
        // Few freedoms first: fewest coordinates and fewest cut rows (least sum of 2 f - d).
        let freedoms = if edge.class == Joint {
            edge.freedoms
        } else {
            0
        };
        (place, freedoms)
    }
}

/// How large a formulation's equations are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct FormulationSize {
    /// The formulation.
    pub formulation: Formulation,
    /// Coordinates: freedoms of the tree edges, and auxiliary coordinates of cotree components.
    pub coordinates: usize,
    /// Constraint rows of the components in the cotree.
    pub rows: usize,
}
