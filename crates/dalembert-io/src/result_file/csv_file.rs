//! CSV result files (RFC 4180): a header `time [s],crank.angle [rad]`, then one row an instant; an empty field is a gap.

use super::document::Document;
use super::{Meta, ReadError, WriteError, atomic, number, sidecar};
use dalembert::results::{Channel, Results};
use std::io;
use std::path::Path;

pub(super) fn write(path: &Path, results: &Results) -> Result<(), WriteError> {
    atomic::write_file(path, |w| {
        let mut writer = csv::Writer::from_writer(w);
        let headings = results.channels.iter().map(|c| heading(&c.name, &c.unit));
        writer.write_record(headings).map_err(io::Error::from)?;
        let mut text = String::new();
        for instant in 0..results.len() {
            for channel in &results.channels {
                number::shortest(channel.values[instant], &mut text);
                writer.write_field(&text)?;
            }
            writer.write_record(None::<&[u8]>)?;
        }
        writer.flush()
    })
    .map_err(|source| WriteError::Io {
        path: path.to_owned(),
        source,
    })
}

pub(super) fn read(path: &Path) -> Result<(Results, Meta), ReadError> {
    let failed = |error: csv::Error| read_error(path, error);
    let mut reader = csv::Reader::from_path(path).map_err(failed)?;
    let header: Vec<String> = reader
        .headers()
        .map_err(failed)?
        .iter()
        .map(str::to_owned)
        .collect();
    let text = sidecar::text(path);
    let document = text.as_deref().and_then(sidecar::parse);
    let mut channels = channels_of(&header, document.as_ref());

    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).map_err(failed)? {
        for ((field, channel), column) in record.iter().zip(&mut channels).zip(&header) {
            if field.trim().is_empty() {
                channel.values.push(f64::NAN);
                channel.gaps = true;
                continue;
            }
            let value = field.trim().parse().map_err(|_| ReadError::NotANumber {
                path: path.to_owned(),
                line: record.position().map_or(0, csv::Position::line),
                column: column.clone(),
                text: field.to_owned(),
            })?;
            channel.values.push(value);
        }
    }
    let mut results = Results {
        channels,
        ..Results::default()
    };
    let mut meta = Meta {
        model_sha256: None,
        generator: None,
    };
    if let Some(document) = &document {
        sidecar::describe(document, &mut results, true);
        meta = document.meta();
    }
    Ok((results, meta))
}

/// Heading of a column: the name, and the unit in brackets where there is one.
fn heading(name: &str, unit: &str) -> String {
    // "x [1]" without a unit would read back as "x" in units of 1; empty brackets keep it whole.
    if unit.is_empty() && !(name.ends_with(']') && name.contains(" [")) {
        name.to_owned()
    } else {
        format!("{name} [{unit}]")
    }
}

/// Name and unit of a heading.
fn name_and_unit(heading: &str) -> (&str, &str) {
    heading
        .strip_suffix(']')
        .and_then(|rest| rest.rsplit_once(" ["))
        .unwrap_or((heading, ""))
}

/// Empty channels for a header; the sidecar's own names and units hold where they make this very header.
fn channels_of(header: &[String], document: Option<&Document>) -> Vec<Channel> {
    let stated = document.map(|d| &d.channels).filter(|entries| {
        entries.len() == header.len()
            && entries
                .iter()
                .zip(header)
                .all(|(e, h)| heading(&e.name, &e.unit) == *h)
    });
    let channel = |name: &str, unit: &str| Channel {
        name: name.to_owned(),
        unit: unit.to_owned(),
        ..Channel::default()
    };
    match stated {
        Some(entries) => entries.iter().map(|e| channel(&e.name, &e.unit)).collect(),
        None => header
            .iter()
            .map(|h| {
                let (name, unit) = name_and_unit(h.trim());
                channel(name.trim(), unit.trim())
            })
            .collect(),
    }
}

fn read_error(path: &Path, error: csv::Error) -> ReadError {
    let path = path.to_owned();
    if let csv::ErrorKind::UnequalLengths {
        pos,
        expected_len,
        len,
    } = error.kind()
    {
        return ReadError::UnequalRow {
            path,
            line: pos.as_ref().map_or(0, csv::Position::line),
            found: *len,
            expected: *expected_len,
        };
    }
    if !error.is_io_error() {
        return ReadError::Csv {
            path,
            source: error,
        };
    }
    ReadError::Io {
        path,
        source: error.into(),
    }
}
