//! Wavefront OBJ text, in and out.
//!
//! Faces stay polygons. Groups (`g`, and `o` where no `g` follows) and materials (`usemtl`) become tags of faces. Positions with
//! equal bits become one point. Texture coordinates and normals are kept when every face has them. Lines, points, smoothing groups
//! and curves are skipped. Any line ending is accepted, a comment ends with its line, and keywords may be in capitals. Unknown
//! statements give a warning.
//!
//! ```
//! use cga_geometry::obj;
//!
//! let text = "v 0 0 0\nv 4 0 0\nv 4 0 -3\nv 0 0 -3\nf 1 2 3 4\n";
//! let mesh = obj::read(text.as_bytes())?.mesh;
//! assert_eq!((mesh.face_count(), mesh.area()), (1, 12.0));
//! let mut copy = Vec::new();
//! obj::write(&mesh, &mut copy)?;
//! assert_eq!(obj::read(&copy)?.mesh, mesh);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The `tobj` crate keeps positions as f32 and starts a new mesh at each group, so statements are read here.

mod lines;
mod names;
mod reader;
mod warnings;
mod writer;

use std::fmt;

use crate::mesh::{Mesh, MeshError};
pub use lines::{UTF_16, is_utf16, lines};
pub use names::Names;
pub use reader::read;
pub use warnings::{Warnings, escaped, short, shortened_to};
pub use writer::{line_name, write, write_objects};

/// The contents of a file.
#[derive(Debug)]
pub struct ObjText {
    /// The mesh. Its materials are their names, `String`s.
    pub mesh: Mesh,
    /// The distinct texts behind `mtllib`, in the order of the file: each is the name of a material library, or several
    /// with spaces between them.
    pub libraries: Vec<String>,
    /// The warnings about the file, one sentence for each problem.
    pub warnings: Warnings,
}

/// The reason why a file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ObjError {
    /// An invalid statement.
    Line {
        /// The number of its line, from 1.
        line: usize,
        /// A description of the problem.
        what: &'static str,
    },
    /// The faces do not form a mesh.
    Mesh(MeshError),
}

impl fmt::Display for ObjError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ObjError::Line { line, what } => write!(f, "line {line}: {what}"),
            ObjError::Mesh(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for ObjError {}
