//! Linear algebra on our patterns: saddle systems and rank decisions.

mod auxiliary;
mod factored;
mod kernel;
mod ldl;
mod order;
mod pattern;
mod refine;
mod residual;
mod saddle;
mod shape;

pub use factored::Factored;
pub use pattern::Pattern;
pub use residual::{Residual, Rhs};
pub use saddle::Saddle;
pub use shape::{ElementShape, SaddleShape};
