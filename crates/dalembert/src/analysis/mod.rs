//! What a compiled system is asked: assembly, mobility, kinematics, dynamics, inverse dynamics,
//! statics, equations. Each analysis is a small struct of options with a `run`.

mod aligned;
mod assembly;
mod balance;
mod changed_rate;
mod conserved;
mod contact_watch;
mod contradiction;
mod dynamics;
pub mod equations;
mod error;
mod guards;
mod inverse;
mod kinematics;
mod least_reactions;
mod massless;
mod meeting;
mod missing_mass;
mod mobility;
mod motion;
mod newton;
mod open_reactions;
mod pace;
mod pulling;
mod recorder;
mod sides;
mod statics;
mod stiffest;
mod weights;

pub use assembly::{Assembly, AssemblyReport, Moved};
pub use changed_rate::ChangedRate;
pub use dynamics::{Dynamics, DynamicsReport};
pub use equations::{EquationBasis, Equations, EquationsReport, ReferenceFrame};
pub use error::AnalysisError;
pub use inverse::Inverse;
pub use kinematics::{Kinematics, KinematicsRun};
pub use missing_mass::missing_mass;
pub use mobility::{
    BodyMotion, Conflict, Dependence, DriverSweep, FreeMotion, MasslessMotion, Mobility,
    MobilityReport, Rank, SingularKind, SingularPose, SweepOptions, conflicts,
    driver_singularities,
};
pub use motion::Motion;
pub use newton::{NewtonOptions, NewtonReport};
pub use recorder::{Extra, Recorder, Recording};
pub use statics::{
    Equilibrium, HoldingLoad, HoldingLoads, Route, Stability, Statics, StaticsReport, Unknown,
    holding_loads,
};
