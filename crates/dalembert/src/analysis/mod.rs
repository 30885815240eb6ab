//! What a compiled system is asked: assembly, mobility, kinematics, dynamics, inverse dynamics,
//! statics, equations. Each analysis is a small struct of options with a `run`.

mod assembly;
mod error;
mod mobility;
mod newton;
mod recorder;
mod weights;

pub use assembly::{Assembly, AssemblyReport, Moved};
pub use error::AnalysisError;
pub use mobility::{
    BodyMotion, Conflict, Dependence, DriverSweep, FreeMotion, MasslessMotion, Mobility,
    MobilityReport, Rank, SingularKind, SingularPose, SweepOptions, conflicts,
    driver_singularities,
};
pub use newton::{NewtonOptions, NewtonReport};
pub use recorder::Recorder;
