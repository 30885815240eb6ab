//! How far a contact is from places where its equations fail.

use nalgebra::{Matrix3, Vector3};

/// How regular the contact of surfaces is at a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regularity {
    /// For each surface with parameters a and b its normal t_a x t_b in its own axes, in parts of the larger square of a
    /// tangent: it vanishes at poles and turns round behind them.
    pub normals: [Option<Vector3<f64>>; 2],
    /// The relative curvatures, the smaller in size first [1/m]: where that is zero the surfaces touch along a line. None
    /// where they do so all the time, and for points.
    pub relative: Option<[f64; 2]>,
}

/// Part of the curvatures of surfaces below which their sum is rounding: as their tangents agree to some 1e-13.
const ROUNDING: f64 = 1e-9;

impl Regularity {
    /// The principal curvatures of a tensor that has no curvature across the surface, the smaller in size first.
    pub fn principal(relative: &Matrix3<f64>) -> [f64; 2] {
        let trace = relative.trace();
        let product = 0.5 * (trace * trace - (relative * relative).trace());
        let root = (0.25 * trace * trace - product).max(0.0).sqrt();
        let larger = 0.5 * trace + root.copysign(trace);
        if larger == 0.0 {
            return [0.0; 2];
        }
        [product / larger, larger]
    }

    /// The smaller over the larger curvature in size, with the sign of their product, of a tensor that has no curvature
    /// across the surface.
    pub fn flatness(relative: &Matrix3<f64>) -> f64 {
        let [smaller, larger] = Self::principal(relative);
        if larger == 0.0 { 0.0 } else { smaller / larger }
    }

    /// The curvatures of two surfaces that touch with opposite normals, in the direction in which they run into each other;
    /// none where they do not. Both tensors in the same axes, towards the own normal positive: the gap beside the contact is
    /// -x.(K_1 + K_2) x/2.
    pub fn crossing(curvatures: &[Matrix3<f64>; 2]) -> Option<[f64; 2]> {
        let [one, two] = curvatures;
        let sum = one + two;
        let size = one.amax().max(two.amax());
        if sum.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let eigen = (0.5 * (sum + sum.transpose())).symmetric_eigen();
        let most = eigen.eigenvalues.imax();
        if eigen.eigenvalues[most] <= ROUNDING * size {
            return None;
        }
        let along = eigen.eigenvectors.column(most);
        Some([one, two].map(|k| along.dot(&(k * along))))
    }
}
