//! Homogeneous bodies bounded by triangles.

use super::MassProperties;
use nalgebra::{Matrix3, Vector3};
use std::collections::HashMap;
use thiserror::Error;

/// A mesh that does not enclose a volume.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum MeshError {
    /// It has no triangles.
    #[error("the mesh has no triangles")]
    Empty,
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names the vertex {vertex}, but there are only {vertices}")]
    NoSuchVertex {
        /// Number of the triangle, from 1.
        triangle: usize,
        /// The vertex, from 1.
        vertex: usize,
        /// Number of vertices.
        vertices: usize,
    },
    /// A coordinate is not finite.
    #[error("vertex {vertex} has a coordinate that is not finite")]
    NotFinite {
        /// The vertex, from 1.
        vertex: usize,
    },
    /// Edges that bound one triangle only, or are run through twice in one direction.
    #[error("the mesh is not closed: {edges} of its edges do not join two triangles")]
    NotClosed {
        /// How many.
        edges: usize,
    },
    /// The triangles enclose nothing.
    #[error("the mesh encloses no volume")]
    NoVolume,
}

/// Volume [m^3] and mass properties of unit density of the space that a closed mesh encloses; triangles run
/// counter-clockwise seen from outside, or all the other way round.
///
/// Sums over the tetrahedra (origin, a, b, c) of signed volume V = a.(b x c) / 6, first moments V (a + b + c) / 4 and
/// second moments V / 20 (sum of p p^T over a, b, c and s = a + b + c).
///
/// # Errors
/// The mesh is empty, open, flat, or has numbers or indices that cannot be.
pub fn mesh_properties(
    vertices: &[[f64; 3]],
    triangles: &[[usize; 3]],
) -> Result<MassProperties, MeshError> {
    check(vertices, triangles)?;
    // From the middle of the box, so that far meshes lose no digits.
    let [low, high] = [f64::min, f64::max].map(|pick| {
        vertices
            .iter()
            .map(|v| Vector3::from(*v))
            .reduce(|a, b| a.zip_map(&b, pick))
            .unwrap_or_default()
    });
    let (origin, size) = (0.5 * (low + high), (high - low).amax());
    let (mut volume, mut first, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
    for t in triangles {
        let [a, b, c] = t.map(|v| Vector3::from(vertices[v]) - origin);
        let v = a.dot(&b.cross(&c)) / 6.0;
        let s = a + b + c;
        volume += v;
        first += v / 4.0 * s;
        let sum = a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose();
        second += v / 20.0 * sum;
    }
    // Rounding of a flat mesh.
    if volume.abs() <= 1e-12 * size.powi(3) {
        return Err(MeshError::NoVolume);
    }
    let sign = volume.signum();
    let (volume, first, second) = (sign * volume, sign * first, sign * second);
    let inertia = Matrix3::identity() * second.trace() - second;
    let mut properties = MassProperties::about_origin(volume, first / volume, inertia);
    properties.center += origin;
    Ok(properties)
}

fn check(vertices: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<(), MeshError> {
    if triangles.is_empty() {
        return Err(MeshError::Empty);
    }
    for (k, v) in vertices.iter().enumerate() {
        if !v.iter().all(|x| x.is_finite()) {
            return Err(MeshError::NotFinite { vertex: k + 1 });
        }
    }
    // Every edge of a closed mesh is run through once in each direction.
    let mut edges: HashMap<(usize, usize), i64> = HashMap::new();
    for (k, t) in triangles.iter().enumerate() {
        for i in 0..3 {
            let (from, to) = (t[i], t[(i + 1) % 3]);
            if from >= vertices.len() {
                return Err(MeshError::NoSuchVertex {
                    triangle: k + 1,
                    vertex: from + 1,
                    vertices: vertices.len(),
                });
            }
            let (key, way) = if from < to {
                ((from, to), 1)
            } else {
                ((to, from), -1)
            };
            *edges.entry(key).or_insert(0) += way;
        }
    }
    let open = edges.values().filter(|&&n| n != 0).count();
    if open > 0 {
        return Err(MeshError::NotClosed { edges: open });
    }
    Ok(())
}
