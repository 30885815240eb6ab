//! A machine at rest, evaluated in comparable units.

use crate::analysis::AnalysisError;
use crate::analysis::least_reactions::LeastReactions;
use crate::analysis::meeting::Meeting;
use crate::analysis::newton::{NewtonOptions, correct_positions};
use crate::analysis::sides::facing;
use crate::analysis::weights::Weights;
use crate::joint::RowUnit;
use crate::solve::RankError;
use crate::space::{Space, Tuple, norm};
use crate::system::{ForceData, State, System, Workspace};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// Distance of the points of a central difference, in units of the machine's size and of radians:
/// the cube root of the rounding error balances truncation and rounding.
const DIFFERENCE: f64 = 1e-5;

/// A machine at rest with its drivers frozen at one time.
///
/// Coordinates are scaled: lengths count in units of the machine's size, so generalized forces are
/// energies [J], and rows count in units of their row scales.
pub(super) struct Problem<'a, S: Space> {
    pub system: &'a System<S>,
    pub ws: Workspace<S>,
    /// Size of a unit of each coordinate.
    pub unit: DVector<f64>,
    /// Unit of each row.
    pub row_unit: DVector<f64>,
    pub newton: NewtonOptions,
    weights: Weights,
    least: LeastReactions,
    meeting: Meeting<S>,
    state: State,
    trial: Vec<f64>,
}

impl<'a, S: Space> Problem<'a, S> {
    /// Poses are refused at which points meet that an element acts between.
    pub fn new(system: &'a System<S>, newton: NewtonOptions) -> Self {
        let mut unit = DVector::from_element(system.nv(), 1.0);
        for k in (0..system.body_nv()).filter(|k| k % S::NV < S::LINEAR) {
            unit[k] = system.size;
        }
        let mut ws = Workspace::new(system);
        for (k, own) in auxiliary_units(system, &mut ws) {
            unit[k] = own;
        }
        Self {
            ws,
            unit,
            row_unit: DVector::from_fn(system.rows, |row, _| system.row_scale(row)),
            newton,
            weights: Weights::even(system),
            least: LeastReactions::new(system),
            meeting: Meeting::new(system),
            state: State {
                t: system.estimate.t,
                q: vec![0.0; system.nq()],
                v: vec![0.0; system.nv()],
            },
            trial: Vec::new(),
            system,
        }
    }

    /// The time at which everything is evaluated.
    pub fn time(&self) -> f64 {
        self.state.t
    }

    /// Evaluates at another time from now on.
    pub fn set_time(&mut self, t: f64) {
        self.state.t = t;
    }

    /// Moves a pose onto the constraints, as little as possible.
    pub fn assemble(&mut self, q: &mut [f64]) -> Result<(), AnalysisError> {
        self.state.q.copy_from_slice(q);
        correct_positions(
            self.system,
            &mut self.ws,
            &mut self.state,
            &self.weights,
            &self.newton,
            &mut self.trial,
        )?;
        facing(self.system, &self.ws, self.state.t)?;
        q.copy_from_slice(&self.state.q);
        Ok(())
    }

    /// Markers, constraints and forces at a pose, all velocities zero.
    pub fn evaluate(&mut self, q: &[f64]) -> Result<(), AnalysisError> {
        self.system.update_markers(q, &self.state.v, &mut self.ws);
        self.meeting.check(self.system, &self.ws, self.state.t)?;
        self.system.evaluate_constraints(self.state.t, &mut self.ws);
        self.system.evaluate_forces(self.state.t, &mut self.ws);
        let ws = &self.ws;
        if let Some(row) = ws.value.iter().position(|c| !c.is_finite()) {
            return Err(self.not_finite(self.system.row_name(row)));
        }
        if ws.force.iter().any(|x| !x.is_finite()) {
            let bad = self.system.forces.iter().find(|f| {
                self.wrenches(f)
                    .iter()
                    .any(|(_, w)| w.as_slice().iter().any(|x| !x.is_finite()))
            });
            return Err(self.not_finite(bad.map_or_else(
                || "a force".to_owned(),
                |f| format!("{} ({})", f.name, f.kind),
            )));
        }
        Ok(())
    }

    fn not_finite(&self, element: String) -> AnalysisError {
        AnalysisError::NotFinite {
            element,
            time: self.state.t,
        }
    }

    /// A rank decision that failed: only numbers that are not finite make it fail.
    pub fn rank_error(&self, error: RankError) -> AnalysisError {
        self.not_finite(format!("the constraint Jacobian ({error})"))
    }

    /// Wrenches of a force element on its markers, at the markers of the workspace.
    pub fn wrenches(&self, force: &ForceData<S>) -> Vec<(usize, S::Twist)> {
        let markers: Vec<S::Marker> = force.markers.iter().map(|&m| self.ws.markers[m]).collect();
        let mut wrenches = vec![S::Twist::zero(); markers.len()];
        force
            .element
            .wrenches(self.state.t, &markers, &mut wrenches);
        force.markers.iter().copied().zip(wrenches).collect()
    }

    /// The scaled generalized force of wrenches on markers.
    pub fn generalized(&self, wrenches: &[(usize, S::Twist)]) -> DVector<f64> {
        let mut out = DVector::zeros(self.system.nv());
        for (m, w) in wrenches {
            if let Some(b) = self.system.markers[*m].body {
                let pulled = S::pull(&self.ws.markers[*m], w);
                for (k, x) in (S::NV * b..).zip(pulled.as_slice()) {
                    out[k] += x * self.unit[k];
                }
            }
        }
        out
    }

    /// The largest scaled generalized force that a single element or weight exerts: what a residual
    /// is compared with. Sums would vanish at an equilibrium.
    pub fn force_scale(&self) -> f64 {
        let mut scale: f64 = 0.0;
        for (w, u) in self.system.weight.iter().zip(self.unit.iter()) {
            scale = scale.max((w * u).abs());
        }
        for f in &self.system.forces {
            for wrench in self.wrenches(f) {
                scale = scale.max(self.generalized(&[wrench]).amax());
            }
        }
        scale
    }

    /// Potential energy of weights and force elements [J] (constant forces have none).
    pub fn potential(&self) -> f64 {
        let mut sum = 0.0;
        for (b, body) in self.system.bodies.iter().enumerate() {
            let point = S::point(&self.ws.markers[body.center_marker]);
            let weight = &self.system.weight[S::NV * b..][..S::LINEAR];
            sum -= weight.iter().zip(point).map(|(w, x)| w * x).sum::<f64>();
        }
        sum + self.stored()
    }

    /// Potential energy of the force elements [J].
    pub fn stored(&self) -> f64 {
        let report = |f: &ForceData<S>| {
            let markers: Vec<S::Marker> = f.markers.iter().map(|&m| self.ws.markers[m]).collect();
            f.element.report(self.state.t, &markers).potential
        };
        self.system.forces.iter().map(report).sum()
    }

    /// The scaled constraint Jacobian.
    pub fn jacobian(&self) -> DMatrix<f64> {
        let mut c = self.system.dense_jacobian(&self.ws);
        for (mut column, u) in c.column_iter_mut().zip(self.unit.iter()) {
            column *= *u;
        }
        for (mut row, u) in c.row_iter_mut().zip(self.row_unit.iter()) {
            row /= *u;
        }
        c
    }

    /// The scaled applied forces.
    pub fn forces(&self) -> DVector<f64> {
        DVector::from_fn(self.ws.force.len(), |k, _| self.ws.force[k] * self.unit[k])
    }

    /// Multipliers and unbalanced force, both scaled, of the evaluated pose: the force that is left
    /// in the free motions, by the sparse solver. `None` where rows depend on each other.
    pub fn balance(&mut self) -> Option<(DVector<f64>, DVector<f64>)> {
        let factored = self.ws.factor(&self.weights.inverse);
        if !factored.vanished.is_empty() || !factored.zero.is_empty() {
            return None;
        }
        self.ws.rhs.fill(0.0);
        if !self.ws.solve_forces(&self.weights.blocks).converged {
            return None;
        }
        let lambda = self.ws.lambda.iter().zip(&self.row_unit);
        let lambda = DVector::from_iterator(self.system.rows, lambda.map(|(l, u)| l * u));
        let unbalanced = self.unbalanced(&lambda);
        Some((lambda, unbalanced))
    }

    /// The free motion at the evaluated pose that comes nearest to a wanted scaled step, each
    /// coordinate of a body counting by its weight.
    pub fn nearest_motion(&mut self, wanted: &DVector<f64>, weight: &DVector<f64>) -> DVector<f64> {
        let n = S::NV;
        let mut blocks = vec![0.0; self.system.mass.len()];
        let mut inverse = blocks.clone();
        let mut f = vec![0.0; self.system.nv()];
        for k in 0..self.system.body_nv() {
            let w = weight[k] / (self.unit[k] * self.unit[k]);
            blocks[n * k + k % n] = w;
            inverse[n * k + k % n] = 1.0 / w;
            f[k] = w * wanted[k] * self.unit[k];
        }
        self.ws.factor(&inverse);
        self.ws.rhs.fill(0.0);
        self.ws.solve(&blocks, &f);
        DVector::from_fn(self.unit.len(), |k, _| self.ws.a[k] / self.unit[k])
    }

    /// Of the sets of multipliers (scaled; the answer is not) that balance the same forces at the
    /// evaluated pose, the least one.
    pub fn least_multipliers(&mut self, lambda: &DVector<f64>) -> Vec<f64> {
        for ((to, l), u) in self.ws.lambda.iter_mut().zip(lambda).zip(&self.row_unit) {
            *to = l / u;
        }
        self.least.settle(self.system, &mut self.ws);
        self.ws.lambda.clone()
    }

    /// Names of the elements whose reactions are not unique at the evaluated pose.
    pub fn not_unique(&mut self) -> Vec<&'a str> {
        let lambda = self.ws.lambda.clone();
        self.least.settle(self.system, &mut self.ws);
        self.ws.lambda = lambda;
        self.least.not_unique(self.system)
    }

    /// The scaled unbalanced force F = Q_e - C_q^T lambda at the evaluated pose (Shabana 6.171).
    pub fn unbalanced(&self, lambda: &DVector<f64>) -> DVector<f64> {
        let mut f = self.ws.force.clone();
        let plain: Vec<f64> = lambda
            .iter()
            .zip(self.row_unit.iter())
            .map(|(l, u)| l / u)
            .collect();
        self.system
            .jac_transpose_add(&self.ws, -1.0, &plain, &mut f);
        DVector::from_fn(f.len(), |k, _| f[k] * self.unit[k])
    }

    /// Stiffness -dF/dq along scaled directions, one column each, at fixed multipliers. The workspace
    /// is left at another pose.
    ///
    /// Turns in space do not commute: with F in the axes of the turning bodies the matrix is Newton's, but symmetric only
    /// where F = 0, K_ij - K_ji = F . [e_i, e_j]. Its symmetric part is the second derivative of a potential along steps
    /// of constant velocity at any pose.
    pub fn stiffness(
        &mut self,
        q: &[f64],
        lambda: &DVector<f64>,
        directions: &DMatrix<f64>,
    ) -> Result<DMatrix<f64>, AnalysisError> {
        let mut k = DMatrix::zeros(directions.nrows(), directions.ncols());
        let mut shifted = vec![0.0; q.len()];
        for j in 0..directions.ncols() {
            let direction = directions.column(j).into_owned();
            let mut side = |factor: f64| -> Result<DVector<f64>, AnalysisError> {
                shifted.copy_from_slice(q);
                self.shift(&mut shifted, factor, &direction);
                self.evaluate(&shifted)?;
                Ok(self.unbalanced(lambda))
            };
            let slope = (side(-DIFFERENCE)? - side(DIFFERENCE)?) / (2.0 * DIFFERENCE);
            k.set_column(j, &slope);
        }
        Ok(k)
    }

    /// Moves a pose by a scaled step.
    pub fn shift(&self, q: &mut [f64], factor: f64, step: &DVector<f64>) {
        let plain = step.iter().zip(self.unit.iter());
        let plain: Vec<f64> = plain.map(|(d, u)| factor * d * u).collect();
        self.system.advance(q, 1.0, &plain);
    }

    /// The scaled step that `shift` needs from one pose to another.
    pub fn difference(&self, from: &[f64], to: &[f64]) -> DVector<f64> {
        DVector::from_vec(self.system.difference(from, to)).component_div(&self.unit)
    }

    /// The same with angles by the shorter way round, and without the auxiliary coordinates, which follow the bodies.
    pub fn shorter_way(&self, from: &[f64], to: &[f64]) -> DVector<f64> {
        let mut way = self.difference(from, to);
        for (k, d) in way.iter_mut().enumerate() {
            if k >= self.system.body_nv() {
                *d = 0.0;
            } else if k % S::NV >= S::LINEAR {
                *d -= 2.0 * PI * (*d / (2.0 * PI)).round();
            }
        }
        way
    }

    /// Moves of a scaled step in units of the size, and turns [rad], of every body.
    pub fn moves_and_turns(&self, step: &DVector<f64>) -> Vec<[f64; 2]> {
        let bodies = step.as_slice()[..self.system.body_nv()].chunks_exact(S::NV);
        let parts = bodies.map(|own| own.split_at(S::LINEAR));
        parts.map(|(a, b)| [norm(a), norm(b)]).collect()
    }

    /// Does a scaled coordinate turn something (auxiliary coordinates count as turns)?
    pub fn turns(&self, k: usize) -> bool {
        k >= self.system.body_nv() || k % S::NV >= S::LINEAR
    }
}

/// Units of the auxiliary coordinates of unknown kind: some are lengths, the parameters of a plane, and in a large machine
/// many for one step. What a coordinate does to the rows at the estimate tells, between one and the size.
fn auxiliary_units<S: Space>(system: &System<S>, ws: &mut Workspace<S>) -> Vec<(usize, f64)> {
    let labels = system.elements.iter().flat_map(|e| e.element.auxiliaries());
    let unknown: Vec<usize> = (system.body_nv()..)
        .zip(labels)
        .filter(|(_, label)| label.unit == RowUnit::Other)
        .map(|(k, _)| k)
        .collect();
    if unknown.is_empty() {
        return Vec::new();
    }
    system.update_markers(&system.estimate.q, &vec![0.0; system.nv()], ws);
    system.evaluate_constraints(system.estimate.t, ws);
    let jacobian = system.dense_jacobian(ws);
    let unit = |k: usize| {
        let column = jacobian.column(k);
        let scaled = (0..system.rows).map(|row| (column[row] / system.row_scale(row)).abs());
        let gradient = scaled.fold(0.0, f64::max);
        // Also where it is not finite.
        if gradient > 0.0 {
            (1.0 / gradient).clamp(1.0, system.size.max(1.0))
        } else {
            1.0
        }
    };
    unknown.into_iter().map(|k| (k, unit(k))).collect()
}

/// The factor that keeps a scaled step within what a linear model can mean: half a radian, twice
/// the size.
pub(super) fn step_limit<S: Space>(system: &System<S>, step: &DVector<f64>) -> f64 {
    let mut worst: f64 = 0.0;
    for (k, x) in step.iter().enumerate() {
        let linear = k < system.body_nv() && k % S::NV < S::LINEAR;
        worst = worst.max(if linear { x.abs() / 4.0 } else { x.abs() });
    }
    if worst > 0.5 { 0.5 / worst } else { 1.0 }
}
