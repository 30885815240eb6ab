//! The animated page that the program carries in itself.

use std::error::Error;
use std::fmt;

/// What stands in the page in place of the data, exactly once (`viewer/build.mjs` sees to it).
const PLACEHOLDER: &str = "\"@dalembert-data@\"";

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

/// The HTML of the page, still without an animation in it.
pub fn page() -> Result<&'static str, ViewerError> {
    PAGE.ok_or(ViewerError::NotBuilt)
}

/// The HTML of the page with an animation in it, given as JSON of the format "dalembert-animation/1".
pub fn page_with(json: &str) -> Result<String, ViewerError> {
    Ok(insert(page()?, json))
}

/// Puts JSON into the page; "<" is escaped, so that no text in it can end the script element.
fn insert(page: &str, json: &str) -> String {
    page.replacen(PLACEHOLDER, &json.replace('<', "\\u003c"), 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_cannot_leave_its_element() {
        let page = format!("<script>{PLACEHOLDER}</script>");
        let written = insert(&page, r#"{"title":"</script><b>"}"#);
        assert_eq!(
            written,
            r#"<script>{"title":"\u003c/script>\u003cb>"}</script>"#
        );
    }

    #[cfg(feature = "viewer")]
    #[test]
    fn the_page_has_one_place_for_data_and_asks_for_nothing() {
        let page = page().unwrap();
        assert_eq!(page.matches(PLACEHOLDER).count(), 1);
        assert!(page.contains("default-src 'none'"));
        for request in [
            "<link rel=\"stylesheet\"",
            "<script src",
            "@import",
            "url(http",
        ] {
            assert!(!page.contains(request), "the page contains {request}");
        }
        assert!(!page_with("{}").unwrap().contains(PLACEHOLDER));
    }

    #[cfg(not(feature = "viewer"))]
    #[test]
    fn without_the_feature_there_is_no_page() {
        assert_eq!(page(), Err(ViewerError::NotBuilt));
        assert_eq!(page_with("{}"), Err(ViewerError::NotBuilt));
    }
}
