//! Surfaces of bodies, by two parameters, with the derivatives that contacts need.

mod field;
mod partials;
mod shape;

pub use field::Field;
pub use partials::Partials;
pub use shape::{Surface, SurfaceShape};
