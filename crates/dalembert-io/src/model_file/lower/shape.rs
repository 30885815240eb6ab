//! Shapes of bodies.

use super::{inertia, orientation};
use crate::mesh_file::{TriangleMesh, read_mesh};
use crate::model_file::item::Item;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Shape, ShapeKind, SpaceKind, Value};

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Bar,
    Rectangle,
    Circle,
    Ring,
    Polygon,
    Lump,
    Box,
    Cylinder,
    Tube,
    Sphere,
    Shell,
    Hemisphere,
    Cone,
    Rod,
    Disk,
    Plate,
    Ellipsoid,
    Mesh,
    Torus,
}

const PLANAR: [(&str, Kind); 5] = [
    ("bar", Kind::Bar),
    ("rectangle", Kind::Rectangle),
    ("circle", Kind::Circle),
    ("ring", Kind::Ring),
    ("polygon", Kind::Polygon),
];

const SPATIAL: [(&str, Kind); 13] = [
    ("box", Kind::Box),
    ("cylinder", Kind::Cylinder),
    ("tube", Kind::Tube),
    ("sphere", Kind::Sphere),
    ("shell", Kind::Shell),
    ("hemisphere", Kind::Hemisphere),
    ("cone", Kind::Cone),
    ("rod", Kind::Rod),
    ("disk", Kind::Disk),
    ("plate", Kind::Plate),
    ("ellipsoid", Kind::Ellipsoid),
    ("mesh", Kind::Mesh),
    ("torus", Kind::Torus),
];

/// Kinds that both spaces have.
const COMMON: [(&str, Kind); 1] = [("lump", Kind::Lump)];

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
    // Other solids have no thickness.
    let solid = kind.as_ref().is_some_and(|kind| !is_thin(kind));
    let thick = if solid {
        SpaceKind::Planar
    } else {
        table.context().space()
    };
    let shape = Shape {
        kind: kind.unwrap_or(ShapeKind::Lump { inertia: None }),
        at: table.point("at"),
        angle: table.of_space(SpaceKind::Planar, "angle", Item::value),
        orientation: table.of_space(SpaceKind::Spatial, "orientation", orientation::lower),
        mass: table.value("mass"),
        density: table.value("density"),
        thickness: table.of_space(thick, "thickness", Item::value),
        cut: table.flag("cut"),
        color: table.optional("color", color),
    };
    check_mass(&table, &shape);
    if known {
        table.finish();
    }
    shape
}

fn kind(table: &mut TableReader<'_>) -> Option<ShapeKind> {
    let (own, foreign) = match table.context().space() {
        SpaceKind::Planar => ([&PLANAR[..], &COMMON].concat(), &SPATIAL[..]),
        SpaceKind::Spatial => ([&SPATIAL[..], &COMMON].concat(), &PLANAR[..]),
    };
    Some(match table.kind_of(&own, foreign)? {
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
            inertia: table.optional("inertia", inertia::lower),
        },
        Kind::Box => ShapeKind::Box {
            size: numbers(table, "size", "write the sizes along x, y and z"),
        },
        Kind::Cylinder => ShapeKind::Cylinder {
            radius: table.need_value("radius"),
            length: table.need_value("length"),
        },
        Kind::Tube => ShapeKind::Tube {
            outer: table.need_value("outer"),
            inner: table.need_value("inner"),
            length: table.need_value("length"),
        },
        Kind::Sphere => ShapeKind::Sphere {
            radius: table.need_value("radius"),
        },
        Kind::Shell => ShapeKind::Shell {
            radius: table.need_value("radius"),
        },
        Kind::Hemisphere => ShapeKind::Hemisphere {
            radius: table.need_value("radius"),
        },
        Kind::Cone => ShapeKind::Cone {
            radius: table.need_value("radius"),
            height: table.need_value("height"),
        },
        Kind::Rod => ShapeKind::Rod {
            length: table.need_value("length"),
            radius: table.value("radius"),
        },
        Kind::Disk => ShapeKind::Disk {
            radius: table.need_value("radius"),
        },
        Kind::Plate => ShapeKind::Plate {
            width: table.need_value("width"),
            height: table.need_value("height"),
        },
        Kind::Ellipsoid => ShapeKind::Ellipsoid {
            semi_axes: numbers(table, "semi_axes", "write the half axes along x, y and z"),
        },
        Kind::Mesh => mesh(table),
        Kind::Torus => ShapeKind::Torus {
            radius: table.need_value("radius"),
            tube: table.need_value("tube"),
        },
    })
}

fn numbers(table: &mut TableReader<'_>, key: &'static str, help: &str) -> [Value; 3] {
    table
        .required(key, |item| item.numbers(help))
        .unwrap_or_default()
}

/// Reads the mesh that a file beside the model has.
fn mesh(table: &mut TableReader<'_>) -> ShapeKind {
    let mut mesh = TriangleMesh::default();
    let file = table.required("file", |item| {
        let file = item.text()?;
        match item.context.folder {
            None => item.error(
                "mesh",
                &format!("the model was not read from a folder, so \"{file}\" cannot be found"),
                "read the model from a file in a folder",
            ),
            Some(folder) => match read_mesh(folder, &file) {
                Ok(found) => mesh = found,
                Err(error) => item.error("mesh", &error.to_string(), error.help()),
            },
        }
        Some(file)
    });
    ShapeKind::Mesh {
        file: file.unwrap_or_default(),
        scale: table.value("scale"),
        vertices: mesh.vertices,
        triangles: mesh.triangles,
    }
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

/// Has the shape no thickness of its own, so that a density needs one?
fn is_thin(kind: &ShapeKind) -> bool {
    matches!(
        kind,
        ShapeKind::Shell { .. } | ShapeKind::Disk { .. } | ShapeKind::Plate { .. }
    )
}

/// The mass of a part is given once: as `mass`, or as `density` with what it needs beside the sizes.
fn check_mass(table: &TableReader<'_>, shape: &Shape) {
    let planar = table.context().space() == SpaceKind::Planar;
    let thick = "give `mass`, or `density` together with `thickness`, or none of them";
    if let ShapeKind::Torus { .. } = shape.kind {
        let help = "give the mass to another shape: this one is for the picture only";
        for key in ["mass", "density", "cut"] {
            if table.has(key) {
                table.combination(key, &format!("a `torus` has no `{key}`"), help);
            }
        }
        return;
    }
    let needs_thickness = planar || is_thin(&shape.kind);
    let help = if needs_thickness {
        thick
    } else {
        "give `mass`, or `density`, or none of them"
    };
    if table.has("mass") && table.has("density") {
        table.combination("density", "`mass` and `density` exclude each other", help);
        return;
    }
    if needs_thickness && table.has("density") && !table.has("thickness") {
        table.combination("density", "`density` needs `thickness`", help);
    }
    // The thickness of disks and plates is drawn.
    let drawn = matches!(shape.kind, ShapeKind::Disk { .. } | ShapeKind::Plate { .. });
    if needs_thickness && !drawn && table.has("thickness") && !table.has("density") {
        table.combination("thickness", "`thickness` needs `density`", help);
    }
    if let ShapeKind::Rod { radius: None, .. } = shape.kind
        && table.has("density")
    {
        let help = "give `mass`, or `density` together with `radius`, or none of them";
        table.combination("density", "`density` needs `radius`", help);
    }
    if let ShapeKind::Lump { .. } = shape.kind
        && !planar
        && table.has("density")
    {
        let help = "give `mass`: a lump has no volume";
        table.combination("density", "a `lump` has no `density`", help);
    }
}
