//! Constraints that are not joints.

use super::{quantity, unknown_kind};
use crate::model_file::item::Item;
use crate::model_file::names::Section;
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Constraint, ConstraintKind, Quantity, Term};

#[derive(Clone, Copy)]
enum Kind {
    Fixed,
    Coupler,
    Expression,
    Velocity,
}

const KINDS: [(&str, Kind); 4] = [
    ("fixed", Kind::Fixed),
    ("coupler", Kind::Coupler),
    ("expression", Kind::Expression),
    ("velocity", Kind::Velocity),
];

/// Reads a `[[constraint]]`.
pub(super) fn lower(mut table: TableReader<'_>) -> Constraint {
    let name = table.name(Section::Constraint);
    let fixed = |quantity: Option<Quantity>, value| ConstraintKind::Fixed {
        quantity: quantity.unwrap_or_else(unknown_kind::quantity),
        value,
    };
    let kind = match table.kind(&KINDS) {
        Some(Kind::Fixed) => fixed(
            table.required("quantity", quantity::from_item),
            table.value("value"),
        ),
        Some(Kind::Coupler) => ConstraintKind::Coupler {
            terms: table.required("terms", terms).unwrap_or_default(),
            value: table.value("value"),
        },
        Some(Kind::Velocity) => ConstraintKind::Velocity {
            expression: table.need_value("expression"),
        },
        Some(Kind::Expression) => ConstraintKind::Expression {
            expression: table.need_value("expression"),
        },
        None => {
            unknown_kind::read(&mut table);
            let kind = fixed(None, None);
            return Constraint { name, kind };
        }
    };
    table.finish();
    Constraint { name, kind }
}

fn terms(item: &Item<'_>) -> Option<Vec<Term>> {
    if item.entries("a list of tables")?.is_empty() {
        item.wrong_length(
            "at least 1",
            0,
            "write [{ factor = 1, kind = \"angle\", ... }]",
        );
    }
    item.list(|item| {
        let term = super::table_of(item, |table| {
            Some(Term {
                factor: table.need_value("factor"),
                quantity: quantity::lower(table)?,
            })
        });
        Some(term.unwrap_or_else(|| Term {
            factor: Default::default(),
            quantity: unknown_kind::quantity(),
        }))
    })
}
