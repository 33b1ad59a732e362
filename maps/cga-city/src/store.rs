//! Where the files of a city are: a folder, or a store of another program.

use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// A store of files. Names are relative to the city, with `/`, as in `tiles/0/17/69000/43000.glb`. Several threads use it at a time.
pub trait Store: Sync {
    /// The bytes of a file; `None` if it does not exist.
    ///
    /// # Errors
    /// Errors of the store.
    fn read(&self, name: &str) -> io::Result<Option<Vec<u8>>>;

    /// Writes a file. A reader sees the old file or the new one, never a part.
    ///
    /// # Errors
    /// Errors of the store.
    fn write(&self, name: &str, bytes: Vec<u8>) -> io::Result<()>;

    /// Deletes a file, if it exists.
    ///
    /// # Errors
    /// Errors of the store.
    fn delete(&self, name: &str) -> io::Result<()>;

    /// Returns true if a file has its bytes, by their number and their digest in hexadecimal digits.
    fn is_whole(&self, name: &str, count: u64, digest: &str) -> bool {
        // A file system that was full or without power may have left others, also of the same length.
        matches!(self.read(name), Ok(Some(bytes)) if has_digest(&bytes, count, digest))
    }
}

/// Returns true if bytes have a number and a digest in hexadecimal digits.
pub fn has_digest(bytes: &[u8], count: u64, digest: &str) -> bool {
    bytes.len() as u64 == count && digest_of(bytes) == digest
}

/// The digest of a file in hexadecimal digits.
pub fn digest_of(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

/// A folder of the file system.
#[derive(Clone, Debug)]
pub struct Folder(pub PathBuf);

impl Store for Folder {
    fn read(&self, name: &str) -> io::Result<Option<Vec<u8>>> {
        match fs::read(self.0.join(name)) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(why) if why.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(why) => Err(why),
        }
    }

    fn write(&self, name: &str, bytes: Vec<u8>) -> io::Result<()> {
        let path = self.0.join(name);
        let folder = path.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder)?;
        let mut builder = tempfile::Builder::new();
        // A server may run as another user.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut file = builder.prefix(".part-").tempfile_in(folder)?;
        file.write_all(&bytes)?;
        file.persist(path)?;
        Ok(())
    }

    fn delete(&self, name: &str) -> io::Result<()> {
        match fs::remove_file(self.0.join(name)) {
            Err(why) if why.kind() != io::ErrorKind::NotFound => Err(why),
            _ => Ok(()),
        }
    }
}
