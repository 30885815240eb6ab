//! The gallery is complete: every model has its page, and every page its picture.

use super::run::examples;
use std::fs;

#[test]
fn every_model_is_in_the_gallery() {
    let gallery = examples().join("../docs/gallery");
    let index = fs::read_to_string(gallery.join("README.md")).unwrap();
    let mut models = 0;
    for entry in fs::read_dir(examples()).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        models += 1;
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let page = fs::read_to_string(gallery.join(format!("{name}.md")))
            .unwrap_or_else(|e| panic!("docs/gallery/{name}.md: {e}"));
        assert!(
            page.contains(&format!("({name}.svg)")),
            "{name}.md shows its picture"
        );
        assert!(
            page.contains(&format!("examples/{name}.toml")),
            "{name}.md names its model"
        );
        assert!(gallery.join(format!("{name}.svg")).exists(), "{name}.svg");
        assert!(
            index.contains(&format!("({name}.md)")),
            "README.md leads to {name}.md"
        );
    }
    assert!(models > 20, "{models} models");
}
