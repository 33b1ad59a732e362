//! Towns for tests.

use std::collections::BTreeMap;
use std::path::Path;

use cga_city::build::{Build, NoProgress, Options, Progress, Summary};
use cga_city::rules::Rules;
use cga_geo::reader;
use cga_geo::survey::{Columns, Surveyor};

/// The rules of the command's own town.
pub(crate) fn rules() -> Rules {
    Rules::open(&[concat!(env!("CARGO_MANIFEST_DIR"), "/rules/town.cga")]).expect("good rules")
}

/// Small tiles, and one far level.
pub(crate) fn options() -> Options {
    Options { levels: vec!["Block".parse().expect("a rule")], lots_per_tile: 16, jobs: Some(3), ..Options::default() }
}

pub(crate) fn city(lots: &Path, folder: &Path) -> Summary {
    build(lots, folder, &rules(), options(), &NoProgress).expect("a city")
}

pub(crate) fn build(
    lots: &Path,
    folder: &Path,
    rules: &Rules,
    options: Options,
    progress: &dyn Progress,
) -> Result<Summary, String> {
    let columns = Columns { id: Some("id".into()), ..Columns::default() };
    let file = reader::open(lots, &columns.names(&rules.grammars()))?;
    let surveyor = Surveyor::new(rules.grammars(), columns);
    let mut build = Build::begin(folder, options)?;
    build.add("lots", file.rows, &surveyor, progress).map_err(|why| why.to_string())?;
    build.finish(rules, progress)
}

/// The files of a folder by their names. Problems have the numbers of rows, which depend on the format.
pub(crate) fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    add(folder, folder, &mut files);
    files.remove("problems.jsonl");
    files
}

fn add(root: &Path, folder: &Path, files: &mut BTreeMap<String, Vec<u8>>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            add(root, &path, files);
        } else {
            let name = path.strip_prefix(root).expect("below").to_string_lossy().into_owned();
            files.insert(name, std::fs::read(&path).expect("a file"));
        }
    }
}
