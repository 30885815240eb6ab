//! Surfaces of bodies that touch.

use super::Value;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Form of a surface in its own frame, by two parameters a and b (spatial); every length in metres.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum SurfaceForm {
    /// The x-y plane, free on the side of +z: (a, b, 0).
    #[default]
    Plane,
    /// A sphere about the origin: R (cos b cos a, cos b sin a, sin b).
    Sphere {
        /// Radius.
        radius: Value,
    },
    /// A cylinder about z: (R cos a, R sin a, b).
    Cylinder {
        /// Radius.
        radius: Value,
    },
    /// A cone about z, its base at z = 0, its apex at z = height: (r cos a, r sin a, b).
    Cone {
        /// Radius of the base.
        radius: Value,
        /// Height.
        height: Value,
    },
    /// An ellipsoid: (A cos b cos a, B cos b sin a, C sin b).
    Ellipsoid {
        /// Half axes A, B, C along x, y, z.
        semi_axes: [Value; 3],
    },
    /// A ring about z: (r cos a, r sin a, t sin b) with r = radius + t cos b.
    Torus {
        /// Radius of the circle in the middle of the tube.
        radius: Value,
        /// Radius t of the tube.
        tube: Value,
    },
    /// A profile turned about z: (r(b) cos a, r(b) sin a, z(b)).
    Revolved {
        /// r(b), an expression of `b`.
        r: Value,
        /// z(b), an expression of `b`.
        z: Value,
    },
    /// Any surface, by expressions of `a` and `b`, which are plain numbers: a bowl is
    /// `x = "a * 1 m", y = "b * 1 m", z = "(a^2 + b^2) * 0.5 m"`.
    Expression {
        /// x(a, b).
        x: Value,
        /// y(a, b).
        y: Value,
        /// z(a, b).
        z: Value,
    },
}

/// A surface of a body (spatial). Its normal, out of the body, is that of (du/da) x (du/db).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Surface {
    /// Form and sizes.
    #[serde(flatten)]
    pub form: SurfaceForm,
    /// Does the body lie around the surface (a bowl, a hole)? The normal is then the opposite one.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inside: bool,
}
