//! The sets of orientation coordinates that people may choose.

use super::{
    AxisAngle, EulerParameters, EulerSequence, OrientationError, RodriguezParameters, Rotation,
};
use nalgebra::{Matrix3, Vector3, Vector4};
use smallvec::SmallVec;
use std::f64::consts::TAU;
use std::fmt;
use std::str::FromStr;

/// A set of coordinates for orientations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum OrientationSet {
    /// Four Euler parameters, scalar first.
    #[default]
    EulerParameters,
    /// Three Euler angles.
    Euler(EulerSequence),
    /// Axis and angle: four coordinates.
    AxisAngle,
    /// Three Rodriguez parameters.
    Rodriguez,
    /// Nine direction cosines, the columns of A one after the other.
    DirectionCosines,
}

/// Scalar part below which an orientation counts as a half turn: runs at usual tolerances do not know it better.
const HALF_TURN: f64 = 1e-7;

/// Coordinates of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct SetCoordinates {
    /// The numbers, in the order of [`OrientationSet::names`].
    pub values: SmallVec<[f64; 9]>,
    /// Is the orientation a singular pose of the set: are coordinates not unique there, or infinite?
    pub singular: bool,
}

impl OrientationSet {
    /// Names of the coordinates.
    pub fn names(&self) -> Vec<String> {
        let plain = |names: &[&str]| names.iter().map(|&n| n.to_owned()).collect();
        match self {
            Self::EulerParameters => plain(&["b0", "b1", "b2", "b3"]),
            Self::Euler(sequence) => sequence.names().to_vec(),
            Self::AxisAngle => plain(&["v1", "v2", "v3", "angle"]),
            Self::Rodriguez => plain(&["g1", "g2", "g3"]),
            Self::DirectionCosines => plain(&[
                "a11", "a21", "a31", "a12", "a22", "a32", "a13", "a23", "a33",
            ]),
        }
    }

    /// Which of the coordinates are angles.
    pub fn is_angle(&self, coordinate: usize) -> bool {
        match self {
            Self::Euler(_) => true,
            Self::AxisAngle => coordinate == 3,
            Self::EulerParameters | Self::Rodriguez | Self::DirectionCosines => false,
        }
    }

    /// Coordinates of an orientation; infinite Rodriguez parameters at half turns come out as such.
    pub fn coordinates(&self, rotation: &Rotation) -> SetCoordinates {
        let (values, singular) = match self {
            Self::EulerParameters => {
                let b = EulerParameters::of(rotation).0;
                (SmallVec::from_slice(b.as_slice()), false)
            }
            Self::Euler(sequence) => {
                let found = sequence.angles(rotation);
                (
                    SmallVec::from_slice(found.angles.as_slice()),
                    found.singular,
                )
            }
            Self::AxisAngle => {
                let (AxisAngle { axis, angle }, singular) = AxisAngle::of(rotation);
                (
                    SmallVec::from_slice(&[axis.x, axis.y, axis.z, angle]),
                    singular,
                )
            }
            Self::Rodriguez => {
                // At a half turn they are infinite; a component that vanishes stays zero.
                let half = rotation.w.abs() < HALF_TURN;
                let over = |x: f64| match half {
                    true if x.abs() < HALF_TURN => 0.0,
                    true => f64::INFINITY.copysign(x),
                    false => x / rotation.w,
                };
                let values = rotation.imag().iter().map(|x| over(*x)).collect();
                (values, half)
            }
            Self::DirectionCosines => {
                let matrix = rotation.to_rotation_matrix();
                (SmallVec::from_slice(matrix.matrix().as_slice()), false)
            }
        };
        SetCoordinates { values, singular }
    }

    /// How far an orientation is from a singular pose of the set: zero at one, one where the coordinates are at their best.
    pub fn regularity(&self, rotation: &Rotation) -> f64 {
        match self {
            Self::Euler(sequence) => sequence.regularity(&sequence.angles(rotation).angles),
            Self::Rodriguez => rotation.w.abs(),
            Self::AxisAngle => rotation.imag().norm(),
            Self::EulerParameters | Self::DirectionCosines => 1.0,
        }
    }

    /// The same orientation by the numbers nearest to others: Euler parameters have two signs, angles any number of
    /// turns.
    pub fn near(&self, mut values: SmallVec<[f64; 9]>, to: &[f64]) -> SmallVec<[f64; 9]> {
        if *self == Self::EulerParameters {
            let product: f64 = values.iter().zip(to).map(|(a, b)| a * b).sum();
            if product < 0.0 {
                values.iter_mut().for_each(|x| *x = -*x);
            }
        } else if let Self::Euler(_) = self {
            for (x, to) in values.iter_mut().zip(to) {
                *x += TAU * ((to - *x) / TAU).round();
            }
        }
        values
    }

    /// The orientation of coordinates; `values` has as many as there are names.
    ///
    /// # Errors
    /// The numbers are not an orientation.
    pub fn rotation(&self, values: &[f64]) -> Result<Rotation, OrientationError> {
        if !values.iter().all(|x| x.is_finite()) {
            return Err(OrientationError::NotFinite);
        }
        match self {
            Self::EulerParameters => {
                EulerParameters(Vector4::from_column_slice(&values[..4])).rotation()
            }
            Self::Euler(sequence) => {
                Ok(sequence.rotation(&Vector3::from_column_slice(&values[..3])))
            }
            Self::AxisAngle => {
                Ok(AxisAngle::new(Vector3::from_column_slice(&values[..3]), values[3])?.rotation())
            }
            Self::Rodriguez => {
                Ok(RodriguezParameters(Vector3::from_column_slice(&values[..3])).rotation())
            }
            Self::DirectionCosines => super::from_matrix(&Matrix3::from_column_slice(&values[..9])),
        }
    }
}

impl fmt::Display for OrientationSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::EulerParameters => f.write_str("euler-parameters"),
            Self::Euler(sequence) => write!(f, "euler-{sequence}"),
            Self::AxisAngle => f.write_str("axis-angle"),
            Self::Rodriguez => f.write_str("rodriguez"),
            Self::DirectionCosines => f.write_str("direction-cosines"),
        }
    }
}

impl FromStr for OrientationSet {
    type Err = OrientationError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let plain = [
            Self::EulerParameters,
            Self::AxisAngle,
            Self::Rodriguez,
            Self::DirectionCosines,
        ];
        if let Some(set) = plain.into_iter().find(|set| set.to_string() == text) {
            return Ok(set);
        }
        let sequence = text.strip_prefix("euler-").unwrap_or(text);
        sequence
            .parse()
            .map(Self::Euler)
            .map_err(|_| OrientationError::UnknownSequence {
                name: text.to_owned(),
            })
    }
}
