//! Compiled markers, constraint elements, force elements and traces.

use crate::force::ForceElement;
use crate::joint::{ConstraintElement, Measure};
use crate::space::{Planar, Space};
use smallvec::SmallVec;
use std::ops::Range;
use std::sync::Arc;

/// A frame on a body or on the ground: a vertex of the linear graph.
#[derive(Clone, Debug)]
pub struct MarkerData<S: Space> {
    /// Movable body, or none for the ground.
    pub body: Option<usize>,
    /// The frame, from the centre of mass (ground: from the origin).
    pub frame: S::Frame,
}

/// What a constraint element is in the user's model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A joint.
    Joint,
    /// A constraint that is not a joint.
    Constraint,
    /// A driver.
    Driver,
    /// An initial condition or a held coordinate.
    Start,
}

/// When the rows of an element hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Always.
    Always,
    /// At the start, for the positions.
    StartPosition,
    /// At the start, for the velocities.
    StartVelocity,
}

/// A free coordinate of a joint: a measure on the element's own markers.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate<S: Space = Planar> {
    /// Name: "angle", "displacement".
    pub name: &'static str,
    /// The measure (a basis vector of the motion subspace S).
    pub measure: Measure<S>,
}

/// A compiled constraint element.
#[derive(Clone, Debug)]
pub struct ElementData<S: Space> {
    /// Name.
    pub name: String,
    /// What it is for the user.
    pub role: Role,
    /// Kind in words: "revolute", "angle driver".
    pub kind: String,
    /// Place in the model.
    pub path: String,
    /// When it holds.
    pub phase: Phase,
    /// The equations.
    pub element: Arc<dyn ConstraintElement<S>>,
    /// Its markers, numbers in the system.
    pub markers: SmallVec<[usize; 4]>,
    /// Which of its markers the reaction is reported at (the second body's).
    pub reaction_marker: usize,
    /// Marker whose axes are the joint's axes.
    pub axes_marker: usize,
    /// Its free coordinates.
    pub coordinates: SmallVec<[Coordinate<S>; 2]>,
    /// Initial estimates of its auxiliary coordinates.
    pub auxiliary_start: SmallVec<[f64; 1]>,
    /// What counts as 1 in its rows that are neither lengths nor angles; set by the system.
    pub scale: f64,
    /// Distinct movable bodies; set by the system.
    pub bodies: SmallVec<[usize; 4]>,
    /// For each marker the position of its body in `bodies`; set by the system.
    pub slots: SmallVec<[Option<usize>; 4]>,
    /// Its rows; set by the system.
    pub rows: Range<usize>,
    /// Its auxiliary coordinates; set by the system.
    pub aux: Range<usize>,
}

/// A compiled force element.
#[derive(Clone, Debug)]
pub struct ForceData<S: Space> {
    /// Name.
    pub name: String,
    /// Kind in words.
    pub kind: String,
    /// Place in the model.
    pub path: String,
    /// The law.
    pub element: Arc<dyn ForceElement<S>>,
    /// Its markers, numbers in the system.
    pub markers: SmallVec<[usize; 4]>,
}

/// A point whose motion is wanted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TraceData {
    /// Name.
    pub name: String,
    /// Its marker.
    pub marker: usize,
    /// Frame marker of the body that observes it, and that body's name.
    pub observer: Option<(usize, String)>,
}
