//! Why the program ends without success, and its exit code.

use dalembert::analysis::{AnalysisError, Conflict};
use serde_json::{Value, json};
use std::path::PathBuf;
use thiserror::Error;

/// Why the program ends without success.
#[derive(Debug, Error)]
pub enum Failure {
    /// The analysis failed.
    #[error("{0}")]
    Analysis(#[from] AnalysisError),
    /// The analysis stopped early; what it has is written, with the reason.
    #[error("{0}")]
    Stopped(AnalysisError),
    /// The machine cannot be assembled; what contradicts what.
    #[error("{error}")]
    NotAssembled {
        /// What Newton's method met.
        error: AnalysisError,
        /// The smallest sets of elements that contradict each other.
        conflicts: Vec<Conflict>,
    },
    /// The command line asks for something that does not exist.
    #[error("{0}")]
    Usage(String),
    /// The model has mistakes.
    #[error("{text}")]
    Model {
        /// The mistakes for people.
        text: String,
        /// The mistakes for programs.
        diagnostics: Value,
    },
    /// A file cannot be read or written.
    #[error("{}", file_message(path, cause))]
    File {
        /// File.
        path: PathBuf,
        /// Cause.
        cause: String,
    },
}

/// "path: cause"; causes that name the file themselves stand alone.
fn file_message(path: &std::path::Path, cause: &str) -> String {
    let name = path.display().to_string();
    if cause.starts_with(&name) {
        cause.to_owned()
    } else {
        format!("{name}: {cause}")
    }
}

impl Failure {
    /// Tells the user: people by a text on the error stream, programs (`json`) by one JSON object
    /// on the output. With an object of results the reason is in that one.
    pub fn tell(&self, json: bool) {
        match self {
            Self::Model { diagnostics, .. } if json => {
                say!(
                    "{:#}",
                    json!({ "completed": false, "diagnostics": diagnostics })
                );
            }
            Self::Analysis(_) | Self::Usage(_) | Self::File { .. } if json => {
                say!(
                    "{:#}",
                    json!({ "completed": false, "error": self.to_string() })
                );
            }
            Self::NotAssembled { conflicts, .. } if json => {
                say!(
                    "{:#}",
                    json!({ "completed": false, "error": self.to_string(), "conflicts": conflicts })
                );
            }
            Self::NotAssembled { conflicts, .. } => {
                for conflict in conflicts {
                    eprintln!("conflict: {conflict}");
                }
                eprintln!("error: {self}");
            }
            Self::Model { text, .. } => eprintln!("{}", text.trim_end()),
            _ => eprintln!("error: {self}"),
        }
    }

    /// Did an analysis of a valid model fail?
    pub fn is_of_analysis(&self) -> bool {
        matches!(
            self,
            Self::Analysis(_) | Self::Stopped(_) | Self::NotAssembled { .. }
        )
    }

    /// Exit code for scripts.
    pub fn code(&self) -> u8 {
        match self {
            Self::Analysis(_) | Self::Stopped(_) | Self::NotAssembled { .. } => 1,
            Self::Usage(_) => 2,
            Self::Model { .. } => 3,
            Self::File { .. } => 4,
        }
    }
}
