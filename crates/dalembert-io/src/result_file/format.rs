//! The formats of result files.

use std::path::Path;

/// Format of a result file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values, one column a channel, with a JSON sidecar.
    Csv,
    /// A zip archive of NumPy arrays, one a channel, with a JSON sidecar.
    Npz,
    /// One JSON document with everything.
    Json,
}

impl Format {
    /// The format that the extension of a path names (in any case); `Err` holds the unknown extension.
    pub fn of_path(path: &Path) -> Result<Self, Option<String>> {
        let extension = path.extension().map(|e| e.to_string_lossy().into_owned());
        match extension.as_deref().map(str::to_ascii_lowercase).as_deref() {
            Some("csv") => Ok(Self::Csv),
            Some("npz") => Ok(Self::Npz),
            Some("json") => Ok(Self::Json),
            _ => Err(extension),
        }
    }
}
