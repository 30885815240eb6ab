//! Rigid bodies.

use super::quantity::COORDINATES;
use super::shape;
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Body, Shape};
use toml::de::DeValue;

/// Reads a `[[body]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Body {
    let body = Body {
        name: table.name(Section::Body),
        mass: table.value("mass"),
        inertia: table.value("inertia"),
        center: table.point("center"),
        position: table.point("position"),
        angle: table.value("angle"),
        velocity: table.point("velocity"),
        angular_velocity: table.value("angular_velocity"),
        hold: table.list("hold", |item| item.choice(&COORDINATES)),
        fixed: table.flag("fixed"),
        shape: table.item("shape").map(shapes).unwrap_or_default(),
    };
    table.finish();
    body
}

/// Reads `shape`: one table, or a list of them.
fn shapes(mut item: Item<'_>) -> Vec<Shape> {
    match item.value {
        DeValue::Table(_) => {
            item.place.path.push_str("[0]");
            vec![shape::lower(&item)]
        }
        DeValue::Array(_) => item
            .list(|item| Some(shape::lower(item)))
            .unwrap_or_default(),
        _ => {
            item.wrong_type("a table or a list of tables");
            Vec::new()
        }
    }
}
