//! Where joints and bushings sit.

use crate::model_file::item::Item;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{
    Placement,
    SpaceKind::{Planar, Spatial},
};

/// What a kind of joint needs to know of its place.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Needs {
    /// One point: `at` or `point`.
    Point,
    /// One point, and an axis.
    PointAndAxis,
    /// One point, and in space an axis.
    PointAndSpatialAxis,
    /// Two different points: `at`.
    TwoPoints,
    /// Two different points: `at`, and an axis.
    TwoPointsAndAxis,
    /// An axis only.
    Axis,
    /// The bodies only.
    Bodies,
}

/// Reads the place of an element, which is of the given kind.
pub(super) fn lower(table: &mut TableReader<'_>, kind: &str, needs: Needs) -> Placement {
    let placement = Placement {
        bodies: table.need_bodies(),
        at: table.optional("at", Item::two_points),
        point: table.point("point"),
        angles: table.of_space(Planar, "angles", |item| item.pair(Item::value)),
        direction: table.of_space(Planar, "direction", Item::planar_direction),
        axis: table.of_space(Spatial, "axis", Item::axis),
        axes: table.of_space(Spatial, "axes", Item::two_axes),
        x_axis: table.of_space(Spatial, "x_axis", Item::axis),
        x_axes: table.of_space(Spatial, "x_axes", Item::two_axes),
    };
    check_points(table, kind, needs);
    check_axes(table, kind, needs);
    placement
}

fn check_points(table: &TableReader<'_>, kind: &str, needs: Needs) {
    let (one_point, two_points) = match table.context().space() {
        Planar => (
            "`at = [[x, y], [x, y]]` is the point in each body's frame, \
             `point = [x, y]` the one point in ground axes at the initial estimate",
            "`at = [[x, y], [x, y]]` is the point in each body's frame",
        ),
        Spatial => (
            "`at = [[x, y, z], [x, y, z]]` is the point in each body's frame, \
             `point = [x, y, z]` the one point in ground axes at the initial estimate",
            "`at = [[x, y, z], [x, y, z]]` is the point in each body's frame",
        ),
    };
    match (table.has("at"), table.has("point")) {
        (true, true) => {
            table.combination("point", "`at` and `point` exclude each other", one_point);
        }
        (false, _) if matches!(needs, Needs::TwoPoints | Needs::TwoPointsAndAxis) => table
            .combination(
                "point",
                &format!("the kind `{kind}` needs two points: `at`"),
                two_points,
            ),
        (false, false) if !matches!(needs, Needs::Axis | Needs::Bodies) => table.combination(
            "at",
            &format!("the kind `{kind}` needs a point: `at` or `point`"),
            one_point,
        ),
        _ => {}
    }
}

fn check_axes(table: &TableReader<'_>, kind: &str, needs: Needs) {
    let planar = "`angles = [a, b]` is the angle of the joint's x axis in each body's frame, \
                  `direction = [x, y]` the axis in ground axes at the initial estimate";
    let spatial = "`axis = [x, y, z]` is the joint's z axis in ground axes at the initial \
                   estimate, `axes = [[x, y, z], [x, y, z]]` the axis in each body's frame";
    let zero = "`x_axis = [x, y, z]` is the joint's x axis in ground axes at the initial \
                estimate, `x_axes = [[x, y, z], [x, y, z]]` the axis in each body's frame";
    let space = table.context().space();
    let needed = match needs {
        Needs::PointAndAxis | Needs::TwoPointsAndAxis | Needs::Axis => true,
        Needs::PointAndSpatialAxis => space == Spatial,
        Needs::Point | Needs::TwoPoints | Needs::Bodies => false,
    };
    // Those of the other space are refused by the engine, which says what to write instead.
    let (bodies, ground, help) = match space {
        Planar => ("angles", "direction", planar),
        Spatial => ("axes", "axis", spatial),
    };
    let foreign = ["angles", "direction", "axes", "axis"];
    let foreign = foreign.iter().any(|key| table.has(key));
    match (table.has(bodies), table.has(ground)) {
        (true, true) => {
            let text = format!("`{bodies}` and `{ground}` exclude each other");
            table.combination(ground, &text, help);
        }
        (false, false) if needed && !foreign => {
            let text = match space {
                Planar => "an axis: `angles` or `direction`",
                Spatial => "an axis: `axis` or `axes`",
            };
            table.combination(bodies, &format!("the kind `{kind}` needs {text}"), help);
        }
        _ => {}
    }
    if table.has("x_axis") && table.has("x_axes") {
        table.combination("x_axes", "`x_axis` and `x_axes` exclude each other", zero);
    }
}
