//! Assembly of the reduced matrix from products of blocks on the same body.

use super::kernel::{Size, add_product};
use super::ldl::BlockLdl;
use super::pattern::{Incidence, Pattern};

/// One product `W_a J_b^T` that goes into a block of the reduced matrix.
#[derive(Clone, Copy, Debug)]
struct Pair {
    /// Where the block of the rows starts in the Jacobian's values, and its rows.
    row: (usize, usize),
    /// The same for the columns.
    column: (usize, usize),
    /// Where the product goes.
    target: usize,
}

/// The products whose sum is the reduced matrix `S = J M^-1 J^T`, with their places in the factor.
#[derive(Clone, Debug)]
pub(super) struct Products {
    pairs: Vec<Pair>,
}

impl Products {
    /// Lists all pairs of blocks on the same body, with the place of their sum.
    pub fn new(pattern: &Pattern, ldl: &BlockLdl) -> Self {
        let mut on_body: Vec<Vec<usize>> = vec![Vec::new(); pattern.shape().bodies];
        for (number, block) in pattern.incidences.iter().enumerate() {
            on_body[block.body].push(number);
        }
        let element = |number: usize| -> &Incidence { &pattern.incidences[number] };
        let mut pairs = Vec::new();
        for list in &on_body {
            for (at, &first) in list.iter().enumerate() {
                for &second in &list[at..] {
                    let (target, upright) =
                        ldl.block(element(first).element, element(second).element);
                    let side = |number: usize| (element(number).jac, element(number).rows);
                    let (row, column) = if upright {
                        (side(first), side(second))
                    } else {
                        (side(second), side(first))
                    };
                    pairs.push(Pair {
                        row,
                        column,
                        target,
                    });
                    if first != second && element(first).element == element(second).element {
                        // One body in two slots of one element: both cross terms belong to the diagonal block.
                        pairs.push(Pair {
                            row: column,
                            column: row,
                            target,
                        });
                    }
                }
            }
        }
        pairs.sort_by_key(|pair| pair.target);
        Self { pairs }
    }

    /// Adds all products to the values of a factor; `w` is `J M^-1`, laid out as `jac`.
    #[inline(always)]
    pub fn add<D: Size>(&self, dof: D, w: &[f64], jac: &[f64], values: &mut [f64]) {
        for pair in &self.pairs {
            let (a, b) = (&w[pair.row.0..], &jac[pair.column.0..]);
            add_product(
                (pair.row.1, pair.column.1, dof),
                1.0,
                &mut values[pair.target..],
                a,
                b,
            );
        }
    }
}
