//! Euler angles of any sequence.

use super::{Axis, OrientationError, Rotation};
use nalgebra::{Matrix3, Unit, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fmt;
use std::str::FromStr;

/// Three successive rotations, about the axes of the moving body or about those of the ground.
///
/// Body axes a, b, c: A = R_a(x1) R_b(x2) R_c(x3) (Shabana 7.32 for z, x, z). Space axes a, b, c: A = R_c(x3) R_b(x2)
/// R_a(x1), the body sequence c, b, a with its angles in reverse order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EulerSequence {
    axes: [Axis; 3],
    space_axes: bool,
}

/// Angles of a sequence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerAngles {
    /// The angles, each in (-pi, pi] [rad].
    pub angles: Vector3<f64>,
    /// Did only the sum or the difference of the outer angles matter, so that the last one was set to zero?
    pub singular: bool,
}

/// Sine of half the middle angle's distance from its singular value below which the outer angles are not told apart: a
/// few roundings of a quaternion.
const SINGULAR: f64 = 1e-15;

impl EulerSequence {
    /// The sequence of the book: z, x, z about body axes.
    pub const ZXZ: Self = Self {
        axes: [Axis::Z, Axis::X, Axis::Z],
        space_axes: false,
    };

    /// A sequence of axes; neighbours must differ.
    pub fn new(axes: [Axis; 3], space_axes: bool) -> Option<Self> {
        (axes[0] != axes[1] && axes[1] != axes[2]).then_some(Self { axes, space_axes })
    }

    /// All twelve sequences about body axes, or about space axes.
    pub fn all(space_axes: bool) -> impl Iterator<Item = Self> {
        let axes = Axis::ALL;
        axes.into_iter()
            .flat_map(move |a| axes.into_iter().map(move |b| (a, b)))
            .flat_map(move |(a, b)| axes.into_iter().map(move |c| [a, b, c]))
            .filter_map(move |axes| Self::new(axes, space_axes))
    }

    /// Axes in the order of the angles.
    pub fn axes(&self) -> [Axis; 3] {
        self.axes
    }

    /// Are the rotations about the axes of the ground?
    pub fn about_space_axes(&self) -> bool {
        self.space_axes
    }

    /// The same rotations about body axes, and the angles in their order.
    fn body(&self, x: &Vector3<f64>) -> ([Axis; 3], Vector3<f64>) {
        let [a, b, c] = self.axes;
        if self.space_axes {
            ([c, b, a], Vector3::new(x[2], x[1], x[0]))
        } else {
            ([a, b, c], *x)
        }
    }

    /// Columns or entries in the order of the user's angles.
    fn user<T: Copy>(&self, [a, b, c]: [T; 3]) -> [T; 3] {
        if self.space_axes {
            [c, b, a]
        } else {
            [a, b, c]
        }
    }

    /// The orientation of angles.
    pub fn rotation(&self, angles: &Vector3<f64>) -> Rotation {
        let (axes, x) = self.body(angles);
        let turn = |k: usize| Rotation::from_axis_angle(&Unit::new_unchecked(axes[k].unit()), x[k]);
        turn(0) * turn(1) * turn(2)
    }

    /// The angles of an orientation; the middle one in [0, pi] where the first and the last axis are the same, and in
    /// [-pi/2, pi/2] where not.
    ///
    /// With q = q_i(x1) q_j(x2) q_i(x3) and m the third axis, s = +-1 its handedness (derived from the product):
    ///   w = cos(x2/2) cos((x1+x3)/2),  q_i = cos(x2/2) sin((x1+x3)/2),
    ///   q_j = sin(x2/2) cos((x1-x3)/2), s q_m = sin(x2/2) sin((x1-x3)/2).
    /// Three different axes i, j, k are reduced to that: e_k = R_j(d) e_i with d = -s 90 degrees.
    pub fn angles(&self, rotation: &Rotation) -> EulerAngles {
        let (axes, _) = self.body(&Vector3::zeros());
        let [i, j, k] = axes;
        let (m, sign) = Axis::third(i, j);
        let proper = i == k;
        let shift = -sign * FRAC_PI_2;
        let q = if proper {
            *rotation
        } else {
            rotation * Rotation::from_axis_angle(&Unit::new_unchecked(j.unit()), shift)
        };
        let [qi, qj, qm] = [i, j, m].map(|a| q.imag()[a.number()]);
        let (sine, cosine) = (qj.hypot(qm), q.w.hypot(qi));
        let (half_sum, half_difference) = (qi.atan2(q.w), (sign * qm).atan2(qj));
        let middle = 2.0 * sine.atan2(cosine);
        let (mut x, singular) = if sine <= SINGULAR {
            ([2.0 * half_sum, middle, 0.0], true)
        } else if cosine <= SINGULAR {
            ([2.0 * half_difference, middle, 0.0], true)
        } else {
            (
                [
                    half_sum + half_difference,
                    middle,
                    half_sum - half_difference,
                ],
                false,
            )
        };
        if !proper && sign > 0.0 {
            // (x1 + pi, -x2, x3 + pi) is the same orientation, and brings the middle angle into its range; at the
            // singular poses the outer turns act about one line, where pi and pi cancel or make a turn.
            x[1] = -x[1];
            if !singular {
                x[0] += PI;
                x[2] += PI;
            }
        }
        if !proper {
            x[1] -= shift;
        }
        let [a, b, c] = self.user(x);
        EulerAngles {
            angles: Vector3::new(a, b, c).map(wrapped),
            singular,
        }
    }

    /// Gbar: its columns are the three axes of rotation in the body frame (Shabana 7.81 for z, x, z).
    pub fn gbar(&self, angles: &Vector3<f64>) -> Matrix3<f64> {
        let (axes, x) = self.body(angles);
        let third = turn(axes[2], -x[2]);
        let columns = [
            third * (turn(axes[1], -x[1]) * axes[0].unit()),
            third * axes[1].unit(),
            axes[2].unit(),
        ];
        Matrix3::from_columns(&self.user(columns))
    }

    /// d(Gbar)/dt for the rates of the angles.
    ///
    /// A column is an axis that stands still before the later rotations: seen from the body it turns with the negative
    /// of their angular velocity.
    pub fn gbar_rate(&self, angles: &Vector3<f64>, rates: &Vector3<f64>) -> Matrix3<f64> {
        let (_, r) = self.body(rates);
        let gbar = self.gbar(angles);
        let c = self.user([0, 1, 2].map(|k| gbar.column(k).into_owned()));
        let columns = [
            -(r[1] * c[1] + r[2] * c[2]).cross(&c[0]),
            -(r[2] * c[2]).cross(&c[1]),
            Vector3::zeros(),
        ];
        Matrix3::from_columns(&self.user(columns))
    }

    /// |det G|: one where the axes are at right angles, zero at the singular pose (Shabana 7.5).
    pub fn regularity(&self, angles: &Vector3<f64>) -> f64 {
        if self.axes[0] == self.axes[2] {
            angles[1].sin().abs()
        } else {
            angles[1].cos().abs()
        }
    }

    /// Names of the angles: phi, theta, psi for z, x, z; the axes and their order else.
    pub fn names(&self) -> [String; 3] {
        if *self == Self::ZXZ {
            return ["phi", "theta", "psi"].map(str::to_owned);
        }
        let [a, b, c] = self.axes.map(Axis::letter);
        [format!("{a}1"), format!("{b}2"), format!("{c}3")]
    }
}

/// An elementary rotation matrix (Shabana 7.19 to 7.21).
fn turn(axis: Axis, angle: f64) -> Matrix3<f64> {
    *nalgebra::Rotation3::from_axis_angle(&Unit::new_unchecked(axis.unit()), angle).matrix()
}

/// An angle in (-pi, pi].
fn wrapped(angle: f64) -> f64 {
    let rest = angle - TAU * (angle / TAU).round();
    if rest <= -PI { rest + TAU } else { rest }
}

impl fmt::Display for EulerSequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for axis in self.axes {
            write!(f, "{}", axis.letter())?;
        }
        if self.space_axes {
            write!(f, "-space")?;
        }
        Ok(())
    }
}

impl FromStr for EulerSequence {
    type Err = OrientationError;

    /// "zxz" about body axes, "zxz-space" about space axes.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let unknown = || OrientationError::UnknownSequence {
            name: text.to_owned(),
        };
        let (letters, space_axes) = match text.split_once('-') {
            None => (text, false),
            Some((letters, "space")) => (letters, true),
            Some((letters, "body")) => (letters, false),
            Some(_) => return Err(unknown()),
        };
        let axes: Option<Vec<Axis>> = letters.chars().map(Axis::from_letter).collect();
        axes.and_then(|axes| <[Axis; 3]>::try_from(axes).ok())
            .and_then(|axes| Self::new(axes, space_axes))
            .ok_or_else(unknown)
    }
}
