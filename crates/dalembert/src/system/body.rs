//! Compiled bodies.

use crate::space::Space;

/// A movable body of a compiled system.
#[derive(Clone, Debug)]
pub struct BodyData<S: Space> {
    /// Name.
    pub name: String,
    /// Number of the body in the model's list.
    pub index: usize,
    /// The user's body frame, from the centre of mass.
    pub frame: S::Frame,
    /// Marker of the user's body frame.
    pub frame_marker: usize,
    /// Marker of the centre of mass.
    pub center_marker: usize,
    /// Is the mass missing or zero?
    pub massless: bool,
}
