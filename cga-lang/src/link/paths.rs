//! The possible paths of an imported file.

use crate::suggest::nearest;

/// The maximum number of folders above the importing file that are searched.
const MOST_FOLDERS: usize = 16;

/// The ending of the names of rule files.
const ENDING: &str = ".cga";

/// The possible names of a file that `from` imports as `path`, the likeliest first. All names are written with `/`.
///
/// A path is relative to the folder of the importing file, to a folder above it, or to the `assets` folder in one of
/// these (*Asset search*: the project's assets, then the project). A path with a leading `/` is a path of a
/// workspace, and its first part is the name of a project (*import*). It is also relative to the folders above, with
/// and without its first part.
pub fn candidates(path: &str, from: &str) -> Vec<String> {
    let path = path.replace('\\', "/");
    let from = from.replace('\\', "/");
    let mut folders: Vec<&str> = Vec::new();
    let mut folder = from.rsplit_once('/').map_or("", |(folder, _)| folder);
    loop {
        folders.push(folder);
        if folder.is_empty() || folders.len() == MOST_FOLDERS {
            break;
        }
        folder = folder.rsplit_once('/').map_or("", |(folder, _)| folder);
    }
    let root = if from.starts_with('/') { "/" } else { "" };
    let join = |folder: &str, path: &str| match folder {
        "" => normal(&format!("{root}{path}")),
        folder => normal(&format!("{folder}/{path}")),
    };
    let mut list: Vec<String> = Vec::new();
    match path.strip_prefix('/') {
        Some(inside) => {
            let without = inside.split_once('/').map(|(_, rest)| rest);
            for folder in folders {
                list.extend([Some(inside), without].into_iter().flatten().map(|path| join(folder, path)));
            }
        }
        None => {
            for folder in folders {
                list.push(join(folder, &path));
                list.push(join(folder, &format!("assets/{path}")));
            }
        }
    }
    let mut seen = std::collections::HashSet::new();
    list.retain(|name| seen.insert(name.clone()));
    list
}

/// The folder of the file that `from` imports as `path`, if it is relative to the importing file.
pub fn folder(path: &str, from: &str) -> String {
    let name = candidates(path, from).swap_remove(0);
    name.rsplit_once('/').map_or(String::new(), |(folder, _)| if folder.is_empty() { "/" } else { folder }.to_owned())
}

/// Returns the first character in the name of a rule file that CGA does not allow (*CGA changelog 2023.0*).
pub fn stray_character(path: &str) -> Option<char> {
    let name = path.rsplit(['/', '\\']).next()?;
    name.strip_suffix(ENDING)?.chars().find(|character| matches!(character, '$' | '[' | ';' | '.'))
}

/// The path of the most similar rule file among the names of files in its folder.
pub(super) fn like(path: &str, names: &[String]) -> Option<String> {
    let (folder, name) = path.split_at(path.rfind(['/', '\\']).map_or(0, |slash| slash + 1));
    let others = names.iter().filter(|other| *other != name).filter_map(|other| other.strip_suffix(ENDING));
    let near = nearest(name.strip_suffix(ENDING)?, others)?;
    Some(format!("{folder}{near}{ENDING}"))
}

/// The path of a file with `/`, without `.` and without `..` where possible.
///
/// ```
/// assert_eq!(cga_lang::link::normal("./lib\\..//a.cga"), "a.cga");
/// ```
pub fn normal(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split(['/', '\\']) {
        match part {
            "" | "." => {}
            ".." if parts.last().is_some_and(|last| *last != "..") => _ = parts.pop(),
            part => parts.push(part),
        }
    }
    format!("{}{}", if path.starts_with(['/', '\\']) { "/" } else { "" }, parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::{candidates, folder, like, stray_character};

    #[test]
    fn a_name_like_it_is_found_in_the_folder() {
        let names = ["imp.cga", "walls.cga", "wall.txt"].map(str::to_owned);
        assert_eq!(like("Imp.cga", &names).as_deref(), Some("imp.cga"));
        assert_eq!(like("../lib/wals.cga", &names).as_deref(), Some("../lib/walls.cga"));
        assert_eq!(like("roof.cga", &names), None);
        assert_eq!(folder("../lib/x.cga", "city/rules/a.cga"), "city/lib");
        assert_eq!(folder("x.cga", "a.cga"), "");
        assert_eq!(folder("x.cga", "/a.cga"), "/");
    }

    #[test]
    fn a_stray_character_is_one_of_the_name_alone() {
        for (path, found) in [("a.v2.cga", Some('.')), ("b/a$.cga", Some('$')), ("a[1].cga", Some('[')), (".cga", None)]
        {
            assert_eq!(stray_character(path), found, "{path}");
        }
        assert_eq!(stray_character("../lib$/v.1/a-b_c.cga"), None);
        assert_eq!(stray_character("a.b.txt"), None);
    }

    #[test]
    fn the_importing_files_folder_comes_first() {
        assert_eq!(
            candidates("x.cga", "city/rules/a.cga"),
            ["city/rules/x.cga", "city/rules/assets/x.cga", "city/x.cga", "city/assets/x.cga", "x.cga", "assets/x.cga"]
        );
        assert_eq!(candidates("../b/./x.cga", "rules/a.cga")[0], "b/x.cga");
        assert_eq!(candidates("x.cga", "a.cga"), ["x.cga", "assets/x.cga"]);
        assert_eq!(candidates("x.cga", "/p/a.cga")[0], "/p/x.cga");
    }

    #[test]
    fn a_path_of_a_workspace_may_begin_with_the_project() {
        let list = candidates("/city/rules/x.cga", "city/rules/a.cga");
        assert!(list.contains(&"city/rules/x.cga".to_owned()) && list.contains(&"rules/x.cga".to_owned()), "{list:?}");
        assert_eq!(candidates("/x.cga", ""), ["x.cga"]);
    }

    #[test]
    fn what_leads_out_stays_visible() {
        assert_eq!(candidates("../../x.cga", "a/b.cga")[0], "../x.cga");
        assert!(candidates("x.cga", &"a/".repeat(10_000)).len() <= 2 * super::MOST_FOLDERS);
    }
}
