//! Exact elimination of the auxiliaries of one element by an orthogonal turn of its rows.

// Indices say what the algorithms of dense matrices mean; iterators would hide it.
#![allow(clippy::needless_range_loop)]

use super::pattern::Pattern;

/// A column of the auxiliary Jacobian whose new part is below this part of its norm adds no direction.
const DEPENDENT_COLUMN: f64 = 1e-11;

/// The auxiliaries of one element, eliminated by `Js P = Q [R; 0]` (Householder, column pivoting).
///
/// In the turned rows `Q^T (J a + Js s) = Q^T g` only the first `rank` rows contain auxiliaries, and there the
/// multipliers are known from `Js^T l = h`. What remains is a plain constraint without auxiliaries. An auxiliary that
/// is not determined at this pose is zero, and its row stays a plain constraint.
#[derive(Clone, Debug)]
pub(super) struct AuxElement {
    pub element: usize,
    pub row: usize,
    pub rows: usize,
    /// First auxiliary of the element.
    pub first: usize,
    /// Number of auxiliaries of the element.
    pub count: usize,
    jac_aux: usize,
    /// Number of turned rows that contain auxiliaries.
    pub rank: usize,
    q: Vec<f64>,
    r: Vec<f64>,
    order: Vec<usize>,
    norm: Vec<f64>,
    work: Vec<f64>,
}

impl AuxElement {
    /// Allocates the elimination of one element of a pattern.
    pub fn new(pattern: &Pattern, element: usize) -> Self {
        let shape = &pattern.shape().elements[element];
        Self {
            element,
            row: pattern.row_offset(element),
            rows: shape.rows,
            first: pattern.aux_offset(element),
            count: shape.aux,
            jac_aux: pattern.jac_aux_offset(element),
            rank: 0,
            q: vec![0.0; shape.rows * shape.rows],
            r: vec![0.0; shape.rows * shape.aux],
            order: vec![0; shape.aux],
            norm: vec![0.0; shape.aux],
            work: vec![0.0; shape.rows.max(shape.aux)],
        }
    }

    /// The element's block of the auxiliary Jacobian.
    pub fn block<'a>(&self, jac_aux: &'a [f64]) -> &'a [f64] {
        &jac_aux[self.jac_aux..self.jac_aux + self.rows * self.count]
    }

    /// Factors the element's block of the auxiliary Jacobian.
    pub fn factor(&mut self, jac_aux: &[f64]) {
        let (m, p) = (self.rows, self.count);
        self.r
            .copy_from_slice(&jac_aux[self.jac_aux..self.jac_aux + m * p]);
        self.q.fill(0.0);
        for i in 0..m {
            self.q[i * m + i] = 1.0;
        }
        for j in 0..p {
            self.order[j] = j;
            self.norm[j] = (0..m)
                .map(|i| self.r[i * p + j] * self.r[i * p + j])
                .sum::<f64>()
                .sqrt();
        }
        self.rank = 0;
        for k in 0..m.min(p) {
            let Some(pivot) = self.pivot_column(k) else {
                break;
            };
            for i in 0..m {
                self.r.swap(i * p + k, i * p + pivot);
            }
            self.order.swap(k, pivot);
            self.norm.swap(k, pivot);
            self.reflect(k);
            self.rank = k + 1;
        }
    }

    /// The column with the largest part outside the columns before `k`, relative to its own norm.
    fn pivot_column(&self, k: usize) -> Option<usize> {
        let (m, p) = (self.rows, self.count);
        let mut best = None;
        let mut best_part = DEPENDENT_COLUMN;
        for j in k..p {
            let rest = (k..m)
                .map(|i| self.r[i * p + j] * self.r[i * p + j])
                .sum::<f64>()
                .sqrt();
            if self.norm[j] > 0.0 && rest > best_part * self.norm[j] {
                best_part = rest / self.norm[j];
                best = Some(j);
            }
        }
        best
    }

    /// Householder reflection that clears column `k` below its diagonal.
    fn reflect(&mut self, k: usize) {
        let (m, p) = (self.rows, self.count);
        let length = (k..m)
            .map(|i| self.r[i * p + k] * self.r[i * p + k])
            .sum::<f64>()
            .sqrt();
        let alpha = if self.r[k * p + k] > 0.0 {
            -length
        } else {
            length
        };
        let v = &mut self.work[..m];
        for i in k..m {
            v[i] = self.r[i * p + k];
        }
        v[k] -= alpha;
        let square: f64 = v[k..].iter().map(|x| x * x).sum();
        // The sign of alpha keeps |v[k]| >= length > 0, so the square is positive.
        for j in k..p {
            let dot: f64 = (k..m).map(|i| v[i] * self.r[i * p + j]).sum();
            for i in k..m {
                self.r[i * p + j] -= 2.0 * dot / square * v[i];
            }
        }
        for i in 0..m {
            let dot: f64 = (k..m).map(|j| self.q[i * m + j] * v[j]).sum();
            for j in k..m {
                self.q[i * m + j] -= 2.0 * dot / square * v[j];
            }
        }
    }

    /// Replaces a block of the Jacobian by its turned rows; rows that contain auxiliaries become zero.
    pub fn turn_block(&self, dof: usize, block: &[f64], out: &mut [f64]) {
        let m = self.rows;
        out[..m * dof].fill(0.0);
        for i in 0..m {
            for k in self.rank..m {
                let q = self.q[i * m + k];
                for c in 0..dof {
                    out[k * dof + c] += q * block[i * dof + c];
                }
            }
        }
    }

    /// Turns the element's part of a vector of rows in place: `x = Q^T x`.
    pub fn turn(&mut self, x: &mut [f64]) {
        let m = self.rows;
        let x = &mut x[self.row..self.row + m];
        self.work[..m].copy_from_slice(x);
        for k in 0..m {
            x[k] = (0..m).map(|i| self.q[i * m + k] * self.work[i]).sum();
        }
    }

    /// Sets the element's multipliers to the part that `Js^T l = h` determines.
    pub fn particular(&mut self, h: &[f64], l: &mut [f64]) {
        let (m, p, rank) = (self.rows, self.count, self.rank);
        for k in 0..rank {
            let mut sum = h[self.first + self.order[k]];
            for j in 0..k {
                sum -= self.r[j * p + k] * self.work[j];
            }
            self.work[k] = sum / self.r[k * p + k];
        }
        for i in 0..m {
            l[self.row + i] = (0..rank).map(|k| self.q[i * m + k] * self.work[k]).sum();
        }
    }

    /// Adds the multipliers of the turned plain rows.
    pub fn add_turned(&self, turned: &[f64], l: &mut [f64]) {
        let m = self.rows;
        for i in 0..m {
            l[self.row + i] += (self.rank..m)
                .map(|k| self.q[i * m + k] * turned[self.row + k])
                .sum::<f64>();
        }
    }

    /// Sets the auxiliaries from the element's rows `Js s = rhs` (`rhs` has only this element's rows).
    pub fn solve_aux(&mut self, rhs: &[f64], s: &mut [f64]) {
        let (m, p, rank) = (self.rows, self.count, self.rank);
        s[self.first..self.first + p].fill(0.0);
        for k in (0..rank).rev() {
            let mut sum: f64 = (0..m).map(|i| self.q[i * m + k] * rhs[i]).sum();
            for j in k + 1..rank {
                sum -= self.r[k * p + j] * s[self.first + self.order[j]];
            }
            s[self.first + self.order[k]] = sum / self.r[k * p + k];
        }
    }

    /// The original row that weighs most in a turned row, among those that `taken` does not contain.
    pub fn heaviest_row(&self, turned: usize, taken: &[usize]) -> Option<usize> {
        let m = self.rows;
        let weight = |i: &usize| self.q[i * m + turned - self.row].abs();
        (0..m)
            .filter(|i| !taken.contains(&(self.row + i)))
            .max_by(|a, b| weight(a).total_cmp(&weight(b)))
            .map(|i| self.row + i)
    }
}
