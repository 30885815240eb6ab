//! A mesh of triangles with every vertex once.

use std::collections::HashMap;

/// A mesh of triangles, in units of its file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// Vertices; no two at the same place.
    pub vertices: Vec<[f64; 3]>,
    /// Numbers of the vertices of each triangle, from 0.
    pub triangles: Vec<[usize; 3]>,
}

/// Puts a mesh together from corners that come again with every triangle.
#[derive(Default)]
pub(super) struct Merger {
    mesh: TriangleMesh,
    numbers: HashMap<[u64; 3], usize>,
}

impl Merger {
    /// Adds a triangle; one that is only a line or a point is left out.
    pub fn add(&mut self, corners: [[f64; 3]; 3]) {
        let triangle = corners.map(|corner| self.number(corner));
        let [a, b, c] = triangle;
        // Its edges cancel each other, so that a closed mesh stays closed.
        if a != b && b != c && c != a {
            self.mesh.triangles.push(triangle);
        }
    }

    fn number(&mut self, corner: [f64; 3]) -> usize {
        // Zero and minus zero are the same place.
        let corner = corner.map(|x| x + 0.0);
        *self
            .numbers
            .entry(corner.map(f64::to_bits))
            .or_insert_with(|| {
                self.mesh.vertices.push(corner);
                self.mesh.vertices.len() - 1
            })
    }

    /// The mesh.
    pub fn finish(self) -> TriangleMesh {
        self.mesh
    }
}
