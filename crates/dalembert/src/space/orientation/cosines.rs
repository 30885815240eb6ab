//! Direction cosines: matrices, axis vectors, points.

use super::{Axis, OrientationError, Rotation};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Largest deviation from right angles and unit lengths that counts as rounding of given digits.
const DEVIATION: f64 = 1e-3;

/// The orientation whose matrix A is given, columns = body axes in ground axes.
///
/// # Errors
/// A number is not finite, a column is not a unit vector, two are not at right angles, or they are left-handed.
pub fn from_matrix(matrix: &Matrix3<f64>) -> Result<Rotation, OrientationError> {
    for axis in Axis::ALL {
        let length = matrix.column(axis.number()).norm();
        if !length.is_finite() {
            return Err(OrientationError::NotFinite);
        }
        if (length - 1.0).abs() > DEVIATION {
            return Err(OrientationError::NotNormal {
                letter: axis.letter(),
                length,
            });
        }
    }
    from_axes([0, 1, 2].map(|k| matrix.column(k).into_owned()))
}

/// The orientation whose body axes have the directions of three vectors of any length (Shabana 7.14).
///
/// # Errors
/// A vector has no length or is not finite, two are not at right angles, or they are left-handed.
pub fn from_axes(axes: [Vector3<f64>; 3]) -> Result<Rotation, OrientationError> {
    const NAMES: [&str; 3] = ["the x axis", "the y axis", "the z axis"];
    let mut units = [Vector3::zeros(); 3];
    for ((unit, axis), what) in units.iter_mut().zip(axes).zip(NAMES) {
        *unit = direction(axis, what)?;
    }
    for (i, j) in [(0, 1), (1, 2), (0, 2)] {
        let cosine = units[i].dot(&units[j]);
        if cosine.abs() > DEVIATION {
            return Err(OrientationError::NotOrthogonal {
                first: Axis::ALL[i].letter(),
                second: Axis::ALL[j].letter(),
                degrees: cosine.asin().abs().to_degrees(),
            });
        }
    }
    if units[0].cross(&units[1]).dot(&units[2]) < 0.0 {
        return Err(OrientationError::LeftHanded);
    }
    Ok(nearest(&Matrix3::from_columns(&units)))
}

/// The frame of three points: from O to P is the x axis, Q lies on the side of +y (Shabana 2.4).
///
/// # Errors
/// P is O, a number is not finite, or the points lie on a line.
pub fn from_points(
    o: &Vector3<f64>,
    p: &Vector3<f64>,
    q: &Vector3<f64>,
) -> Result<Rotation, OrientationError> {
    let x = direction(p - o, "the line from the first to the second point")?;
    let d = direction(q - o, "the line from the first to the third point")?;
    let z = x.cross(&d);
    // The sine of the angle between the lines: below a few roundings there is no plane.
    if z.norm() < 1e-12 {
        return Err(OrientationError::Collinear);
    }
    let z = z.normalize();
    Ok(nearest(&Matrix3::from_columns(&[x, z.cross(&x), z])))
}

/// A frame whose z axis has the direction of a vector; the others by the rule of the largest component (Shabana 2.4):
/// x = z cross d, d = ones with a zero at z's largest component.
///
/// # Errors
/// The vector has no length or is not finite.
pub fn triad(axis: &Vector3<f64>) -> Result<Rotation, OrientationError> {
    let z = direction(*axis, "the axis")?;
    let mut d = Vector3::repeat(1.0);
    d[z.iamax()] = 0.0;
    let x = z.cross(&d).normalize();
    Ok(nearest(&Matrix3::from_columns(&[x, z.cross(&x), z])))
}

pub(super) fn direction(
    v: Vector3<f64>,
    what: &'static str,
) -> Result<Vector3<f64>, OrientationError> {
    let largest = v.amax();
    if !v.iter().all(|x| x.is_finite()) {
        return Err(OrientationError::NotFinite);
    }
    if largest == 0.0 {
        return Err(OrientationError::ZeroVector { what });
    }
    Ok((v / largest).normalize())
}

/// The rotation nearest to a matrix that is one but for rounding of its digits: Newton's iteration for the polar factor,
/// A <- (A + A^-T) / 2, squares the deviation in each step.
fn nearest(matrix: &Matrix3<f64>) -> Rotation {
    let mut a = *matrix;
    // 1e-3, 1e-6, 1e-12, 1e-24.
    for _ in 0..3 {
        if let Some(inverse) = a.try_inverse() {
            a = 0.5 * (a + inverse.transpose());
        }
    }
    rotation_of(&a)
}

/// The rotation of axes that are orthogonal to rounding; [`from_matrix`] looks whether they are.
pub fn rotation_of(axes: &Matrix3<f64>) -> Rotation {
    Rotation::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*axes))
}
