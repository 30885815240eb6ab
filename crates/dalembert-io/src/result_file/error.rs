//! Errors of writing and reading result files, always with the path.

use super::{Defect, NpyError};
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a result file was not written.
#[derive(Debug, Error)]
pub enum WriteError {
    /// The extension names no known format.
    #[error("{}: {}; use .csv, .npz or .json", path.display(), unknown(extension))]
    UnknownFormat {
        /// The file.
        path: PathBuf,
        /// Its extension, if it has one.
        extension: Option<String>,
    },
    /// The results are not fit for a file.
    #[error("{}: {defect}", path.display())]
    Defective {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        #[source]
        defect: Defect,
    },
    /// The place of the sidecar holds something else, which is not overwritten.
    #[error(
        "{}: this file is not a sidecar of dalembert and stays as it is; choose another name for the results",
        path.display()
    )]
    SidecarInTheWay {
        /// The file that stands where the sidecar would go.
        path: PathBuf,
    },
    /// The file is the sidecar of another result file, which would lose its units and meanings.
    #[error(
        "{}: this file describes {data:?} and stays as it is; choose another name for the results",
        path.display()
    )]
    SidecarOfAnother {
        /// The file.
        path: PathBuf,
        /// The file that it describes, in the same folder.
        data: String,
    },
    /// The system refused to write.
    #[error("{}: cannot write: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
}

/// Why a result file was not read.
#[derive(Debug, Error)]
pub enum ReadError {
    /// The extension names no known format.
    #[error("{}: {}; use .csv, .npz or .json", path.display(), unknown(extension))]
    UnknownFormat {
        /// The file.
        path: PathBuf,
        /// Its extension, if it has one.
        extension: Option<String>,
    },
    /// The file's content is no results.
    #[error("{}: {defect}", path.display())]
    Defective {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        #[source]
        defect: Defect,
    },
    /// The system refused to read.
    #[error("{}: cannot read: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// A CSV field is not a number.
    #[error("{}:{line}: {text:?} in column {column:?} is not a number", path.display())]
    NotANumber {
        /// The file.
        path: PathBuf,
        /// Line, counted from 1 (where the row or the blank lines before it begin).
        line: u64,
        /// Heading of the column.
        column: String,
        /// The field as it stands.
        text: String,
    },
    /// A CSV row is longer or shorter than the header.
    #[error("{}:{line}: {found} fields, but the header has {expected}", path.display())]
    UnequalRow {
        /// The file.
        path: PathBuf,
        /// Line, counted from 1 (where the row or the blank lines before it begin).
        line: u64,
        /// Fields in this row.
        found: u64,
        /// Fields in the header.
        expected: u64,
    },
    /// The file is not CSV text.
    #[error("{}: not readable as CSV: {source}", path.display())]
    Csv {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: csv::Error,
    },
    /// The file is not JSON, or not of the expected structure.
    #[error("{}: not readable as JSON results: {source}", path.display())]
    Json {
        /// The file.
        path: PathBuf,
        /// The reason, with line and column.
        source: serde_json::Error,
    },
    /// The JSON file is a sidecar: it describes channels but holds no values.
    #[error("{}: this sidecar holds no values; read {data:?} instead", path.display())]
    OnlyASidecar {
        /// The file.
        path: PathBuf,
        /// The file that it belongs to.
        data: String,
    },
    /// The JSON file says that it is of another kind or version.
    #[error("{}: its format is {found:?}, not {expected:?}", path.display())]
    OtherFormat {
        /// The file.
        path: PathBuf,
        /// Format that the file names.
        found: String,
        /// Format that is understood.
        expected: &'static str,
    },
    /// A channel of a JSON file has no values.
    #[error("{}: channel {name:?} has no values", path.display())]
    NoValues {
        /// The file.
        path: PathBuf,
        /// Name of the channel.
        name: String,
    },
    /// The file is not a zip archive.
    #[error("{}: not readable as an NPZ archive: {source}", path.display())]
    Zip {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: zip::result::ZipError,
    },
    /// An array of an NPZ file cannot be used.
    #[error("{}: array {array:?}: {source}", path.display())]
    Npy {
        /// The file.
        path: PathBuf,
        /// Name of the array.
        array: String,
        /// The reason.
        source: NpyError,
    },
}

fn unknown(extension: &Option<String>) -> String {
    match extension {
        Some(extension) => format!("unknown result format {extension:?}"),
        None => "the name has no extension that tells the format".to_owned(),
    }
}
