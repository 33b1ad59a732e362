//! Files that are written whole or not at all.

use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher as _, Hasher as _, RandomState};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::error::WriteError;

/// A file in the making: it has a temporary name beside its own, which [`finish`](WholeFile::finish) gives it. If it is dropped
/// before, the temporary file goes, and a file that had the name stays as it was.
///
/// A file that takes the place of another one is on the disk before it gets the name. So a crash of the machine leaves one of the
/// two whole. A new file is not waited for: after such a crash it may be empty.
///
/// An existing file keeps its permissions, and one that may not be written is an error. A link stays: the file that it leads to is
/// written. What another file cannot take the place of is written directly: pipes, devices, the open files of the process, such
/// as `/dev/stdout`, files of another owner or with several names, and files in a folder that takes no new ones.
#[derive(Debug)]
pub(super) struct WholeFile {
    /// The name in errors.
    path: PathBuf,
    file: File,
    /// The temporary name and the final one; `None` for what is written directly.
    names: Option<[PathBuf; 2]>,
    /// True if a file has the final name.
    replaces: bool,
}

impl WholeFile {
    /// Begins a file.
    pub(super) fn create(path: &Path) -> Result<Self, WriteError> {
        open(path).map_err(|error| failed(path, error))
    }

    /// The file to write to.
    pub(super) fn file(&self) -> &File {
        &self.file
    }

    /// Gives the file its name.
    pub(super) fn finish(mut self) -> Result<(), WriteError> {
        let Some([temporary, name]) = &self.names else { return Ok(()) };
        if self.replaces {
            // A file system may write the new name before the bytes. Until both are on the disk, the file before stays.
            self.file.sync_all().map_err(|error| failed(&self.path, error))?;
        }
        fs::rename(temporary, name).map_err(|error| failed(&self.path, error))?;
        self.names = None;
        Ok(())
    }
}

impl Drop for WholeFile {
    fn drop(&mut self) {
        if let Some([temporary, _]) = &self.names {
            let _ = fs::remove_file(temporary);
        }
    }
}

/// Writes a file of these bytes as models write theirs: under a temporary name, which becomes the name at the end. A file that had the name
/// stays as it was if this fails. Pipes, devices, files of another owner or with several names, and files in a folder that takes no new
/// ones are written directly.
///
/// # Errors
/// Errors of the file system, with the path.
pub fn write_file(path: impl AsRef<Path>, bytes: &[u8]) -> Result<(), WriteError> {
    write(path.as_ref(), bytes)
}

/// Writes a file of these bytes.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    write_with(path, |out| Ok(out.write_all(bytes)?))
}

/// Writes a file with a function that gets the writer. It has no buffer.
pub(super) fn write_with(
    path: &Path,
    contents: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>,
) -> Result<(), WriteError> {
    let whole = WholeFile::create(path)?;
    contents(&mut whole.file()).map_err(|error| named(path, error))?;
    whole.finish()
}

/// The error of a writer, with the name of the file that it writes.
pub(super) fn named(path: &Path, error: WriteError) -> WriteError {
    match error {
        WriteError::Io(error) => failed(path, error),
        other => other,
    }
}

/// The error of a file.
fn failed(path: &Path, error: io::Error) -> WriteError {
    WriteError::File { path: path.to_owned(), error }
}

/// A file that is written directly.
fn direct(path: &Path, file: File) -> WholeFile {
    WholeFile { path: path.to_owned(), file, names: None, replaces: false }
}

/// Opens what is to be written.
fn open(path: &Path) -> io::Result<WholeFile> {
    let known = match fs::metadata(path) {
        Ok(known) => Some(known),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    let is_link = fs::symlink_metadata(path).is_ok_and(|own| own.is_symlink());
    if known.as_ref().is_some_and(|known| !known.is_file()) || (is_link && (known.is_none() || is_open_file(path))) {
        return Ok(direct(path, File::create(path)?));
    }
    let name = if is_link { fs::canonicalize(path)? } else { path.to_owned() };
    if known.is_some() {
        // A rename would replace a file that may not be written.
        OpenOptions::new().write(true).open(&name)?;
    }
    let temporary = beside(&name)?;
    let file = match OpenOptions::new().write(true).create_new(true).open(&temporary) {
        Err(error) if known.is_some() && error.kind() == io::ErrorKind::PermissionDenied => {
            return Ok(direct(path, File::create(name)?));
        }
        opened => opened?,
    };
    // If it is dropped without being finished, the temporary file goes.
    let names = Some([temporary.clone(), name.clone()]);
    let whole = WholeFile { path: path.to_owned(), file, names, replaces: known.is_some() };
    if let Some(known) = known {
        if !can_replace(&known, &whole.file.metadata()?) {
            return Ok(direct(path, File::create(name)?));
        }
        fs::set_permissions(&temporary, known.permissions())?;
    }
    Ok(whole)
}

/// Returns true if a new file can take the place of a known one: it has the same owner and no other name.
#[cfg(unix)]
fn can_replace(known: &fs::Metadata, new: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    (known.uid(), known.gid(), known.nlink()) == (new.uid(), new.gid(), 1)
}

#[cfg(not(unix))]
fn can_replace(_: &fs::Metadata, _: &fs::Metadata) -> bool {
    true
}

/// Returns true for a link that may lead to an open file of the process: after a rename, the process would write to the file before.
fn is_open_file(link: &Path) -> bool {
    cfg!(unix) && ["/dev", "/proc"].iter().any(|folder| link.starts_with(folder))
}

/// A random name beside a file. It is short, as the file's own name may be as long as a name can be.
fn beside(name: &Path) -> io::Result<PathBuf> {
    if name.file_name().is_none() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "the path names no file"));
    }
    Ok(name.with_file_name(format!(".cga-{:016x}.part", RandomState::new().build_hasher().finish())))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An empty folder, and the names of its files.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("cga-whole-file-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder");
        folder
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = entries.map(|name| name.to_string_lossy().into_owned()).collect();
        names.sort_unstable();
        names
    }

    #[test]
    fn what_is_not_finished_leaves_the_file_before() {
        let folder = folder("unfinished");
        let path = folder.join("city.glb");
        write(&path, b"good").expect("a file");
        let whole = WholeFile::create(&path).expect("a file");
        whole.file().write_all(b"ba").expect("some bytes");
        assert_eq!(names(&folder).len(), 2);
        drop(whole);
        assert_eq!((fs::read(&path).expect("a file"), names(&folder)), (b"good".to_vec(), vec!["city.glb".to_owned()]));
        write(&path, b"better").expect("a file");
        assert_eq!((fs::read(&path).expect("a file"), names(&folder).len()), (b"better".to_vec(), 1));
        fs::remove_dir_all(folder).expect("it goes");
    }

    #[cfg(unix)]
    #[test]
    fn a_file_with_two_names_keeps_them() {
        let folder = folder("names");
        let [one, two] = ["a.glb", "b.glb"].map(|name| folder.join(name));
        write(&one, b"good").expect("a file");
        fs::hard_link(&one, &two).expect("another name");
        write(&one, b"better").expect("a file");
        assert_eq!((fs::read(&two).expect("a file"), names(&folder).len()), (b"better".to_vec(), 2));
        fs::remove_dir_all(folder).expect("it goes");
    }

    #[test]
    fn errors_name_the_path() {
        let folder = folder("errors");
        for path in [folder.join("none/a.glb"), folder.clone()] {
            let error = write(&path, b"x").expect_err("no such place").to_string();
            assert!(error.starts_with("cannot write `") && error.contains("cga-whole-file-errors"), "{error}");
        }
        assert!(write(Path::new(""), b"x").is_err() && names(&folder).is_empty());
        fs::remove_dir_all(folder).expect("it goes");
    }

    #[test]
    fn the_longest_name_of_a_file_system_is_written() {
        let folder = folder("long");
        let path = folder.join(format!("{}.glb", "n".repeat(251)));
        write(&path, b"good").expect("a file");
        write(&path, b"better").expect("a file");
        assert_eq!((fs::read(&path).expect("a file"), names(&folder).len()), (b"better".to_vec(), 1));
        fs::remove_dir_all(folder).expect("it goes");
    }

    #[cfg(unix)]
    #[test]
    fn a_pipe_is_written_directly() {
        let folder = folder("pipe");
        let pipe = folder.join("pipe.svg");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.expect("mkfifo").success());
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe).expect("the pipe")
        });
        write(&pipe, b"a picture").expect("the pipe");
        assert_eq!(reader.join().expect("a reader"), b"a picture");
        assert_eq!(names(&folder), ["pipe.svg"]);
        fs::remove_dir_all(folder).expect("it goes");
    }

    /// `/dev/stdout` leads to such a name. A rename would take the file from the program that has it open.
    #[cfg(target_os = "linux")]
    #[test]
    fn an_open_file_of_the_process_is_written_directly() {
        use std::os::fd::AsRawFd as _;
        use std::os::unix::fs::MetadataExt as _;
        let folder = folder("open");
        let path = folder.join("output.txt");
        let output = File::create(&path).expect("a file");
        write(Path::new(&format!("/proc/self/fd/{}", output.as_raw_fd())), b"a picture").expect("an open file");
        let number = |known: io::Result<fs::Metadata>| known.expect("a file").ino();
        assert_eq!(number(fs::metadata(&path)), number(output.metadata()));
        assert_eq!(fs::read(&path).expect("a file"), b"a picture");
        fs::remove_dir_all(folder).expect("it goes");
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_links_stay_and_devices_are_written_directly() {
        use std::os::unix::fs::{PermissionsExt as _, symlink};
        let folder = folder("unix");
        let (path, link) = (folder.join("a.obj"), folder.join("link.obj"));
        write(&path, b"one").expect("a file");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("permissions");
        symlink("a.obj", &link).expect("a link");
        write(&link, b"two").expect("a file");
        assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
        assert_eq!(fs::read(&path).expect("a file"), b"two");
        assert_eq!(fs::metadata(&path).expect("a file").permissions().mode() & 0o777, 0o640);
        symlink("later.obj", folder.join("dangling.obj")).expect("a link");
        write(&folder.join("dangling.obj"), b"three").expect("a file");
        assert_eq!(names(&folder), ["a.obj", "dangling.obj", "later.obj", "link.obj"]);
        write(Path::new("/dev/null"), b"four").expect("a device");
        #[cfg(target_os = "linux")]
        assert!(write(Path::new("/dev/full"), b"five").is_err_and(|error| error.to_string().contains("/dev/full")));
        fs::remove_dir_all(folder).expect("it goes");
    }
}
