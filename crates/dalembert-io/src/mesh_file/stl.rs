//! STL files, text and binary.

use super::{MeshFileError, TriangleMesh, merge::Merger};

/// Bytes before the first triangle of a binary file: a comment of 80 and the number of triangles.
const HEADER: usize = 84;

/// Bytes of a triangle: a normal and three corners of three floats of 4 bytes, and 2 bytes for anything.
const TRIANGLE: usize = 50;

/// Reads a file. Binary files may start with "solid" too, but only they have the length that they state.
pub(super) fn parse(file: &str, bytes: &[u8]) -> Result<TriangleMesh, MeshFileError> {
    let stated = stated_triangles(bytes);
    let length = |n: u32| HEADER as u64 + TRIANGLE as u64 * u64::from(n);
    if stated.is_some_and(|n| length(n) == bytes.len() as u64) {
        return binary(file, bytes);
    }
    if bytes.trim_ascii_start().starts_with(b"solid") {
        return text(file, &String::from_utf8_lossy(bytes));
    }
    let file = file.to_owned();
    Err(match stated {
        Some(triangles) => MeshFileError::NotStl {
            file,
            triangles,
            expected: length(triangles),
            found: bytes.len() as u64,
        },
        None => MeshFileError::TooShort {
            file,
            found: bytes.len(),
        },
    })
}

fn stated_triangles(bytes: &[u8]) -> Option<u32> {
    let number = bytes.get(HEADER - 4..HEADER)?;
    Some(u32::from_le_bytes(number.try_into().ok()?))
}

fn binary(file: &str, bytes: &[u8]) -> Result<TriangleMesh, MeshFileError> {
    let mut merger = Merger::default();
    let triangles = bytes[HEADER..].chunks_exact(TRIANGLE);
    for (k, triangle) in triangles.enumerate() {
        // A triangle has 50 bytes, so that each of its numbers has 4.
        let number = |i: usize| {
            let bytes = [0, 1, 2, 3].map(|b| triangle[4 * i + b]);
            f64::from(f32::from_le_bytes(bytes))
        };
        let corners = [3, 6, 9].map(|i| [number(i), number(i + 1), number(i + 2)]);
        if !corners.as_flattened().iter().all(|x| x.is_finite()) {
            return Err(MeshFileError::NotFinite {
                file: file.to_owned(),
                triangle: k + 1,
            });
        }
        merger.add(corners);
    }
    Ok(merger.finish())
}

/// Reads a text. Only the corners count; normals follow from them.
fn text(file: &str, text: &str) -> Result<TriangleMesh, MeshFileError> {
    let mut merger = Merger::default();
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for (k, line) in text.lines().enumerate() {
        let (file, line_number) = (|| file.to_owned(), k + 1);
        let mut words = line.split_whitespace();
        let Some(word) = words.next() else {
            continue;
        };
        match word.to_ascii_lowercase().as_str() {
            "vertex" => {
                let corner =
                    super::obj::three_numbers(words).ok_or_else(|| MeshFileError::BadVertex {
                        file: file(),
                        line: line_number,
                        text: line.trim().to_owned(),
                    })?;
                corners.push(corner);
            }
            "endloop" | "endfacet" if corners.is_empty() => {}
            "endloop" | "endfacet" => {
                let Ok(triangle) = <[[f64; 3]; 3]>::try_from(corners.as_slice()) else {
                    return Err(MeshFileError::NotATriangle {
                        file: file(),
                        line: line_number,
                        corners: corners.len(),
                    });
                };
                merger.add(triangle);
                corners.clear();
            }
            "solid" | "endsolid" | "facet" | "outer" if corners.is_empty() => {}
            _ => {
                return Err(MeshFileError::Unexpected {
                    file: file(),
                    line: line_number,
                    text: word.to_owned(),
                });
            }
        }
    }
    if !corners.is_empty() {
        return Err(MeshFileError::CutOff {
            file: file.to_owned(),
        });
    }
    Ok(merger.finish())
}
