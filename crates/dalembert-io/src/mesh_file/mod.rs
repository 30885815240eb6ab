//! Meshes of triangles from STL and OBJ files.

mod error;
mod merge;
mod obj;
mod stl;

pub use error::MeshFileError;
pub use merge::TriangleMesh;

use std::path::Path;

/// Reads the mesh `file` of a folder: STL (text or binary) or OBJ, by the ending of its name.
///
/// Vertices at the same place are one, and triangles that are only a line are left out.
///
/// # Errors
/// The file cannot be read, is not what its name says, has faces that are not triangles, or no triangle at all.
pub fn read_mesh(folder: &Path, file: &str) -> Result<TriangleMesh, MeshFileError> {
    let parse = match ending(file).as_deref() {
        Some("stl") => stl::parse,
        Some("obj") => obj::parse,
        _ => {
            return Err(MeshFileError::UnknownEnding {
                file: file.to_owned(),
            });
        }
    };
    let unreadable = |reason: &dyn std::fmt::Display| MeshFileError::Unreadable {
        file: file.to_owned(),
        reason: reason.to_string(),
    };
    let path = folder.join(file);
    // Devices and pipes may never end.
    let is_file = std::fs::metadata(&path)
        .map_err(|e| unreadable(&e))?
        .is_file();
    if !is_file {
        return Err(unreadable(&"it is not a file"));
    }
    let bytes = std::fs::read(&path).map_err(|e| unreadable(&e))?;
    let mesh = parse(file, &bytes)?;
    if mesh.triangles.is_empty() {
        return Err(MeshFileError::Empty {
            file: file.to_owned(),
        });
    }
    Ok(mesh)
}

fn ending(file: &str) -> Option<String> {
    let ending = Path::new(file).extension()?.to_str()?;
    Some(ending.to_ascii_lowercase())
}
