//! The data put into the viewer page.

use super::{Animation, AnimationError};

/// The place for the data in the viewer page; it stands there exactly once.
pub const MARKER: &str = r#"<script id="dalembert-data" type="application/json"></script>"#;

/// The viewer page with the animation's data inside, complete in one file.
///
/// Every `<` of the data is written as `\u003c`, which JSON reads back as `<`, so that no name
/// in a model can end the element or begin another.
pub fn html(page_template: &str, animation: &Animation) -> Result<String, AnimationError> {
    let found = page_template.matches(MARKER).count();
    let (Some((before, after)), 1) = (page_template.split_once(MARKER), found) else {
        return Err(AnimationError::Marker { found });
    };
    let json = animation.to_json()?.replace('<', "\\u003c");
    // The marker without its closing tag opens the element.
    let open = MARKER.strip_suffix("</script>").unwrap_or(MARKER);
    Ok([before, open, &json, "</script>", after].concat())
}
