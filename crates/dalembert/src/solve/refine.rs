//! Solution and refinement of the saddle system.

use super::kernel::{Size, add_apply, add_apply_transposed, with_dof, with_size};
use super::residual::{Residual, Rhs};
use super::saddle::Saddle;

/// Residual at which refinement stops.
const GOAL: f64 = 1e-13;

/// Residual up to which a solution counts as converged: near singular poses large multipliers that cancel leave more
/// than the goal.
const ACCEPTED: f64 = 1e-11;

/// Backward error of a row of the factorization over its largest product: measured on chains of up to 10000 bars, it
/// is 1 to 2.2 times the machine's unit, whatever the length.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Most corrections after the first solution.
const SWEEPS: usize = 6;

/// A solution without the vanished rows is preferred if its residual is below this many times the other one.
const CONTRADICTION: f64 = 10.0;

/// Which factor solves.
#[derive(Clone, Copy)]
enum Use {
    Plain,
    Lifted,
}

impl Saddle {
    /// Solves with the last factorization and refines against the true system. Allocates nothing.
    ///
    /// `mass` has one row-major `dof x dof` block a body: the inverse of what [`factor`](Self::factor) was given, or a
    /// matrix near it, which may be singular. Each sweep gains the part by which they differ on the free motions.
    pub fn solve(
        &mut self,
        mass: &[f64],
        rhs: Rhs<'_>,
        a: &mut [f64],
        l: &mut [f64],
        s: &mut [f64],
    ) -> Residual {
        let dof = self.pattern.shape().dof;
        with_dof!(dof, dof => self.solve_sized(dof, mass, rhs, a, l, s))
    }

    fn solve_sized<D: Size>(
        &mut self,
        dof: D,
        mass: &[f64],
        rhs: Rhs<'_>,
        a: &mut [f64],
        l: &mut [f64],
        s: &mut [f64],
    ) -> Residual {
        let dependent = !self.factored().vanished.is_empty();
        let first = if dependent { Use::Lifted } else { Use::Plain };
        let mut found = self.solve_afresh(dof, first, mass, rhs, (a, l, s));
        if dependent && found.relative > GOAL {
            // Directions that hardly count are slow with the lifted factor, and fast with the plain one.
            let sweeps = self.refine(dof, Use::Plain, mass, rhs, (a, l, s), &mut found.relative);
            found.sweeps += sweeps;
            found.kept = found.relative;
        }
        if dependent && found.relative > GOAL {
            // Rows that contradict each other drive the lifted multipliers up: then leave the vanished rows out.
            self.work.kept_a.copy_from_slice(a);
            self.work.kept_l.copy_from_slice(l);
            self.work.kept_s.copy_from_slice(s);
            let plain = self.solve_afresh(dof, Use::Plain, mass, rhs, (a, l, s));
            if plain.relative <= CONTRADICTION * found.relative || !found.relative.is_finite() {
                found = plain;
            } else {
                a.copy_from_slice(&self.work.kept_a);
                l.copy_from_slice(&self.work.kept_l);
                s.copy_from_slice(&self.work.kept_s);
            }
        }
        // Large joint forces that cancel leave more rounding than a machine of short levers.
        found.converged = found.relative <= ACCEPTED.max(self.rounding(l));
        if dependent && !found.converged {
            found.kept = self.without_vanished(dof, mass, rhs, (a, l, s));
        }
        found
    }

    /// Residual of the equations without the rows that vanished.
    fn without_vanished<D: Size>(
        &mut self,
        dof: D,
        mass: &[f64],
        rhs: Rhs<'_>,
        (a, l, s): (&[f64], &[f64], &[f64]),
    ) -> f64 {
        self.work.kept_l.copy_from_slice(&self.row_weight);
        for &row in &self.vanished {
            self.row_weight[row] = 0.0;
        }
        let kept = self.residual(dof, mass, rhs, a, l, s);
        self.row_weight.copy_from_slice(&self.work.kept_l);
        kept
    }

    /// Solves with one of the factors and refines with it.
    fn solve_afresh<D: Size>(
        &mut self,
        dof: D,
        factor: Use,
        mass: &[f64],
        rhs: Rhs<'_>,
        (a, l, s): (&mut [f64], &mut [f64], &mut [f64]),
    ) -> Residual {
        self.work.force.copy_from_slice(rhs.f);
        self.work.row.copy_from_slice(rhs.g);
        self.work.aux.copy_from_slice(rhs.h);
        self.correction(dof, factor);
        a.copy_from_slice(&self.work.step_a);
        l.copy_from_slice(&self.work.step_l);
        s.copy_from_slice(&self.work.step_s);
        let mut relative = self.residual(dof, mass, rhs, a, l, s);
        let sweeps = self.refine(dof, factor, mass, rhs, (a, l, s), &mut relative);
        Residual {
            relative,
            kept: relative,
            sweeps,
            converged: relative <= ACCEPTED,
        }
    }

    /// Corrects a solution as long as that helps; the residuals in `work` belong to it before and after.
    fn refine<D: Size>(
        &mut self,
        dof: D,
        factor: Use,
        mass: &[f64],
        rhs: Rhs<'_>,
        (a, l, s): (&mut [f64], &mut [f64], &mut [f64]),
        relative: &mut f64,
    ) -> usize {
        let mut sweeps = 0;
        if *relative <= GOAL || *relative <= self.rounding(l) {
            return sweeps;
        }
        while *relative > GOAL && relative.is_finite() && sweeps < SWEEPS {
            self.correction(dof, factor);
            self.work.best_a.copy_from_slice(a);
            self.work.best_l.copy_from_slice(l);
            self.work.best_s.copy_from_slice(s);
            add(a, &self.work.step_a);
            add(l, &self.work.step_l);
            add(s, &self.work.step_s);
            let next = self.residual(dof, mass, rhs, a, l, s);
            if next >= *relative {
                a.copy_from_slice(&self.work.best_a);
                l.copy_from_slice(&self.work.best_l);
                s.copy_from_slice(&self.work.best_s);
                self.residual(dof, mass, rhs, a, l, s);
                break;
            }
            sweeps += 1;
            let stalled = next > 0.5 * *relative;
            *relative = next;
            if stalled {
                break;
            }
        }
        sweeps
    }

    /// The relative residual that rounding of the multipliers alone can leave: in a long chain large forces of
    /// neighbouring joints cancel on each body, and no correction gains anything below this.
    fn rounding(&self, l: &[f64]) -> f64 {
        let squares = l
            .iter()
            .zip(&self.row_weight)
            .filter(|(_, weight)| **weight > 0.0)
            .map(|(l, weight)| l * l / weight);
        let largest = squares.fold(0.0, larger);
        if self.work.scale > 0.0 {
            ROUNDING * (largest / self.work.scale).sqrt()
        } else {
            0.0
        }
    }

    /// Solves the factored system for the residuals in `work`; the answer is the step in `work`.
    fn correction<D: Size>(&mut self, dof: D, factor: Use) {
        let n = dof.get();
        let work = &mut self.work;
        if !self.auxiliaries.is_empty() {
            work.step_l.fill(0.0);
        }
        for aux in &mut self.auxiliaries {
            aux.particular(&work.aux, &mut work.step_l);
            for slot in 0..self.pattern.shape().elements[aux.element].bodies.len() {
                let body = self.pattern.shape().elements[aux.element].bodies[slot];
                if body < self.pattern.shape().bodies {
                    let block = &self.jac[self.pattern.jac_offset(aux.element, slot)..];
                    let l = &work.step_l[aux.row..];
                    add_apply_transposed(
                        (aux.rows, dof),
                        -1.0,
                        &mut work.force[body * n..],
                        block,
                        l,
                    );
                }
            }
        }
        // J M^-1 J^T l = J M^-1 f - g
        for (to, &g) in work.turned.iter_mut().zip(&work.row) {
            *to = -g;
        }
        for aux in &mut self.auxiliaries {
            aux.turn(&mut work.turned);
        }
        for block in &self.pattern.incidences {
            let force = &work.force[block.body * n..];
            let to = &mut work.turned[block.row..];
            with_size!(block.rows, rows => add_apply((rows, dof), 1.0, to, &self.w[block.jac..], force));
        }
        let factor = match factor {
            Use::Plain => &self.plain,
            Use::Lifted => &self.lifted,
        };
        self.ldl.solve(factor, &mut work.turned);
        // a = M^-1 f - M^-1 J^T l
        work.step_a.fill(0.0);
        for body in 0..self.pattern.shape().bodies {
            let inverse = &self.mass_inverse[body * n * n..];
            add_apply(
                (dof, dof),
                1.0,
                &mut work.step_a[body * n..],
                inverse,
                &work.force[body * n..],
            );
        }
        for block in &self.pattern.incidences {
            let to = &mut work.step_a[block.body * n..];
            let l = &work.turned[block.row..];
            with_size!(block.rows, rows => add_apply_transposed((rows, dof), -1.0, to, &self.w[block.jac..], l));
        }
        if self.auxiliaries.is_empty() {
            std::mem::swap(&mut work.step_l, &mut work.turned);
            return;
        }
        let mut next = 0;
        for aux in &mut self.auxiliaries {
            work.step_l[next..aux.row].copy_from_slice(&work.turned[next..aux.row]);
            next = aux.row + aux.rows;
            aux.add_turned(&work.turned, &mut work.step_l);
            let local = &mut work.local[..aux.rows];
            local.copy_from_slice(&work.row[aux.row..next]);
            for slot in 0..self.pattern.shape().elements[aux.element].bodies.len() {
                let body = self.pattern.shape().elements[aux.element].bodies[slot];
                if body < self.pattern.shape().bodies {
                    let block = &self.jac[self.pattern.jac_offset(aux.element, slot)..];
                    add_apply(
                        (aux.rows, dof),
                        -1.0,
                        local,
                        block,
                        &work.step_a[body * n..],
                    );
                }
            }
            aux.solve_aux(local, &mut work.step_s);
        }
        work.step_l[next..].copy_from_slice(&work.turned[next..]);
    }

    /// Sets the residuals in `work` to those of the true equations and measures them.
    fn residual<D: Size>(
        &mut self,
        dof: D,
        mass: &[f64],
        rhs: Rhs<'_>,
        a: &[f64],
        l: &[f64],
        s: &[f64],
    ) -> f64 {
        let n = dof.get();
        let work = &mut self.work;
        // Squares of weighted numbers: the largest residual and the largest term.
        let (mut worst, mut scale) = (0.0_f64, 0.0_f64);
        // Not finite as soon as one residual is not.
        let mut sum_of_all = 0.0;
        work.force.fill(0.0);
        work.row.fill(0.0);
        for block in &self.pattern.incidences {
            let jac = &self.jac[block.jac..];
            let force = &mut work.force[block.body * n..];
            let row = &mut work.row[block.row..];
            with_size!(block.rows, rows => {
                add_apply_transposed((rows, dof), 1.0, force, jac, &l[block.row..]);
                add_apply((rows, dof), 1.0, row, jac, &a[block.body * n..]);
            });
        }
        for body in 0..self.pattern.shape().bodies {
            let (block, inverse) = (
                &mass[body * n * n..][..n * n],
                &self.mass_inverse[body * n * n..][..n * n],
            );
            let a = &a[body * n..][..n];
            let force = &mut work.force[body * n..][..n];
            let f = &rhs.f[body * n..][..n];
            for i in 0..n {
                let mut inertia = 0.0;
                for j in 0..n {
                    inertia += block[i * n + j] * a[j];
                }
                let term = larger(larger(force[i].abs(), f[i].abs()), inertia.abs());
                let rest = f[i] - inertia - force[i];
                force[i] = rest;
                let weight = inverse[i * n + i];
                worst = larger(worst, rest * rest * weight);
                scale = larger(scale, term * term * weight);
                sum_of_all += rest;
            }
        }
        for aux in &self.auxiliaries {
            let block = aux.block(&self.jac_aux);
            for k in 0..aux.count {
                let at = aux.first + k;
                let (mut sum, mut term) = (0.0, rhs.h[at].abs());
                for i in 0..aux.rows {
                    let product = block[i * aux.count + k] * l[aux.row + i];
                    sum += product;
                    term = term.max(product.abs());
                    work.row[aux.row + i] += block[i * aux.count + k] * s[at];
                }
                let rest = rhs.h[at] - sum;
                work.aux[at] = rest;
                worst = larger(worst, rest * rest * self.aux_weight[at]);
                scale = larger(scale, term * term * self.aux_weight[at]);
                sum_of_all += rest;
            }
        }
        for ((row, &g), &weight) in work.row.iter_mut().zip(rhs.g).zip(&self.row_weight) {
            let term = larger(g.abs(), row.abs());
            let rest = g - *row;
            *row = rest;
            worst = larger(worst, rest * rest * weight);
            scale = larger(scale, term * term * weight);
            sum_of_all += rest;
        }
        work.scale = scale;
        match (f64::is_finite(sum_of_all) && scale.is_finite(), scale > 0.0) {
            (false, _) => f64::INFINITY,
            (true, false) => 0.0,
            (true, true) => (worst / scale).sqrt(),
        }
    }
}

/// The larger of two numbers, in one instruction; the first one if the second is NaN.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// `to += step`
fn add(to: &mut [f64], step: &[f64]) {
    for (to, step) in to.iter_mut().zip(step) {
        *to += step;
    }
}
