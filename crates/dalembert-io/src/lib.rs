//! Model files, result files and plots.
