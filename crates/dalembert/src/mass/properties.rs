//! Mass, centre and inertia, and how they are moved, turned and added.

use crate::space::orientation::Rotation;
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Mass properties in some frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MassProperties {
    /// Mass [kg]; negative for cut-outs.
    pub mass: f64,
    /// Centre of mass in the frame [m].
    pub center: Vector3<f64>,
    /// Inertia tensor about the CENTRE, axes of the frame [kg m^2].
    pub inertia: Matrix3<f64>,
}

/// Principal moments and axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    /// Moments, ascending [kg m^2].
    pub moments: Vector3<f64>,
    /// The axes as columns, right-handed (Shabana 7.101, 7.102).
    pub axes: Matrix3<f64>,
}

/// What is wrong or unusual with an inertia tensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InertiaWarning {
    /// A principal moment is negative: no body has this tensor.
    Negative {
        /// The smallest moment.
        smallest: f64,
    },
    /// The largest principal moment exceeds the sum of the others: no body has this tensor, but equations hold.
    Triangle {
        /// The moments, ascending.
        moments: [f64; 3],
    },
}

impl MassProperties {
    /// From the inertia tensor about the ORIGIN of the frame.
    pub fn about_origin(mass: f64, center: Vector3<f64>, inertia: Matrix3<f64>) -> Self {
        Self {
            mass,
            center,
            inertia: inertia - steiner(mass, &center),
        }
    }

    /// Inertia tensor about a point of the frame (parallel axes, Shabana 7.96).
    pub fn inertia_about(&self, point: &Vector3<f64>) -> Matrix3<f64> {
        self.inertia + steiner(self.mass, &(self.center - point))
    }

    /// The same body in a frame in which its old frame has this place and this orientation (Shabana 7.99).
    #[must_use]
    pub fn placed(&self, at: &Vector3<f64>, rotation: &Rotation) -> Self {
        let c = rotation.to_rotation_matrix();
        let inertia = c.matrix() * self.inertia * c.matrix().transpose();
        Self {
            mass: self.mass,
            center: at + rotation * self.center,
            inertia: symmetric(&inertia),
        }
    }

    /// Both bodies as one.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        let moment = self.mass * self.center + other.mass * other.center;
        let center = if mass == 0.0 {
            Vector3::zeros()
        } else {
            moment / mass
        };
        Self {
            mass,
            center,
            inertia: self.inertia_about(&center) + other.inertia_about(&center),
        }
    }

    /// This body without the other: a cut-out.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&Self {
            mass: -other.mass,
            center: other.center,
            inertia: -other.inertia,
        })
    }

    /// Principal moments and axes about the centre. Among equal moments the axes are those nearest to the frame's.
    pub fn principal(&self) -> Principal {
        principal(&self.inertia)
    }

    /// What is wrong or unusual with the tensor.
    pub fn warning(&self) -> Option<InertiaWarning> {
        let m = self.principal().moments;
        // Rounding of given digits is no reason to complain.
        let slack = 1e-9 * m[2].abs();
        if m[0] < -slack {
            return Some(InertiaWarning::Negative { smallest: m[0] });
        }
        (m[2] > m[0] + m[1] + slack).then_some(InertiaWarning::Triangle {
            moments: [m[0], m[1], m[2]],
        })
    }
}

/// m (|c|^2 I - c c^T).
fn steiner(mass: f64, c: &Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::identity() * c.norm_squared() - c * c.transpose()) * mass
}

fn symmetric(a: &Matrix3<f64>) -> Matrix3<f64> {
    0.5 * (a + a.transpose())
}

/// Relative difference below which principal moments count as equal.
const EQUAL: f64 = 1e-10;

fn principal(inertia: &Matrix3<f64>) -> Principal {
    let eigen = symmetric(inertia).symmetric_eigen();
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
    let moments = Vector3::from_fn(|k, _| eigen.eigenvalues[order[k]]);
    let mut axes = Matrix3::from_fn(|i, k| eigen.eigenvectors[(i, order[k])]);
    let tolerance = EQUAL * moments.amax();
    let equal = |i: usize, j: usize| (moments[j] - moments[i]).abs() <= tolerance;
    match (equal(0, 1), equal(1, 2)) {
        (true, true) => axes = Matrix3::identity(),
        (true, false) => settle(&mut axes, 2),
        (false, true) => settle(&mut axes, 0),
        (false, false) => {}
    }
    for mut column in axes.column_iter_mut() {
        if column[column.iamax()] < 0.0 {
            column.neg_mut();
        }
    }
    if axes.determinant() < 0.0 {
        axes.column_mut(2).neg_mut();
    }
    Principal { moments, axes }
}

/// Of all pairs of axes across the single one, takes that which the shortest turn of the frame gives.
fn settle(axes: &mut Matrix3<f64>, single: usize) {
    let mut axis = axes.column(single).into_owned();
    let target = axis.iamax();
    if axis[target] < 0.0 {
        axis = -axis;
    }
    let mut unit = Vector3::zeros();
    unit[target] = 1.0;
    // The unit vector and the axis are never opposite: their product is at least 1 / sqrt(3).
    let turn = Rotation3::rotation_between(&unit, &axis).unwrap_or_else(Rotation3::identity);
    let others = [(target + 1) % 3, (target + 2) % 3];
    let (low, high) = if single == 0 { (1, 2) } else { (0, 1) };
    axes.set_column(single, &axis);
    axes.set_column(low, &turn.matrix().column(others[0]).into_owned());
    axes.set_column(high, &turn.matrix().column(others[1]).into_owned());
}
