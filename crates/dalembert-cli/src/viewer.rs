//! The animated page that the program carries in itself.

use std::error::Error;
use std::fmt;

#[cfg(feature = "viewer")]
const PAGE: Option<&str> = Some(include_str!(concat!(env!("OUT_DIR"), "/viewer.html")));
#[cfg(not(feature = "viewer"))]
const PAGE: Option<&str> = None;

/// The page cannot be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewerError {
    /// The program was built without the feature `viewer`.
    NotBuilt,
}

impl fmt::Display for ViewerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotBuilt => f.write_str(
                "this program was built without the viewer; build it again with npm installed and \
                 with the feature \"viewer\" (which is on by default)",
            ),
        }
    }
}

impl Error for ViewerError {}

/// The HTML of the page; its element `dalembert-data` is empty and takes the JSON of an animation.
pub fn page() -> Result<&'static str, ViewerError> {
    PAGE.ok_or(ViewerError::NotBuilt)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(feature = "viewer")]
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

    #[cfg(not(feature = "viewer"))]
    #[test]
    fn without_the_feature_there_is_no_page() {
        assert_eq!(page(), Err(ViewerError::NotBuilt));
    }
}
