//! The animated page that the program carries in itself.

use std::error::Error;
use std::fmt;

#[cfg(viewer_page)]
const PAGE: Option<&str> = Some(include_str!(concat!(env!("OUT_DIR"), "/viewer.html")));
#[cfg(not(viewer_page))]
const PAGE: Option<&str> = None;

/// Why there is no page, as the build script found it.
const REASON: Option<&str> = option_env!("DALEMBERT_NO_PAGE");

/// The page cannot be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewerError {
    /// The program was built without the page.
    NotBuilt {
        /// What was missing and what to do.
        reason: &'static str,
    },
}

impl fmt::Display for ViewerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotBuilt { reason } => {
                write!(
                    f,
                    "this program was built without the animated page: {reason}"
                )
            }
        }
    }
}

impl Error for ViewerError {}

/// The HTML of the page; its element `dalembert-data` is empty and takes the JSON of an animation.
pub fn page() -> Result<&'static str, ViewerError> {
    PAGE.ok_or(ViewerError::NotBuilt {
        reason: REASON.unwrap_or("the reason is not known"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(viewer_page)]
    #[test]
    fn the_page_has_one_place_for_data_and_asks_for_nothing() {
        let page = page().unwrap();
        let place = r#"<script id="dalembert-data" type="application/json"></script>"#;
        assert_eq!(page.matches(place).count(), 1);
        assert!(page.contains("default-src 'none'"));
        for request in [
            "<link rel=\"stylesheet\"",
            "<script src",
            "@import",
            "url(http",
        ] {
            assert!(!page.contains(request), "the page contains {request}");
        }
    }

    #[cfg(not(viewer_page))]
    #[test]
    fn a_program_without_the_page_says_how_to_get_it() {
        let text = page().unwrap_err().to_string();
        assert!(text.contains("build"), "{text}");
    }
}
