//! Model files, result files and plots.
#![forbid(unsafe_code)]

pub mod model_file;
