//! The animated page of a run.

use crate::failure::Failure;
use crate::load::Loaded;
use crate::output::write_text;
use crate::{scene, summary, viewer};
use dalembert::analysis::{Assembly, Mobility};
use dalembert::model::SpaceKind;
use dalembert::results::Results;
use dalembert::space::Space;
use dalembert::system::{Phase, Role, System};
use dalembert_io::animation::html;
use std::path::Path;

/// Can pages be written? Asked before a run, so that nobody waits for a page that cannot come.
pub fn check() -> Result<(), Failure> {
    // Both pages are there, or none.
    viewer::page(SpaceKind::Planar)
        .map(drop)
        .map_err(|e| Failure::Usage(e.to_string()))
}

/// Writes the page of a run.
pub fn write<S: Space>(loaded: &Loaded<S>, results: &Results, path: &Path) -> Result<(), Failure> {
    let template =
        viewer::page(loaded.model.info.space).map_err(|e| Failure::Usage(e.to_string()))?;
    let facts = facts(&loaded.compiled.system, results);
    let page =
        html(template, &scene::animation(loaded, results, facts)).map_err(|e| Failure::File {
            path: path.to_owned(),
            cause: e.to_string(),
        })?;
    write_text(path, &page)
}

/// Rows of the page's table: what was computed, how large it is, and how well it went.
fn facts<S: Space>(system: &System<S>, results: &Results) -> Vec<(String, String)> {
    let mut rows = vec![
        ("Analysis".to_owned(), results.analysis.clone()),
        ("Movable bodies".to_owned(), system.bodies.len().to_string()),
    ];
    rows.extend(mobility(system));
    let equations = |driver: bool| -> usize {
        system
            .elements
            .iter()
            .filter(|e| e.phase == Phase::Always && (e.role == Role::Driver) == driver)
            .map(|e| e.rows.len())
            .sum()
    };
    for (name, count) in [
        ("Coordinates", system.nv()),
        ("Constraint equations", equations(false)),
        ("Driver equations", equations(true)),
        ("Instants", results.len()),
    ] {
        rows.push((name.to_owned(), count.to_string()));
    }
    for (name, value) in &results.statistics {
        if name != "instants" {
            rows.push((capitalized(name), summary::number(*value)));
        }
    }
    for (channel, worst) in summary::errors(results) {
        let text = format!("{} {}", summary::number(worst), channel.unit);
        rows.push((
            format!("Largest |{}|", channel.name),
            text.trim_end().to_owned(),
        ));
    }
    rows
}

/// What the machine can do at its start; nothing where that cannot be decided.
fn mobility<S: Space>(system: &System<S>) -> Vec<(String, String)> {
    let report = Assembly::default()
        .run(system)
        .and_then(|(state, _)| Mobility::default().run(system, &state));
    let Ok(report) = report else {
        return Vec::new();
    };
    let mut rows = vec![("Mobility", report.freedoms())];
    if report.driver_rows > 0 {
        rows.push(("Freedoms left by the drivers", report.freedoms_left()));
    }
    if !report.redundant.is_empty() {
        rows.push(("Redundant equations", report.redundant.len()));
    }
    rows.into_iter()
        .map(|(name, count)| (name.to_owned(), count.to_string()))
        .collect()
}

fn capitalized(text: &str) -> String {
    let mut rest = text.chars();
    match rest.next() {
        Some(first) => first.to_uppercase().chain(rest).collect(),
        None => String::new(),
    }
}
