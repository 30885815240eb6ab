//! Model files, result files and plots.
#![forbid(unsafe_code)]

pub mod animation;
pub mod plot;
pub mod result_file;
