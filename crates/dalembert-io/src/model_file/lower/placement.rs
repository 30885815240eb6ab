//! Where joints and bushings sit.

use crate::model_file::item::Item;
use crate::model_file::table_reader::TableReader;
use dalembert::model::Placement;

/// What a kind of joint needs to know of its place.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Needs {
    /// One point: `at` or `point`.
    Point,
    /// One point, and an axis: `angles` or `direction`.
    PointAndAxis,
    /// Two different points: `at`.
    TwoPoints,
}

/// Reads the place of an element, which is of the given kind.
pub(super) fn lower(table: &mut TableReader<'_>, kind: &str, needs: Needs) -> Placement {
    let placement = Placement {
        bodies: table.need_bodies(),
        at: table.optional("at", Item::two_points),
        point: table.point("point"),
        angles: table.optional("angles", |item| item.pair(Item::value)),
        direction: table.point("direction"),
    };
    let one_point = "`at = [[x, y], [x, y]]` is the point in each body's frame, \
                     `point = [x, y]` the one point in ground axes at the initial estimate";
    match (table.has("at"), table.has("point")) {
        (true, true) => {
            table.combination("point", "`at` and `point` exclude each other", one_point);
        }
        (false, _) if needs == Needs::TwoPoints => table.combination(
            "point",
            &format!("the kind `{kind}` needs two points: `at`"),
            "`at = [[x, y], [x, y]]` is the point in each body's frame",
        ),
        (false, false) => table.combination(
            "at",
            &format!("the kind `{kind}` needs a point: `at` or `point`"),
            one_point,
        ),
        _ => {}
    }
    let axis = "`angles = [a, b]` is the angle of the joint's x axis in each body's frame, \
                `direction = [x, y]` the axis in ground axes at the initial estimate";
    match (table.has("angles"), table.has("direction")) {
        (true, true) => {
            table.combination(
                "direction",
                "`angles` and `direction` exclude each other",
                axis,
            );
        }
        (false, false) if needs == Needs::PointAndAxis => table.combination(
            "angles",
            &format!("the kind `{kind}` needs an axis: `angles` or `direction`"),
            axis,
        ),
        _ => {}
    }
    placement
}
