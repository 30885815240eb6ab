//! JSON result files.

use super::document::{Document, RESULTS_FORMAT, SIDECAR_FORMAT};
use super::{Meta, ReadError, WriteError, atomic, sidecar};
use dalembert::results::{Channel, Results};
use serde::Deserialize;
use std::fs;
use std::io;
use std::path::Path;

/// The tag alone, to tell a foreign file from a damaged one.
#[derive(Deserialize)]
struct Tag {
    #[serde(default)]
    format: String,
    #[serde(default)]
    data: String,
}

pub(super) fn write(path: &Path, results: &Results, meta: &Meta) -> Result<(), WriteError> {
    if let Some(data) = sidecar::owner(path).filter(|data| path.with_file_name(data).exists()) {
        return Err(WriteError::SidecarOfAnother {
            path: path.to_owned(),
            data,
        });
    }
    let document = Document::of_results(results, meta);
    atomic::write_file(path, |w| {
        serde_json::to_writer(w, &document).map_err(io::Error::from)
    })
    .map_err(|source| WriteError::Io {
        path: path.to_owned(),
        source,
    })
}

pub(super) fn read(path: &Path) -> Result<(Results, Meta), ReadError> {
    let text = fs::read_to_string(path).map_err(|source| ReadError::Io {
        path: path.to_owned(),
        source,
    })?;
    let json = |source| ReadError::Json {
        path: path.to_owned(),
        source,
    };
    let tag: Tag = serde_json::from_str(&text).map_err(json)?;
    if tag.format == SIDECAR_FORMAT {
        return Err(ReadError::OnlyASidecar {
            path: path.to_owned(),
            data: tag.data,
        });
    }
    if tag.format != RESULTS_FORMAT {
        return Err(ReadError::OtherFormat {
            path: path.to_owned(),
            found: tag.format,
            expected: RESULTS_FORMAT,
        });
    }
    let document: Document = serde_json::from_str(&text).map_err(json)?;
    let meta = document.meta();
    let mut channels = Vec::with_capacity(document.channels.len());
    for entry in document.channels {
        let Some(values) = entry.values else {
            return Err(ReadError::NoValues {
                path: path.to_owned(),
                name: entry.name.into_owned(),
            });
        };
        channels.push(Channel {
            name: entry.name.into_owned(),
            unit: entry.unit.into_owned(),
            meaning: entry.meaning.into_owned(),
            values: values.into_owned(),
            gaps: entry.gaps,
        });
    }
    let results = Results {
        model: document.model.into_owned(),
        analysis: document.analysis.into_owned(),
        channels,
        statistics: document.statistics.into_owned(),
        notes: document.notes.into_owned(),
    };
    Ok((results, meta))
}
