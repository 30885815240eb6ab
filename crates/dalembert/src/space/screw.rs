//! Motions along and about an axis.

use nalgebra::Vector3;

/// What a rigid body does at an instant: it turns about an axis and moves along it (Chasles), or only moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screw {
    /// Unit vector along the axis, or along the motion where the body does not turn.
    pub direction: Vector3<f64>,
    /// The point of the axis that is nearest to the centre of mass [m]; none where the body does not turn.
    pub point: Option<Vector3<f64>>,
    /// Advance along the axis [m/rad].
    pub pitch: f64,
}

impl Screw {
    /// The screw of a twist at a point; none where nothing moves.
    ///
    /// With omega not zero: axis through point + omega x v / omega^2, pitch = omega . v / omega^2.
    pub fn new(
        point: &Vector3<f64>,
        linear: &Vector3<f64>,
        angular: &Vector3<f64>,
    ) -> Option<Self> {
        let square = angular.norm_squared();
        if square > 0.0 {
            return Some(Self {
                direction: angular / square.sqrt(),
                point: Some(point + angular.cross(linear) / square),
                pitch: angular.dot(linear) / square,
            });
        }
        let speed = linear.norm();
        (speed > 0.0).then(|| Self {
            direction: linear / speed,
            point: None,
            pitch: 0.0,
        })
    }
}
