//! What a compiled system is asked: assembly, mobility, kinematics, dynamics, inverse dynamics,
//! statics, equations. Each analysis is a small struct of options with a `run`.

mod assembly;
pub mod equations;
mod error;
mod newton;
mod recorder;
mod weights;

pub use assembly::{Assembly, AssemblyReport, Moved};
pub use equations::{EquationBasis, Equations, EquationsReport, ReferenceFrame};
pub use error::AnalysisError;
pub use newton::{NewtonOptions, NewtonReport};
pub use recorder::Recorder;
