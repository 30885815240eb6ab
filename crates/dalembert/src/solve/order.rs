//! Elimination order and fill of the graph of elements that share a body.

use super::pattern::Pattern;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

/// The symbolic factorization: elements in elimination order and the block columns of the factor.
#[derive(Clone, Debug)]
pub(super) struct Elimination {
    /// Position -> element.
    pub element: Vec<usize>,
    /// Element -> position.
    pub position: Vec<usize>,
    /// Position -> start of its column in `below`, with one entry more at the end.
    pub start: Vec<usize>,
    /// Later positions that have a block in each column, ascending within the column.
    pub below: Vec<usize>,
}

impl Elimination {
    /// Orders the elements of a pattern for little fill (approximate minimum degree) and finds the fill.
    pub fn new(pattern: &Pattern) -> Self {
        let neighbours = neighbours(pattern);
        let element = minimum_degree(&neighbours);
        let n = element.len();
        let mut position = vec![0; n];
        for (at, &e) in element.iter().enumerate() {
            position[e] = at;
        }
        // The column of a position is what its own element and its children in the elimination tree reach.
        let mut columns: Vec<Vec<usize>> = Vec::with_capacity(n);
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); n];
        let mut seen = vec![usize::MAX; n];
        for at in 0..n {
            let mut column = Vec::new();
            let own = neighbours[element[at]].iter().map(|&e| position[e]);
            let inherited = children[at]
                .iter()
                .flat_map(|&child: &usize| columns[child].iter().copied());
            for row in own.chain(inherited) {
                if row > at && seen[row] != at {
                    seen[row] = at;
                    column.push(row);
                }
            }
            column.sort_unstable();
            if let Some(&parent) = column.first() {
                children[parent].push(at);
            }
            columns.push(column);
        }
        let mut start = Vec::with_capacity(n + 1);
        start.push(0);
        let mut below = Vec::new();
        for column in &columns {
            below.extend_from_slice(column);
            start.push(below.len());
        }
        Self {
            element,
            position,
            start,
            below,
        }
    }
}

/// For each element the others that share a body with it, ascending.
fn neighbours(pattern: &Pattern) -> Vec<Vec<usize>> {
    let mut on_body: Vec<Vec<usize>> = vec![Vec::new(); pattern.shape().bodies];
    for block in &pattern.incidences {
        on_body[block.body].push(block.element);
    }
    let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); pattern.elements()];
    for block in &pattern.incidences {
        neighbours[block.element]
            .extend(on_body[block.body].iter().filter(|&&e| e != block.element));
    }
    for list in &mut neighbours {
        list.sort_unstable();
        list.dedup();
    }
    neighbours
}

/// Approximate minimum degree order; the given order where it cannot be found.
fn minimum_degree(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let n = neighbours.len();
    let mut start = Vec::with_capacity(n + 1);
    start.push(0);
    let mut index = Vec::new();
    for list in neighbours {
        index.extend_from_slice(list);
        start.push(index.len());
    }
    let graph = SymbolicSparseColMatRef::new_checked(n, n, &start, None, &index);
    let mut order = vec![0; n];
    let mut inverse = vec![0; n];
    let mut memory = MemBuffer::new(amd::order_scratch::<usize>(n, index.len() + n + 16));
    let found = amd::order(
        &mut order,
        &mut inverse,
        graph,
        amd::Control::default(),
        MemStack::new(&mut memory),
    );
    match found {
        Ok(_) => order,
        Err(_) => (0..n).collect(),
    }
}
