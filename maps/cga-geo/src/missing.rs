//! Files, columns and attributes that do not exist, with the names that may be meant.

use std::ffi::OsStr;
use std::io::ErrorKind;
use std::path::Path;

use cga_split::suggest::nearest;

use crate::plain;

/// The most entries of a folder that are compared with the name of a missing file.
const MOST_ENTRIES: usize = 10_000;

/// Returns the sentence about a file that cannot be opened. For a file that does not exist, the sentence has the nearest name in its folder, or
/// the names of all files there with one of some endings. Endings have no dot and small letters.
///
/// ```
/// use std::path::Path;
///
/// let error = std::fs::File::open("town/lots.fgb").expect_err("no town");
/// assert_eq!(cga_geo::missing::unopened(Path::new("town/lots.fgb"), &error, &["fgb"]), "the folder `town` does not exist");
/// ```
pub fn unopened(path: &Path, error: &std::io::Error, endings: &[&str]) -> String {
    let name = path.file_name().and_then(OsStr::to_str);
    let (ErrorKind::NotFound, Some(name)) = (error.kind(), name) else { return error.to_string() };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let Ok(entries) = std::fs::read_dir(folder) else {
        return format!("the folder `{}` does not exist", folder.display());
    };
    let entries = entries.take(MOST_ENTRIES).flatten().filter(|entry| entry.path().is_file());
    let mut known: Vec<String> = entries.filter_map(|entry| entry.file_name().into_string().ok()).collect();
    known.retain(|name| has_ending(Path::new(name), endings));
    known.sort_unstable();
    let known = || known.iter().map(String::as_str);
    if let Some(near) = nearest(name, known()) {
        let near = path.with_file_name(near).display().to_string();
        return format!("it does not exist; did you mean `{}`?", plain::plain(&near, 200));
    }
    match known().count() {
        0 => {
            let endings: Vec<String> = endings.iter().map(|ending| format!("`.{ending}`")).collect();
            format!("it does not exist, and its folder has no file {}", endings.join(", "))
        }
        _ => format!("it does not exist; its folder has {}", plain::names(known())),
    }
}

fn has_ending(path: &Path, endings: &[&str]) -> bool {
    let ending = path.extension().and_then(OsStr::to_str).unwrap_or_default();
    endings.iter().any(|known| ending.eq_ignore_ascii_case(known))
}

/// Returns the end of a message about an unknown name: the nearest name, and the names of all.
///
/// ```
/// use cga_geo::missing::names;
///
/// let columns = ["floors", "height"];
/// assert_eq!(names("hight", "the lots", "columns", columns), "did you mean `height`? The columns are `floors`, `height`");
/// assert_eq!(names("roof", "the lots", "columns", columns), "the columns are `floors`, `height`");
/// assert_eq!(names("roof", "the lots", "columns", []), "the lots have no columns");
/// ```
pub fn names<'n>(name: &str, owner: &str, kind: &str, known: impl IntoIterator<Item = &'n str>) -> String {
    let known: Vec<&str> = known.into_iter().collect();
    if known.is_empty() {
        return format!("{owner} have no {kind}");
    }
    let names = plain::names(known.iter().copied());
    match nearest(name, known) {
        Some(near) => format!("did you mean `{}`? The {kind} are {names}", plain::plain(near, 60)),
        None => format!("the {kind} are {names}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_file_has_a_proposal() {
        let folder = tempfile::tempdir().expect("a folder");
        let why = |name: &str| {
            let path = folder.path().join(name);
            let error = std::fs::File::open(&path).map(|_| ()).expect_err("missing");
            unopened(&path, &error, &["fgb", "shp"]).replace(&folder.path().display().to_string(), "FOLDER")
        };
        assert_eq!(why("town.fgb"), "it does not exist, and its folder has no file `.fgb`, `.shp`");
        for name in ["town.fgb", "rural.SHP", "town.txt"] {
            std::fs::write(folder.path().join(name), "").expect("room");
        }
        assert_eq!(why("twon.fgb"), "it does not exist; did you mean `FOLDER/town.fgb`?");
        assert_eq!(why("lots.parquet"), "it does not exist; its folder has `rural.SHP`, `town.fgb`");
        assert_eq!(why("none/town.fgb"), "the folder `FOLDER/none` does not exist");
    }

    #[test]
    fn other_errors_are_told_as_they_are() {
        let error = std::io::Error::from(ErrorKind::PermissionDenied);
        assert_eq!(unopened(Path::new("town.fgb"), &error, &["fgb"]), error.to_string());
    }
}
