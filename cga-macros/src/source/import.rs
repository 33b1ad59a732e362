//! Files that rules import. They must be inside the package, like the file after `in`.

use std::collections::HashMap;
use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use cga_lang::compile::Dialect;
use cga_lang::link::{Asset, Files, Unit, candidates, folder};
use cga_lang::syntax::lex::lex;
use cga_source::rust::QuotedText;
use proc_macro2::{Literal, TokenStream};

use super::package::{resolved, text, tracking};

/// Larger meshes are there, and no more is known of them.
const LARGEST_MESH: u64 = 1 << 26;

/// Files in a folder that are looked at for one that may have been meant.
const MOST_BESIDE: usize = 500;

/// Opens imported files and keeps them: diagnostics quote them, and the build tracks them.
pub(crate) struct Imports {
    /// The package's folder.
    root: PathBuf,
    /// In the order in which they were opened first.
    opened: Vec<Imported>,
    /// The same files as the compiler takes them: each is read once, as it may change between two imports.
    units: HashMap<String, Unit>,
    /// The entries of the folders read so far.
    listed: HashMap<PathBuf, Vec<String>>,
}

/// A file that was imported.
pub(crate) struct Imported {
    pub(super) text: QuotedText,
    /// The path in the `import` of the compiled rules through which the file was reached.
    pub(super) path: String,
}

impl Imports {
    pub(crate) fn new() -> Self {
        let root = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
        Imports { root, opened: Vec::new(), units: HashMap::new(), listed: HashMap::new() }
    }

    /// The files.
    pub(crate) fn opened(self) -> Vec<Imported> {
        self.opened
    }
}

impl Files for Imports {
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String> {
        // A machine's own paths have no place in a package.
        let inside = |name: &String| !name.starts_with("..") && !name.starts_with('/');
        let names: Vec<String> = candidates(path, from).into_iter().filter(inside).collect();
        let found = names.iter().find(|name| self.root.join(name).is_file());
        let Some(name) = found else {
            return Err(match names.first() {
                Some(first) if first != path => format!("there is no file `{first}` in the package"),
                _ => "there is no such file in the package".into(),
            });
        };
        if let Some(unit) = self.units.get(name) {
            return Ok(unit.clone());
        }
        let text = text(&self.root, name).map_err(|error| error.to_string())?;
        let lexed = lex(&text);
        let through = self.opened.iter().find(|file| file.text.name == from);
        let path = through.map_or(path, |file| &file.path).to_owned();
        let text = QuotedText { name: name.clone(), written: text, ranges: lexed.ranges };
        self.opened.push(Imported { text, path });
        let unit = Unit { name: name.clone(), tokens: lexed.tokens, dialect: Dialect::Text, found: lexed.diags };
        self.units.insert(name.clone(), unit.clone());
        Ok(unit)
    }

    fn beside(&mut self, path: &str, from: &str) -> Vec<String> {
        let folder = folder(path, from);
        if folder.starts_with("..") || folder.starts_with('/') {
            return Vec::new();
        }
        resolved(&self.root, &folder).map(|folder| names(&folder).collect()).unwrap_or_default()
    }

    fn asset(&mut self, place: &str) -> Option<Asset> {
        let Some(path) = self.inside(place) else {
            return Some(Asset::Missing(self.beside_place(place)));
        };
        let is_mesh = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("obj"));
        let bytes = is_mesh.then(|| small_file(&path)).flatten();
        Some(bytes.map_or(Asset::There, |bytes| Asset::obj(&String::from_utf8_lossy(&bytes))))
    }
}

impl Imports {
    /// The path of a file in the package, without links: one that leads out of it a run does not follow either.
    fn inside(&self, place: &str) -> Option<PathBuf> {
        resolved(&self.root, place).ok().filter(|path| path.is_file())
    }

    /// The names of the files in the folder of one that is not there.
    fn beside_place(&mut self, place: &str) -> Vec<String> {
        let folder = place.rsplit_once('/').map_or("", |(folder, _)| folder);
        let Ok(folder) = resolved(&self.root, folder) else { return Vec::new() };
        self.listed.entry(folder.clone()).or_insert_with(|| names(&folder).take(MOST_BESIDE).collect()).clone()
    }
}

/// The bytes of a file that is not larger than [`LARGEST_MESH`].
fn small_file(path: &Path) -> Option<Vec<u8>> {
    // A pipe may have no end.
    let about = std::fs::metadata(path).ok()?;
    if !about.is_file() || LARGEST_MESH < about.len() {
        return None;
    }
    let file = File::open(path).ok()?;
    let mut bytes = Vec::new();
    // A file may grow while it is read.
    file.take(LARGEST_MESH + 1).read_to_end(&mut bytes).ok()?;
    (bytes.len() as u64 <= LARGEST_MESH).then_some(bytes)
}

/// The entries of a folder, unsorted.
fn names(folder: &Path) -> impl Iterator<Item = String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    entries.filter_map(|entry| entry.file_name().into_string().ok())
}

/// Makes the build follow the imported files.
pub(super) fn follow(files: &[Imported]) -> TokenStream {
    files.iter().map(|file| tracking(&Literal::string(&file.text.name))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn assets_are_those_of_the_package() {
        let root = std::env::temp_dir().join(format!("cga-assets-{}", std::process::id()));
        std::fs::create_dir_all(root.join("assets/wood")).unwrap();
        let write = |name: &str, text: &str| std::fs::write(root.join(name), text).unwrap();
        write("assets/tree.obj", "g Bark\nf 1 2 3\n");
        write("assets/wood/oak.png", "");
        write("table.csv", "1;2");
        let mut files =
            Imports { root: root.clone(), opened: Vec::new(), units: HashMap::new(), listed: HashMap::new() };
        let groups = vec!["Bark".to_owned()];
        let tree = Asset::Mesh { has_faces: true, groups, materials: Vec::new() };
        assert_eq!(files.asset("assets/tree.obj"), Some(tree));
        assert_eq!(files.asset("table.csv"), Some(Asset::There));
        assert_eq!(files.asset("assets/wood/oak.png"), Some(Asset::There));
        assert_eq!(files.asset("assets/wood/elm.png"), Some(Asset::Missing(vec!["oak.png".to_owned()])));
        assert!(
            matches!(files.asset("assets/wood"), Some(Asset::Missing(names)) if names.contains(&"tree.obj".to_owned()))
        );
        std::fs::remove_dir_all(&root).unwrap();
    }

    #[test]
    fn an_imported_file_is_read_once() {
        let root = std::env::temp_dir().join(format!("cga-import-once-{}", std::process::id()));
        std::fs::create_dir_all(&root).unwrap();
        std::fs::write(root.join("wall.cga"), "Wall --> X.").unwrap();
        let mut files = Imports { root: root.clone(), ..Imports::new() };
        let count = |unit: Result<Unit, String>| unit.unwrap().tokens.as_slice().len();
        let first = count(files.open("wall.cga", "lot.cga"));
        std::fs::write(root.join("wall.cga"), "Wall --> extrude(3) X. Roof --> Y.").unwrap();
        assert_eq!(count(files.open("wall.cga", "house.cga")), first);
        std::fs::remove_file(root.join("wall.cga")).unwrap();
        // Diagnostics quote the text that was read.
        assert_eq!((files.opened.len(), files.opened[0].text.ranges.len()), (1, first));
        std::fs::remove_dir_all(&root).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn imports_and_suggestions_stay_in_the_package() {
        use std::os::unix::fs::symlink;
        let root = std::env::temp_dir().join(format!("cga-import-links-{}", std::process::id()));
        let package = root.join("package");
        std::fs::create_dir_all(&package).unwrap();
        std::fs::write(root.join("secret.cga"), "secret").unwrap();
        std::fs::write(package.join("wall.cga"), "Wall --> X.").unwrap();
        symlink(root.join("secret.cga"), package.join("file.cga")).unwrap();
        symlink(&root, package.join("folder")).unwrap();
        symlink("wall.cga", package.join("inside.cga")).unwrap();
        let mut files = Imports { root: package, opened: Vec::new(), units: HashMap::new(), listed: HashMap::new() };
        let why = "it is not a file in the package, and paths and links that lead out of it are not followed";
        for path in ["file.cga", "folder/secret.cga"] {
            assert_eq!(files.open(path, "lot.cga").unwrap_err(), why);
        }
        assert!(files.opened.is_empty());
        assert!(files.open("inside.cga", "lot.cga").is_ok());
        assert!(files.beside("folder/secre.cga", "lot.cga").is_empty());
        assert_eq!(files.asset("folder/secre.cga"), Some(Asset::Missing(Vec::new())));
        assert!(files.beside("wal.cga", "lot.cga").contains(&"wall.cga".to_owned()));
        std::fs::remove_dir_all(&root).unwrap();
    }
}
