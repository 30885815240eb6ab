//! Vertices of the linear graph.

use serde::Serialize;

/// What a vertex is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum VertexKind {
    /// The inertial origin O.
    Origin,
    /// The centre of mass frame of a body.
    Center,
    /// A frame at which a component is attached.
    Terminal,
}

/// A vertex: a frame on a body or on the ground.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Vertex {
    /// Name: "O", "crank.G", "crank@A".
    pub name: String,
    /// What it is.
    pub kind: VertexKind,
    /// Movable body, or none for the ground.
    pub body: Option<usize>,
}
