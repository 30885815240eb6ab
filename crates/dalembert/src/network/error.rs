//! Why a question to the graph has no answer.

use super::Formulation;
use thiserror::Error;

/// Why a question to the graph has no answer.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NetworkError {
    /// The formulation needs another terminal graph.
    #[error("the {formulation} formulation needs the terminal graph with arms (frame -> centre)")]
    NeedsArms {
        /// The formulation.
        formulation: Formulation,
    },
}
