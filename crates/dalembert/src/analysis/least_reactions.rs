//! One set of reactions where redundant constraints leave a choice.

use super::weights::Weights;
use crate::formulation::column_scale;
use crate::solve::Rhs;
use crate::space::Space;
use crate::system::{System, Workspace};

/// Part of a combination of rows that may be left when it should vanish: rounding leaves 1e-13.
const VANISHES: f64 = 1e-9;
/// A combination is new where this part of it lies outside of the others.
const NEW: f64 = 1e-8;
/// Part of a row in the vanishing combinations from which on its multiplier is not unique.
const OPEN: f64 = 1e-7;

/// Takes from all multipliers that balance the same forces those with the least sum of squares, each
/// multiplied by the scale of its row (a length: the machine's size; an angle: one).
///
/// So forces and moments are compared as energies, and the set depends neither on masses nor on the
/// coordinates, the analysis or the solver: only on the machine and its pose. The cost is linear in
/// the machine for each redundant row.
#[derive(Debug)]
pub(super) struct LeastReactions {
    weights: Weights,
    column_scale: Vec<f64>,
    /// Orthonormal combinations of the scaled rows that vanish at the pose.
    combinations: Vec<Vec<f64>>,
    accelerations: Vec<f64>,
    auxiliaries: Vec<f64>,
    multipliers: Vec<f64>,
    force: Vec<f64>,
}

impl LeastReactions {
    /// For the rows of a system.
    pub fn new<S: Space>(system: &System<S>) -> Self {
        Self {
            weights: Weights::even(system),
            column_scale: column_scale(system),
            combinations: Vec::new(),
            accelerations: vec![0.0; system.body_nv()],
            auxiliaries: vec![0.0; system.aux],
            multipliers: vec![0.0; system.rows],
            force: vec![0.0; system.nv()],
        }
    }

    /// Replaces the multipliers of the workspace, whose Jacobian is that of the pose, by the least
    /// ones. The factors of the workspace are then those of the even metric.
    pub fn settle<S: Space>(&mut self, system: &System<S>, ws: &mut Workspace<S>) {
        self.find_combinations(system, ws);
        if self.combinations.is_empty() {
            return;
        }
        for (row, l) in ws.lambda.iter_mut().enumerate() {
            *l *= system.row_scale(row);
        }
        // Twice: the first pass leaves rounding of what it takes away.
        for _ in 0..2 {
            for combination in &self.combinations {
                let part = dot(combination, &ws.lambda);
                add(&mut ws.lambda, -part, combination);
            }
        }
        for (row, l) in ws.lambda.iter_mut().enumerate() {
            *l /= system.row_scale(row);
        }
    }

    /// Is the multiplier of each row the same in every set, at the pose settled last?
    pub fn unique(&self, row: usize) -> bool {
        let part: f64 = self.combinations.iter().map(|c| c[row] * c[row]).sum();
        part.sqrt() <= OPEN
    }

    /// Names of the elements with a row whose multiplier is not unique, in order.
    pub fn not_unique<'s, S: Space>(&self, system: &'s System<S>) -> Vec<&'s str> {
        if self.combinations.is_empty() {
            return Vec::new();
        }
        let open = |rows: std::ops::Range<usize>| rows.into_iter().any(|row| !self.unique(row));
        let elements = system.elements.iter().filter(|e| open(e.rows.clone()));
        elements.map(|e| e.name.as_str()).collect()
    }

    /// The combinations of rows that vanish: every row without pivot follows from the others.
    fn find_combinations<S: Space>(&mut self, system: &System<S>, ws: &mut Workspace<S>) {
        self.combinations.clear();
        let factored = ws.factor(&self.weights.inverse);
        let dependent = [factored.vanished, factored.zero].concat();
        let without_gradient = factored.vanished.len();
        for (k, &row) in dependent.iter().enumerate() {
            let mut combination = vec![0.0; system.rows];
            combination[row] = 1.0;
            if k < without_gradient {
                self.express(system, ws, &mut combination);
            }
            for (row, x) in combination.iter_mut().enumerate() {
                *x *= system.row_scale(row);
            }
            self.keep(combination);
        }
    }

    /// Subtracts from a row what the rows together make of it: C_q^T l = (its gradient), so that the
    /// rest vanishes; it is set to zero where it does not.
    fn express<S: Space>(
        &mut self,
        system: &System<S>,
        ws: &mut Workspace<S>,
        combination: &mut [f64],
    ) {
        self.force.fill(0.0);
        system.jac_transpose_add(ws, 1.0, combination, &mut self.force);
        let rhs = Rhs {
            f: &self.force[..system.body_nv()],
            g: &vec![0.0; system.rows],
            h: &self.force[system.body_nv()..],
        };
        let (a, s) = (&mut self.accelerations, &mut self.auxiliaries);
        let l = &mut self.multipliers;
        ws.saddle.solve(&self.weights.blocks, rhs, a, l, s);
        add(combination, -1.0, &self.multipliers);
        self.force.fill(0.0);
        system.jac_transpose_add(ws, 1.0, combination, &mut self.force);
        let left = self.force.iter().zip(&self.column_scale);
        let left = left.fold(0.0_f64, |m, (x, s)| m.max((x * s).abs()));
        let scaled = combination.iter().enumerate();
        let size = scaled.fold(0.0_f64, |m, (row, x)| {
            m.max((x * system.row_scale(row)).abs())
        });
        // A comparison that is false for NaN.
        let vanishes = left <= VANISHES * size;
        if !vanishes {
            combination.fill(0.0);
        }
    }

    /// Keeps the part of a combination that the others do not have.
    fn keep(&mut self, mut combination: Vec<f64>) {
        let before = dot(&combination, &combination).sqrt();
        for _ in 0..2 {
            for other in &self.combinations {
                let part = dot(other, &combination);
                add(&mut combination, -part, other);
            }
        }
        let norm = dot(&combination, &combination).sqrt();
        if norm > NEW * before {
            for x in &mut combination {
                *x /= norm;
            }
            self.combinations.push(combination);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn add(to: &mut [f64], factor: f64, x: &[f64]) {
    for (to, x) in to.iter_mut().zip(x) {
        *to += factor * x;
    }
}
