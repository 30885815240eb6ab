//! Force elements.

use super::placement::{self, Needs};
use super::quantity::angle_axis;
use super::{axial_vector, unknown_kind};
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Axes, Force, ForceKind, Matrix, SpaceKind};
use toml::de::DeValue;

#[derive(Clone, Copy)]
enum Kind {
    Force,
    Moment,
    Actuator,
    SpringDamper,
    TorsionSpring,
    JointSpring,
    Bushing,
    PointGravity,
}

const KINDS: [(&str, Kind); 8] = [
    ("force", Kind::Force),
    ("moment", Kind::Moment),
    ("actuator", Kind::Actuator),
    ("spring-damper", Kind::SpringDamper),
    ("torsion-spring", Kind::TorsionSpring),
    ("joint-spring", Kind::JointSpring),
    ("bushing", Kind::Bushing),
    ("point-gravity", Kind::PointGravity),
];

pub(super) const AXES: [(&str, Axes); 2] = [("ground", Axes::Ground), ("body", Axes::Body)];

/// Reads a `[[force]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Force {
    let name = table.name(Section::Force);
    if let Some(kind) = kind(&mut table) {
        table.finish();
        return Force { name, kind };
    }
    unknown_kind::read(&mut table);
    Force {
        name,
        // The engine refuses it, so that it counts as spoilt.
        kind: ForceKind::PointGravity {
            body: String::new(),
            mu: Default::default(),
            center: None,
        },
    }
}

fn kind(table: &mut TableReader<'_>) -> Option<ForceKind> {
    Some(match table.kind(&KINDS)? {
        Kind::Force => ForceKind::Force {
            body: table.need_body("body"),
            at: table.point("at"),
            value: table.required("value", Item::point).unwrap_or_default(),
            axes: table
                .optional("axes", |item| item.choice(&AXES))
                .unwrap_or_default(),
        },
        Kind::Moment => ForceKind::Moment {
            body: table.need_body("body"),
            value: table
                .required("value", axial_vector::lower)
                .unwrap_or_default(),
            axes: table.of_space(SpaceKind::Spatial, "axes", |item| item.choice(&AXES)),
        },
        Kind::Actuator => ForceKind::Actuator {
            joint: table.need_joint(),
            value: table.need_value("value"),
            coordinate: table.optional("coordinate", Item::text),
        },
        Kind::SpringDamper => ForceKind::SpringDamper {
            bodies: table.need_bodies(),
            at: table.need_points("at"),
            stiffness: table.value("stiffness"),
            damping: table.value("damping"),
            free_length: table.value("free_length"),
            force: table.value("force"),
        },
        Kind::TorsionSpring => ForceKind::TorsionSpring {
            bodies: table.need_bodies(),
            axis: angle_axis(table),
            stiffness: table.value("stiffness"),
            damping: table.value("damping"),
            free_angle: table.value("free_angle"),
            moment: table.value("moment"),
        },
        Kind::JointSpring => ForceKind::JointSpring {
            joint: table.need_joint(),
            stiffness: table.value("stiffness"),
            damping: table.value("damping"),
            free: table.value("free"),
            coordinate: table.optional("coordinate", Item::text),
        },
        Kind::Bushing => ForceKind::Bushing {
            placement: placement::lower(table, "bushing", Needs::Point),
            stiffness: table
                .required("stiffness", matrix)
                .unwrap_or(Matrix::Diagonal(Vec::new())),
            damping: table.optional("damping", matrix),
        },
        Kind::PointGravity => ForceKind::PointGravity {
            body: table.need_body("body"),
            mu: table.need_value("mu"),
            center: table.point("center"),
        },
    })
}

/// Reads a matrix on a relative pose: its diagonal, or its rows.
fn matrix(item: &Item<'_>) -> Option<Matrix> {
    // The components of a pose: 3 in the plane, 6 in space.
    let size = 3 * (item.context.dimension.get() - 1);
    let expected = format!("a list of {size} numbers or of {size} rows");
    let entries = item.entries(&expected)?;
    if entries.len() != size {
        item.wrong_length(
            &size.to_string(),
            entries.len(),
            "give the diagonal, or all rows",
        );
    }
    if !entries.iter().any(|e| matches!(e.value, DeValue::Array(_))) {
        return item.values().map(Matrix::Diagonal);
    }
    let row = |item: &Item<'_>| {
        let found = item.entries(&format!("a row of {size} numbers"))?.len();
        if found != size {
            item.wrong_length(&size.to_string(), found, "complete the row");
        }
        item.values()
    };
    let rows = entries.iter().map(|e| row(e).unwrap_or_default());
    Some(Matrix::Rows(rows.collect()))
}
