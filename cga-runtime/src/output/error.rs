//! The errors of writing a model.

use std::fmt;
use std::io;
use std::path::PathBuf;

use crate::geometry::obj::escaped;

/// The reason why a file or a buffer could not be written.
#[derive(Debug)]
#[non_exhaustive]
pub enum WriteError {
    /// An error of a writer or of the encoder.
    Io(io::Error),
    /// An error of the file system. A file that was there before stays as it was.
    File {
        /// The file.
        path: PathBuf,
        /// The error.
        error: io::Error,
    },
    /// The output exceeds the capacity of the format or the buffer.
    TooLarge {
        /// The counted items, in the plural: `vertices`, `bytes`.
        what: &'static str,
        /// The largest possible number.
        limit: u64,
    },
    /// A coordinate is NaN or beyond the range of 32-bit floats.
    NotFinite,
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WriteError::Io(error) => write!(f, "cannot write: {error}"),
            WriteError::File { path, error } => {
                write!(f, "cannot write `{}`: {error}", escaped(&path.to_string_lossy()))
            }
            WriteError::TooLarge { what, limit } => write!(f, "too large: more than {limit} {what}"),
            WriteError::NotFinite => f.write_str("a coordinate is not finite as a 32-bit float"),
        }
    }
}

impl std::error::Error for WriteError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            WriteError::Io(error) | WriteError::File { error, .. } => Some(error),
            _ => None,
        }
    }
}

impl From<io::Error> for WriteError {
    fn from(error: io::Error) -> Self {
        WriteError::Io(error)
    }
}
