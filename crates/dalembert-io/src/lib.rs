//! Model files, result files, plots and the data of the animated page.
#![forbid(unsafe_code)]

pub mod animation;
pub mod mesh_file;
pub mod model_file;
pub mod plot;
pub mod result_file;
