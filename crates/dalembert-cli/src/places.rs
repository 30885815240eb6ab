//! Where the elements that a message names stand in the model file.

use dalembert_io::model_file::{line_column, parse_model};
use std::path::Path;

/// Most elements that are pointed at.
const MOST: usize = 4;

/// Lines like "  --> file.toml:12:8: joint 'pin'" for the elements that a message names; none where the file cannot be read.
pub fn of_elements(message: &str, file: &Path) -> Vec<String> {
    let Ok(text) = std::fs::read_to_string(file) else {
        return Vec::new();
    };
    let parsed = parse_model(&text, file.parent());
    let Some(model) = parsed.draft else {
        return Vec::new();
    };
    let bodies = model.bodies.iter().map(|x| &x.name);
    let joints = model.joints.iter().map(|x| &x.name);
    let constraints = model.constraints.iter().map(|x| &x.name);
    let drivers = model.drivers.iter().map(|x| &x.name);
    let forces = model.forces.iter().map(|x| &x.name);
    let of = |section: &'static str| move |(number, name)| (section, number, name);
    let elements = (bodies.enumerate().map(of("body")))
        .chain(joints.enumerate().map(of("joint")))
        .chain(constraints.enumerate().map(of("constraint")))
        .chain(drivers.enumerate().map(of("driver")))
        .chain(forces.enumerate().map(of("force")));
    let mut named: Vec<(usize, &str, usize, &String)> = elements
        .filter_map(|(section, number, name)| {
            // As messages write them: 'pin', or pin (revolute).
            let written = [format!("'{name}'"), format!(" {name} (")];
            let at = written.iter().filter_map(|w| message.find(w)).min()?;
            Some((at, section, number, name))
        })
        .collect();
    named.sort_unstable();
    let lines = named.into_iter().filter_map(|(_, section, number, name)| {
        let span = parsed.source.locate(&format!("{section}[{number}].name"))?;
        let (line, column) = line_column(&text, span.start);
        let file = file.display();
        Some(format!("  --> {file}:{line}:{column}: {section} '{name}'"))
    });
    lines.take(MOST).collect()
}
