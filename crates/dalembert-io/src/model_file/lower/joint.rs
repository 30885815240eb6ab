//! Joints.

use super::placement::{self, Needs};
use super::unknown_kind;
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{CamFollower, CamProfile, Joint, JointKind, Side, Value};

#[derive(Clone, Copy)]
enum Kind {
    Revolute,
    Prismatic,
    Weld,
    Distance,
    PinSlot,
    Gear,
    Rack,
    Cam,
    RollingOnLine,
    RollingOnCircle,
}

const KINDS: [(&str, Kind); 10] = [
    ("revolute", Kind::Revolute),
    ("prismatic", Kind::Prismatic),
    ("weld", Kind::Weld),
    ("distance", Kind::Distance),
    ("pin-slot", Kind::PinSlot),
    ("gear", Kind::Gear),
    ("rack", Kind::Rack),
    ("cam", Kind::Cam),
    ("rolling-on-line", Kind::RollingOnLine),
    ("rolling-on-circle", Kind::RollingOnCircle),
];

const SIDES: [(&str, Side); 2] = [("left", Side::Left), ("right", Side::Right)];

/// Reads a `[[joint]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Joint {
    let name = table.name(Section::Joint);
    if let Some(kind) = kind(&mut table) {
        table.finish();
        return Joint { name, kind };
    }
    unknown_kind::read(&mut table);
    Joint {
        name,
        kind: JointKind::Revolute {
            placement: unknown_kind::placement(),
        },
    }
}

fn kind(table: &mut TableReader<'_>) -> Option<JointKind> {
    Some(match table.kind(&KINDS)? {
        Kind::Revolute => JointKind::Revolute {
            placement: placement::lower(table, "revolute", Needs::Point),
        },
        Kind::Prismatic => JointKind::Prismatic {
            placement: placement::lower(table, "prismatic", Needs::PointAndAxis),
        },
        Kind::Weld => JointKind::Weld {
            placement: placement::lower(table, "weld", Needs::Point),
        },
        Kind::Distance => JointKind::Distance {
            placement: placement::lower(table, "distance", Needs::TwoPoints),
            length: table.value("length"),
        },
        Kind::PinSlot => JointKind::PinSlot {
            placement: placement::lower(table, "pin-slot", Needs::PointAndAxis),
        },
        Kind::Gear => JointKind::Gear {
            bodies: table.need_bodies(),
            carrier: table.optional("carrier", Item::body),
            radii: radii(table),
            internal: table.flag("internal"),
        },
        Kind::Rack => JointKind::Rack {
            placement: placement::lower(table, "rack", Needs::PointAndAxis),
            radius: table.need_value("radius"),
            side: table.optional("side", |item| item.choice(&SIDES)),
        },
        Kind::Cam => JointKind::Cam {
            placement: placement::lower(table, "cam", Needs::Point),
            profile: table
                .required("profile", profile)
                .unwrap_or(CamProfile::Polar {
                    radius: Value::default(),
                }),
            follower: table
                .required("follower", follower)
                .unwrap_or(CamFollower::KnifeEdge),
            phi: table.value("phi"),
        },
        Kind::RollingOnLine => JointKind::RollingOnLine {
            placement: placement::lower(table, "rolling-on-line", Needs::PointAndAxis),
            radius: table.need_value("radius"),
            side: table.optional("side", |item| item.choice(&SIDES)),
        },
        Kind::RollingOnCircle => JointKind::RollingOnCircle {
            placement: placement::lower(table, "rolling-on-circle", Needs::TwoPoints),
            radii: radii(table),
            internal: table.flag("internal"),
        },
    })
}

fn radii(table: &mut TableReader<'_>) -> [Value; 2] {
    table
        .required("radii", |item| item.pair(Item::value))
        .unwrap_or_default()
}

/// Reads a cam profile: `radius`, or `x` and `y`.
fn profile(item: &Item<'_>) -> Option<CamProfile> {
    super::table_of(item, |table| {
        let cartesian = table.has("x") || table.has("y");
        let help = "give `radius` as an expression of `phi`, or both `x` and `y`";
        let radius = table.value("radius");
        let (x, y) = (table.value("x"), table.value("y"));
        if table.has("radius") && cartesian {
            table.combination("radius", "`radius` excludes `x` and `y`", help);
        } else if table.has("x") != table.has("y") {
            let there = if table.has("x") { "x" } else { "y" };
            table.combination(there, "`x` and `y` need each other", help);
        } else if !table.has("radius") && !cartesian {
            table.combination("radius", "a profile needs `radius`, or `x` and `y`", help);
        }
        Some(match (radius, x, y) {
            (None, Some(x), Some(y)) => CamProfile::Cartesian { x, y },
            (radius, _, _) => CamProfile::Polar {
                radius: radius.unwrap_or_default(),
            },
        })
    })
}

#[derive(Clone, Copy)]
enum Follower {
    KnifeEdge,
    Roller,
    Flat,
}

const FOLLOWERS: [(&str, Follower); 3] = [
    ("knife-edge", Follower::KnifeEdge),
    ("roller", Follower::Roller),
    ("flat", Follower::Flat),
];

fn follower(item: &Item<'_>) -> Option<CamFollower> {
    super::table_of(item, |table| {
        Some(match table.kind(&FOLLOWERS)? {
            Follower::KnifeEdge => CamFollower::KnifeEdge,
            Follower::Roller => CamFollower::Roller {
                radius: table.need_value("radius"),
            },
            Follower::Flat => CamFollower::Flat,
        })
    })
}
