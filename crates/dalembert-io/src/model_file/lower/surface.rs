//! Surfaces.

use crate::model_file::item::Item;
use dalembert::model::{Surface, SurfaceForm};

#[derive(Clone, Copy)]
enum Kind {
    Plane,
    Sphere,
    Cylinder,
    Cone,
    Ellipsoid,
    Torus,
    Revolved,
    Expression,
}

const KINDS: [(&str, Kind); 8] = [
    ("plane", Kind::Plane),
    ("sphere", Kind::Sphere),
    ("cylinder", Kind::Cylinder),
    ("cone", Kind::Cone),
    ("ellipsoid", Kind::Ellipsoid),
    ("torus", Kind::Torus),
    ("revolved", Kind::Revolved),
    ("expression", Kind::Expression),
];

/// Reads a surface.
pub(super) fn lower(item: &Item<'_>) -> Option<Surface> {
    super::table_of(item, |table| {
        let form = match table.kind(&KINDS)? {
            Kind::Plane => SurfaceForm::Plane,
            Kind::Sphere => SurfaceForm::Sphere {
                radius: table.need_value("radius"),
            },
            Kind::Cylinder => SurfaceForm::Cylinder {
                radius: table.need_value("radius"),
            },
            Kind::Cone => SurfaceForm::Cone {
                radius: table.need_value("radius"),
                height: table.need_value("height"),
            },
            Kind::Ellipsoid => SurfaceForm::Ellipsoid {
                semi_axes: table
                    .required("semi_axes", |item| {
                        item.numbers("write the half axes along x, y and z")
                    })
                    .unwrap_or_default(),
            },
            Kind::Torus => SurfaceForm::Torus {
                radius: table.need_value("radius"),
                tube: table.need_value("tube"),
            },
            Kind::Revolved => SurfaceForm::Revolved {
                r: table.need_value("r"),
                z: table.need_value("z"),
            },
            Kind::Expression => SurfaceForm::Expression {
                x: table.need_value("x"),
                y: table.need_value("y"),
                z: table.need_value("z"),
            },
        };
        let inside = table.flag("inside");
        Some(Surface { form, inside })
    })
}
