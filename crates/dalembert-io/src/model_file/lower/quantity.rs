//! Scalar quantities, which drivers, constraints and initial conditions speak of.

use super::unknown_kind;
use crate::model_file::item::Item;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{CoordinateName, Point, Quantity, SpaceKind};

/// Reads a coordinate of a body; that of the other space is refused by the engine.
fn coordinate(item: &Item<'_>) -> Option<CoordinateName> {
    let [x, y] = [("x", CoordinateName::X), ("y", CoordinateName::Y)];
    let (z, angle) = (("z", CoordinateName::Z), ("angle", CoordinateName::Angle));
    match item.context.space() {
        SpaceKind::Planar => item.choice_of(&[x, y, angle], &[z]),
        SpaceKind::Spatial => item.choice_of(&[x, y, z], &[angle]),
    }
}

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Coordinate,
    Angle,
    Displacement,
    JointCoordinate,
    RelativeAngle,
    Distance,
}

/// The kinds, for elements that have more kinds of their own.
pub(super) const KINDS: [(&str, Kind); 6] = [
    ("coordinate", Kind::Coordinate),
    ("angle", Kind::Angle),
    ("displacement", Kind::Displacement),
    ("joint-coordinate", Kind::JointCoordinate),
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
                .required("coordinate", coordinate)
                .unwrap_or(CoordinateName::X),
        },
        Kind::Angle => Quantity::Angle {
            joint: table.need_joint(),
        },
        Kind::Displacement => Quantity::Displacement {
            joint: table.need_joint(),
        },
        Kind::JointCoordinate => Quantity::JointCoordinate {
            joint: table.need_joint(),
            coordinate: table.required("coordinate", Item::text).unwrap_or_default(),
        },
        Kind::RelativeAngle => Quantity::RelativeAngle {
            bodies: table.need_bodies(),
            axis: angle_axis(table),
        },
        Kind::Distance => Quantity::Distance {
            bodies: table.need_bodies(),
            at: table.need_points("at"),
        },
    }
}

/// Reads the axis of an angle between two bodies, which is needed in space.
pub(super) fn angle_axis(table: &mut TableReader<'_>) -> Option<Point> {
    match table.context().space() {
        SpaceKind::Planar => table.of_space(SpaceKind::Spatial, "axis", Item::axis),
        SpaceKind::Spatial => table.required("axis", Item::axis),
    }
}

/// Reads a quantity in a table of its own.
pub(super) fn from_item(item: &Item<'_>) -> Option<Quantity> {
    super::table_of(item, lower)
}
