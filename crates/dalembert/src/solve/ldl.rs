//! Block-sparse LDL^T of the reduced system, without pivoting, on a fixed pattern.

use super::kernel::{Fixed, Size, add_apply, add_apply_transposed, add_product, with_size};
use super::order::Elimination;
use super::pattern::Pattern;

/// Factor of a symmetric positive semidefinite block-sparse matrix; one block row for each element.
#[derive(Clone, Debug)]
pub(super) struct BlockLdl {
    elimination: Elimination,
    /// Position -> rows of its element.
    size: Vec<usize>,
    /// Position -> first row of its element.
    row: Vec<usize>,
    /// Position -> where its square diagonal block starts in `values`; one entry more at the end.
    diagonal: Vec<usize>,
    /// Entry of `elimination.below` -> where its block starts in `values`.
    offset: Vec<usize>,
    values: Vec<f64>,
    /// Row -> one over its pivot; zero for a row that is left out.
    inverse_pivot: Vec<f64>,
    /// Row -> pivot over the row's own initial diagonal.
    pub ratio: Vec<f64>,
    /// Blocks of one column times their pivots.
    scaled: Vec<f64>,
    /// Unknowns of one element.
    local: Vec<f64>,
}

/// What happens to a row whose pivot is small against its initial diagonal.
#[derive(Clone, Copy, Debug)]
pub(super) enum Floor {
    /// The row is left out: its unknown is zero.
    Drop(f64),
    /// The pivot is lifted to this part of the initial diagonal.
    Lift(f64),
}

impl BlockLdl {
    /// Lays out the factor; the only place where it allocates.
    pub fn new(pattern: &Pattern) -> Self {
        let elimination = Elimination::new(pattern);
        let size: Vec<usize> = elimination
            .element
            .iter()
            .map(|&e| pattern.shape().elements[e].rows)
            .collect();
        let row = elimination
            .element
            .iter()
            .map(|&e| pattern.row_offset(e))
            .collect();
        let mut diagonal = Vec::with_capacity(size.len() + 1);
        let mut offset = Vec::with_capacity(elimination.below.len());
        let (mut at, mut widest) = (0, 0);
        for (k, &n) in size.iter().enumerate() {
            diagonal.push(at);
            at += n * n;
            let first = at;
            for &i in &elimination.below[elimination.start[k]..elimination.start[k + 1]] {
                offset.push(at);
                at += size[i] * n;
            }
            widest = widest.max(at - first);
        }
        diagonal.push(at);
        Self {
            values: vec![0.0; at],
            inverse_pivot: vec![0.0; pattern.rows()],
            ratio: vec![0.0; pattern.rows()],
            scaled: vec![0.0; widest],
            local: vec![0.0; size.iter().copied().max().unwrap_or(0)],
            elimination,
            size,
            row,
            diagonal,
            offset,
        }
    }

    /// Where the block of two elements starts in the values, and whether the first one is its row.
    pub fn block(&self, first: usize, second: usize) -> (usize, bool) {
        let (a, b) = (
            self.elimination.position[first],
            self.elimination.position[second],
        );
        if a == b {
            return (self.diagonal[a], true);
        }
        let (row, column) = (a.max(b), a.min(b));
        let range = self.elimination.start[column]..self.elimination.start[column + 1];
        let within = self.elimination.below[range.clone()].partition_point(|&i| i < row);
        (self.offset[range.start + within], row == a)
    }

    /// Number of values of the factor.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// The values, to be filled with the matrix before [`factor`](Self::factor).
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Copies the diagonal of the matrix that was filled in.
    pub fn copy_diagonal(&self, out: &mut [f64]) {
        for (k, &n) in self.size.iter().enumerate() {
            for i in 0..n {
                out[self.row[k] + i] = self.values[self.diagonal[k] + i * (n + 1)];
            }
        }
    }

    /// Multiplies each diagonal entry by `1 + part`.
    pub fn lift_diagonal(&mut self, part: f64) {
        for (k, &n) in self.size.iter().enumerate() {
            for i in 0..n {
                self.values[self.diagonal[k] + i * (n + 1)] *= 1.0 + part;
            }
        }
    }

    /// Factors the matrix that was filled in; rows whose `initial` diagonal is not above `zero` are left out.
    pub fn factor(&mut self, initial: &[f64], zero: f64, floor: Floor) {
        for k in 0..self.size.len() {
            with_size!(self.size[k], n => self.factor_column(k, n, initial, zero, floor));
        }
    }

    #[inline(always)]
    fn factor_column<N: Size>(
        &mut self,
        k: usize,
        size: N,
        initial: &[f64],
        zero: f64,
        floor: Floor,
    ) {
        let n = size.get();
        let row = self.row[k];
        let (done, later) = self.values.split_at_mut(self.diagonal[k + 1]);
        let later_start = done.len();
        let (diagonal, below) = done[self.diagonal[k]..].split_at_mut(n * n);
        let inverse = &mut self.inverse_pivot[row..row + n];
        let ratio = &mut self.ratio[row..row + n];
        let initial = &initial[row..row + n];
        for j in 0..n {
            let mut pivot = diagonal[j * n + j];
            ratio[j] = if initial[j] > zero {
                pivot / initial[j]
            } else {
                0.0
            };
            inverse[j] = match floor {
                _ if initial[j] <= zero => 0.0,
                Floor::Drop(least) if ratio[j] <= least => 0.0,
                Floor::Lift(least) if ratio[j] <= least => {
                    pivot = least * initial[j];
                    1.0 / pivot
                }
                _ => 1.0 / pivot,
            };
            for i in j + 1..n {
                let factor = diagonal[i * n + j] * inverse[j];
                for q in j + 1..=i {
                    diagonal[i * n + q] -= factor * diagonal[q * n + j];
                }
            }
            for i in j + 1..n {
                diagonal[i * n + j] *= inverse[j];
            }
        }
        // Each row b of a block below: x = b L^-T goes to `scaled`, x D^-1 stays as the factor.
        let scaled = &mut self.scaled[..below.len()];
        for (line, keep) in below
            .chunks_exact_mut(n.max(1))
            .zip(scaled.chunks_exact_mut(n.max(1)))
        {
            for j in 0..n {
                let mut x = line[j];
                for p in 0..j {
                    x -= keep[p] * diagonal[j * n + p];
                }
                keep[j] = x;
            }
            for j in 0..n {
                line[j] = keep[j] * inverse[j];
            }
        }
        let (start, end) = (self.elimination.start[k], self.elimination.start[k + 1]);
        let own = self.diagonal[k] + n * n;
        for j in start..end {
            let target = self.elimination.below[j];
            let width = self.size[target];
            let factor = &below[self.offset[j] - own..][..width * n];
            let x = &scaled[self.offset[j] - own..][..width * n];
            add_product(
                (width, width, n),
                -1.0,
                &mut later[self.diagonal[target] - later_start..],
                x,
                factor,
            );
            // The rows below are among the rows of the target's column; both lists ascend.
            let mut at = self.elimination.start[target];
            for i in j + 1..end {
                let wanted = self.elimination.below[i];
                while self.elimination.below[at] != wanted {
                    at += 1;
                }
                let height = self.size[wanted];
                let x = &scaled[self.offset[i] - own..][..height * n];
                add_product(
                    (height, width, n),
                    -1.0,
                    &mut later[self.offset[at] - later_start..],
                    x,
                    factor,
                );
            }
        }
    }

    /// Solves with the factor: right-hand side in, solution out.
    pub fn solve(&mut self, x: &mut [f64]) {
        for k in 0..self.size.len() {
            with_size!(self.size[k], n => self.forward(k, n, x));
        }
        for k in (0..self.size.len()).rev() {
            with_size!(self.size[k], n => self.backward(k, n, x));
        }
    }

    #[inline(always)]
    fn forward<N: Size>(&mut self, k: usize, size: N, x: &mut [f64]) {
        let n = size.get();
        let row = self.row[k];
        let diagonal = &self.values[self.diagonal[k]..][..n * n];
        let local = &mut self.local[..n];
        local.copy_from_slice(&x[row..row + n]);
        for i in 0..n {
            for j in 0..i {
                local[i] -= diagonal[i * n + j] * local[j];
            }
        }
        x[row..row + n].copy_from_slice(local);
        for at in self.elimination.start[k]..self.elimination.start[k + 1] {
            let i = self.elimination.below[at];
            let target = &mut x[self.row[i]..];
            let block = &self.values[self.offset[at]..];
            match self.size[i] {
                2 => add_apply((Fixed::<2>, size), -1.0, target, block, local),
                height => add_apply((height, size), -1.0, target, block, local),
            }
        }
    }

    #[inline(always)]
    fn backward<N: Size>(&mut self, k: usize, size: N, x: &mut [f64]) {
        let n = size.get();
        let row = self.row[k];
        let local = &mut self.local[..n];
        for i in 0..n {
            local[i] = x[row + i] * self.inverse_pivot[row + i];
        }
        for at in self.elimination.start[k]..self.elimination.start[k + 1] {
            let i = self.elimination.below[at];
            let source = &x[self.row[i]..];
            let block = &self.values[self.offset[at]..];
            match self.size[i] {
                2 => add_apply_transposed((Fixed::<2>, size), -1.0, local, block, source),
                height => add_apply_transposed((height, size), -1.0, local, block, source),
            }
        }
        let diagonal = &self.values[self.diagonal[k]..][..n * n];
        for i in (0..n).rev() {
            for j in 0..i {
                local[j] -= diagonal[i * n + j] * local[i];
            }
        }
        x[row..row + n].copy_from_slice(local);
    }
}
