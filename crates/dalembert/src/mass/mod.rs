//! Mass, centre of mass and inertia tensor of spatial bodies: from tensors, solids, meshes, and composites of them.
//!
//! Inertia tensors carry the minus signs of their products: I_xy = - integral of x y dm (Shabana 7.95).

mod mesh;
mod properties;
mod solid;

pub use mesh::{MeshError, mesh_properties};
pub use properties::{InertiaWarning, MassProperties, Principal};
pub use solid::Solid;
