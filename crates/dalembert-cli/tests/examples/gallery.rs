//! The gallery is complete: every model has its page, and every page its picture.

use super::run::{examples, models};
use std::fs;

#[test]
fn every_model_is_in_the_gallery() {
    let gallery = examples().join("../docs/gallery");
    let index = fs::read_to_string(gallery.join("README.md")).unwrap();
    let models = models();
    assert!(models.len() > 20, "{models:?}");
    for name in models {
        let page = fs::read_to_string(gallery.join(format!("{name}.md")))
            .unwrap_or_else(|e| panic!("docs/gallery/{name}.md: {e}"));
        // Planar machines are drawn, machines in space are photographed.
        let pictures = ["svg", "png"].map(|ending| format!("({name}.{ending})"));
        assert!(
            pictures.iter().any(|picture| page.contains(picture)),
            "{name}.md shows its picture"
        );
        assert!(
            page.contains(&format!("examples/{name}.toml)")),
            "{name}.md leads to its model"
        );
        assert!(
            index.contains(&format!("({name}.md)")),
            "README.md leads to {name}.md"
        );
        // Every picture and page that a page names exists.
        for target in page
            .split("](")
            .skip(1)
            .filter_map(|rest| rest.split(')').next())
        {
            assert!(gallery.join(target).exists(), "{name}.md names {target}");
        }
    }
}
