//! Frames of joints from the directions that users give.

use crate::space::orientation::Axis;
use nalgebra::{Matrix3, Vector3};

/// Sine of the angle between two directions below which they count as the same.
const SAME: f64 = 1e-9;

/// A frame with a given z axis, whose x axis has the direction of a vector, as far as it lies across z.
///
/// None where a direction has no length or x lies along z.
pub(super) fn with_x(z: &Vector3<f64>, x: &Vector3<f64>) -> Option<Matrix3<f64>> {
    let z = unit(z)?;
    let x = unit(x)?;
    let across = x - z * z.dot(&x);
    if across.norm() < SAME {
        return None;
    }
    let x = across.normalize();
    Some(Matrix3::from_columns(&[x, z.cross(&x), z]))
}

/// A frame with a given z axis. Its x axis is the body axis that follows the one nearest to z, as far as it lies across z:
/// x for a joint along z, y for one along x, z for one along y. So a joint between bodies with parallel frames has the
/// angle zero. Of axes that are equally near the first is taken: roundings must not decide it, or the two bodies of a
/// joint along (1, 1, 0) would disagree.
pub(super) fn with_z(z: &Vector3<f64>) -> Option<Matrix3<f64>> {
    let along = unit(z)?.abs();
    let least = along.max() - SAME;
    let nearest = Axis::ALL
        .into_iter()
        .zip(&along)
        .find(|(_, c)| **c >= least);
    let (next, _) = nearest?.0.next_two();
    with_x(z, &next.unit())
}

pub(super) fn unit(v: &Vector3<f64>) -> Option<Vector3<f64>> {
    let largest = v.amax();
    (largest > 0.0 && largest.is_finite()).then(|| (v / largest).normalize())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_along_body_axes_are_permutations() {
        for axis in Axis::ALL {
            let frame = with_z(&(3.0 * axis.unit())).unwrap();
            let (i, j) = axis.next_two();
            assert_eq!(
                frame,
                Matrix3::from_columns(&[i.unit(), j.unit(), axis.unit()])
            );
        }
    }

    #[test]
    fn roundings_do_not_choose_the_frame() {
        let whole = Vector3::new(2.0, -1.0, 2.0);
        for k in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut rounded = whole;
                rounded[k] *= 1.0 + sign * 1e-15;
                let difference = with_z(&rounded).unwrap() - with_z(&whole).unwrap();
                assert!(difference.amax() < 1e-14, "{difference}");
            }
        }
    }

    #[test]
    fn what_is_no_frame_is_refused() {
        let z = Vector3::z();
        assert_eq!(with_z(&Vector3::zeros()), None);
        assert_eq!(with_x(&z, &Vector3::zeros()), None);
        assert_eq!(with_x(&z, &(2.0 * z)), None);
        let frame = with_x(&z, &Vector3::new(1.0, 1.0, 5.0)).unwrap();
        assert!((frame.determinant() - 1.0).abs() < 1e-15);
    }
}
