//! Surfaces of bodies: their points by two parameters, or by three coordinates where two have poles, with the derivatives
//! that contacts need.

mod field;
mod local;
mod nearest;
mod partials;
mod shape;
mod sheet;

pub use field::Field;
pub use local::{Around, Coordinates};
pub use nearest::{Placed, Touch, nearest_pair, nearest_point, touch};
pub use partials::Partials;
pub use shape::{Surface, SurfaceShape};
pub use sheet::Sheet;
