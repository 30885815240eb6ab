//! The commands, one file each.

pub mod check;
pub mod equations;
pub mod inverse;
pub mod kinematics;
pub mod network;
pub mod new;
pub mod plot;
pub mod schema;
pub mod simulate;
pub mod statics;
pub mod view;
