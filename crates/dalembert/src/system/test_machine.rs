//! Spatial machines put together by hand, for the tests of the analyses.

use super::{BodyData, Coordinate, ElementData, ForceData, MarkerData, Phase, Role, State, System};
use crate::force::MeasureForce;
use crate::joint::{Measure, MeasureRow, MeasureRows, SpatialMeasure};
use crate::signal::Coefficient;
use crate::space::orientation::{Axis, Rotation};
use crate::space::{Spatial, SpatialFrame};
use nalgebra::{Matrix3, Vector3};
use smallvec::SmallVec;
use std::sync::Arc;

/// The parts of a machine; poses of bodies are those of their centres of mass.
#[derive(Default)]
pub(crate) struct Machine {
    pub bodies: Vec<BodyData<Spatial>>,
    pub markers: Vec<MarkerData<Spatial>>,
    pub elements: Vec<ElementData<Spatial>>,
    pub forces: Vec<ForceData<Spatial>>,
    mass: Vec<f64>,
    estimate: State,
}

/// A measure from the first to the second marker of an element.
pub(crate) fn between(kind: SpatialMeasure) -> Measure<Spatial> {
    Measure {
        kind,
        first: 0,
        second: 1,
    }
}

/// A row that holds a measure at zero.
pub(crate) fn zero(kind: SpatialMeasure, label: &str) -> MeasureRow<Spatial> {
    MeasureRow::minus(between(kind), 0.0, label)
}

/// Rows that hold two points together.
pub(crate) fn together() -> Vec<MeasureRow<Spatial>> {
    vec![
        zero(SpatialMeasure::Ground(Axis::X), "x"),
        zero(SpatialMeasure::Ground(Axis::Y), "y"),
        zero(SpatialMeasure::Ground(Axis::Z), "z"),
    ]
}

/// Rows that hold two z axes parallel.
pub(crate) fn parallel() -> Vec<MeasureRow<Spatial>> {
    vec![
        zero(SpatialMeasure::Dot(Axis::X, Axis::Z), "tilt about y"),
        zero(SpatialMeasure::Dot(Axis::Y, Axis::Z), "tilt about x"),
    ]
}

impl Machine {
    /// Adds a body; `inertia` is the tensor in body axes. Returns its number.
    pub fn body(
        &mut self,
        name: &str,
        at: [f64; 3],
        turn: Rotation,
        mass: f64,
        inertia: Matrix3<f64>,
    ) -> usize {
        let number = self.bodies.len();
        let marker = self.marker(Some(number), [0.0; 3], Matrix3::identity());
        self.bodies.push(BodyData {
            name: name.to_owned(),
            index: number,
            frame: SpatialFrame::default(),
            frame_marker: marker,
            center_marker: marker,
            massless: mass == 0.0
                || inertia.symmetric_eigenvalues().min() <= 1e-12 * inertia.amax(),
        });
        let mut block = [0.0; 36];
        for i in 0..3 {
            block[7 * i] = mass;
            for j in 0..3 {
                block[6 * (3 + i) + 3 + j] = inertia[(i, j)];
            }
        }
        self.mass.extend(block);
        self.estimate.q.extend(at);
        self.estimate.q.extend([turn.w, turn.i, turn.j, turn.k]);
        self.estimate.v.extend([0.0; 6]);
        number
    }

    /// Puts the user's frame of a body somewhere.
    pub fn frame(&mut self, body: usize, at: [f64; 3], axes: Rotation) {
        let axes = *axes.to_rotation_matrix().matrix();
        let marker = self.marker(Some(body), at, axes);
        self.bodies[body].frame_marker = marker;
        self.bodies[body].frame = self.markers[marker].frame;
    }

    /// Adds a marker and returns its number.
    pub fn marker(&mut self, body: Option<usize>, at: [f64; 3], axes: Matrix3<f64>) -> usize {
        let at = Vector3::from(at);
        let frame = SpatialFrame { at, axes };
        self.markers.push(MarkerData { body, frame });
        self.markers.len() - 1
    }

    /// Adds a constraint element.
    pub fn element(
        &mut self,
        name: &str,
        kind: &str,
        role: Role,
        markers: [usize; 2],
        rows: Vec<MeasureRow<Spatial>>,
    ) {
        self.elements.push(ElementData {
            name: name.to_owned(),
            role,
            kind: kind.to_owned(),
            path: String::new(),
            phase: Phase::Always,
            element: Arc::new(MeasureRows::new(2, rows.into_iter().collect())),
            markers: SmallVec::from_slice(&markers),
            reaction_marker: 1,
            axes_marker: 0,
            coordinates: SmallVec::new(),
            auxiliary_start: SmallVec::new(),
            scale: 1.0,
            bodies: SmallVec::new(),
            slots: SmallVec::new(),
            rows: 0..0,
            aux: 0..0,
        });
    }

    /// Points together.
    pub fn spherical(&mut self, name: &str, markers: [usize; 2]) {
        self.element(name, "spherical", Role::Joint, markers, together());
    }

    /// Points together, z axes parallel; its coordinate is the angle about them.
    pub fn revolute(&mut self, name: &str, markers: [usize; 2]) {
        let rows = [together(), parallel()].concat();
        self.element(name, "revolute", Role::Joint, markers, rows);
        let coordinate = Coordinate {
            name: "angle",
            measure: between(SpatialMeasure::Angle(Axis::Z)),
        };
        if let Some(e) = self.elements.last_mut() {
            e.coordinates.push(coordinate);
        }
    }

    /// A force along a measure: stiffness * (measure - free) + pull, positive where it reduces the measure.
    pub fn force(
        &mut self,
        name: &str,
        kind: SpatialMeasure,
        markers: [usize; 2],
        [stiffness, free, pull]: [f64; 3],
    ) {
        self.forces.push(ForceData {
            name: name.to_owned(),
            kind: "force".to_owned(),
            path: String::new(),
            element: Arc::new(MeasureForce {
                measure: between(kind),
                stiffness: Coefficient::Constant(stiffness),
                damping: Coefficient::Constant(0.0),
                free: Coefficient::Constant(free),
                actuator: Coefficient::Constant(pull),
                pushes: false,
            }),
            markers: SmallVec::from_slice(&markers),
        });
    }

    /// The system, with gravity along -z.
    pub fn build(self, gravity: f64) -> System<Spatial> {
        let mut system = System::new(
            "machine".to_owned(),
            self.bodies,
            self.markers,
            self.elements,
            self.forces,
            Vec::new(),
            self.mass,
            vec![0.0, 0.0, -gravity],
        );
        system.position_weight = vec![1.0; system.body_nv()];
        system.velocity_weight = vec![1.0; system.body_nv()];
        system.estimate = self.estimate;
        system.set_size();
        system.set_masses();
        system
    }
}
