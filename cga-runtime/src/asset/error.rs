//! Errors of asset look-ups.

use std::fmt;

/// The reason why an asset is not available. `to_string` gives the end of a sentence, as fault texts use it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum AssetError {
    /// No mesh is registered under the name, and neither an asset folder nor a source is set.
    NoFolder,
    /// Its name leads out of the asset folder.
    Outside,
    /// A link in the asset folder leads out of it.
    LinkOutside,
    /// The file system reports an error.
    File {
        /// The kind of the error.
        kind: std::io::ErrorKind,
        /// The message of the error.
        message: String,
    },
    /// The format of the file is not supported.
    Format(&'static str),
    /// The format is supported, and the contents are invalid.
    Broken(String),
    /// The file exceeds the size limit.
    TooLong {
        /// The limit in bytes.
        most: u64,
    },
}

impl fmt::Display for AssetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AssetError::NoFolder => f.write_str("no asset folder is set (`Settings::assets`)"),
            AssetError::Outside => f.write_str("assets are looked up below the asset folder only"),
            AssetError::LinkOutside => {
                f.write_str("a link leads out of the asset folder, and files outside are not read")
            }
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
