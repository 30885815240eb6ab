//! Mobility: rank, not counting, decides what a machine can do.

mod axis_words;
mod body_motion;
mod conflicts;
mod dependence;
mod driver_sweep;
mod free_motion;
mod massless;
mod nearby;
mod ranked;
mod report;
mod run;
mod singular_pose;
#[cfg(test)]
mod spatial_test;
mod sweep_result;
mod text;

pub use body_motion::BodyMotion;
pub(super) use body_motion::with_axis;
pub use conflicts::{Conflict, conflicts};
pub use dependence::Dependence;
pub use driver_sweep::driver_singularities;
pub use free_motion::FreeMotion;
pub(super) use free_motion::describe;
pub use massless::MasslessMotion;
pub use report::{MobilityReport, Rank};
pub use run::Mobility;
pub use singular_pose::{SingularKind, SingularPose};
pub use sweep_result::{DriverSweep, SweepOptions};
