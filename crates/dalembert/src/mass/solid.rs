//! Homogeneous solids.

use super::MassProperties;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::PI;

/// A homogeneous solid. Its frame sits at the centre of mass except where said otherwise; lengths in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// Edges along x, y, z.
    Box([f64; 3]),
    /// Axis z.
    Cylinder {
        /// Radius.
        radius: f64,
        /// Length along z.
        length: f64,
    },
    /// Hollow cylinder, axis z.
    Tube {
        /// Inner radius.
        inner: f64,
        /// Outer radius.
        outer: f64,
        /// Length along z.
        length: f64,
    },
    /// Ball.
    Sphere {
        /// Radius.
        radius: f64,
    },
    /// Thin spherical shell.
    Shell {
        /// Radius.
        radius: f64,
    },
    /// Half of a ball; the frame sits at the centre of the flat face, z points to the round side.
    Hemisphere {
        /// Radius.
        radius: f64,
    },
    /// Right circular cone; the frame sits at the centre of the base, z points to the apex.
    Cone {
        /// Radius of the base.
        radius: f64,
        /// Height.
        height: f64,
    },
    /// Thin rod along x.
    Rod {
        /// Length.
        length: f64,
    },
    /// Thin disk across z.
    Disk {
        /// Radius.
        radius: f64,
    },
    /// Thin plate across z with edges along x and y.
    Plate([f64; 2]),
    /// Ellipsoid with its half axes along x, y, z.
    Ellipsoid([f64; 3]),
}

impl Solid {
    /// Volume [m^3]; the area [m^2] of shells, disks and plates; the length [m] of rods.
    pub fn extent(&self) -> f64 {
        match *self {
            Self::Box([a, b, c]) => a * b * c,
            Self::Cylinder { radius, length } => PI * radius * radius * length,
            Self::Tube {
                inner,
                outer,
                length,
            } => PI * (outer - inner) * (outer + inner) * length,
            Self::Sphere { radius } => 4.0 / 3.0 * PI * radius.powi(3),
            Self::Shell { radius } => 4.0 * PI * radius * radius,
            Self::Hemisphere { radius } => 2.0 / 3.0 * PI * radius.powi(3),
            Self::Cone { radius, height } => PI * radius * radius * height / 3.0,
            Self::Rod { length } => length,
            Self::Disk { radius } => PI * radius * radius,
            Self::Plate([a, b]) => a * b,
            Self::Ellipsoid([a, b, c]) => 4.0 / 3.0 * PI * a * b * c,
        }
    }

    /// Mass properties of a solid of this mass (Shabana, Table 7.1 and Problems 7.16 to 7.19).
    pub fn properties(&self, mass: f64) -> MassProperties {
        // Moments about the centre for unit mass, and the height of the centre.
        let round = |axial: f64, across: f64| [across, across, axial];
        let (moments, height) = match *self {
            Self::Box([a, b, c]) => (thirds(a, b, c, 12.0), 0.0),
            Self::Cylinder { radius: r, length } => (
                round(r * r / 2.0, (3.0 * r * r + length * length) / 12.0),
                0.0,
            ),
            Self::Tube {
                inner,
                outer,
                length,
            } => {
                let squares = inner * inner + outer * outer;
                let across = (3.0 * squares + length * length) / 12.0;
                (round(squares / 2.0, across), 0.0)
            }
            Self::Sphere { radius: r } => ([0.4 * r * r; 3], 0.0),
            Self::Shell { radius: r } => ([2.0 / 3.0 * r * r; 3], 0.0),
            Self::Hemisphere { radius: r } => {
                (round(0.4 * r * r, 83.0 / 320.0 * r * r), 3.0 / 8.0 * r)
            }
            Self::Cone {
                radius: r,
                height: h,
            } => (
                round(0.3 * r * r, 3.0 / 80.0 * (4.0 * r * r + h * h)),
                h / 4.0,
            ),
            Self::Rod { length } => (thirds(length, 0.0, 0.0, 12.0), 0.0),
            Self::Disk { radius: r } => (round(r * r / 2.0, r * r / 4.0), 0.0),
            Self::Plate([a, b]) => (thirds(a, b, 0.0, 12.0), 0.0),
            Self::Ellipsoid([a, b, c]) => (thirds(a, b, c, 5.0), 0.0),
        };
        MassProperties {
            mass,
            center: Vector3::new(0.0, 0.0, height),
            inertia: Matrix3::from_diagonal(&Vector3::from(moments)) * mass,
        }
    }
}

/// (b^2 + c^2, a^2 + c^2, a^2 + b^2) / n.
fn thirds(a: f64, b: f64, c: f64, n: f64) -> [f64; 3] {
    let [a, b, c] = [a * a, b * b, c * c];
    [(b + c) / n, (a + c) / n, (a + b) / n]
}
