//! Block-sparse LDL^T of the reduced system, without pivoting, on a fixed pattern.

use super::kernel::{Size, add_apply, add_apply_transposed, add_product, with_size};
use super::order::Elimination;
use super::pattern::Pattern;

/// Rounding error of an entry of the matrix over its size.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A pivot below this many times its estimated rounding error is lost in it.
const LOST: f64 = 4.0;

/// Only pivots below this part of their initial diagonal are suspected to be lost: the estimate is pessimistic.
const DOUBTFUL: f64 = 1e-4;

/// Layout of the factor of a positive semidefinite block-sparse matrix, with one block row for each element.
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
    /// Number of values of a factor.
    len: usize,
    /// Number of rows.
    rows: usize,
    /// Blocks of one column times their pivots.
    scaled: Vec<f64>,
    /// Unknowns of one element.
    local: Vec<f64>,
}

/// The numbers of one factorization.
#[derive(Clone, Debug)]
pub(super) struct Factor {
    /// The matrix before, the factor after the factorization.
    pub values: Vec<f64>,
    /// Row -> one over its pivot; zero for a row that is left out.
    inverse_pivot: Vec<f64>,
    /// Row -> pivot over the row's own initial diagonal; not above zero if the pivot is lost in rounding.
    pub ratio: Vec<f64>,
    /// Row -> estimate of the rounding error of its pivot over its initial diagonal.
    noise: Vec<f64>,
}

/// What happens to a row whose pivot is small against its initial diagonal.
#[derive(Clone, Copy, Debug)]
pub(super) enum Floor {
    /// The row is left out: its unknown is zero. So is a row whose pivot is lost in rounding.
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
            len: at,
            rows: pattern.rows(),
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
        self.len
    }

    /// Allocates the numbers of one factorization.
    pub fn allocate(&self) -> Factor {
        Factor {
            values: vec![0.0; self.len],
            inverse_pivot: vec![0.0; self.rows],
            ratio: vec![0.0; self.rows],
            noise: vec![0.0; self.rows],
        }
    }

    /// Copies the diagonal of the matrix that was filled in.
    pub fn copy_diagonal(&self, factor: &Factor, out: &mut [f64]) {
        for (k, &n) in self.size.iter().enumerate() {
            for i in 0..n {
                out[self.row[k] + i] = factor.values[self.diagonal[k] + i * (n + 1)];
            }
        }
    }

    /// Multiplies each diagonal entry by `1 + part`.
    pub fn lift_diagonal(&self, factor: &mut Factor, part: f64) {
        for (k, &n) in self.size.iter().enumerate() {
            for i in 0..n {
                factor.values[self.diagonal[k] + i * (n + 1)] *= 1.0 + part;
            }
        }
    }

    /// Factors the matrix that was filled in. `weight` is one over the `initial` diagonal; rows where it is zero are
    /// left out.
    pub fn factor(&mut self, factor: &mut Factor, initial: &[f64], weight: &[f64], floor: Floor) {
        for (noise, initial) in factor.noise.iter_mut().zip(initial) {
            *noise = ROUNDING * initial;
        }
        for k in 0..self.size.len() {
            with_size!(self.size[k], n => self.factor_column(k, n, factor, weight, floor));
        }
    }

    #[inline(always)]
    fn factor_column<N: Size>(
        &mut self,
        k: usize,
        size: N,
        factor: &mut Factor,
        weight: &[f64],
        floor: Floor,
    ) {
        let n = size.get();
        let row = self.row[k];
        let (done, later) = factor.values.split_at_mut(self.diagonal[k + 1]);
        let later_start = done.len();
        let (diagonal, below) = done[self.diagonal[k]..].split_at_mut(n * n);
        let inverse = &mut factor.inverse_pivot[row..row + n];
        let ratio = &mut factor.ratio[row..row + n];
        let noise = &mut factor.noise[..];
        let weight = &weight[row..row + n];
        for j in 0..n {
            let pivot = diagonal[j * n + j];
            ratio[j] = pivot * weight[j];
            inverse[j] = match floor {
                _ if weight[j] == 0.0 => 0.0,
                Floor::Drop(least) if ratio[j] <= least => 0.0,
                Floor::Drop(_) if ratio[j] <= DOUBTFUL && pivot <= LOST * noise[row + j] => {
                    ratio[j] = 0.0;
                    0.0
                }
                Floor::Lift(least) if ratio[j] <= least => weight[j] / least,
                _ => 1.0 / pivot,
            };
            // An error e of this pivot becomes an error L^2 e of the pivots below.
            noise[row + j] += ROUNDING * pivot;
            for i in 0..n {
                if i > j {
                    let multiplier = diagonal[i * n + j] * inverse[j];
                    noise[row + i] += multiplier * multiplier * noise[row + j];
                    for q in 0..n {
                        if q > j && q <= i {
                            diagonal[i * n + q] -= multiplier * diagonal[q * n + j];
                        }
                    }
                }
            }
            for i in 0..n {
                if i > j {
                    diagonal[i * n + j] *= inverse[j];
                }
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
                // Fixed bounds let the compiler unroll the triangle.
                for p in 0..n {
                    if p < j {
                        x -= keep[p] * diagonal[j * n + p];
                    }
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
            let block = &below[self.offset[j] - own..][..width * n];
            for (i, line) in block.chunks_exact(n.max(1)).enumerate() {
                let mut sum = 0.0;
                for j in 0..n {
                    sum += line[j] * line[j] * noise[row + j];
                }
                noise[self.row[target] + i] += sum;
            }
            let x = &scaled[self.offset[j] - own..][..width * n];
            add_product(
                (width, width, n),
                -1.0,
                &mut later[self.diagonal[target] - later_start..],
                x,
                block,
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
                    block,
                );
            }
        }
    }

    /// Solves with the factor: right-hand side in, solution out.
    pub fn solve(&mut self, factor: &Factor, x: &mut [f64]) {
        let mut spare = std::mem::take(&mut self.local);
        for k in 0..self.size.len() {
            with_size!(self.size[k], n => n.with_array(&mut spare, |local| self.forward(k, n, factor, x, local)));
        }
        for k in (0..self.size.len()).rev() {
            with_size!(self.size[k], n => n.with_array(&mut spare, |local| self.backward(k, n, factor, x, local)));
        }
        self.local = spare;
    }

    #[inline(always)]
    fn forward<N: Size>(
        &self,
        k: usize,
        size: N,
        factor: &Factor,
        x: &mut [f64],
        local: &mut [f64],
    ) {
        let n = size.get();
        let local = &mut local[..n];
        let own = &mut x[self.row[k]..][..n];
        let diagonal = &factor.values[self.diagonal[k]..][..n * n];
        for i in 0..n {
            let mut sum = own[i];
            for j in 0..n {
                if j < i {
                    sum -= diagonal[i * n + j] * local[j];
                }
            }
            local[i] = sum;
            own[i] = sum;
        }
        for at in self.elimination.start[k]..self.elimination.start[k + 1] {
            let i = self.elimination.below[at];
            let target = &mut x[self.row[i]..];
            let block = &factor.values[self.offset[at]..];
            if self.size[i] == n {
                add_apply((size, size), -1.0, target, block, local);
            } else {
                add_apply((self.size[i], size), -1.0, target, block, local);
            }
        }
    }

    #[inline(always)]
    fn backward<N: Size>(
        &self,
        k: usize,
        size: N,
        factor: &Factor,
        x: &mut [f64],
        local: &mut [f64],
    ) {
        let n = size.get();
        let row = self.row[k];
        let local = &mut local[..n];
        let inverse = &factor.inverse_pivot[row..][..n];
        let own = &x[row..][..n];
        for i in 0..n {
            local[i] = own[i] * inverse[i];
        }
        for at in self.elimination.start[k]..self.elimination.start[k + 1] {
            let i = self.elimination.below[at];
            let source = &x[self.row[i]..];
            let block = &factor.values[self.offset[at]..];
            if self.size[i] == n {
                add_apply_transposed((size, size), -1.0, local, block, source);
            } else {
                add_apply_transposed((self.size[i], size), -1.0, local, block, source);
            }
        }
        let diagonal = &factor.values[self.diagonal[k]..][..n * n];
        for i in (0..n).rev() {
            for j in 0..n {
                if j < i {
                    local[j] -= diagonal[i * n + j] * local[i];
                }
            }
        }
        x[row..][..n].copy_from_slice(local);
    }
}
