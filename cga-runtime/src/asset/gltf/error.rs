//! Errors of the reader.

use std::fmt;

use crate::geometry::mesh::MeshError;

/// The reason why a file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GltfError {
    /// The file is neither GLB nor JSON, or ends early.
    Container(&'static str),
    /// The JSON text is invalid.
    Json(String),
    /// The file requires an extension that the reader does not know.
    Extension(String),
    /// An item of a list of the file is invalid.
    Item {
        /// The name of the list, such as `accessors`.
        list: &'static str,
        /// The index of the item.
        index: usize,
        /// A description of the problem.
        what: String,
    },
    /// The scene has more triangles, vertices or places of meshes than the reader accepts.
    TooLarge,
    /// The faces do not form a mesh.
    Mesh(MeshError),
}

impl GltfError {
    /// An invalid item.
    pub(super) fn item(list: &'static str, index: usize, what: impl Into<String>) -> Self {
        GltfError::Item { list, index, what: what.into() }
    }
}

impl fmt::Display for GltfError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GltfError::Container(what) => f.write_str(what),
            GltfError::Json(what) => write!(f, "its JSON text is invalid: {what}"),
            GltfError::Extension(name) => write!(f, "it requires the extension `{name}`, which cannot be read"),
            GltfError::Item { list, index, what } => write!(f, "{list}[{index}]: {what}"),
            GltfError::TooLarge => f.write_str("its scene has too many triangles, vertices or places of meshes"),
            GltfError::Mesh(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for GltfError {}
