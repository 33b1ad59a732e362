//! The files that rules name, as known at compile time.

use super::{Files, Program, folder_of};
use crate::ops::{self, FileUse, Param, ParamKind};
use crate::suggest::nearest;
use crate::syntax::token::{Sym, Tok};
use cga_split::files::places;
use std::collections::{BTreeSet, HashMap, HashSet};

/// The maximum number of names looked up in folders. Nothing is known about the remaining files.
const MOST: usize = 4000;

/// The known properties of a file that rules name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Asset {
    /// The file does not exist; one of these names may have been meant.
    Missing(Vec<String>),
    /// The file exists.
    There,
    /// The file is a mesh.
    Mesh {
        /// True if it has faces.
        has_faces: bool,
        /// The names of its groups.
        groups: Vec<String>,
        /// The names of its materials.
        materials: Vec<String>,
    },
}

impl Asset {
    /// Reads the statements of an OBJ file (*Asset search*; groups are `g` and `o`, materials `usemtl`).
    pub fn obj(text: &str) -> Asset {
        let (mut has_faces, mut groups, mut materials) = (false, Vec::new(), Vec::new());
        for line in text.split(['\n', '\r']).map(|line| line.split('#').next().unwrap_or_default().trim()) {
            let (keyword, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
            let list = match keyword.to_ascii_lowercase().as_str() {
                "g" | "o" => &mut groups,
                "usemtl" => &mut materials,
                "f" => {
                    has_faces = true;
                    continue;
                }
                _ => continue,
            };
            let name = rest.trim();
            if !name.is_empty() && !list.iter().any(|known| known == name) {
                list.push(name.to_owned());
            }
        }
        Asset::Mesh { has_faces, groups, materials }
    }
}

/// The files named by the strings of a program.
#[derive(Default)]
pub(crate) struct Assets {
    /// By folder of the rule file, then by name.
    by_name: HashMap<String, HashMap<String, Asset>>,
    /// Files whose existence the rules test.
    asked_for: HashSet<String>,
}

impl Assets {
    /// Looks up all strings that look like file names, from the folder of each rule file: a constant may be used in
    /// another file than its own.
    pub(super) fn new(program: &Program, files: &mut dyn Files) -> Assets {
        let mut assets = Assets::default();
        let tokens = program.tokens.as_slice();
        for part in tokens.windows(3) {
            if let [Tok::Ident(word), Tok::Sym(Sym::LParen), Tok::Str(name)] = part
                && asks_for_file(word)
            {
                assets.asked_for.insert(name.clone());
            }
        }
        let mut seen = HashSet::new();
        let names = tokens.iter().filter_map(|token| match token {
            Tok::Str(name) if is_file_name(name) && seen.insert(name.as_str()) => Some(name),
            _ => None,
        });
        let names: Vec<&String> = names.take(MOST).collect();
        let folders: BTreeSet<&str> = program.files.iter().map(|file| folder_of(&file.name)).collect();
        // The known files by path, to look up each path once.
        let mut known = HashMap::new();
        for folder in folders.into_iter().take(MOST / names.len().max(1)) {
            let mut found = HashMap::new();
            for &name in &names {
                if let Some(asset) = look_up(name, folder, files, &mut known) {
                    found.insert(name.clone(), asset);
                }
            }
            assets.by_name.insert(folder.to_owned(), found);
        }
        assets
    }

    /// The known properties of a file named in a rule file in `folder`.
    pub(super) fn of(&self, name: &str, folder: &str) -> Option<&Asset> {
        let may_lack = |asset: &&Asset| matches!(asset, Asset::Missing(_)) && self.asked_for.contains(name);
        self.by_name.get(folder)?.get(name).filter(|asset| !may_lack(asset))
    }
}

/// The known properties of the file that a run would use.
fn look_up(
    name: &str,
    folder: &str,
    files: &mut dyn Files,
    known: &mut HashMap<String, Option<Asset>>,
) -> Option<Asset> {
    let mut others = Vec::new();
    for place in places(name, folder)? {
        match known.entry(place).or_insert_with_key(|place| files.asset(place).map(|asset| with_nearest(asset, name))) {
            Some(Asset::Missing(names)) => others.extend(names.iter().cloned()),
            found => return found.clone(),
        }
    }
    Some(Asset::Missing(others))
}

/// Reduces the names of a missing file to the nearest one, because a folder may have hundreds.
fn with_nearest(asset: Asset, name: &str) -> Asset {
    let Asset::Missing(names) = asset else { return asset };
    let mut names: Vec<String> = names.iter().map(|other| beside(name, other)).filter(|other| other != name).collect();
    // The order of a folder listing is undefined.
    names.sort_unstable();
    Asset::Missing(nearest(name, names.iter().map(String::as_str)).map(str::to_owned).into_iter().collect())
}

/// The name of a file in the folder of another one, as rules write it.
fn beside(name: &str, other: &str) -> String {
    let folder = name.rfind('/').map_or("", |at| &name[..=at]);
    format!("{folder}{}", other.rsplit('/').next().unwrap_or(other))
}

/// Returns true for the name of a function that tests the existence of a file.
fn asks_for_file(word: &str) -> bool {
    let asks = |param: &Param| param.kind == ParamKind::File(FileUse::Asked);
    ops::functions(word).any(|row| row.params.first().is_some_and(asks))
}

/// Returns true if a string is a file name below a folder and not the name of a rule file.
fn is_file_name(text: &str) -> bool {
    let Some((stem, extension)) = text.rsplit_once('.') else { return false };
    let is_extension = (2..=5).contains(&extension.len()) && extension.bytes().all(|byte| byte.is_ascii_alphanumeric());
    let inside = text.strip_prefix('/').unwrap_or(text);
    let leaves = inside.split('/').any(|part| matches!(part, ".." | ""));
    let is_plain = !text.contains(['\\', ':', '*', '?', '\n', '"', '<', '>', '|', '$']);
    is_extension && is_plain && !leaves && !stem.is_empty() && !extension.eq_ignore_ascii_case("cga")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_told_from_other_text() {
        for name in ["tree.obj", "facade/brick wall.jpg", "a.b.png", "table.csv", "/lib/tree.obj"] {
            assert!(is_file_name(name), "{name}");
        }
        for text in
            ["tree", "builtin:cube", "../tree.obj", "//tree.obj", "a//b.png", ".obj", "3.5", "roof.x", "lib.cga"]
        {
            assert!(!is_file_name(text), "{text}");
        }
    }

    #[test]
    fn an_obj_file_names_its_groups_and_materials() {
        let found = Asset::obj(
            "# tree\nmtllib tree.mtl\nv 0 0 0\no Tree\ng  Bark # rough\nusemtl Brown\nf 1 2 3\ng\nG Leaves\ng Bark\n",
        );
        let Asset::Mesh { has_faces, groups, materials } = found else { panic!("a mesh") };
        assert!(has_faces);
        assert_eq!(
            (groups, materials),
            (vec!["Tree".into(), "Bark".into(), "Leaves".into()], vec!["Brown".to_string()])
        );
    }
}
