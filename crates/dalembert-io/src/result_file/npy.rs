//! One NumPy array (.npy), one-dimensional.
//!
//! Layout (NEP 1 of the NumPy project): the magic bytes `\x93NUMPY`, version (2 bytes), length of
//! the header (2 bytes in version 1, 4 after), the header (a Python dictionary), the data.

use std::io::{self, Write};
use thiserror::Error;

const MAGIC: &[u8] = b"\x93NUMPY";

/// Why the bytes of an array cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NpyError {
    /// The bytes are no array file.
    #[error("this is not a NumPy array file")]
    NotAnArray,
    /// The version of the layout is not known.
    #[error("version {major} of the array layout is not known")]
    UnknownVersion {
        /// Major version.
        major: u8,
    },
    /// The elements are of a type that is not read.
    #[error("elements of type {descr:?} are not read; use '<f8', '<f4', '<i8' or '<i4'")]
    UnknownType {
        /// NumPy's name of the type.
        descr: String,
    },
    /// The array is not one-dimensional.
    #[error("the shape is {shape}, but a channel has one dimension")]
    NotOneDimensional {
        /// Shape as the file states it.
        shape: String,
    },
    /// The data are longer or shorter than the shape says.
    #[error("the shape asks for {expected} bytes, but there are {found}")]
    WrongLength {
        /// Bytes that the shape asks for.
        expected: usize,
        /// Bytes that are there.
        found: usize,
    },
}

/// Writes values as a one-dimensional array of little-endian doubles.
pub(super) fn write(w: &mut impl Write, values: &[f64]) -> io::Result<()> {
    let mut header = format!(
        "{{'descr': '<f8', 'fortran_order': False, 'shape': ({},), }}",
        values.len()
    );
    // Magic, version, length and header fill a multiple of 64 bytes, ending in a line feed.
    let fixed = MAGIC.len() + 4;
    let total = (fixed + header.len() + 1).next_multiple_of(64);
    while fixed + header.len() + 1 < total {
        header.push(' ');
    }
    header.push('\n');
    w.write_all(MAGIC)?;
    w.write_all(&[1, 0])?;
    // One number in the header: it is far below 65536 bytes.
    w.write_all(&(header.len() as u16).to_le_bytes())?;
    w.write_all(header.as_bytes())?;
    for value in values {
        w.write_all(&value.to_le_bytes())?;
    }
    Ok(())
}

/// Reads a one-dimensional array of numbers.
pub(super) fn read(bytes: &[u8]) -> Result<Vec<f64>, NpyError> {
    let rest = bytes.strip_prefix(MAGIC).ok_or(NpyError::NotAnArray)?;
    let [major, _minor, rest @ ..] = rest else {
        return Err(NpyError::NotAnArray);
    };
    let (length, rest) = match (major, rest) {
        (1, [a, b, rest @ ..]) => (usize::from(u16::from_le_bytes([*a, *b])), rest),
        (2 | 3, [a, b, c, d, rest @ ..]) => (u32::from_le_bytes([*a, *b, *c, *d]) as usize, rest),
        (1..=3, _) => return Err(NpyError::NotAnArray),
        _ => return Err(NpyError::UnknownVersion { major: *major }),
    };
    let (header, data) = rest.split_at_checked(length).ok_or(NpyError::NotAnArray)?;
    let header = std::str::from_utf8(header).map_err(|_| NpyError::NotAnArray)?;
    let descr = quoted_entry(header, "descr").ok_or(NpyError::NotAnArray)?;
    let count = count(header)?;
    match descr {
        "<f8" => elements(data, count, f64::from_le_bytes),
        "<f4" => elements(data, count, |b| f64::from(f32::from_le_bytes(b))),
        "<i8" => elements(data, count, |b| i64::from_le_bytes(b) as f64),
        "<i4" => elements(data, count, |b| f64::from(i32::from_le_bytes(b))),
        other => Err(NpyError::UnknownType {
            descr: other.to_owned(),
        }),
    }
}

fn elements<const N: usize>(
    data: &[u8],
    count: usize,
    convert: impl Fn([u8; N]) -> f64,
) -> Result<Vec<f64>, NpyError> {
    let expected = count.saturating_mul(N);
    if data.len() != expected {
        return Err(NpyError::WrongLength {
            expected,
            found: data.len(),
        });
    }
    let (chunks, _) = data.as_chunks::<N>();
    Ok(chunks.iter().map(|c| convert(*c)).collect())
}

/// The text after `'key':` in a header.
fn entry<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let (_, rest) = header.split_once(&format!("'{key}'"))?;
    Some(rest.trim_start().strip_prefix(':')?.trim_start())
}

fn quoted_entry<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let rest = entry(header, key)?.strip_prefix('\'')?;
    rest.split_once('\'').map(|(text, _)| text)
}

/// Number of elements of the one dimension.
fn count(header: &str) -> Result<usize, NpyError> {
    let inside = entry(header, "shape")
        .and_then(|rest| rest.strip_prefix('('))
        .and_then(|rest| rest.split_once(')'))
        .map(|(inside, _)| inside.trim())
        .ok_or(NpyError::NotAnArray)?;
    inside
        .strip_suffix(',')
        .and_then(|number| number.trim().parse().ok())
        .ok_or_else(|| NpyError::NotOneDimensional {
            shape: format!("({inside})"),
        })
}
