//! OBJ files: vertices and faces; normals, textures, groups and materials are passed over.

use super::{MeshFileError, TriangleMesh, merge::Merger};

/// Reads a file.
pub(super) fn parse(file: &str, bytes: &[u8]) -> Result<TriangleMesh, MeshFileError> {
    let owned = || file.to_owned();
    let text = std::str::from_utf8(bytes).map_err(|_| MeshFileError::NotText { file: owned() })?;
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    for (k, line) in text.lines().enumerate() {
        let number = k + 1;
        let content = line.split('#').next().unwrap_or_default();
        let mut words = content.split_whitespace();
        match words.next() {
            Some("v") => {
                let vertex = three_numbers(words).ok_or_else(|| MeshFileError::BadVertex {
                    file: owned(),
                    line: number,
                    text: content.trim().to_owned(),
                })?;
                vertices.push(vertex);
            }
            Some("f") => {
                let corners: Vec<&str> = words.collect();
                let Ok(corners) = <[&str; 3]>::try_from(corners.as_slice()) else {
                    return Err(MeshFileError::NotATriangle {
                        file: owned(),
                        line: number,
                        corners: corners.len(),
                    });
                };
                faces.push((number, vertices.len(), corners));
            }
            _ => {}
        }
    }
    let mut merger = Merger::default();
    for (line, so_far, corners) in faces {
        let mut triangle = [[0.0; 3]; 3];
        for (place, text) in triangle.iter_mut().zip(corners) {
            // A corner is vertex/texture/normal.
            let vertex: i64 = text
                .split('/')
                .next()
                .and_then(|number| number.parse().ok())
                .ok_or_else(|| MeshFileError::BadCorner {
                    file: owned(),
                    line,
                    text: text.to_owned(),
                })?;
            *place = usize::try_from(vertex)
                .ok()
                .and_then(|n| n.checked_sub(1))
                .or_else(|| {
                    // Negative numbers count back from the last vertex before the face.
                    let back = usize::try_from(vertex.checked_neg()?).ok()?;
                    so_far.checked_sub(back).filter(|_| back > 0)
                })
                .and_then(|n| vertices.get(n).copied())
                .ok_or_else(|| MeshFileError::NoSuchVertex {
                    file: owned(),
                    line,
                    vertex,
                    vertices: vertices.len(),
                })?;
        }
        merger.add(triangle);
    }
    Ok(merger.finish())
}

/// The first three words as finite numbers.
pub(super) fn three_numbers<'a>(mut words: impl Iterator<Item = &'a str>) -> Option<[f64; 3]> {
    let mut numbers = [0.0_f64; 3];
    for number in &mut numbers {
        *number = words.next()?.parse().ok()?;
    }
    numbers.iter().all(|x| x.is_finite()).then_some(numbers)
}
