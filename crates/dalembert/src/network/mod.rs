//! The linear graph of a machine: incidence, trees, cut-sets, circuits, loops (Tokad 1992; parts
//! of the graph carry the names of the user's components).
//!
//! Vertices are frames: the inertial origin O, the centre of mass frame of each body, and every
//! frame at which a component is attached. Edges are components: inertia edges (centre -> O),
//! rigid arms (frame -> centre), joints, constraints, drivers and force elements.

mod dot;
mod edge;
mod error;
mod formulation;
mod graph;
mod loops;
mod parts;
mod text;
mod tree;
mod union_find;
mod vertex;

pub use edge::{Edge, EdgeClass, EdgeSource};
pub use error::NetworkError;
pub use formulation::{Formulation, FormulationSize};
pub use graph::{Network, TerminalGraph};
pub use loops::Loop;
pub use parts::Part;
pub use tree::SpanningTree;
pub(crate) use union_find::UnionFind;
pub use vertex::{Vertex, VertexKind};
