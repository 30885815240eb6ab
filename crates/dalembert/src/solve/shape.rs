//! The fixed pattern of a constrained system: which element touches which bodies.

use smallvec::SmallVec;

/// One element of the system: a group of constraint rows, the bodies that they touch and their auxiliaries.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ElementShape {
    /// Number of constraint rows.
    pub rows: usize,
    /// Numbers of the bodies that the rows touch, each once; the ground is not listed.
    pub bodies: SmallVec<[usize; 4]>,
    /// Number of auxiliary unknowns (surface parameters) that belong to this element alone.
    pub aux: usize,
}

/// The pattern of the saddle system `[M J^T 0; J 0 Js; 0 Js^T 0]`.
///
/// Any pattern is valid. A body number that is not below `bodies` counts as ground: its blocks keep their place in
/// the Jacobian's values and take part in nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SaddleShape {
    /// Number of bodies that move.
    pub bodies: usize,
    /// Velocity coordinates of one body: 3 planar, 6 spatial.
    pub dof: usize,
    /// The elements; their rows and auxiliaries are numbered in this order.
    pub elements: Vec<ElementShape>,
}
