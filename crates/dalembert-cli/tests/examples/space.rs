//! Vectors and rotations of space, for the closed forms of spatial machines.

use super::run::Instant;

/// A vector of space.
pub type Vector = [f64; 3];

/// Three channels of an element, like "wheel.omega_x" and its neighbours by the stem "wheel.omega_".
pub fn vector(i: Instant<'_>, stem: &str) -> Vector {
    ["x", "y", "z"].map(|axis| i.get(&format!("{stem}{axis}")))
}

/// Scalar product.
pub fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

/// Vector product.
pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Difference a - b.
pub fn minus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

/// Sum.
pub fn plus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] + b[k])
}

/// A multiple.
pub fn times(factor: f64, a: Vector) -> Vector {
    a.map(|x| factor * x)
}

/// Length.
pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Axes of a body, seen from the ground, from the channels of its Euler parameters.
pub fn axes(i: Instant<'_>, body: &str) -> [Vector; 3] {
    let [w, x, y, z] = ["b0", "b1", "b2", "b3"].map(|name| i.get(&format!("{body}.{name}")));
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y + w * z),
            2.0 * (x * z - w * y),
        ],
        [
            2.0 * (x * y - w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z + w * x),
        ],
        [
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

/// A point of a body, seen from the ground.
pub fn point(i: Instant<'_>, body: &str, at: Vector) -> Vector {
    let [x, y, z] = axes(i, body);
    let arm = plus(times(at[0], x), plus(times(at[1], y), times(at[2], z)));
    plus(vector(i, &format!("{body}.")), arm)
}
