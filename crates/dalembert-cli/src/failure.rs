//! Why the program ends without success, and its exit code.

use dalembert::analysis::AnalysisError;
use std::path::PathBuf;
use thiserror::Error;

/// Why the program ends without success.
#[derive(Debug, Error)]
pub enum Failure {
    /// The analysis failed, or stopped early.
    #[error("error: {0}")]
    Analysis(#[from] AnalysisError),
    /// The command line asks for something that does not exist.
    #[error("error: {0}")]
    Usage(String),
    /// The model has mistakes; they are rendered already.
    #[error("{0}")]
    Model(String),
    /// A file cannot be read or written.
    #[error("error: {path}: {cause}")]
    File {
        /// File.
        path: PathBuf,
        /// Cause.
        cause: String,
    },
}

impl Failure {
    /// Exit code for scripts.
    pub fn code(&self) -> u8 {
        match self {
            Self::Analysis(_) => 1,
            Self::Usage(_) => 2,
            Self::Model(_) => 3,
            Self::File { .. } => 4,
        }
    }
}
