//! The JSON file beside a CSV or NPZ file that says what its columns are.

use super::document::{Document, SIDECAR_FORMAT};
use super::{Meta, WriteError, atomic};
use dalembert::results::Results;
use serde::Deserialize;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Where the sidecar of a data file stands: the same name with the extension `.json`.
pub fn sidecar_path(data: &Path) -> PathBuf {
    data.with_extension("json")
}

/// Writes the sidecar of the data file `data`; never overwrites a file that is not a sidecar.
pub(super) fn write(data: &Path, results: &Results, meta: &Meta) -> Result<(), WriteError> {
    let path = sidecar_path(data);
    if path.exists() && owner(&path).is_none() {
        return Err(WriteError::SidecarInTheWay { path });
    }
    let name = data
        .file_name()
        .map(|n| n.to_string_lossy().into_owned())
        .unwrap_or_default();
    let document = Document::sidecar(name, results, meta);
    atomic::write_file(&path, |w| {
        serde_json::to_writer_pretty(w, &document).map_err(io::Error::from)
    })
    .map_err(|source| WriteError::Io { path, source })
}

/// The sidecar of the data file `data`, as text; `None` where there is none.
pub(super) fn text(data: &Path) -> Option<String> {
    fs::read_to_string(sidecar_path(data)).ok()
}

/// Understands a sidecar's text; a file of another kind that has the same name counts as none.
pub(super) fn parse(text: &str) -> Option<Document<'_>> {
    serde_json::from_str::<Document>(text)
        .ok()
        .filter(|d| d.format == SIDECAR_FORMAT)
}

/// Gives results what the sidecar knows: model, analysis, statistics, notes, and by name meanings and units.
///
/// `has_units`: the data file states units itself; a channel whose unit differs is not described.
pub(super) fn describe(document: &Document, results: &mut Results, has_units: bool) {
    results.model = document.model.clone().into_owned();
    results.analysis = document.analysis.clone().into_owned();
    results.statistics = document.statistics.clone().into_owned();
    results.notes = document.notes.clone().into_owned();
    for channel in &mut results.channels {
        let known = document.channels.iter().find(|e| e.name == channel.name);
        if let Some(entry) = known.filter(|e| !has_units || e.unit == channel.unit) {
            channel.unit = entry.unit.clone().into_owned();
            channel.meaning = entry.meaning.clone().into_owned();
            channel.gaps |= entry.gaps;
        }
    }
}

/// Name of the data file that the sidecar at `path` belongs to; `None` where this is no sidecar.
pub(super) fn owner(path: &Path) -> Option<String> {
    #[derive(Deserialize)]
    struct Tag {
        format: String,
        #[serde(default)]
        data: String,
    }
    let text = fs::read_to_string(path).ok()?;
    let tag: Tag = serde_json::from_str(&text).ok()?;
    (tag.format == SIDECAR_FORMAT).then_some(tag.data)
}
