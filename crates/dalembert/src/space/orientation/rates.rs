//! Angular velocity and acceleration in the coordinates of any set.

use super::{AxisAngle, EulerParameters, OrientationSet, RodriguezParameters, Rotation};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3, Vector4};

/// What keeps a nearly singular pose apart from a regular one: there, rates lose this part of their digits.
const REGULAR: f64 = 1e-9;

/// The coordinates x of a moving frame: omegabar = Gbar x', d(omegabar)/dt = Gbar x'' + Gbar' x' (Shabana 7.81, 8.24, 8.34).
#[derive(Clone, Debug, PartialEq)]
pub struct OrientationRates {
    /// x.
    pub values: DVector<f64>,
    /// x'.
    pub rates: DVector<f64>,
    /// Gbar.
    pub gbar: DMatrix<f64>,
    /// Gbar' x'.
    pub gbar_rate_times: Vector3<f64>,
    /// Conditions among the coordinates of sets that have more than three.
    pub conditions: Vec<CoordinateCondition>,
}

/// A condition c(x) = 0 among the coordinates of a set, for example a unit norm (Shabana 8.16).
#[derive(Clone, Debug, PartialEq)]
pub struct CoordinateCondition {
    /// What it keeps, for messages: "norm".
    pub name: String,
    /// c.
    pub value: f64,
    /// dc/dx.
    pub gradient: DVector<f64>,
    /// The right side of (dc/dx) x'' = Q_d.
    pub qd: f64,
}

/// x.x - 1 over some of the coordinates.
fn unit_norm(
    name: &str,
    values: &DVector<f64>,
    rates: &DVector<f64>,
    count: usize,
) -> CoordinateCondition {
    let mut gradient = DVector::zeros(values.len());
    gradient
        .rows_mut(0, count)
        .copy_from(&(2.0 * values.rows(0, count)));
    CoordinateCondition {
        name: name.to_owned(),
        value: values.rows(0, count).norm_squared() - 1.0,
        gradient,
        qd: -2.0 * rates.rows(0, count).norm_squared(),
    }
}

fn dynamic<const N: usize>(x: &nalgebra::SVector<f64, N>) -> DVector<f64> {
    DVector::from_column_slice(x.as_slice())
}

impl OrientationSet {
    /// The coordinates of a frame that stands and turns so, the angular velocity in its own axes; none at a singular pose
    /// of the set.
    pub fn rates(&self, rotation: &Rotation, omegabar: &Vector3<f64>) -> Option<OrientationRates> {
        let found = self.coordinates(rotation);
        if found.singular {
            return None;
        }
        let values = DVector::from_column_slice(&found.values);
        let of = |n: usize| Vector3::from_column_slice(&found.values[n..n + 3]);
        match self {
            Self::EulerParameters => {
                let b = EulerParameters(Vector4::from_column_slice(&found.values));
                let rates = dynamic(&b.rates(omegabar));
                Some(OrientationRates {
                    gbar: DMatrix::from_column_slice(3, 4, b.gbar().as_slice()),
                    // Gbar' b' = 0 (Shabana 8.28).
                    gbar_rate_times: Vector3::zeros(),
                    conditions: vec![unit_norm("norm", &values, &rates, 4)],
                    values,
                    rates,
                })
            }
            Self::Euler(sequence) => {
                let angles = of(0);
                if sequence.regularity(&angles) < REGULAR {
                    return None;
                }
                let gbar = sequence.gbar(&angles);
                let rates = gbar.lu().solve(omegabar)?;
                Some(OrientationRates {
                    values,
                    rates: dynamic(&rates),
                    gbar: DMatrix::from_column_slice(3, 3, gbar.as_slice()),
                    gbar_rate_times: sequence.gbar_rate(&angles, &rates) * rates,
                    conditions: Vec::new(),
                })
            }
            Self::AxisAngle => {
                let set = AxisAngle {
                    axis: of(0),
                    angle: found.values[3],
                };
                if (0.5 * set.angle).sin() < REGULAR {
                    return None;
                }
                let rates = set.rates(omegabar)?;
                let (v, v1, t1) = (set.axis, rates.fixed_rows::<3>(0).into_owned(), rates[3]);
                let (s, c) = set.angle.sin_cos();
                let rates = dynamic(&rates);
                Some(OrientationRates {
                    gbar: DMatrix::from_column_slice(3, 4, set.gbar().as_slice()),
                    // Gbar = [I sin t - skew(v) (1 - cos t), v], and v' x v' = 0.
                    gbar_rate_times: t1 * (c * v1 - s * v.cross(&v1) + v1),
                    conditions: vec![unit_norm("norm of the axis", &values, &rates, 3)],
                    values,
                    rates,
                })
            }
            Self::Rodriguez => {
                if rotation.w.abs() < REGULAR {
                    return None;
                }
                let g = RodriguezParameters(of(0));
                let rates = g.rates(omegabar);
                Some(OrientationRates {
                    gbar: DMatrix::from_column_slice(3, 3, g.gbar().as_slice()),
                    gbar_rate_times: g.gbar_rate_times(&rates),
                    conditions: Vec::new(),
                    values,
                    rates: dynamic(&rates),
                })
            }
            Self::DirectionCosines => Some(cosines(values, &[of(0), of(3), of(6)], omegabar)),
        }
    }
}

/// Nine direction cosines: the columns a_k of A move with a_k' = A (omegabar x e_k), and omegabar = (a3.a2', a1.a3', a2.a1').
fn cosines(
    values: DVector<f64>,
    a: &[Vector3<f64>; 3],
    omegabar: &Vector3<f64>,
) -> OrientationRates {
    let axes = Matrix3::from_columns(a);
    let a1: [Vector3<f64>; 3] =
        [0, 1, 2].map(|k| axes * omegabar.cross(&Matrix3::identity().column(k)));
    let mut gbar = DMatrix::zeros(3, 9);
    let mut gbar_rate_times = Vector3::zeros();
    for k in 0..3 {
        let (from, to) = ((k + 2) % 3, (k + 1) % 3);
        for i in 0..3 {
            gbar[(k, 3 * to + i)] = a[from][i];
        }
        gbar_rate_times[k] = a1[from].dot(&a1[to]);
    }
    let mut conditions = Vec::with_capacity(6);
    for i in 0..3 {
        for j in i..3 {
            let mut gradient = DVector::zeros(9);
            for k in 0..3 {
                gradient[3 * i + k] += a[j][k];
                gradient[3 * j + k] += a[i][k];
            }
            conditions.push(CoordinateCondition {
                name: format!("columns {} and {}", i + 1, j + 1),
                value: a[i].dot(&a[j]) - f64::from(u8::from(i == j)),
                gradient,
                qd: -2.0 * a1[i].dot(&a1[j]),
            });
        }
    }
    let rates = a1.iter().flat_map(|x| x.iter().copied());
    OrientationRates {
        rates: DVector::from_iterator(9, rates),
        values,
        gbar,
        gbar_rate_times,
        conditions,
    }
}
