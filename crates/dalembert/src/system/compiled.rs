//! The compiled system.

use super::plan::Plan;
use super::{
    BodyData, ElementData, ForceData, MarkerData, Metric, Phase, Role, State, TraceData, TurnData,
};
use crate::joint::{RowLabel, RowUnit};
use crate::solve::{ElementShape, SaddleShape};
use crate::space::Space;

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
    pub(super) active: Vec<usize>,
    max_rows: usize,
    max_markers: usize,
    max_aux: usize,
    pub(super) plan: Plan<S>,
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
