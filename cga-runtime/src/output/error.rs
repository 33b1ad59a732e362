//! What can go wrong when a model is written.

use std::fmt;
use std::io;

/// Why a file or a buffer could not be written.
#[derive(Debug)]
#[non_exhaustive]
pub enum WriteError {
    /// The disk, the pipe, the encoder.
    Io(io::Error),
    /// More than the format or the buffer can hold.
    TooLarge {
        /// What there is too much of, in the plural: `vertices`, `bytes`.
        what: &'static str,
        /// How many there may be.
        limit: u64,
    },
    /// A coordinate is not a number or lies beyond what 32-bit floats can express.
    NotFinite,
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WriteError::Io(error) => write!(f, "cannot write: {error}"),
            WriteError::TooLarge { what, limit } => write!(f, "too large: more than {limit} {what}"),
            WriteError::NotFinite => f.write_str("a coordinate is not finite as a 32-bit float"),
        }
    }
}

impl std::error::Error for WriteError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            WriteError::Io(error) => Some(error),
            _ => None,
        }
    }
}

impl From<io::Error> for WriteError {
    fn from(error: io::Error) -> Self {
        WriteError::Io(error)
    }
}
