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
    /// A size of a form is not positive.
    #[error("{element:?}: the {size} of its {form} is {value}, it must be positive")]
    NotPositive {
        /// Name of the element.
        element: String,
        /// Kind of the form.
        form: &'static str,
        /// Which size.
        size: &'static str,
        /// What it is (m).
        value: f64,
    },
    /// A size of a form is not smaller than another.
    #[error("{element:?}: the {small} size of its {form} must be smaller than the {large}")]
    NotOrdered {
        /// Name of the element.
        element: String,
        /// Kind of the form.
        form: &'static str,
        /// The size that must be smaller.
        small: &'static str,
        /// The size that must be larger.
        large: &'static str,
    },
    /// A form has too few points, triangles or rows.
    #[error("{element:?}: its {form} has {found} in {field}, it needs at least {least}")]
    TooFew {
        /// Name of the element.
        element: String,
        /// Kind of the form.
        form: &'static str,
        /// Which list or count.
        field: &'static str,
        /// How many there are.
        found: usize,
        /// How many it needs.
        least: usize,
    },
    /// A list of a form should hold three numbers for each of its entries.
    #[error("{element:?}: the {field} of its {form} have {found} numbers, not a multiple of 3")]
    NotTriples {
        /// Name of the element.
        element: String,
        /// Kind of the form.
        form: &'static str,
        /// Which list.
        field: &'static str,
        /// Numbers in the list.
        found: usize,
    },
    /// A triangle of a mesh names a corner that is not there.
    #[error(
        "{element:?}: a triangle of its mesh names corner {corner} of {corners}, counted from 0"
    )]
    UnknownCorner {
        /// Name of the element.
        element: String,
        /// The corner.
        corner: u32,
        /// Number of corners.
        corners: usize,
    },
    /// A revolved profile crosses its axis.
    #[error("{element:?}: the radius {value} in the profile of its revolved form is negative")]
    NegativeRadius {
        /// Name of the element.
        element: String,
        /// The radius (m).
        value: f64,
    },
    /// A direction has no length.
    #[error("{element:?}: its {field} has no length")]
    NoDirection {
        /// Name of the element.
        element: String,
        /// Which direction.
        field: &'static str,
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
