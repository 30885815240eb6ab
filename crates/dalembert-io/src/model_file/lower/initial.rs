//! Initial conditions.

use super::quantity;
use crate::model_file::table_reader::TableReader;
use dalembert::model::Initial;

/// Reads an `[[initial]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Option<Initial> {
    let initial = Initial {
        quantity: quantity::lower(&mut table)?,
        value: table.value("value"),
        rate: table.value("rate"),
    };
    if !table.has("value") && !table.has("rate") {
        table.combination(
            "value",
            "`value` or `rate` or both are needed",
            "`value` is what the quantity has at the start, `rate` how fast it changes there",
        );
    }
    table.finish();
    Some(initial)
}
