//! Scalar quantities, which drivers, constraints and initial conditions speak of.

use super::unknown_kind;
use crate::model_file::item::Item;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{CoordinateName, Quantity};

/// Coordinates of a body.
pub(super) const COORDINATES: [(&str, CoordinateName); 3] = [
    ("x", CoordinateName::X),
    ("y", CoordinateName::Y),
    ("angle", CoordinateName::Angle),
];

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Coordinate,
    Angle,
    Displacement,
    RelativeAngle,
    Distance,
}

/// The kinds, for elements that have more kinds of their own.
pub(super) const KINDS: [(&str, Kind); 5] = [
    ("coordinate", Kind::Coordinate),
    ("angle", Kind::Angle),
    ("displacement", Kind::Displacement),
    ("relative-angle", Kind::RelativeAngle),
    ("distance", Kind::Distance),
];

/// Reads a quantity whose keys stand among those of the element. `None` if its kind is not known;
/// then nobody knows which keys the table should have.
pub(super) fn lower(table: &mut TableReader<'_>) -> Option<Quantity> {
    let Some(kind) = table.kind(&KINDS) else {
        unknown_kind::read(table);
        return None;
    };
    Some(of_kind(table, kind))
}

/// Reads a quantity of a known kind.
pub(super) fn of_kind(table: &mut TableReader<'_>, kind: Kind) -> Quantity {
    match kind {
        Kind::Coordinate => Quantity::Coordinate {
            body: table.need_body("body"),
            at: table.point("at"),
            coordinate: table
                .required("coordinate", |item| item.choice(&COORDINATES))
                .unwrap_or(CoordinateName::X),
        },
        Kind::Angle => Quantity::Angle {
            joint: table.need_joint(),
        },
        Kind::Displacement => Quantity::Displacement {
            joint: table.need_joint(),
        },
        Kind::RelativeAngle => Quantity::RelativeAngle {
            bodies: table.need_bodies(),
        },
        Kind::Distance => Quantity::Distance {
            bodies: table.need_bodies(),
            at: table.need_points("at"),
        },
    }
}

/// Reads a quantity in a table of its own.
pub(super) fn from_item(item: &Item<'_>) -> Option<Quantity> {
    super::table_of(item, lower)
}
