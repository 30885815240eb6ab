//! Why an animation cannot be written.

use super::MARKER;
use thiserror::Error;

/// Why an animation cannot be written.
#[derive(Debug, Error)]
pub enum AnimationError {
    /// A list does not fit the number of instants.
    #[error("{element:?}: {field} has {found} numbers instead of {expected}")]
    WrongLength {
        /// Name of the element.
        element: String,
        /// Which list.
        field: &'static str,
        /// Numbers in the list.
        found: usize,
        /// Numbers that the instants ask for.
        expected: usize,
    },
    /// A number is not finite.
    #[error("{element:?}: number {index} of {field} is not finite")]
    NotFinite {
        /// Name of the element.
        element: String,
        /// Which list.
        field: &'static str,
        /// Place in the list, counted from 0.
        index: usize,
    },
    /// An element sits on a body that the animation lacks.
    #[error("{element:?} sits on the body {body:?}, which is not there")]
    UnknownBody {
        /// Name of the element.
        element: String,
        /// Name of the body.
        body: String,
    },
    /// The page has no place, or several places, for the data.
    #[error("the page has {found} places for the data ({MARKER}) instead of one")]
    Marker {
        /// Number of places.
        found: usize,
    },
    /// The data could not be written as JSON.
    #[error("the animation cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}
