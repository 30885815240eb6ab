//! Points whose motion is wanted.

use super::orientation;
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{
    SpaceKind::{Planar, Spatial},
    Trace,
};

/// Reads a `[[trace]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Trace {
    let trace = Trace {
        name: table.name(Section::Trace),
        body: table.need_body("body"),
        at: table.point("at"),
        angle: table.of_space(Planar, "angle", Item::value),
        orientation: table.of_space(Spatial, "orientation", orientation::lower),
        relative_to: table.optional("relative_to", Item::body),
    };
    table.finish();
    trace
}
