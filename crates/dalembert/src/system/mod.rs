//! Compiled systems: immutable indices and layouts. Everything that changes lives in a [`State`]
//! or a [`Workspace`].

mod body;
mod compiled;
mod element;
mod evaluation;
#[cfg(test)]
mod manipulator_test;
mod masses;
mod metric;
mod plan;
mod positions;
mod products;
mod residuals;
mod row_scales;
mod state;
#[cfg(test)]
pub(crate) mod test_machine;
mod turns;
mod workspace;

pub mod compile;

pub use body::BodyData;
pub use compiled::{RowRef, System};
pub use element::{Coordinate, ElementData, ForceData, MarkerData, Phase, Role, TraceData};
pub use metric::Metric;
pub use state::State;
pub use turns::TurnData;
pub use workspace::Workspace;
