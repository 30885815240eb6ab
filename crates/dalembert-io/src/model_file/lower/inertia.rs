//! Inertia of bodies and lumps.

use crate::model_file::item::Item;
use dalembert::model::Inertia;
use toml::de::DeValue;

/// Reads one moment, three moments or the rows of a tensor.
pub(super) fn lower(item: &Item<'_>) -> Option<Inertia> {
    let DeValue::Array(entries) = item.value else {
        return item.value().map(Inertia::Moment);
    };
    let first = entries.first().map(|entry| entry.get_ref());
    if let Some(DeValue::Array(_)) = first {
        let help = "write [[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]], the tensor itself";
        item.rows(help).map(Inertia::Tensor)
    } else {
        let help = "write [Ixx, Iyy, Izz], or the three rows of the tensor";
        item.numbers(help).map(Inertia::Moments)
    }
}
