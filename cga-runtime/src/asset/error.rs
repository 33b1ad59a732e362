//! Why an asset cannot be had.

use std::fmt;

/// Why an asset cannot be had. `to_string` is a sentence's end, as faults use it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum AssetError {
    /// It was not handed over, and no folder is set in which it could be.
    NoFolder,
    /// Its name leads out of the asset folder.
    Outside,
    /// The file system says no.
    File {
        /// In which way.
        kind: std::io::ErrorKind,
        /// What it says.
        message: String,
    },
    /// Its name says that it is of a kind that cannot be read.
    Format(&'static str),
    /// It is of the right kind, and broken.
    Broken(String),
    /// It is longer than anything that is read.
    TooLong {
        /// The most that is read, in bytes.
        most: u64,
    },
}

impl fmt::Display for AssetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AssetError::NoFolder => f.write_str("no asset folder is set (`Settings::assets`)"),
            AssetError::Outside => f.write_str("assets are looked up below the asset folder only"),
            AssetError::File { message, .. } | AssetError::Broken(message) => f.write_str(message),
            AssetError::Format(wanted) => f.write_str(wanted),
            AssetError::TooLong { most } => write!(f, "it is longer than {most} bytes"),
        }
    }
}

impl std::error::Error for AssetError {}

impl From<std::io::Error> for AssetError {
    fn from(error: std::io::Error) -> Self {
        AssetError::File { kind: error.kind(), message: error.to_string() }
    }
}
