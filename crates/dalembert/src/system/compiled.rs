//! The compiled system and its evaluation.

use super::plan::Plan;
use super::{
    BodyData, ElementData, ForceData, MarkerData, Metric, Phase, Role, State, TraceData, TurnData,
    Workspace,
};
use crate::joint::{ConstraintInput, ConstraintOutput, RowLabel, RowUnit};
use crate::solve::{ElementShape, SaddleShape};
use crate::space::{Space, Tuple};

/// A row of the constraint vector, for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowRef {
    /// Number of the element in [`System::elements`].
    pub element: usize,
    /// Label and unit.
    pub label: RowLabel,
}

/// A compiled machine: never changes. Coordinates: bodies in order, then auxiliaries; positions end with the angles that
/// are remembered to count turns.
#[derive(Clone, Debug)]
pub struct System<S: Space> {
    /// Name of the model.
    pub name: String,
    /// Movable bodies.
    pub bodies: Vec<BodyData<S>>,
    /// Frames on bodies and on the ground.
    pub markers: Vec<MarkerData<S>>,
    /// Constraint elements whose rows hold.
    pub elements: Vec<ElementData<S>>,
    /// Force elements (without gravity).
    pub forces: Vec<ForceData<S>>,
    /// Points whose motion is wanted.
    pub traces: Vec<TraceData>,
    /// Angles that count turns by memory; none in the plane.
    pub turns: Vec<TurnData<S>>,
    /// Mass matrix, NV x NV row-major a body (constant: central frames).
    pub mass: Vec<f64>,
    /// The mass matrix made regular, for the solver.
    pub metric: Metric,
    /// Does a body lack mass or inertia, so that M is singular?
    pub massless: bool,
    /// Weight of every body, generalized force of gravity.
    pub weight: Vec<f64>,
    /// Acceleration of gravity, components as the ground has them.
    pub gravity: Vec<f64>,
    /// Characteristic length: relative tolerances refer to it [m].
    pub size: f64,
    /// The user's estimate of the start.
    pub estimate: State,
    /// Weights of the assembly: how strongly the estimate of each velocity coordinate is kept.
    pub position_weight: Vec<f64>,
    /// The same for the velocities.
    pub velocity_weight: Vec<f64>,
    /// Number of constraint rows.
    pub rows: usize,
    /// Number of auxiliary coordinates.
    pub aux: usize,
    row_refs: Vec<RowRef>,
    /// Rows that hold for velocities only.
    velocity_rows: Vec<usize>,
    /// Markers that elements and forces see.
    active: Vec<usize>,
    max_rows: usize,
    max_markers: usize,
    max_aux: usize,
    plan: Plan<S>,
}

impl<S: Space> System<S> {
    /// Lays out a system from its parts; `elements` of all phases come in, those of the phase
    /// (and those that hold always) stay.
    #[allow(clippy::too_many_arguments)]
    pub(crate) fn new(
        name: String,
        bodies: Vec<BodyData<S>>,
        markers: Vec<MarkerData<S>>,
        elements: Vec<ElementData<S>>,
        forces: Vec<ForceData<S>>,
        traces: Vec<TraceData>,
        mass: Vec<f64>,
        gravity: Vec<f64>,
    ) -> Self {
        let mut system = Self {
            name,
            bodies,
            markers,
            elements,
            forces,
            traces,
            turns: Vec::new(),
            mass,
            metric: Metric::default(),
            massless: false,
            weight: Vec::new(),
            gravity,
            size: 1.0,
            estimate: State::default(),
            position_weight: Vec::new(),
            velocity_weight: Vec::new(),
            rows: 0,
            aux: 0,
            row_refs: Vec::new(),
            velocity_rows: Vec::new(),
            active: Vec::new(),
            max_rows: 0,
            max_markers: 0,
            max_aux: 0,
            plan: Plan::default(),
        };
        system.lay_out();
        system
    }

    fn lay_out(&mut self) {
        let (mut rows, mut aux) = (0, 0);
        self.row_refs.clear();
        self.velocity_rows.clear();
        for (number, e) in self.elements.iter_mut().enumerate() {
            let labels = e.element.labels();
            let auxiliaries = e.element.auxiliaries().len();
            e.bodies.clear();
            e.slots.clear();
            for &m in &e.markers {
                let slot = self.markers[m].body.map(|b| {
                    e.bodies.iter().position(|&x| x == b).unwrap_or_else(|| {
                        e.bodies.push(b);
                        e.bodies.len() - 1
                    })
                });
                e.slots.push(slot);
            }
            e.rows = rows..rows + labels.len();
            let own = e.element.velocity_rows();
            self.velocity_rows.extend(own.map(|r| rows + r));
            e.aux = aux..aux + auxiliaries;
            rows += labels.len();
            aux += auxiliaries;
            self.max_rows = self.max_rows.max(labels.len());
            self.max_markers = self.max_markers.max(e.markers.len());
            self.max_aux = self.max_aux.max(auxiliaries);
            self.row_refs.extend(labels.into_iter().map(|label| RowRef {
                element: number,
                label,
            }));
        }
        for f in &self.forces {
            self.max_markers = self.max_markers.max(f.markers.len());
        }
        self.rows = rows;
        self.aux = aux;
        let of_elements = self.elements.iter().flat_map(|e| &e.markers);
        let of_forces = self.forces.iter().flat_map(|f| &f.markers);
        let mut active: Vec<usize> = of_elements.chain(of_forces).copied().collect();
        // In the order of bodies, so that the poses are read one after the other.
        active.sort_by_key(|&m| (self.markers[m].body, m));
        active.dedup();
        active.retain(|&m| self.markers[m].body.is_some());
        self.active = active;
        self.plan = Plan::new(&self.elements);
    }

    /// The same machine with the rows of another choice of elements. Elements with auxiliary
    /// coordinates must stay, and stay in order, so that the coordinates keep their places.
    #[must_use]
    pub fn with_elements(&self, keep: impl Fn(&ElementData<S>) -> bool) -> Self {
        let mut system = self.clone();
        system.elements.retain(|e| keep(e));
        system.lay_out();
        system
    }

    /// The same machine with some elements kept and others added behind them. Added elements have no
    /// auxiliary coordinates.
    #[must_use]
    pub(crate) fn replace_elements(
        &self,
        keep: impl Fn(&ElementData<S>) -> bool,
        added: Vec<ElementData<S>>,
    ) -> Self {
        let mut system = self.clone();
        system.elements.retain(|e| keep(e));
        system.elements.extend(added);
        system.lay_out();
        system
    }

    /// The machine with the rows that always hold.
    #[must_use]
    pub fn running(&self) -> Self {
        self.with_elements(|e| e.phase == Phase::Always)
    }

    /// The machine with the rows that fix its positions at the start.
    #[must_use]
    pub fn start_positions(&self) -> Self {
        self.with_elements(|e| e.phase != Phase::StartVelocity)
    }

    /// The machine with the rows that fix its velocities at the start.
    #[must_use]
    pub fn start_velocities(&self) -> Self {
        self.with_elements(|e| e.phase != Phase::StartPosition)
    }

    /// The machine without its drivers.
    #[must_use]
    pub fn undriven(&self) -> Self {
        self.with_elements(|e| e.phase == Phase::Always && e.role != Role::Driver)
    }

    /// Number of position coordinates.
    pub fn nq(&self) -> usize {
        self.bodies.len() * S::NQ + self.aux + self.turns.len()
    }

    /// Number of velocity coordinates.
    pub fn nv(&self) -> usize {
        self.bodies.len() * S::NV + self.aux
    }

    /// Number of velocity coordinates that carry mass.
    pub fn body_nv(&self) -> usize {
        self.bodies.len() * S::NV
    }

    /// Rows that hold for velocities only (nonholonomic), ascending.
    pub fn velocity_rows(&self) -> &[usize] {
        &self.velocity_rows
    }

    /// The rows in order.
    pub fn row_refs(&self) -> &[RowRef] {
        &self.row_refs
    }

    /// A row in words: "joint A (revolute): x".
    pub fn row_name(&self, row: usize) -> String {
        let r = &self.row_refs[row];
        let e = &self.elements[r.element];
        format!("{} ({}): {}", e.name, e.kind, r.label.text)
    }

    /// Scale of a row's residual: what counts as 1.
    pub fn row_scale(&self, row: usize) -> f64 {
        match self.row_refs[row].label.unit {
            RowUnit::Length => self.size,
            RowUnit::Angle => 1.0,
            RowUnit::Other => self.elements[self.row_refs[row].element].scale,
        }
    }

    /// The block pattern of the equations of motion.
    pub fn shape(&self) -> SaddleShape {
        SaddleShape {
            bodies: self.bodies.len(),
            dof: S::NV,
            elements: self
                .elements
                .iter()
                .map(|e| ElementShape {
                    rows: e.rows.len(),
                    bodies: e.bodies.clone(),
                    aux: e.aux.len(),
                })
                .collect(),
        }
    }

    pub(crate) fn scratch_sizes(&self) -> (usize, usize, usize) {
        (self.max_rows, self.max_markers, self.max_aux)
    }

    /// Poses and velocities of all markers.
    pub fn update_markers(&self, q: &[f64], v: &[f64], ws: &mut Workspace<S>) {
        self.update_poses(q, v, ws);
        for m in 0..self.markers.len() {
            self.update_marker(m, v, ws);
        }
        self.set_turns(q, ws);
    }

    /// Poses and velocities of the markers that elements and forces see: all that an evaluation of
    /// the equations of motion needs.
    pub fn update_active_markers(&self, q: &[f64], v: &[f64], ws: &mut Workspace<S>) {
        self.update_poses(q, v, ws);
        for &m in &self.active {
            self.update_marker(m, v, ws);
        }
        self.set_turns(q, ws);
    }

    fn update_marker(&self, m: usize, v: &[f64], ws: &mut Workspace<S>) {
        let data = &self.markers[m];
        // Markers on the ground stay as the workspace was made.
        if let Some(b) = data.body {
            ws.markers[m] = S::marker(&data.frame, &ws.poses[b], &v[b * S::NV..(b + 1) * S::NV]);
        }
    }

    fn update_poses(&self, q: &[f64], v: &[f64], ws: &mut Workspace<S>) {
        for (pose, q) in ws.poses.iter_mut().zip(q.chunks_exact(S::NQ)) {
            *pose = S::pose(q);
        }
        if S::GYROSCOPIC {
            let (bodies, n) = (self.bodies.len(), S::NV);
            for (b, v) in v.chunks_exact(n).take(bodies).enumerate() {
                ws.gyroscopic[b] = S::gyroscopic(self.mass_block(b), v);
            }
        }
        let (nq, nv) = (self.bodies.len() * S::NQ, self.body_nv());
        ws.s.copy_from_slice(&q[nq..nq + self.aux]);
        ws.s_rate.copy_from_slice(&v[nv..]);
    }

    /// C, C_q, C_t and Q_d at the markers of the workspace.
    ///
    /// Q_d = -(d2C/dt2 at zero accelerations) (Shabana 3.124, 6.140).
    pub fn evaluate_constraints(&self, t: f64, ws: &mut Workspace<S>) {
        let Workspace {
            markers,
            s,
            s_rate,
            value,
            time,
            qd,
            jac,
            jac_aux,
            local_markers,
            gradient,
            ..
        } = ws;
        let (mut row, mut aux, mut at, mut at_aux) = (0, 0, 0, 0);
        for step in self.plan.steps() {
            let (nm, nr, na) = (step.places.len(), step.rows, step.aux);
            for (local, place) in local_markers.iter_mut().zip(step.places) {
                *local = markers[place.marker()];
            }
            let block = nr * S::NV;
            let rows = row..row + nr;
            let auxiliaries = aux..aux + na;
            let gradient = &mut gradient[..nr * nm];
            let jac = &mut jac[at..at + step.bodies * block];
            let jac_aux = &mut jac_aux[at_aux..at_aux + nr * na];
            let (value, time, qd) = (
                &mut value[rows.clone()],
                &mut time[rows.clone()],
                &mut qd[rows.clone()],
            );
            for out in [&mut *value, &mut *time, &mut *qd, &mut *jac, &mut *jac_aux] {
                out.fill(0.0);
            }
            gradient.fill(S::Twist::zero());
            step.element.evaluate(
                &ConstraintInput {
                    t,
                    markers: &local_markers[..nm],
                    s: &s[auxiliaries.clone()],
                    s_rate: &s_rate[auxiliaries.clone()],
                },
                &mut ConstraintOutput {
                    value,
                    gradient,
                    auxiliary: jac_aux,
                    time,
                    bias: qd,
                },
            );
            for (k, place) in step.places.iter().enumerate() {
                let Some(slot) = place.slot() else { continue };
                let m = &local_markers[k];
                let own = S::bias(m);
                for r in 0..nr {
                    let g = &gradient[r * nm + k];
                    let pulled = S::pull(m, g);
                    let start = slot * block + r * S::NV;
                    for (x, y) in jac[start..start + S::NV].iter_mut().zip(pulled.as_slice()) {
                        *x += y;
                    }
                    qd[r] += g.dot(&own);
                }
            }
            for x in qd.iter_mut() {
                *x = -*x;
            }
            row = rows.end;
            aux = auxiliaries.end;
            at += step.bodies * block;
            at_aux += nr * na;
        }
    }

    /// The same as [`System::evaluate_constraints`], for what holds positions alone: rows that hold for velocities only
    /// have no gradient.
    pub fn evaluate_positions(&self, t: f64, ws: &mut Workspace<S>) {
        self.evaluate_constraints(t, ws);
        if self.velocity_rows.is_empty() {
            return;
        }
        let (jac, jac_aux) = (&mut ws.jac, &mut ws.jac_aux);
        self.each_block(|e, _, at| {
            for (r, row) in e.rows.clone().enumerate() {
                if self.velocity_rows.binary_search(&row).is_ok() {
                    jac[at + r * S::NV..at + (r + 1) * S::NV].fill(0.0);
                }
            }
        });
        self.each_aux(|row, _, at| {
            if self.velocity_rows.binary_search(&row).is_ok() {
                jac_aux[at] = 0.0;
            }
        });
    }

    /// Generalized applied forces Q_e (gravity and force elements) and inertia forces Q_v of turning
    /// bodies, into `ws.force`.
    pub fn evaluate_forces(&self, t: f64, ws: &mut Workspace<S>) {
        let Workspace {
            markers,
            force,
            gyroscopic,
            local_markers,
            gradient,
            ..
        } = ws;
        force[..self.weight.len()].copy_from_slice(&self.weight);
        force[self.weight.len()..].fill(0.0);
        for (force, own) in force.chunks_exact_mut(S::NV).zip(gyroscopic.iter()) {
            for (x, y) in force.iter_mut().zip(own.as_slice()) {
                *x += y;
            }
        }
        for f in &self.forces {
            let nm = f.markers.len();
            for (slot, &m) in local_markers.iter_mut().zip(&f.markers) {
                *slot = markers[m];
            }
            let wrench = &mut gradient[..nm];
            wrench.fill(S::Twist::zero());
            f.element.wrenches(t, &local_markers[..nm], wrench);
            for (k, &m) in f.markers.iter().enumerate() {
                if let Some(b) = self.markers[m].body {
                    let pulled = S::pull(&local_markers[k], &wrench[k]);
                    let at = b * S::NV;
                    for (x, y) in force[at..at + S::NV].iter_mut().zip(pulled.as_slice()) {
                        *x += y;
                    }
                }
            }
        }
    }

    /// Power of the force elements beyond what their potentials lose [W].
    pub fn force_power(&self, t: f64, ws: &mut Workspace<S>) -> f64 {
        let Workspace {
            markers,
            local_markers,
            gradient,
            ..
        } = ws;
        let mut power = 0.0;
        for f in &self.forces {
            let nm = f.markers.len();
            for (slot, &m) in local_markers.iter_mut().zip(&f.markers) {
                *slot = markers[m];
            }
            let (seen, wrench) = (&local_markers[..nm], &mut gradient[..nm]);
            wrench.fill(S::Twist::zero());
            f.element.wrenches(t, seen, wrench);
            power += f.element.report(t, seen).potential_rate;
            for (w, m) in wrench.iter().zip(seen) {
                power += w.dot(&S::twist(m));
            }
        }
        power
    }

    /// out = M v on the bodies.
    pub fn mass_mul(&self, v: &[f64], out: &mut [f64]) {
        let n = S::NV;
        for b in 0..self.bodies.len() {
            let block = &self.mass[b * n * n..(b + 1) * n * n];
            for i in 0..n {
                out[b * n + i] = (0..n).map(|j| block[i * n + j] * v[b * n + j]).sum();
            }
        }
    }

    /// out = C_q v (with the auxiliary columns).
    pub fn jac_mul(&self, ws: &Workspace<S>, v: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        self.each_block(|e, body, at| {
            for (r, row) in e.rows.clone().enumerate() {
                let j = &ws.jac[at + r * S::NV..at + (r + 1) * S::NV];
                let x = &v[body * S::NV..(body + 1) * S::NV];
                out[row] += j.iter().zip(x).map(|(a, b)| a * b).sum::<f64>();
            }
        });
        self.each_aux(|row, aux, at| out[row] += ws.jac_aux[at] * v[self.body_nv() + aux]);
    }

    /// out += factor * C_q^T lambda (with the auxiliary columns).
    pub fn jac_transpose_add(
        &self,
        ws: &Workspace<S>,
        factor: f64,
        lambda: &[f64],
        out: &mut [f64],
    ) {
        self.each_block(|e, body, at| {
            for (r, row) in e.rows.clone().enumerate() {
                let j = &ws.jac[at + r * S::NV..at + (r + 1) * S::NV];
                for (x, y) in out[body * S::NV..(body + 1) * S::NV].iter_mut().zip(j) {
                    *x += factor * lambda[row] * y;
                }
            }
        });
        let n = self.body_nv();
        self.each_aux(|row, aux, at| out[n + aux] += factor * lambda[row] * ws.jac_aux[at]);
    }

    pub(super) fn each_block(&self, mut f: impl FnMut(&ElementData<S>, usize, usize)) {
        let mut at = 0;
        for e in &self.elements {
            for &b in &e.bodies {
                f(e, b, at);
                at += e.rows.len() * S::NV;
            }
        }
    }

    fn each_aux(&self, mut f: impl FnMut(usize, usize, usize)) {
        let mut at = 0;
        for e in &self.elements {
            for row in e.rows.clone() {
                for aux in e.aux.clone() {
                    f(row, aux, at);
                    at += 1;
                }
            }
        }
    }

    /// C_q as a dense matrix, rows x velocity coordinates.
    pub fn dense_jacobian(&self, ws: &Workspace<S>) -> nalgebra::DMatrix<f64> {
        let mut c = nalgebra::DMatrix::zeros(self.rows, self.nv());
        self.each_block(|e, body, at| {
            for (r, row) in e.rows.clone().enumerate() {
                for k in 0..S::NV {
                    c[(row, body * S::NV + k)] += ws.jac[at + r * S::NV + k];
                }
            }
        });
        let n = self.body_nv();
        self.each_aux(|row, aux, at| c[(row, n + aux)] += ws.jac_aux[at]);
        c
    }

    /// M as a dense matrix (auxiliaries have none).
    pub fn dense_mass(&self) -> nalgebra::DMatrix<f64> {
        let mut m = nalgebra::DMatrix::zeros(self.nv(), self.nv());
        let n = S::NV;
        for b in 0..self.bodies.len() {
            for i in 0..n {
                for j in 0..n {
                    m[(b * n + i, b * n + j)] = self.mass[(b * n + i) * n + j];
                }
            }
        }
        m
    }

    /// What a residual, in units of the row scales, can be by the rounding of the positions alone:
    /// machines far from the origin, or after many turns.
    pub fn rounding(&self, q: &[f64]) -> f64 {
        let mut largest = [0.0_f64; 2];
        for body in q[..self.bodies.len() * S::NQ].chunks_exact(S::NQ) {
            let [distance, angle] = S::reach(body);
            largest = [largest[0].max(distance), largest[1].max(angle)];
        }
        4.0 * f64::EPSILON * (1.0 + largest[0] / self.size + largest[1])
    }

    /// Largest residual in units of the row scales, and its row.
    pub fn violation(&self, ws: &Workspace<S>) -> (f64, usize) {
        self.largest(&ws.value)
    }

    /// Largest entry of a vector over the rows, in units of the row scales, and its row.
    pub fn largest(&self, x: &[f64]) -> (f64, usize) {
        let mut worst = (0.0, 0);
        for (row, value) in x.iter().enumerate() {
            let scaled = value.abs() / self.row_scale(row);
            // A NaN counts as infinitely large.
            if scaled.is_nan() {
                return (f64::INFINITY, row);
            }
            if scaled > worst.0 {
                worst = (scaled, row);
            }
        }
        worst
    }

    /// The element of a name.
    pub fn element(&self, name: &str) -> Option<&ElementData<S>> {
        self.elements.iter().find(|e| e.name == name)
    }

    /// The drivers, in order.
    pub fn drivers(&self) -> impl Iterator<Item = &ElementData<S>> {
        self.elements.iter().filter(|e| e.role == Role::Driver)
    }

    /// Does a driver prescribe a motion?
    pub fn is_driven(&self) -> bool {
        self.drivers().next().is_some()
    }

    /// Names of the velocity coordinates in the user's words: "crank.x", "A.phi".
    pub fn coordinate_names(&self) -> Vec<String> {
        self.names(S::VELOCITY_NAMES)
    }

    /// Names of the position coordinates in the user's words: those of the velocities, but "body.b0" in space.
    pub fn position_names(&self) -> Vec<String> {
        self.names(S::POSITION_NAMES)
    }

    fn names(&self, of_bodies: &[&str]) -> Vec<String> {
        let mut names = Vec::with_capacity(of_bodies.len() * self.bodies.len() + self.aux);
        for b in &self.bodies {
            for c in of_bodies {
                names.push(format!("{}.{c}", b.name));
            }
        }
        for e in &self.elements {
            for label in e.element.auxiliaries() {
                names.push(format!("{}.{}", e.name, label.text));
            }
        }
        names
    }
}
