//! Elements of which nothing is known but that they are there.

use crate::model_file::context::Context;
use crate::model_file::item::{Item, Place};
use crate::model_file::table_reader::TableReader;
use dalembert::model::{Placement, Quantity, SpaceKind};
use toml::de::{DeTable, DeValue};

/// Reads the keys that mean the same in every kind of element, for the mistakes in them. Unknown
/// and missing keys are not reported, because the kind would say which they are.
pub(super) fn read(table: &mut TableReader<'_>) {
    table.optional("bodies", |item| item.pair(Item::body));
    for key in ["body", "carrier", "from", "relative_to"] {
        table.optional(key, Item::body);
    }
    table.optional("joint", Item::joint);
    table.optional("joints", |item| item.pair(Item::joint));
    for key in ["point", "center", "from_at"] {
        table.point(key);
    }
    table.of_space(SpaceKind::Planar, "direction", Item::planar_direction);
    for key in ["axis", "x_axis", "second_axis"] {
        table.of_space(SpaceKind::Spatial, key, Item::axis);
    }
    table.optional("at", |item| {
        let is_list = |value: &DeValue<'_>| matches!(value, DeValue::Array(_));
        let first = item.value.as_array().and_then(|list| list.first());
        if first.is_some_and(|first| is_list(first.get_ref())) {
            item.pair(Item::point).map(drop)
        } else {
            item.point().map(drop)
        }
    });
}

/// A placement that the engine refuses, so that the element counts as spoilt.
pub(super) fn placement() -> Placement {
    Placement::default()
}

/// A quantity that the engine refuses.
pub(super) fn quantity() -> Quantity {
    Quantity::RelativeAngle {
        bodies: Default::default(),
        axis: None,
    }
}

/// An element that is no table keeps its place in the list; what it lacks is not said.
pub(super) fn silently<T>(lower: &impl for<'b> Fn(TableReader<'b>) -> T) -> T {
    let context = Context::new(None);
    let table = DeTable::new();
    let place = Place {
        path: String::new(),
        label: "".into(),
        element: 0,
    };
    lower(TableReader::new(&context, &table, place))
}
