//! Spanning trees with their fundamental cut-sets and circuits.

use super::union_find::UnionFind;
use super::{Formulation, FormulationSize, Network, NetworkError, TerminalGraph};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// A spanning tree (a forest where the graph is not connected) and what follows from it.
///
/// With the incidence matrix split into branches and chords, A = [A_b A_ch], the matrix
/// A_c = A_b^-1 A_ch has entries 0, +1, -1. Cut-sets: y_b + A_c y_c = 0. Circuits:
/// x_c - A_c^T x_b = 0.
///
/// Written as data: formulation, branches, chords, and the circuit of each chord.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpanningTree {
    /// The formulation.
    pub formulation: Formulation,
    /// Edges in the tree.
    pub branches: Vec<usize>,
    /// Edges in the cotree.
    pub chords: Vec<usize>,
    /// The ends of each chord, tail and head.
    ends: Vec<(usize, usize)>,
    ascent: Ascent,
}

impl SpanningTree {
    /// The tree that Kruskal's rule finds when edges are taken in the order of a formulation.
    ///
    /// # Errors
    /// The joint formulation needs the terminal graph with arms.
    pub fn new(network: &Network, formulation: Formulation) -> Result<Self, NetworkError> {
        if formulation == Formulation::Joint && network.terminals != TerminalGraph::Arms {
            return Err(NetworkError::NeedsArms { formulation });
        }
        let mut order: Vec<usize> = (0..network.edges.len()).collect();
        order.sort_by_key(|&e| formulation.priority(&network.edges[e]));
        Ok(Self::from_order(network, formulation, &order))
    }

    /// The tree of the edges taken in an order; edges that are left out belong to nothing.
    pub(super) fn from_order(network: &Network, formulation: Formulation, order: &[usize]) -> Self {
        let mut sets = UnionFind::new(network.vertices.len());
        let (mut branches, mut chords) = (Vec::new(), Vec::new());
        for &number in order {
            let e = &network.edges[number];
            if sets.join(e.tail, e.head) {
                branches.push(number);
            } else {
                chords.push(number);
            }
        }
        chords.sort_unstable();
        Self {
            formulation,
            ascent: Ascent::new(network, &branches),
            ends: chords
                .iter()
                .map(|&c| (network.edges[c].tail, network.edges[c].head))
                .collect(),
            branches,
            chords,
        }
    }

    /// The circuit of a chord (a position in `chords`): branches (positions in `branches`) with
    /// their entries in A_c, ascending.
    pub fn circuit(&self, chord: usize) -> Vec<(usize, i8)> {
        let (tail, head) = self.ends[chord];
        self.ascent.path(tail, head)
    }

    /// The cut-set of each branch: chords (positions in `chords`) with their entries in A_c.
    pub fn cut_sets(&self) -> Vec<Vec<(usize, i8)>> {
        let mut sets = vec![Vec::new(); self.branches.len()];
        for chord in 0..self.chords.len() {
            for (branch, sign) in self.circuit(chord) {
                sets[branch].push((chord, sign));
            }
        }
        sets
    }

    /// A_c, branches x chords.
    pub fn cut_set_matrix(&self) -> Vec<Vec<i8>> {
        let mut a = vec![vec![0; self.chords.len()]; self.branches.len()];
        for (row, cut) in a.iter_mut().zip(self.cut_sets()) {
            for (chord, sign) in cut {
                row[chord] = sign;
            }
        }
        a
    }

    /// Circuit matrix [-A_c^T I], chords x edges of the network.
    pub fn circuit_matrix(&self, network: &Network) -> Vec<Vec<i8>> {
        let mut b = vec![vec![0; network.edges.len()]; self.chords.len()];
        for chord in 0..self.chords.len() {
            b[chord][self.chords[chord]] = 1;
            for (branch, sign) in self.circuit(chord) {
                b[chord][self.branches[branch]] = -sign;
            }
        }
        b
    }

    /// Coordinates and constraint rows of the formulation.
    ///
    /// n = sum of the freedoms of the tree edges (+ auxiliaries of cotree components), m = rows of
    /// the components in the cotree; n - m is the same for every tree.
    pub fn size(&self, network: &Network) -> FormulationSize {
        let mut coordinates: usize = self
            .branches
            .iter()
            .map(|&b| network.edges[b].freedoms)
            .sum();
        let mut rows = 0;
        let mut in_tree = vec![false; network.edges.len()];
        for &b in &self.branches {
            in_tree[b] = true;
        }
        for (number, edges) in network.element_edges.iter().enumerate() {
            if !edges.is_empty() && !edges.iter().any(|&e| in_tree[e]) {
                coordinates += network.element_aux[number];
                rows += network.element_rows[number];
            }
        }
        FormulationSize {
            formulation: self.formulation,
            coordinates,
            rows,
        }
    }
}

impl Serialize for SpanningTree {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let circuits: Vec<_> = (0..self.chords.len()).map(|c| self.circuit(c)).collect();
        let mut out = serializer.serialize_struct("SpanningTree", 4)?;
        out.serialize_field("formulation", &self.formulation)?;
        out.serialize_field("branches", &self.branches)?;
        out.serialize_field("chords", &self.chords)?;
        out.serialize_field("circuits", &circuits)?;
        out.end()
    }
}

/// The tree as a way up from every vertex.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Ascent {
    /// Parent vertex, position of the edge in `branches`, +1 where the edge points up.
    up: Vec<Option<(usize, usize, i8)>>,
    depth: Vec<usize>,
}

impl Ascent {
    fn new(network: &Network, branches: &[usize]) -> Self {
        let count = network.vertices.len();
        let mut neighbours: Vec<Vec<(usize, usize, i8)>> = vec![Vec::new(); count];
        for (position, &b) in branches.iter().enumerate() {
            let e = &network.edges[b];
            neighbours[e.tail].push((e.head, position, -1));
            neighbours[e.head].push((e.tail, position, 1));
        }
        let mut ascent = Self {
            up: vec![None; count],
            depth: vec![0; count],
        };
        let mut seen = vec![false; count];
        for root in 0..count {
            if std::mem::replace(&mut seen[root], true) {
                continue;
            }
            let mut stack = vec![root];
            while let Some(v) = stack.pop() {
                for &(next, position, sign) in &neighbours[v] {
                    if !std::mem::replace(&mut seen[next], true) {
                        ascent.up[next] = Some((v, position, sign));
                        ascent.depth[next] = ascent.depth[v] + 1;
                        stack.push(next);
                    }
                }
            }
        }
        ascent
    }

    /// Branches on the way from one vertex to another, +1 where they are passed tail to head.
    fn path(&self, mut from: usize, mut to: usize) -> Vec<(usize, i8)> {
        let mut path = Vec::new();
        while from != to {
            let down = self.depth[to] > self.depth[from];
            let (vertex, turn) = if down { (&mut to, -1) } else { (&mut from, 1) };
            // The ends of a chord hang in the same tree, so both ways up meet.
            let Some((parent, position, sign)) = self.up[*vertex] else {
                break;
            };
            path.push((position, turn * sign));
            *vertex = parent;
        }
        path.sort_unstable_by_key(|(position, _)| *position);
        path
    }
}
