//! Rigid bodies.

use super::{axial_vector, force::AXES, inertia, orientation, shape};
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{
    Body, HeldCoordinate, Shape,
    SpaceKind::{Planar, Spatial},
};
use toml::de::DeValue;

/// Reads a `[[body]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Body {
    let body = Body {
        name: table.name(Section::Body),
        mass: table.value("mass"),
        inertia: table.optional("inertia", inertia::lower),
        inertia_at: table.of_space(Spatial, "inertia_at", Item::axis),
        inertia_orientation: table.of_space(Spatial, "inertia_orientation", orientation::lower),
        center: table.point("center"),
        position: table.point("position"),
        angle: table.of_space(Planar, "angle", Item::value),
        orientation: table.of_space(Spatial, "orientation", orientation::lower),
        velocity: table.point("velocity"),
        angular_velocity: table.optional("angular_velocity", axial_vector::lower),
        angular_velocity_axes: table
            .of_space(Spatial, "angular_velocity_axes", |item| item.choice(&AXES)),
        hold: table.list("hold", held),
        fixed: table.flag("fixed"),
        shape: table.item("shape").map(shapes).unwrap_or_default(),
    };
    table.finish();
    body
}

/// Reads a coordinate that is held; those of the other space are refused by the engine.
fn held(item: &Item<'_>) -> Option<HeldCoordinate> {
    let [x, y] = [("x", HeldCoordinate::X), ("y", HeldCoordinate::Y)];
    let z = ("z", HeldCoordinate::Z);
    let angle = ("angle", HeldCoordinate::Angle);
    let orientation = ("orientation", HeldCoordinate::Orientation);
    match item.context.space() {
        Planar => item.choice_of(&[x, y, angle], &[z, orientation]),
        Spatial => item.choice_of(&[x, y, z, orientation], &[angle]),
    }
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
