//! Constraints that are not joints.

use super::quantity;
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Constraint, ConstraintKind, Term};

#[derive(Clone, Copy)]
enum Kind {
    Fixed,
    Coupler,
    Expression,
}

const KINDS: [(&str, Kind); 3] = [
    ("fixed", Kind::Fixed),
    ("coupler", Kind::Coupler),
    ("expression", Kind::Expression),
];

/// Reads a `[[constraint]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Option<Constraint> {
    let name = table.name(Section::Constraint);
    let kind = match table.kind(&KINDS)? {
        Kind::Fixed => {
            let quantity = table.required("quantity", quantity::from_item);
            let value = table.value("value");
            // A quantity has no placeholder: without it the constraint is left out.
            quantity.map(|quantity| ConstraintKind::Fixed { quantity, value })
        }
        Kind::Coupler => Some(ConstraintKind::Coupler {
            terms: table.required("terms", terms).unwrap_or_default(),
            value: table.value("value"),
        }),
        Kind::Expression => Some(ConstraintKind::Expression {
            expression: table.need_value("expression"),
        }),
    };
    table.finish();
    Some(Constraint { name, kind: kind? })
}

fn terms(item: &Item<'_>) -> Option<Vec<Term>> {
    if item.entries("a list of tables")?.is_empty() {
        item.wrong_length("at least 1", 0);
    }
    item.list(|item| {
        super::table_of(item, |table| {
            Some(Term {
                factor: table.need_value("factor"),
                quantity: quantity::lower(table)?,
            })
        })
    })
}
