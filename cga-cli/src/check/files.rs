//! The rule files of a check, and the files that they import.

use cga_lang::link::Files as _;
use cga_source::{RuleFiles, import_paths};
use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The rule files among some paths, in order, each once; and what could not be read.
pub(crate) fn find(paths: &[PathBuf]) -> (Vec<PathBuf>, Vec<String>) {
    let (mut list, mut unread) = (Vec::new(), Vec::new());
    for path in paths {
        if !path.is_dir() {
            list.push(path.clone());
            continue;
        }
        let before = (list.len(), unread.len());
        walk(path, &mut list, &mut unread);
        if (list.len(), unread.len()) == before {
            unread.push(format!("`{}` has no file whose name ends in .cga", path.display()));
        }
    }
    let mut seen = HashSet::new();
    list.retain(|path| seen.insert(path.clone()));
    (list, unread)
}

fn walk(top: &Path, list: &mut Vec<PathBuf>, unread: &mut Vec<String>) {
    let mut folders = vec![top.to_owned()];
    while let Some(folder) = folders.pop() {
        let entries = match fs::read_dir(&folder).and_then(|entries| entries.collect::<Result<Vec<_>, _>>()) {
            Ok(entries) => entries,
            Err(why) => {
                unread.push(format!("cannot read `{}`: {why}", folder.display()));
                continue;
            }
        };
        let mut inner = Vec::new();
        let mut own = Vec::new();
        for entry in entries {
            let path = entry.path();
            // A link to a folder is not followed: it may lead back.
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                inner.push(path);
            } else if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("cga")) && path.is_file() {
                own.push(path);
            }
        }
        own.sort();
        inner.sort();
        list.extend(own);
        folders.extend(inner.into_iter().rev());
    }
}

/// The names of the files that files import. Files that cannot be read import nothing.
pub(crate) fn imported(files: &mut RuleFiles, numbers: &[usize]) -> HashSet<String> {
    let mut imported = HashSet::new();
    for &number in numbers {
        let unit = files.unit(number);
        let paths = import_paths(&unit.tokens);
        let opened = paths.iter().filter_map(|path| files.open(path, &unit.name).ok());
        imported.extend(opened.map(|unit| unit.name));
    }
    imported
}
