//! Scalar measures between two markers of space: the primitives of which joints are made (Shabana 7.10).

use super::{Guarded, Lost, MeasureKind, Measured};
use crate::space::orientation::Axis;
use crate::space::{Spatial, SpatialMarker, join};
use nalgebra::{Vector3, Vector6};
use std::f64::consts::TAU;

/// Which scalar is measured from the first marker (a) to the second (b).
///
/// d = r_b - r_a; e_k are the axes of the first marker, f_k those of the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpatialMeasure {
    /// d along an axis of the ground [m].
    Ground(Axis),
    /// d along an axis of the first marker [m].
    Along(Axis),
    /// e_i . f_j: the cosine of the angle between two axes.
    Dot(Axis, Axis),
    /// |d| [m]; its gradient needs |d| > 0.
    Distance,
    /// Turn of b about an axis of a, of which only the rate says something: e_k.(w_b - w_a). Its value is zero.
    Turn(Axis),
    /// Angle about an axis k of the first marker, from e_i to the projection of f_i, with (k, i, j) right-handed, on the
    /// turn nearest to what the second marker remembers [rad]; it needs f_i not to stand along e_k.
    Angle(Axis),
}

/// A scalar product of an axis of each marker.
struct Product {
    value: f64,
    rate: f64,
    bias: f64,
    /// Gradient by the first marker's rotation; that by the second's is its negative.
    turn: Vector3<f64>,
}

impl Product {
    fn new(a: &SpatialMarker, e: Axis, b: &SpatialMarker, f: Axis) -> Self {
        let (e, f) = (column(a, e), column(b, f));
        let (e1, f1) = (a.omega.cross(&e), b.omega.cross(&f));
        let (e2, f2) = (a.omega.cross(&e1), b.omega.cross(&f1));
        Self {
            value: e.dot(&f),
            rate: e1.dot(&f) + e.dot(&f1),
            bias: e2.dot(&f) + 2.0 * e1.dot(&f1) + e.dot(&f2),
            turn: e.cross(&f),
        }
    }
}

fn column(m: &SpatialMarker, axis: Axis) -> Vector3<f64> {
    m.axes.column(axis.number()).into_owned()
}

fn turning(turn: Vector3<f64>, value: f64, rate: f64, bias: f64) -> Measured<Vector6<f64>> {
    let zero = Vector3::zeros();
    Measured {
        value,
        rate,
        bias,
        first: join(&zero, &turn),
        second: join(&zero, &-turn),
    }
}

/// The angle, changed by whole turns, that is nearest to another.
fn nearest_turn(angle: f64, to: f64) -> f64 {
    let turns = (to - angle) / TAU;
    // Halfway, both are as near.
    if turns.abs() <= 0.5 {
        angle
    } else {
        angle + TAU * turns.round()
    }
}

impl SpatialMeasure {
    /// Is the value an angle?
    pub fn is_angle(self) -> bool {
        matches!(self, Self::Angle(_) | Self::Turn(_))
    }

    /// Is the value a length?
    pub fn is_length(self) -> bool {
        matches!(self, Self::Ground(_) | Self::Along(_) | Self::Distance)
    }

    /// Value, rate, gradients and bias.
    ///
    /// Along: e.d, rate e.d' + (w_a x e).d, bias (w_a x (w_a x e)).d + 2 (w_a x e).d'.
    /// Dot: e.f, rate (w_a - w_b).(e x f), bias e''.f + 2 e'.f' + e.f''.
    /// Distance: l = |d|, l' = n.d', bias (d'.d' - l'^2) / l.
    /// Angle: x = e_i.f_i, y = e_j.f_i, s = x^2 + y^2: theta = atan2(y, x), theta' = (x y' - y x') / s,
    /// bias (x y'' - y x'') / s - 2 theta' (x x' + y y') / s.
    pub fn evaluate(self, a: &SpatialMarker, b: &SpatialMarker) -> Measured<Vector6<f64>> {
        let d = b.point - a.point;
        let dv = b.velocity - a.velocity;
        let pulling = |n: Vector3<f64>, value: f64, bias: f64, turn: Vector3<f64>| Measured {
            value,
            rate: n.dot(&dv) + turn.dot(&a.omega),
            bias,
            first: join(&-n, &turn),
            second: join(&n, &Vector3::zeros()),
        };
        match self {
            Self::Ground(axis) => {
                let value = d[axis.number()];
                pulling(axis.unit(), value, 0.0, Vector3::zeros())
            }
            Self::Along(axis) => {
                let e = column(a, axis);
                let e1 = a.omega.cross(&e);
                let bias = a.omega.cross(&e1).dot(&d) + 2.0 * e1.dot(&dv);
                pulling(e, e.dot(&d), bias, e.cross(&d))
            }
            Self::Distance => {
                let l = d.norm();
                // As in the plane: coincident points have no direction, and no gradient.
                if l == 0.0 {
                    return Measured::default();
                }
                let n = d / l;
                let rate = n.dot(&dv);
                let bias = (dv.norm_squared() - rate * rate) / l;
                pulling(n, l, bias, Vector3::zeros())
            }
            Self::Dot(e, f) => {
                let p = Product::new(a, e, b, f);
                turning(p.turn, p.value, p.rate, p.bias)
            }
            Self::Turn(axis) => {
                let e = column(a, axis);
                let relative = b.omega - a.omega;
                // e' = w_a x e; the angular accelerations vanish.
                turning(-e, 0.0, e.dot(&relative), a.omega.cross(&e).dot(&relative))
            }
            Self::Angle(axis) => {
                let (i, j) = axis.next_two();
                let x = Product::new(a, i, b, i);
                let y = Product::new(a, j, b, i);
                let s = x.value * x.value + y.value * y.value;
                // f_i along e_k: every angle is as good as another.
                if s == 0.0 {
                    return Measured::default();
                }
                let rate = (x.value * y.rate - y.value * x.rate) / s;
                let bias = (x.value * y.bias - y.value * x.bias) / s
                    - 2.0 * rate * (x.value * x.rate + y.value * y.rate) / s;
                turning(
                    (x.value * y.turn - y.value * x.turn) / s,
                    nearest_turn(y.value.atan2(x.value), b.turn),
                    rate,
                    bias,
                )
            }
        }
    }
}

impl MeasureKind<Spatial> for SpatialMeasure {
    const DISTANCE: Self = Self::Distance;

    fn is_angle(self) -> bool {
        self.is_angle()
    }

    fn is_length(self) -> bool {
        self.is_length()
    }

    fn value(self, a: &SpatialMarker, b: &SpatialMarker) -> f64 {
        self.evaluate(a, b).value
    }

    /// Angle: the projection of f_i, in the axes of the first marker.
    fn guarded(self, a: &SpatialMarker, b: &SpatialMarker) -> Option<Guarded> {
        let Self::Angle(axis) = self else {
            return None;
        };
        let (i, j) = axis.next_two();
        let x = Product::new(a, i, b, i);
        let y = Product::new(a, j, b, i);
        Some(Guarded {
            vector: Vector3::new(x.value, y.value, 0.0),
            rate: Vector3::new(x.rate, y.rate, 0.0),
            limit: Guarded::DIGITS,
            lost: Lost::Angle,
        })
    }

    fn evaluate(self, a: &SpatialMarker, b: &SpatialMarker) -> Measured<Vector6<f64>> {
        self.evaluate(a, b)
    }
}
