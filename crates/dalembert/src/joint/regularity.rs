//! How far a contact is from places where its equations fail.

use nalgebra::{Matrix3, Vector3};

/// How regular the contact of surfaces is at a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regularity {
    /// For each surface with parameters a and b its normal t_a x t_b in its own axes, in parts of the larger square of a
    /// tangent: it vanishes at poles and turns round behind them.
    pub normals: [Option<Vector3<f64>>; 2],
    /// The smaller over the larger relative curvature, with its sign: at zero the surfaces touch along a line. None where
    /// they do so all the time, and for points.
    pub flatness: Option<f64>,
}

impl Regularity {
    /// The smaller over the larger curvature in size, with the sign of their product, of a tensor that has no curvature
    /// across the surface.
    pub fn flatness(relative: &Matrix3<f64>) -> f64 {
        let trace = relative.trace();
        let product = 0.5 * (trace * trace - (relative * relative).trace());
        let root = (0.25 * trace * trace - product).max(0.0).sqrt();
        let larger = 0.5 * trace.abs() + root;
        if larger > 0.0 {
            product / (larger * larger)
        } else {
            0.0
        }
    }
}
