//! Angular velocities and moments.

use crate::model_file::item::Item;
use dalembert::model::AxialVector;
use toml::de::DeValue;

/// Reads one number, or three components.
pub(super) fn lower(item: &Item<'_>) -> Option<AxialVector> {
    match item.value {
        DeValue::Array(_) => item.numbers("write [x, y, z]").map(AxialVector::Spatial),
        _ => item.value().map(AxialVector::Planar),
    }
}
