//! The force between touching surfaces.

use nalgebra::Vector3;

/// What a contact transmits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactForce {
    /// Force along the normal, positive where the bodies push each other apart [N].
    pub normal: f64,
    /// Point of contact in ground axes [m].
    pub point: Vector3<f64>,
}
