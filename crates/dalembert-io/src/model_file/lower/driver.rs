//! Drivers.

use super::{quantity, unknown_kind};
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Driver, DriverKind, Motion, PathTag, SpaceKind};

#[derive(Clone, Copy)]
enum Kind {
    Scalar(quantity::Kind),
    Path,
}

/// Reads a `[[driver]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Driver {
    let mut kinds: Vec<(&'static str, Kind)> = quantity::KINDS
        .map(|(word, kind)| (word, Kind::Scalar(kind)))
        .to_vec();
    kinds.push(("path", Kind::Path));
    let name = table.name(Section::Driver);
    let kind = match table.kind(&kinds) {
        Some(Kind::Scalar(kind)) => DriverKind::Scalar {
            quantity: quantity::of_kind(&mut table, kind),
            motion: motion(&mut table),
        },
        Some(Kind::Path) => path(&mut table),
        None => {
            unknown_kind::read(&mut table);
            let kind = DriverKind::Scalar {
                quantity: unknown_kind::quantity(),
                motion: Motion::Value {
                    value: Default::default(),
                },
            };
            return Driver { name, kind };
        }
    };
    table.finish();
    Driver { name, kind }
}

fn motion(table: &mut TableReader<'_>) -> Motion {
    let (value, rate, start) = (
        table.value("value"),
        table.value("rate"),
        table.value("start"),
    );
    let help = "`value` is the motion as an expression of `t`; `rate` its first derivative, \
                integrated from `start`";
    match (table.has("value"), table.has("rate")) {
        (true, true) => {
            table.combination("rate", "`value` and `rate` exclude each other", help);
        }
        (false, false) => {
            table.combination("value", "a motion is missing: `value` or `rate`", help)
        }
        (true, false) if table.has("start") => {
            table.combination("start", "`start` goes with `rate`, not with `value`", help);
        }
        _ => {}
    }
    if table.has("rate") && !table.has("value") {
        Motion::Rate {
            rate: rate.unwrap_or_default(),
            start,
        }
    } else {
        Motion::Value {
            value: value.unwrap_or_default(),
        }
    }
}

fn path(table: &mut TableReader<'_>) -> DriverKind {
    let kind = DriverKind::Path {
        kind: PathTag::Path,
        body: table.need_body("body"),
        at: table.point("at"),
        from: table.optional("from", Item::body),
        from_at: table.point("from_at"),
        x: table.value("x"),
        y: table.value("y"),
        z: table.of_space(SpaceKind::Spatial, "z", Item::value),
    };
    if !["x", "y", "z"].iter().any(|key| table.has(key)) {
        let (text, help) = match table.context().space() {
            SpaceKind::Planar => (
                "a path needs `x` or `y` or both",
                "`x` and `y` are expressions of `t`; a coordinate that is left out is free",
            ),
            SpaceKind::Spatial => (
                "a path needs `x`, `y` or `z`",
                "`x`, `y` and `z` are expressions of `t`; a coordinate that is left out is free",
            ),
        };
        table.combination("x", text, help);
    }
    kind
}
