//! The saddle system of constrained dynamics: symbolic once, numeric without allocation.

use super::auxiliary::AuxElement;
use super::factored::Factored;
use super::kernel::{Size, with_dof};
use super::ldl::{BlockLdl, Factor, Floor};
use super::pattern::Pattern;
use super::products::Products;
use super::shape::SaddleShape;
use super::work::Work;

/// Rows whose pivot ratio is below this are dependent: an angle of 3e-6 to the other rows.
///
/// Rounding leaves about `rows * 1e-16` of the pivot of a dependent row, far below. A body that is lighter than its
/// neighbours by this factor looks like a dependence too: then factor a metric in which it is heavier and solve with the
/// true mass, as [`Metric`](crate::system::Metric) does.
pub const DEPENDENT_PIVOT: f64 = 1e-11;

/// Part of its own diagonal that is added to each row while dependent rows are present.
///
/// Measured on doubled chains with mass ratios up to 1e6: from 1e-11 to 1e-9 one or two sweeps are enough, 1e-8 takes
/// four, 1e-7 fails. The multipliers of dependent rows carry the rounding divided by this part: 1e-5 at 1e-11, 2e-7 here.
const REGULARIZATION: f64 = 1e-9;

/// Diagonals below this part of the largest one belong to rows without gradient.
const ZERO_ROW: f64 = 1e-24;

/// Solver of `[M J^T 0; J 0 Js; 0 Js^T 0] [a; l; s] = [f; g; h]` on a fixed pattern.
///
/// M may be singular: what is factored is the inverse of any regular matrix near it, and solutions are refined against M.
/// The auxiliaries go first: an orthogonal turn of the rows of their element separates them exactly. Then the bodies
/// (M is block-diagonal), which leaves `S = J M^-1 J^T` on the graph of elements that share a body. S is factored by
/// a block-sparse LDL^T in minimum-degree order: linear time for chains and trees. A body with many elements makes
/// their part of S dense: hundreds of elements on one body cost the cube of their number.
///
/// Dependent rows: S is then only semidefinite. Rows whose pivot vanishes are reported, and the factorization is
/// repeated with a small part of the diagonal added (proximal point method). Refinement against the true equations
/// removes its effect: accelerations are those of the consistent system, and the multipliers tend to the ones that
/// minimize the sum of `S_ii l_i^2`.
#[derive(Clone, Debug)]
pub struct Saddle {
    pub(super) pattern: Pattern,
    pub(super) ldl: BlockLdl,
    /// Factor without the rows that vanished.
    pub(super) plain: Factor,
    /// Factor with a part of the diagonal added; valid while rows are missing from the plain one.
    pub(super) lifted: Factor,
    products: Products,
    pub(super) auxiliaries: Vec<AuxElement>,
    tolerance: f64,
    pub(super) mass_inverse: Vec<f64>,
    pub(super) jac: Vec<f64>,
    pub(super) jac_aux: Vec<f64>,
    /// Jacobian with turned rows where there are auxiliaries; empty if there are none at all.
    turned: Vec<f64>,
    /// Turned Jacobian times the inverse mass, laid out as the Jacobian.
    pub(super) w: Vec<f64>,
    /// Diagonal of S before regularization, for turned rows.
    diagonal: Vec<f64>,
    /// One over that diagonal; zero for rows without gradient.
    turned_weight: Vec<f64>,
    /// One over the diagonal of S of the original rows; zero for rows without gradient.
    pub(super) row_weight: Vec<f64>,
    /// The same for the columns of the auxiliary Jacobian.
    pub(super) aux_weight: Vec<f64>,
    pivot_ratio: Vec<f64>,
    smallest: f64,
    largest: f64,
    pub(super) vanished: Vec<usize>,
    zero: Vec<usize>,
    pub(super) work: Work,
}

impl Saddle {
    /// Does the symbolic work and allocates everything.
    pub fn new(shape: SaddleShape) -> Self {
        let pattern = Pattern::new(shape);
        let ldl = BlockLdl::new(&pattern);
        let auxiliaries: Vec<AuxElement> = (0..pattern.elements())
            .filter(|&e| pattern.shape().elements[e].aux > 0)
            .map(|e| AuxElement::new(&pattern, e))
            .collect();
        let (rows, jac_len) = (pattern.rows(), pattern.jac_len());
        Self {
            products: Products::new(&pattern, &ldl),
            plain: ldl.allocate(),
            lifted: ldl.allocate(),
            tolerance: DEPENDENT_PIVOT,
            mass_inverse: vec![0.0; pattern.mass_len()],
            jac: vec![0.0; jac_len],
            jac_aux: vec![0.0; pattern.jac_aux_len()],
            turned: vec![0.0; if auxiliaries.is_empty() { 0 } else { jac_len }],
            w: vec![0.0; jac_len],
            diagonal: vec![0.0; rows],
            turned_weight: vec![0.0; rows],
            row_weight: vec![0.0; rows],
            aux_weight: vec![0.0; pattern.aux()],
            pivot_ratio: vec![0.0; rows],
            smallest: 1.0,
            largest: 1.0,
            vanished: Vec::with_capacity(rows),
            zero: Vec::with_capacity(rows),
            work: Work::new(&pattern),
            auxiliaries,
            pattern,
            ldl,
        }
    }

    /// Sets the pivot ratio below which a row counts as dependent (the square of the sine of an angle).
    ///
    /// Positions that are off by a relative error e turn gradients by about e, so a run with loose position tolerances
    /// needs at least `e * e` here, or redundant joints lock. Values are kept within 1e-14 and 1e-2.
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = if tolerance.is_nan() {
            DEPENDENT_PIVOT
        } else {
            tolerance.clamp(1e-14, 1e-2)
        };
        self
    }

    /// The layout of all values.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// Number of constraint rows.
    pub fn rows(&self) -> usize {
        self.pattern.rows()
    }

    /// Number of auxiliaries.
    pub fn aux(&self) -> usize {
        self.pattern.aux()
    }

    /// Number of values of the Jacobian.
    pub fn jac_len(&self) -> usize {
        self.pattern.jac_len()
    }

    /// Where the block of an element and one of its bodies starts in the Jacobian's values.
    pub fn jac_offset(&self, element: usize, body_slot: usize) -> usize {
        self.pattern.jac_offset(element, body_slot)
    }

    /// Number of values of the auxiliary Jacobian.
    pub fn jac_aux_len(&self) -> usize {
        self.pattern.jac_aux_len()
    }

    /// Where the block of an element starts in the auxiliary Jacobian's values.
    pub fn jac_aux_offset(&self, element: usize) -> usize {
        self.pattern.jac_aux_offset(element)
    }

    /// Number of stored values of the factor, a measure of fill.
    pub fn factor_len(&self) -> usize {
        self.ldl.len()
    }

    /// Adds `J^T l` to `out`, with the Jacobian of the last factorization.
    pub fn jt_mul(&self, l: &[f64], out: &mut [f64]) {
        self.pattern.jt_mul(&self.jac, l, out);
    }

    /// Sets `out` to `J v`, with the Jacobian of the last factorization.
    pub fn j_mul(&self, v: &[f64], out: &mut [f64]) {
        self.pattern.j_mul(&self.jac, v, out);
    }

    /// Factors the system. Allocates nothing.
    ///
    /// `mass_inverse` has one symmetric row-major `dof x dof` block a body; the Jacobians are laid out as
    /// [`Pattern`] says. Each slice must have the length of its layout.
    pub fn factor(&mut self, mass_inverse: &[f64], jac: &[f64], jac_aux: &[f64]) -> Factored<'_> {
        self.mass_inverse.copy_from_slice(mass_inverse);
        self.jac.copy_from_slice(jac);
        self.jac_aux.copy_from_slice(jac_aux);
        self.turn_rows();
        let dof = self.pattern.shape().dof;
        with_dof!(dof, dof => self.multiply_mass(dof));
        self.assemble(false);
        self.ldl.copy_diagonal(&self.plain, &mut self.diagonal);
        let largest = self.diagonal.iter().fold(
            0.0,
            |largest: f64, &x| if x > largest { x } else { largest },
        );
        let zero = ZERO_ROW * largest;
        for (to, &diagonal) in self.turned_weight.iter_mut().zip(&self.diagonal) {
            *to = if diagonal <= zero {
                0.0
            } else {
                1.0 / diagonal
            };
        }
        self.weigh_rows(zero);
        let least = Floor::Drop(self.tolerance);
        self.ldl
            .factor(&mut self.plain, &self.diagonal, &self.turned_weight, least);
        std::mem::swap(&mut self.pivot_ratio, &mut self.plain.ratio);
        self.classify();
        if !self.vanished.is_empty() {
            self.assemble(true);
            self.ldl.lift_diagonal(&mut self.lifted, REGULARIZATION);
            let least = Floor::Lift(0.1 * REGULARIZATION);
            self.ldl
                .factor(&mut self.lifted, &self.diagonal, &self.turned_weight, least);
        }
        self.factored()
    }

    /// The report of the last factorization.
    pub fn factored(&self) -> Factored<'_> {
        Factored {
            pivot_ratio: &self.pivot_ratio,
            smallest: self.smallest,
            largest: self.largest,
            vanished: &self.vanished,
            zero: &self.zero,
            tolerance: self.tolerance,
        }
    }

    /// Eliminates the auxiliaries: turns the rows of their elements.
    fn turn_rows(&mut self) {
        if self.auxiliaries.is_empty() {
            return;
        }
        self.turned.copy_from_slice(&self.jac);
        let dof = self.pattern.shape().dof;
        for aux in &mut self.auxiliaries {
            aux.factor(&self.jac_aux);
            let bodies = self.pattern.shape().elements[aux.element].bodies.len();
            for slot in 0..bodies {
                let at = self.pattern.jac_offset(aux.element, slot);
                aux.turn_block(dof, &self.jac[at..], &mut self.turned[at..]);
            }
        }
    }

    /// Sets `w` to the turned Jacobian times the inverse mass.
    fn multiply_mass<D: Size>(&mut self, dof: D) {
        let n = dof.get();
        let jac = if self.auxiliaries.is_empty() {
            &self.jac
        } else {
            &self.turned
        };
        for block in &self.pattern.incidences {
            let inverse = &self.mass_inverse[block.body * n * n..][..n * n];
            let source = jac[block.jac..][..block.rows * n].chunks_exact(n.max(1));
            let target = self.w[block.jac..][..block.rows * n].chunks_exact_mut(n.max(1));
            for (from, to) in source.zip(target) {
                for c in 0..n {
                    let mut sum = 0.0;
                    for k in 0..n {
                        sum += from[k] * inverse[c * n + k];
                    }
                    to[c] = sum;
                }
            }
        }
    }

    /// Fills one of the factors with the reduced matrix `S = J M^-1 J^T`.
    fn assemble(&mut self, lifted: bool) {
        with_dof!(self.pattern.shape().dof, dof => self.assemble_sized(dof, lifted));
    }

    fn assemble_sized<D: Size>(&mut self, dof: D, lifted: bool) {
        let jac = if self.auxiliaries.is_empty() {
            &self.jac
        } else {
            &self.turned
        };
        let factor = if lifted {
            &mut self.lifted
        } else {
            &mut self.plain
        };
        let values = &mut factor.values[..];
        values.fill(0.0);
        self.products.add(dof, &self.w, jac, values);
    }

    /// Finds the weights that make residuals of rows and auxiliaries comparable.
    fn weigh_rows(&mut self, zero: f64) {
        let weight = |diagonal: f64| if diagonal > zero { 1.0 / diagonal } else { 0.0 };
        self.row_weight.copy_from_slice(&self.turned_weight);
        let n = self.pattern.shape().dof;
        for aux in &self.auxiliaries {
            // The diagonal holds turned rows here: take that of the original ones.
            for i in 0..aux.rows {
                let mut diagonal = 0.0;
                for (slot, &body) in self.pattern.shape().elements[aux.element]
                    .bodies
                    .iter()
                    .enumerate()
                {
                    if body >= self.pattern.shape().bodies {
                        continue;
                    }
                    let row = &self.jac[self.pattern.jac_offset(aux.element, slot) + i * n..][..n];
                    let inverse = &self.mass_inverse[body * n * n..][..n * n];
                    for c in 0..n {
                        for k in 0..n {
                            diagonal += row[c] * inverse[c * n + k] * row[k];
                        }
                    }
                }
                self.row_weight[aux.row + i] = weight(diagonal);
            }
            let block = aux.block(&self.jac_aux);
            for k in 0..aux.count {
                let sum: f64 = (0..aux.rows)
                    .map(|i| {
                        block[i * aux.count + k]
                            * block[i * aux.count + k]
                            * self.row_weight[aux.row + i]
                    })
                    .sum();
                self.aux_weight[aux.first + k] = if sum > 0.0 { 1.0 / sum } else { 0.0 };
            }
        }
    }

    /// Sorts the rows into kept, vanished and without gradient.
    fn classify(&mut self) {
        self.vanished.clear();
        self.zero.clear();
        (self.smallest, self.largest) = (f64::INFINITY, 0.0);
        let mut first = 0;
        for number in 0..self.auxiliaries.len() {
            let aux = &self.auxiliaries[number];
            let (row, rank, rows) = (aux.row, aux.rank, aux.rows);
            self.classify_rows(first, row, None);
            // The first turned rows determine auxiliaries: no constraint of the bodies, and not redundant.
            self.pivot_ratio[row..row + rank].fill(1.0);
            first = row + rows;
            self.classify_rows(row + rank, first, Some(number));
        }
        self.classify_rows(first, self.pivot_ratio.len(), None);
        if self.smallest > self.largest {
            (self.smallest, self.largest) = (1.0, 1.0);
        }
        if !self.auxiliaries.is_empty() {
            self.zero.sort_unstable();
            self.vanished.sort_unstable();
        }
    }

    fn classify_rows(&mut self, first: usize, end: usize, aux: Option<usize>) {
        let aux = aux.map(|number| &self.auxiliaries[number]);
        for row in first..end {
            let ratio = self.pivot_ratio[row];
            if ratio > self.tolerance {
                self.smallest = if ratio < self.smallest {
                    ratio
                } else {
                    self.smallest
                };
                self.largest = if ratio > self.largest {
                    ratio
                } else {
                    self.largest
                };
                continue;
            }
            let list = if self.turned_weight[row] == 0.0 {
                &mut self.zero
            } else {
                &mut self.vanished
            };
            let named = aux
                .and_then(|aux| aux.heaviest_row(row, list))
                .unwrap_or(row);
            list.push(named);
        }
    }
}
