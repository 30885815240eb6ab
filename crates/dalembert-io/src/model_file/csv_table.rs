//! Points of a table from a CSV file.

use dalembert::model::{Table, Value};
use std::path::Path;
use thiserror::Error;

/// Why a CSV file gives no table.
#[derive(Debug, Error, PartialEq)]
pub(super) enum CsvError {
    /// The model has no folder in which the file could be.
    #[error("the model was not read from a folder, so \"{file}\" cannot be found")]
    NoFolder { file: String },
    /// The file cannot be opened or read.
    #[error("cannot read \"{file}\": {reason}")]
    Unreadable { file: String, reason: String },
    /// A line is too short.
    #[error("\"{file}\", line {line}: there is no column {column}, the line has {found}")]
    NoColumn {
        file: String,
        line: u64,
        column: usize,
        found: usize,
        /// Which of the two columns it is: 0 for x, 1 for y.
        entry: usize,
    },
    /// A field is not a finite number.
    #[error("\"{file}\", line {line}, column {column}: \"{text}\" is not a finite number")]
    NotANumber {
        file: String,
        line: u64,
        column: usize,
        text: String,
    },
    /// There is nothing to interpolate between.
    #[error("\"{file}\" has {found} line{} of numbers; a table needs at least 2", if *found == 1 { "" } else { "s" })]
    TooFew { file: String, found: usize },
}

impl CsvError {
    /// What to do.
    pub fn help(&self) -> &'static str {
        match self {
            Self::NoFolder { .. } => "give `x` and `y` in the model file",
            Self::Unreadable { .. } => "the name is relative to the folder of the model file",
            Self::NoColumn { .. } => {
                "`columns = [1, 2]` says which columns are x and y, counted from 1"
            }
            Self::NotANumber { .. } => {
                "numbers have a decimal point; one line of headings is allowed at the top"
            }
            Self::TooFew { .. } => "add points to the file",
        }
    }
}

/// Reads arguments and values. Columns are separated by commas, semicolons or tabs; lines that
/// start with `#` are comments; one line of headings is allowed.
pub(super) fn read(
    folder: Option<&Path>,
    file: &str,
    table: &Table,
) -> Result<(Vec<Value>, Vec<Value>), CsvError> {
    let owned = || file.to_owned();
    let folder = folder.ok_or_else(|| CsvError::NoFolder { file: owned() })?;
    let unreadable = |reason: &dyn std::fmt::Display| CsvError::Unreadable {
        file: owned(),
        reason: reason.to_string(),
    };
    let path = folder.join(file);
    // Devices and pipes may never end.
    if !std::fs::metadata(&path)
        .map_err(|e| unreadable(&e))?
        .is_file()
    {
        return Err(unreadable(&"it is not a file"));
    }
    let text = std::fs::read_to_string(&path).map_err(|e| unreadable(&e))?;
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter(&text))
        .comment(Some(b'#'))
        .flexible(true)
        .has_headers(false)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let columns = table.columns.unwrap_or([1, 2]);
    let (mut x, mut y) = (Vec::new(), Vec::new());
    for (k, record) in reader.records().enumerate() {
        let record = record.map_err(|e| unreadable(&e))?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |entry: usize| -> Result<f64, CsvError> {
            let column = columns[entry];
            let text = column
                .checked_sub(1)
                .and_then(|c| record.get(c))
                .ok_or_else(|| CsvError::NoColumn {
                    file: owned(),
                    line,
                    column,
                    found: record.len(),
                    entry,
                })?;
            let number: Option<f64> = text.parse().ok();
            number
                .filter(|n| n.is_finite())
                .ok_or_else(|| CsvError::NotANumber {
                    file: owned(),
                    line,
                    column,
                    text: text.to_owned(),
                })
        };
        match (number(0), number(1)) {
            (Ok(argument), Ok(value)) => {
                x.push(with_unit(argument, table.x_unit.as_deref()));
                y.push(with_unit(value, table.y_unit.as_deref()));
            }
            // Headings: the first line, and neither of its columns is a number.
            (Err(CsvError::NotANumber { .. }), Err(CsvError::NotANumber { .. })) if k == 0 => {}
            // A column that does not exist is the mistake, whatever the line holds.
            (_, Err(error @ CsvError::NoColumn { .. })) => return Err(error),
            (Err(error), _) | (_, Err(error)) => return Err(error),
        }
    }
    if x.len() < 2 {
        return Err(CsvError::TooFew {
            file: owned(),
            found: x.len(),
        });
    }
    Ok((x, y))
}

/// The separator of the first line that is not a comment.
fn delimiter(text: &str) -> u8 {
    let line = text
        .lines()
        .find(|l| !l.starts_with('#') && !l.trim().is_empty())
        .unwrap_or_default();
    [b',', b';', b'\t']
        .into_iter()
        .find(|d| line.as_bytes().contains(d))
        .unwrap_or(b',')
}

/// A number of the file as a value of the model; the unit is converted where expressions are.
fn with_unit(number: f64, unit: Option<&str>) -> Value {
    match unit {
        Some(unit) => Value::Text(format!("{number} {unit}")),
        None => Value::Number(number),
    }
}
