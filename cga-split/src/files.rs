//! The places where files named by rules are looked up: meshes, images, tables and text (*Asset search*). The compiler
//! reports names without a file, so it must look in the same places as a run.

/// The number of folders above a rule file that are searched.
const MOST_FOLDERS: usize = 16;

/// The places where a file may be, in order of precedence. Each is a path relative to the asset folder, with forward
/// slashes and without `.`. `None` if the name leads out of the asset folder or ends with a slash.
///
/// A name that begins with `/` is such a path already. Any other name is looked up in the project of the rule file that
/// names it: in the project's folder `assets`, then in the project itself. The boundaries of projects are unknown, so
/// each folder from `folder`, the folder of the rule file, up to the asset folder counts as a project.
///
/// ```
/// let places = cga_split::files::places("tree.obj", "city/rules").expect("it stays inside");
/// assert_eq!(places[..2], ["city/rules/assets/tree.obj", "city/rules/tree.obj"]);
/// assert_eq!(places[4..], ["assets/tree.obj", "tree.obj"]);
/// assert_eq!(cga_split::files::places("/city/tree.obj", "lib"), Some(vec!["city/tree.obj".to_owned()]));
/// assert_eq!(cga_split::files::places("../tree.obj", "lib"), None);
/// ```
pub fn places(name: &str, folder: &str) -> Option<Vec<String>> {
    let path = normal(name).filter(|_| !name.ends_with('/'))?;
    if name.starts_with('/') {
        return Some(vec![path]);
    }
    // A folder outside the asset folder gives no places inside it.
    let folder = if folder.starts_with('/') { None } else { normal(folder) };
    let folder = folder.unwrap_or_default();
    let mut places = Vec::new();
    for above in above(&folder) {
        let slash = if above.is_empty() { "" } else { "/" };
        places.push(format!("{above}{slash}assets/{path}"));
        places.push(format!("{above}{slash}{path}"));
    }
    Some(places)
}

/// A folder and the folders above it, the nearest first. The topmost folder is always included.
fn above(folder: &str) -> impl Iterator<Item = &str> {
    let own = std::iter::successors(Some(folder), |folder| folder.rsplit_once('/').map(|(up, _)| up));
    own.filter(|folder| !folder.is_empty()).take(MOST_FOLDERS).chain([""])
}

/// A path without `.` and doubled slashes. `None` if it leads upwards.
fn normal(path: &str) -> Option<String> {
    let parts = path.split('/').filter(|part| !matches!(*part, "" | "."));
    let parts: Vec<&str> = parts.collect();
    let leads_out = |part: &&str| *part == ".." || is_outside(part);
    (!parts.iter().any(leads_out)).then(|| parts.join("/"))
}

/// Returns true if some platform reads a part of a path as another place: a drive, or several parts in one.
fn is_outside(part: &str) -> bool {
    part.contains(['\\', '\0']) || part.as_bytes().get(1) == Some(&b':')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_folder_of_the_rule_file_comes_first_and_the_asset_folder_last() {
        assert_eq!(places("a.obj", "").unwrap(), ["assets/a.obj", "a.obj"]);
        assert_eq!(
            places("./b//a.obj", "lib").unwrap(),
            ["lib/assets/b/a.obj", "lib/b/a.obj", "assets/b/a.obj", "b/a.obj"]
        );
        let deep = places("a.obj", &"d/".repeat(1000)).unwrap();
        assert_eq!((deep.len(), deep.last().unwrap().as_str()), (2 * MOST_FOLDERS + 2, "a.obj"));
    }

    #[test]
    fn a_path_of_the_workspace_is_not_searched() {
        assert_eq!(places("/ESRI.lib/assets/q.obj", "lib").unwrap(), ["ESRI.lib/assets/q.obj"]);
        assert_eq!(places("//a.obj", "").unwrap(), ["a.obj"]);
    }

    #[test]
    fn no_name_leads_out_or_to_a_folder() {
        for name in ["a/", "..", "../a", "/../a", "a/../../b", "a/..", "C:\\a", "C:/a", "..\\a", "a\0b"] {
            assert_eq!(places(name, "lib"), None, "{name}");
        }
        for folder in ["..", "../up", "/etc", "a/../..", "C:/lib"] {
            assert_eq!(places("a.obj", folder).unwrap(), ["assets/a.obj", "a.obj"], "{folder}");
        }
    }
}
