//! The folder that rules must not lead out of.

use std::io::{Error, ErrorKind, Result};
use std::path::{Path, PathBuf};

/// A folder that paths and links must not lead out of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// The name in messages.
    name: String,
    /// The folder with links resolved.
    folder: PathBuf,
}

impl Root {
    /// A folder with a name for messages: a path in quotes, or words.
    ///
    /// # Errors
    /// The folder cannot be read, or it is a file ([`ErrorKind::NotADirectory`]).
    pub fn new(folder: &Path, name: impl Into<String>) -> Result<Self> {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let folder = folder.canonicalize()?;
        if !folder.is_dir() {
            return Err(Error::new(ErrorKind::NotADirectory, "it is not a folder"));
        }
        Ok(Root { name: name.into(), folder })
    }

    /// The folder, without links.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The path of a file or folder inside, with links resolved. A relative path counts from the folder.
    ///
    /// # Errors
    /// It does not exist ([`ErrorKind::NotFound`]), or a path or a link leads out. Both have one message, so rules cannot find out which
    /// files exist outside.
    pub fn resolved(&self, path: &Path) -> Result<PathBuf> {
        let outside = |kind| Error::new(kind, self.outside());
        let real = self.folder.join(path).canonicalize().map_err(|why| outside(why.kind()))?;
        if real.starts_with(&self.folder) { Ok(real) } else { Err(outside(ErrorKind::PermissionDenied)) }
    }

    /// The reason why a file is not read. Files that do not exist have the same.
    pub(crate) fn outside(&self) -> String {
        let name = &self.name;
        format!("it is not a file in {name}, and paths and links that lead out of it are not followed")
    }
}
