//! Initial conditions.

use super::{quantity, unknown_kind};
use crate::model_file::table_reader::TableReader;
use dalembert::model::Initial;

/// Reads an `[[initial]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Initial {
    let quantity = quantity::lower(&mut table);
    let known = quantity.is_some();
    let initial = Initial {
        quantity: quantity.unwrap_or_else(unknown_kind::quantity),
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
    if known {
        table.finish();
    }
    initial
}
