//! The place of files: a folder or a source. All other code reads files through it.

use std::fmt;
use std::io::{ErrorKind, Read as _};
use std::path::PathBuf;

use super::folder::{self, Listing};
use super::{AssetError, AssetSource};

/// The place of files.
#[derive(Default)]
pub(super) enum Store {
    /// No files.
    #[default]
    Nothing,
    /// The files below a folder.
    Folder(PathBuf),
    /// The files of a source.
    Source(Box<dyn AssetSource>),
}

impl fmt::Debug for Store {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Store::Nothing => f.write_str("Nothing"),
            Store::Folder(root) => f.debug_tuple("Folder").field(root).finish(),
            Store::Source(_) => f.write_str("Source"),
        }
    }
}

/// A file that was found: in a folder its path with links resolved, otherwise its name.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct StoredFile(PathBuf);

impl StoredFile {
    /// The path, for the extension of the name.
    #[cfg(any(feature = "obj", feature = "gltf"))]
    pub(super) fn path(&self) -> &std::path::Path {
        &self.0
    }
}

impl Store {
    /// Returns true if it may have files.
    pub(super) fn is_set(&self) -> bool {
        !matches!(self, Store::Nothing)
    }

    /// The name of the folder, which searches compare with `Project=`.
    pub(super) fn project(&self) -> &str {
        match self {
            Store::Folder(root) => root.file_name().and_then(|name| name.to_str()).unwrap_or_default(),
            Store::Nothing | Store::Source(_) => "",
        }
    }

    /// The file at a place, which has no `.` and no `..`.
    pub(super) fn find(&self, place: &str) -> Result<StoredFile, AssetError> {
        match self {
            Store::Nothing => Err(AssetError::NoFolder),
            Store::Folder(root) => folder::file(root, place).map(StoredFile),
            Store::Source(source) if source.has(place) => Ok(StoredFile(place.into())),
            Store::Source(_) => Err(missing()),
        }
    }

    /// At most `most` bytes of a file.
    pub(super) fn read(&self, StoredFile(path): &StoredFile, most: u64) -> Result<Vec<u8>, AssetError> {
        let mut bytes = Vec::new();
        match self {
            Store::Nothing => return Err(AssetError::NoFolder),
            Store::Folder(_) => _ = std::fs::File::open(path)?.take(most).read_to_end(&mut bytes)?,
            Store::Source(source) => {
                let all = path.to_str().and_then(|name| source.bytes(name)).ok_or_else(missing)?;
                let most = usize::try_from(most).unwrap_or(usize::MAX);
                bytes.extend_from_slice(&all[..all.len().min(most)]);
            }
        }
        Ok(bytes)
    }

    /// The file that another file names, relative to its own folder.
    pub(super) fn beside(&self, StoredFile(path): &StoredFile, name: &str) -> Option<StoredFile> {
        match self {
            Store::Nothing => None,
            Store::Folder(root) => {
                let found = folder::inside(root, &path.parent()?.join(name)).ok()?;
                found.is_file().then_some(StoredFile(found))
            }
            Store::Source(source) => {
                let place = joined(path.to_str()?, name)?;
                source.has(&place).then(|| StoredFile(place.into()))
            }
        }
    }

    /// The path of a file from the top of the store, with forward slashes.
    pub(super) fn place(&self, StoredFile(path): &StoredFile) -> Option<String> {
        match self {
            Store::Nothing => None,
            Store::Folder(root) => {
                Some(path.strip_prefix(root.canonicalize().ok()?).ok()?.to_str()?.replace('\\', "/"))
            }
            Store::Source(_) => path.to_str().map(str::to_owned),
        }
    }

    /// The names of all files, and the additional names `given`.
    pub(super) fn listing<'a>(&self, given: impl Iterator<Item = &'a String>) -> Listing {
        match self {
            Store::Nothing => Listing::new(None, given),
            Store::Folder(root) => Listing::new(Some(root), given),
            Store::Source(source) => Listing::of(source.names(), given),
        }
    }
}

fn missing() -> AssetError {
    AssetError::File { kind: ErrorKind::NotFound, message: "the source of assets has no such file".to_owned() }
}

/// The place of a file that the file at `place` names. `None` if it leads out of the store.
fn joined(place: &str, name: &str) -> Option<String> {
    let mut parts: Vec<&str> = place.split('/').collect();
    parts.pop();
    for part in name.split('/') {
        match part {
            "" | "." => {}
            ".." => _ = parts.pop()?,
            part => parts.push(part),
        }
    }
    Some(parts.join("/"))
}

#[cfg(all(test, any(feature = "obj", feature = "gltf")))]
mod tests {
    use super::*;

    #[test]
    fn names_in_files_are_relative_to_them_and_stay_inside() {
        assert_eq!(joined("a/b/tree.obj", "tree.mtl").as_deref(), Some("a/b/tree.mtl"));
        assert_eq!(joined("a/b/tree.obj", "./../images//bark.png").as_deref(), Some("a/images/bark.png"));
        assert_eq!(joined("tree.obj", "../tree.mtl"), None);
        assert_eq!(joined("a/tree.obj", "../../a/tree.mtl"), None);
    }

    #[test]
    fn a_source_is_read_up_to_a_limit() {
        let store = Store::Source(Box::new([("a.txt", "abc")]));
        let file = store.find("a.txt").expect("it exists");
        assert_eq!(store.read(&file, 2).as_deref(), Ok(b"ab".as_slice()));
        assert_eq!(store.read(&file, 9).as_deref(), Ok(b"abc".as_slice()));
        assert!(matches!(store.find("b.txt"), Err(AssetError::File { kind: ErrorKind::NotFound, .. })));
    }
}
