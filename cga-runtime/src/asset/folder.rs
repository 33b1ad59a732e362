//! The asset folder: look-up of one file, and a list of all files. Files outside the folder are never touched, neither
//! through `..` nor through links.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use cga_split::files::places;

use super::AssetError;
use crate::geometry::small_sort::sort_owned_by;
use crate::value::text::Text;

/// The limit on files and folders that are visited. Beyond it the same ones are skipped on every platform.
const MOST_ENTRIES: usize = 100_000;

/// The greatest depth of nested folders that are visited.
const DEEPEST: usize = 32;

/// The path of a file, with links resolved. Folders and special files are refused, because reading from a special file
/// may block.
pub(super) fn file(root: &Path, place: &str) -> Result<PathBuf, AssetError> {
    let path = inside(root, &root.join(place))?;
    if path.is_file() {
        return Ok(path);
    }
    let message = "it is not a file".to_owned();
    Err(AssetError::File { kind: std::io::ErrorKind::InvalidInput, message })
}

/// The path with links resolved, if it exists and is below the root.
pub(super) fn inside(root: &Path, path: &Path) -> Result<PathBuf, AssetError> {
    let real = path.canonicalize()?;
    if real.starts_with(root.canonicalize()?) {
        return Ok(real);
    }
    let goes_up = path.strip_prefix(root).is_ok_and(|path| path.components().any(|part| part == Component::ParentDir));
    Err(if goes_up { AssetError::Outside } else { AssetError::LinkOutside })
}

/// All files, as names with forward slashes, sorted.
#[derive(Debug, Default)]
pub(super) struct Listing {
    pub(super) names: Vec<String>,
    /// True if files were skipped because of a limit.
    pub(super) cut_short: bool,
}

impl Listing {
    /// The files below a root, and the additional names `given`.
    pub(super) fn new<'a>(root: Option<&Path>, given: impl Iterator<Item = &'a String>) -> Self {
        let mut walk = FolderWalk { listing: Listing::default(), looked_at: 0 };
        if let Some(root) = root.and_then(|root| root.canonicalize().ok()) {
            walk.folder(&root, &root, "", 0);
        }
        let Listing { names, cut_short } = walk.listing;
        Listing { cut_short, ..Listing::of(names, given) }
    }

    /// These names, and the additional names `given`.
    pub(super) fn of<'a>(mut names: Vec<String>, given: impl Iterator<Item = &'a String>) -> Self {
        names.extend(given.cloned());
        sort_owned_by(&mut names, Ord::cmp);
        names.dedup();
        Listing { names, cut_short: false }
    }
}

impl Listing {
    /// The name by which a rule file in `folder` finds a listed file. If the plain name leads to another file first,
    /// the result has a slash in front.
    pub(super) fn as_written(&self, name: &str, folder: &str) -> Text {
        let is_listed = |place: &String| self.names.binary_search(place).is_ok();
        match places(name, folder).into_iter().flatten().find(is_listed) {
            Some(first) if first != name => Text::from(format!("/{name}")),
            _ => Text::from(name),
        }
    }
}

struct FolderWalk {
    listing: Listing,
    looked_at: usize,
}

impl FolderWalk {
    /// Visits a folder in the order of names, because the order of the file system differs between platforms.
    fn folder(&mut self, root: &Path, folder: &Path, prefix: &str, depth: usize) {
        if DEEPEST < depth {
            self.listing.cut_short = true;
            return;
        }
        let Ok(entries) = std::fs::read_dir(folder) else { return };
        let mut names = BTreeSet::new();
        // Rules cannot contain names that are not UTF-8.
        for name in entries.flatten().filter_map(|entry| entry.file_name().into_string().ok()) {
            names.insert(name);
            if MOST_ENTRIES < self.looked_at + names.len() {
                names.pop_last();
                self.listing.cut_short = true;
            }
        }
        self.looked_at += names.len();
        for name in names {
            let path = folder.join(&name);
            let Ok(kind) = path.symlink_metadata().map(|data| data.file_type()) else { continue };
            let name = format!("{prefix}{name}");
            if kind.is_dir() {
                self.folder(root, &path, &format!("{name}/"), depth + 1);
            } else if kind.is_file() || kind.is_symlink() && inside(root, &path).is_ok_and(|real| real.is_file()) {
                // Links to folders are not followed, because they may form cycles.
                self.listing.names.push(name);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder for one test, deleted afterwards.
    struct Temporary(PathBuf);

    impl Temporary {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("cga-{name}-{}", std::process::id()));
            let _ = std::fs::remove_dir_all(&path);
            std::fs::create_dir_all(path.join("project/assets/deep")).expect("a folder");
            let file = |name: &str| std::fs::write(path.join(name), "x").expect("a file");
            ["outside.txt", "project/b.txt", "project/a.txt", "project/assets/a.txt", "project/assets/deep/Z.txt"]
                .into_iter()
                .for_each(file);
            Temporary(path)
        }

        fn root(&self) -> PathBuf {
            self.0.join("project")
        }
    }

    impl Drop for Temporary {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn all_files_are_listed_in_the_order_of_names() {
        let folder = Temporary::new("list");
        let listing = Listing::new(Some(&folder.root()), ["given.obj".to_owned(), "a.txt".to_owned()].iter());
        assert_eq!(listing.names, ["a.txt", "assets/a.txt", "assets/deep/Z.txt", "b.txt", "given.obj"]);
        assert!(!listing.cut_short);
        assert_eq!(Listing::new(None, [].iter()).names, [""; 0]);
        assert_eq!(Listing::new(Some(&folder.root().join("none")), [].iter()).names, [""; 0]);
    }

    #[test]
    fn what_is_no_file_is_not_found() {
        let folder = Temporary::new("none");
        assert!(file(&folder.root(), "assets/deep").is_err_and(|error| error.to_string() == "it is not a file"));
        let missing = file(&folder.root(), "c.txt");
        assert!(matches!(missing, Err(AssetError::File { kind: std::io::ErrorKind::NotFound, .. })));
        assert!(file(&folder.root(), "a\0b").is_err());
        assert_eq!(file(&folder.root(), "../outside.txt"), Err(AssetError::Outside));
    }

    #[cfg(unix)]
    #[test]
    fn no_link_leads_out() {
        let folder = Temporary::new("link");
        let link = |to: &Path, name: &str| {
            std::os::unix::fs::symlink(to, folder.root().join(name)).expect("a link");
        };
        link(&folder.0.join("outside.txt"), "out.txt");
        link(&folder.0, "up");
        link(&folder.root().join("b.txt"), "in.txt");
        link(&folder.root(), "round");
        link(Path::new("nowhere"), "dead");
        assert_eq!(file(&folder.root(), "out.txt"), Err(AssetError::LinkOutside));
        assert_eq!(file(&folder.root(), "up/outside.txt"), Err(AssetError::LinkOutside));
        assert!(file(&folder.root(), "in.txt").is_ok());
        let listing = Listing::new(Some(&folder.root()), [].iter());
        assert_eq!(listing.names, ["a.txt", "assets/a.txt", "assets/deep/Z.txt", "b.txt", "in.txt"]);
    }

    #[test]
    fn a_folder_without_end_is_cut_short() {
        let folder = Temporary::new("deep");
        let deep = folder.root().join("d/".repeat(DEEPEST + 2));
        std::fs::create_dir_all(&deep).expect("folders");
        std::fs::write(deep.join("x.txt"), "x").expect("a file");
        let listing = Listing::new(Some(&folder.root()), [].iter());
        assert!(listing.cut_short && listing.names.len() == 4);
    }
}
