//! Result files: time histories written to and read from CSV, NPZ and JSON.
//!
//! The extension of the path picks the format. CSV and NPZ hold the numbers only; a JSON file of
//! the same name beside them (the sidecar) holds the model's name, units, meanings, statistics
//! and notes. A JSON result file holds everything. Numbers survive a round trip bit for bit.

mod atomic;
mod channel_selection;
mod csv_file;
mod defect;
mod document;
mod error;
mod format;
mod json_file;
mod meta;
mod npy;
mod npz_file;
mod number;
mod sidecar;

#[cfg(test)]
mod tests;

pub use channel_selection::{UnknownChannel, select, some_of};
pub use defect::Defect;
pub use error::{ReadError, WriteError};
pub use format::Format;
pub use meta::Meta;
pub use npy::NpyError;
pub use sidecar::sidecar_path;

use dalembert::results::Results;
use std::path::Path;

/// Writes results to a file; the extension (`.csv`, `.npz`, `.json`) picks the format.
///
/// CSV and NPZ get a JSON sidecar of the same name. Each file appears whole or not at all.
pub fn write(path: &Path, results: &Results, meta: &Meta) -> Result<(), WriteError> {
    let format = Format::of_path(path).map_err(|extension| WriteError::UnknownFormat {
        path: path.to_owned(),
        extension,
    })?;
    defect::check(results).map_err(|defect| WriteError::Defective {
        path: path.to_owned(),
        defect,
    })?;
    match format {
        Format::Csv => {
            sidecar::write(path, results, meta)?;
            csv_file::write(path, results)
        }
        Format::Npz => {
            sidecar::write(path, results, meta)?;
            npz_file::write(path, results)
        }
        Format::Json => json_file::write(path, results, meta),
    }
}

/// Reads results from a file; the extension (`.csv`, `.npz`, `.json`) picks the format.
///
/// A CSV or NPZ file without its sidecar is read too: it then has no meanings, and an NPZ file no units.
pub fn read(path: &Path) -> Result<Results, ReadError> {
    read_with_meta(path).map(|(results, _)| results)
}

/// Reads results together with what the file says of their origin.
pub fn read_with_meta(path: &Path) -> Result<(Results, Meta), ReadError> {
    let format = Format::of_path(path).map_err(|extension| ReadError::UnknownFormat {
        path: path.to_owned(),
        extension,
    })?;
    let (results, meta) = match format {
        Format::Csv => csv_file::read(path)?,
        Format::Npz => npz_file::read(path)?,
        Format::Json => json_file::read(path)?,
    };
    defect::check(&results).map_err(|defect| ReadError::Defective {
        path: path.to_owned(),
        defect,
    })?;
    Ok((results, meta))
}
