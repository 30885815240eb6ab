//! Shapes of bodies.

use crate::model_file::item::Item;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Shape, ShapeKind};

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Bar,
    Rectangle,
    Circle,
    Ring,
    Polygon,
    Lump,
}

const KINDS: [(&str, Kind); 6] = [
    ("bar", Kind::Bar),
    ("rectangle", Kind::Rectangle),
    ("circle", Kind::Circle),
    ("ring", Kind::Ring),
    ("polygon", Kind::Polygon),
    ("lump", Kind::Lump),
];

/// Reads a shape.
pub(super) fn lower(item: &Item<'_>) -> Shape {
    match item.table() {
        Some(table) => of_table(table),
        None => super::unknown_kind::silently(&of_table),
    }
}

fn of_table(mut table: TableReader<'_>) -> Shape {
    let kind = kind(&mut table);
    let known = kind.is_some();
    let shape = Shape {
        kind: kind.unwrap_or(ShapeKind::Lump { inertia: None }),
        at: table.point("at"),
        angle: table.value("angle"),
        mass: table.value("mass"),
        density: table.value("density"),
        thickness: table.value("thickness"),
        cut: table.flag("cut"),
        color: table.optional("color", color),
    };
    check_mass(&table);
    if known {
        table.finish();
    }
    shape
}

fn kind(table: &mut TableReader<'_>) -> Option<ShapeKind> {
    Some(match table.kind(&KINDS)? {
        Kind::Bar => ShapeKind::Bar {
            length: table.need_value("length"),
            width: table.value("width"),
        },
        Kind::Rectangle => ShapeKind::Rectangle {
            width: table.need_value("width"),
            height: table.need_value("height"),
        },
        Kind::Circle => ShapeKind::Circle {
            radius: table.need_value("radius"),
        },
        Kind::Ring => ShapeKind::Ring {
            outer: table.need_value("outer"),
            inner: table.need_value("inner"),
        },
        Kind::Polygon => ShapeKind::Polygon {
            points: table.required("points", polygon).unwrap_or_default(),
        },
        Kind::Lump => ShapeKind::Lump {
            inertia: table.value("inertia"),
        },
    })
}

fn polygon(item: &Item<'_>) -> Option<Vec<dalembert::model::Point>> {
    let points = item.list(|item| Some(item.point().unwrap_or_default()))?;
    let found = item.entries("a list")?.len();
    if found < 3 {
        item.wrong_length("at least 3", found, "give the corners [[x, y], ...]");
    }
    Some(points)
}

fn color(item: &Item<'_>) -> Option<String> {
    let text = item.text()?;
    let digits = text.strip_prefix('#').unwrap_or_default();
    if digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit()) {
        return Some(text);
    }
    item.error(
        "bad-color",
        &format!("\"{text}\" is not a colour"),
        "write \"#rrggbb\", for example \"#3070b0\"",
    );
    None
}

/// The mass of a part is given once: as `mass`, or as `density` with `thickness`.
fn check_mass(table: &TableReader<'_>) {
    let help = "give `mass`, or `density` together with `thickness`, or none of them";
    if table.has("mass") && table.has("density") {
        table.combination("density", "`mass` and `density` exclude each other", help);
    } else if table.has("density") && !table.has("thickness") {
        table.combination("density", "`density` needs `thickness`", help);
    } else if table.has("thickness") && !table.has("density") {
        table.combination("thickness", "`thickness` needs `density`", help);
    }
}
