//! Why a file gives no mesh.

use thiserror::Error;

/// Why a file gives no mesh.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum MeshFileError {
    /// The ending of the name is not known.
    #[error("\"{file}\" is neither an .stl nor an .obj file")]
    UnknownEnding {
        /// Name of the file.
        file: String,
    },
    /// The file cannot be opened or read.
    #[error("cannot read \"{file}\": {reason}")]
    Unreadable {
        /// Name of the file.
        file: String,
        /// What the operating system says.
        reason: String,
    },
    /// The file is neither a text that starts with "solid" nor as long as a binary file must be.
    #[error("\"{file}\" is not an STL file: it does not start with \"solid\", and it has {found} bytes where a binary file of its {triangles} {} has {expected}", triangle_word(*.triangles))]
    NotStl {
        /// Name of the file.
        file: String,
        /// Number of triangles that the header of a binary file states.
        triangles: u32,
        /// Bytes of a binary file with so many.
        expected: u64,
        /// Bytes of the file.
        found: u64,
    },
    /// The file is too short for any STL file.
    #[error("\"{file}\" is not an STL file: it has only {found} bytes")]
    TooShort {
        /// Name of the file.
        file: String,
        /// Bytes of the file.
        found: usize,
    },
    /// The text of the file is not text.
    #[error("\"{file}\" is not a text file")]
    NotText {
        /// Name of the file.
        file: String,
    },
    /// A corner without three finite numbers.
    #[error("\"{file}\", line {line}: a corner needs three finite numbers, found \"{text}\"")]
    BadVertex {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A triangle of a binary file with a number that is not finite.
    #[error("\"{file}\": triangle {triangle} has a number that is not finite")]
    NotFinite {
        /// Name of the file.
        file: String,
        /// Triangle, from 1.
        triangle: usize,
    },
    /// A face that is not a triangle.
    #[error("\"{file}\", line {line}: a face with {corners} {}, only triangles can be read", corner_word(*.corners))]
    NotATriangle {
        /// Name of the file.
        file: String,
        /// Line where the face ends, from 1.
        line: usize,
        /// Number of corners.
        corners: usize,
    },
    /// A face that does not name its corners by numbers.
    #[error("\"{file}\", line {line}: \"{text}\" is not the number of a vertex")]
    BadCorner {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A face names a vertex that does not exist.
    #[error("\"{file}\", line {line}: there is no vertex {vertex}, the file has {vertices}")]
    NoSuchVertex {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// The number, as it stands in the file.
        vertex: i64,
        /// Number of vertices of the file.
        vertices: usize,
    },
    /// A word that has no place there.
    #[error("\"{file}\", line {line}: \"{text}\" is not expected here")]
    Unexpected {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// The word.
        text: String,
    },
    /// The file ends inside a face.
    #[error("\"{file}\" ends inside a face")]
    CutOff {
        /// Name of the file.
        file: String,
    },
    /// No triangle with an area.
    #[error("\"{file}\" has no triangles")]
    Empty {
        /// Name of the file.
        file: String,
    },
}

fn triangle_word(count: u32) -> &'static str {
    if count == 1 { "triangle" } else { "triangles" }
}

fn corner_word(count: usize) -> &'static str {
    if count == 1 { "corner" } else { "corners" }
}

impl MeshFileError {
    /// What to do.
    pub fn help(&self) -> &'static str {
        match self {
            Self::UnknownEnding { .. } => {
                "save the mesh as STL or OBJ, and let the name of the file end so"
            }
            Self::Unreadable { .. } => "the name is relative to the folder of the model file",
            Self::NotStl { .. } | Self::TooShort { .. } | Self::CutOff { .. } => {
                "the file may be cut off or of another format: save the mesh again"
            }
            Self::NotText { .. } => "OBJ files are texts: save the mesh again as OBJ or STL",
            Self::NotATriangle { .. } => {
                "save the mesh again with triangles only (\"triangulate faces\")"
            }
            Self::BadVertex { .. }
            | Self::NotFinite { .. }
            | Self::BadCorner { .. }
            | Self::NoSuchVertex { .. }
            | Self::Unexpected { .. } => "mend the line, or save the mesh again",
            Self::Empty { .. } => "save a mesh with faces",
        }
    }
}
