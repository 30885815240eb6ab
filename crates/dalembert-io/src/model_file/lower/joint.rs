//! Joints.

use super::placement::{self, Needs};
use super::{surface, unknown_kind};
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{
    CamFollower, CamProfile, Joint, JointKind, Point, Side, SpaceCurve, SpaceKind, Value,
};

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
    Spherical,
    Cylindrical,
    Universal,
    ConstantVelocity,
    Screw,
    Planar,
    PointOnLine,
    PointOnPlane,
    PointOnCurve,
    ParallelAxes,
    PerpendicularAxes,
    RollingDisc,
    RollingBall,
    KnifeEdge,
    SurfaceContact,
    PointOnSurface,
    GearPair,
    RackPair,
}

/// Kinds that both spaces have.
const COMMON: [(&str, Kind); 4] = [
    ("revolute", Kind::Revolute),
    ("prismatic", Kind::Prismatic),
    ("weld", Kind::Weld),
    ("distance", Kind::Distance),
];

const PLANAR: [(&str, Kind); 6] = [
    ("pin-slot", Kind::PinSlot),
    ("gear", Kind::Gear),
    ("rack", Kind::Rack),
    ("cam", Kind::Cam),
    ("rolling-on-line", Kind::RollingOnLine),
    ("rolling-on-circle", Kind::RollingOnCircle),
];

const SPATIAL: [(&str, Kind); 18] = [
    ("spherical", Kind::Spherical),
    ("cylindrical", Kind::Cylindrical),
    ("universal", Kind::Universal),
    ("constant-velocity", Kind::ConstantVelocity),
    ("screw", Kind::Screw),
    ("planar", Kind::Planar),
    ("point-on-line", Kind::PointOnLine),
    ("point-on-plane", Kind::PointOnPlane),
    ("point-on-curve", Kind::PointOnCurve),
    ("parallel-axes", Kind::ParallelAxes),
    ("perpendicular-axes", Kind::PerpendicularAxes),
    ("rolling-disc", Kind::RollingDisc),
    ("rolling-ball", Kind::RollingBall),
    ("knife-edge", Kind::KnifeEdge),
    ("surface-contact", Kind::SurfaceContact),
    ("point-on-surface", Kind::PointOnSurface),
    ("gear-pair", Kind::GearPair),
    ("rack-pair", Kind::RackPair),
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
    let (own, foreign) = match table.context().space() {
        SpaceKind::Planar => ([&COMMON[..], &PLANAR].concat(), &SPATIAL[..]),
        SpaceKind::Spatial => ([&COMMON[..], &SPATIAL].concat(), &PLANAR[..]),
    };
    Some(match table.kind_of(&own, foreign)? {
        Kind::Revolute => JointKind::Revolute {
            placement: placement::lower(table, "revolute", Needs::PointAndSpatialAxis),
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
        Kind::Spherical => JointKind::Spherical {
            placement: placement::lower(table, "spherical", Needs::Point),
        },
        Kind::Cylindrical => JointKind::Cylindrical {
            placement: placement::lower(table, "cylindrical", Needs::PointAndAxis),
        },
        Kind::Universal => JointKind::Universal {
            placement: placement::lower(table, "universal", Needs::PointAndAxis),
            second_axis: second_axis(table, "universal"),
        },
        Kind::ConstantVelocity => JointKind::ConstantVelocity {
            placement: placement::lower(table, "constant-velocity", Needs::PointAndAxis),
        },
        Kind::Screw => JointKind::Screw {
            placement: placement::lower(table, "screw", Needs::PointAndAxis),
            pitch: table.need_value("pitch"),
        },
        Kind::Planar => JointKind::Planar {
            placement: placement::lower(table, "planar", Needs::PointAndAxis),
        },
        Kind::PointOnLine => JointKind::PointOnLine {
            placement: placement::lower(table, "point-on-line", Needs::PointAndAxis),
        },
        Kind::PointOnPlane => JointKind::PointOnPlane {
            placement: placement::lower(table, "point-on-plane", Needs::PointAndAxis),
        },
        Kind::PointOnCurve => JointKind::PointOnCurve {
            placement: placement::lower(table, "point-on-curve", Needs::Point),
            curve: table.required("curve", curve).unwrap_or_default(),
            u: table.value("u"),
        },
        Kind::ParallelAxes => JointKind::ParallelAxes {
            placement: placement::lower(table, "parallel-axes", Needs::Axis),
        },
        Kind::PerpendicularAxes => JointKind::PerpendicularAxes {
            placement: placement::lower(table, "perpendicular-axes", Needs::Axis),
            second_axis: second_axis(table, "perpendicular-axes"),
        },
        Kind::RollingDisc => JointKind::RollingDisc {
            placement: placement::lower(table, "rolling-disc", Needs::TwoPointsAndAxis),
            second_axis: second_axis(table, "rolling-disc"),
            radius: table.need_value("radius"),
            rounding: table.value("rounding"),
        },
        Kind::RollingBall => JointKind::RollingBall {
            placement: placement::lower(table, "rolling-ball", Needs::TwoPointsAndAxis),
            radius: table.need_value("radius"),
        },
        Kind::KnifeEdge => JointKind::KnifeEdge {
            placement: placement::lower(table, "knife-edge", Needs::PointAndAxis),
        },
        Kind::SurfaceContact => JointKind::SurfaceContact {
            placement: placement::lower(table, "surface-contact", Needs::Bodies),
            surfaces: table
                .required("surfaces", |item| item.pair(surface::lower))
                .unwrap_or_default(),
            parameters: table.optional("parameters", |item| {
                item.pair(|item| item.pair(Item::value))
            }),
        },
        Kind::PointOnSurface => JointKind::PointOnSurface {
            placement: placement::lower(table, "point-on-surface", Needs::Point),
            surface: table
                .required("surface", surface::lower)
                .unwrap_or_default(),
            parameters: table.optional("parameters", |item| item.pair(Item::value)),
        },
        Kind::GearPair => JointKind::GearPair {
            joints: joints(table),
            ratio: table.need_value("ratio"),
        },
        Kind::RackPair => JointKind::RackPair {
            joints: joints(table),
            radius: table.need_value("radius"),
        },
    })
}

fn joints(table: &mut TableReader<'_>) -> [String; 2] {
    table
        .required("joints", |item| item.pair(Item::joint))
        .unwrap_or_default()
}

/// Reads the axis of the second body, which goes with `axis`.
fn second_axis(table: &mut TableReader<'_>, kind: &str) -> Option<Point> {
    let axis = table.optional("second_axis", Item::axis);
    let help = "`axis` and `second_axis` are the axes of the two bodies in ground axes at the \
                initial estimate, `axes = [[x, y, z], [x, y, z]]` those in each body's frame";
    match (table.has("axis"), table.has("second_axis")) {
        (true, false) => table.combination(
            "axis",
            &format!("the kind `{kind}` has two axes: `second_axis` is missing"),
            help,
        ),
        (false, true) if table.has("axes") => table.combination(
            "second_axis",
            "`second_axis` goes with `axis`, not with `axes`",
            help,
        ),
        _ => {}
    }
    axis
}

/// Reads a curve in space.
fn curve(item: &Item<'_>) -> Option<SpaceCurve> {
    super::table_of(item, |table| {
        let [x, y, z] = ["x", "y", "z"].map(|key| table.need_value(key));
        Some(SpaceCurve { x, y, z })
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
