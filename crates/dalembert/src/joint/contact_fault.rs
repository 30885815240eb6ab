//! Poses in which the rows of a contact hold, but not its surfaces.

/// Why surfaces do not touch as they should although the rows of their contact hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactFault {
    /// The contact lies at a pole of the parameters of a surface: 0 for the first, 1 for the second.
    Pole(usize),
    /// The surfaces run into each other beside the contact: the curvatures of both in the direction in which they do so,
    /// towards their own normals positive [1/m].
    Crossing([f64; 2]),
}
