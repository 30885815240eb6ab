//! The animated pages that the program carries in itself.

use dalembert::model::SpaceKind;
use std::error::Error;
use std::fmt;

#[cfg(viewer_page)]
const PAGES: Option<Pages> = Some(Pages {
    planar: include_str!(concat!(env!("OUT_DIR"), "/viewer.html")),
    spatial: include_str!(concat!(env!("OUT_DIR"), "/viewer-spatial.html")),
});
#[cfg(not(viewer_page))]
const PAGES: Option<Pages> = None;

/// Planar machines have a page of their own: without the library that draws in space it is a
/// sixth of the size.
struct Pages {
    planar: &'static str,
    spatial: &'static str,
}

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

/// The HTML of the page for machines of a kind; its element `dalembert-data` is empty and takes
/// the JSON of an animation.
pub fn page(space: SpaceKind) -> Result<&'static str, ViewerError> {
    let pages = PAGES.ok_or(ViewerError::NotBuilt {
        reason: REASON.unwrap_or("the reason is not known"),
    })?;
    Ok(match space {
        SpaceKind::Planar => pages.planar,
        SpaceKind::Spatial => pages.spatial,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(viewer_page)]
    #[test]
    fn the_pages_have_one_place_for_data_and_ask_for_nothing() {
        let place = r#"<script id="dalembert-data" type="application/json"></script>"#;
        for space in [SpaceKind::Planar, SpaceKind::Spatial] {
            let page = page(space).unwrap();
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
    }

    #[cfg(viewer_page)]
    #[test]
    fn the_page_of_planar_machines_is_small() {
        let size = |space| page(space).unwrap().len();
        assert!(3 * size(SpaceKind::Planar) < size(SpaceKind::Spatial));
    }

    #[cfg(not(viewer_page))]
    #[test]
    fn a_program_without_the_page_says_how_to_get_it() {
        let text = page(SpaceKind::Planar).unwrap_err().to_string();
        assert!(text.contains("build"), "{text}");
    }
}
