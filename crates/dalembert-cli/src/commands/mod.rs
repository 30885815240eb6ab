//! The commands, one file each.

pub mod inverse;
pub mod kinematics;
pub mod new;
pub mod plot;
pub mod schema;
pub mod simulate;
pub mod view;
