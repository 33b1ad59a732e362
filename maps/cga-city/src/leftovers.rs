//! Files of earlier runs that do not belong to the city.

use std::fs;
use std::io;
use std::path::Path;

use crate::images::is_image;

/// The folders of tiles, of blocks, of areas and of images.
const FOLDERS: [&str; 4] = ["tiles", "sets", "areas", "images"];

/// Deletes files of tiles and blocks of earlier runs that are not part of the city, and folders that become empty. `is_part` gets names
/// relative to the folder of the city, with `/`. Links are not followed, and files with other names stay.
///
/// # Errors
/// Errors of the file system.
pub fn delete_others(city: &Path, is_part: &dyn Fn(&str) -> bool) -> io::Result<()> {
    // Also files that a killed run had begun to write.
    let is_other = |name: &str| (is_part_of_file(name) || is_made(name)) && !is_part(name);
    FOLDERS.iter().try_for_each(|part| delete_below(city, part, &is_other))
}

/// Returns true if a run had begun to write a file when it was killed.
pub(crate) fn is_part_of_file(name: &str) -> bool {
    name.rsplit('/').next().is_some_and(|own| own.starts_with(".part-"))
}

/// Returns true if a run may write or delete a file or a folder with a name relative to the folder of the city, with `/`.
pub fn is_of_city(name: &str) -> bool {
    FOLDERS.iter().any(|folder| name == *folder || name.starts_with(&format!("{folder}/")))
        || ["cga-city.json", "problems.jsonl", "tileset.json"].contains(&name)
        || name.starts_with(".lots-")
}

/// Deletes the files of a folder of a city that a function chooses by their names, and folders that become empty. Links are not followed.
///
/// # Errors
/// Errors of the file system.
pub(crate) fn delete_below(city: &Path, folder: &str, is_other: &dyn Fn(&str) -> bool) -> io::Result<()> {
    let path = city.join(folder);
    if !fs::symlink_metadata(&path).is_ok_and(|found| found.is_dir()) {
        return Ok(());
    }
    for entry in fs::read_dir(path)? {
        let entry = entry?;
        let kind = entry.file_type()?;
        let name = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if kind.is_dir() {
            delete_below(city, &name, is_other)?;
            // A folder with files stays.
            let _ = fs::remove_dir(entry.path());
        } else if kind.is_file() && is_other(&name) {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

/// Returns true for the name of a tile, of its description, of a block, of an area, or of an image.
///
/// Names such as `tiles/0/17/69000/43000.glb`, `tiles/0/28/1/2ab.json` and `sets/12/2157/1343.json`.
pub fn is_made(name: &str) -> bool {
    let is_number = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let Some((path, ending)) = name.rsplit_once('.') else { return false };
    if is_image(name) {
        return true;
    }
    let parts: Vec<&str> = path.split('/').collect();
    // Halves of the lots of a smallest cell have letters.
    let is_row = |row: &str| is_number(row.trim_end_matches(['a', 'b']));
    match parts[..] {
        ["tiles", level, zoom, column, row] => {
            ["glb", "json"].contains(&ending) && [level, zoom, column].into_iter().all(is_number) && is_row(row)
        }
        ["sets" | "areas", zoom, column, row] => {
            ending == "json" && [zoom, column].into_iter().all(is_number) && is_row(row)
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_tiles_and_blocks_are_known() {
        for name in [
            "tiles/0/17/69000/43000.glb",
            "tiles/12/28/1/2ab.json",
            "sets/12/2157/1343.json",
            "sets/28/1/2ba.json",
            "areas/5/16/10.json",
        ] {
            assert!(is_made(name) && is_of_city(name), "{name}");
        }
        for name in
            ["tiles/0/17/house.glb", "tiles/0/1/2/3.txt", "sets/0/1/2/3.json", "tiles/0/1/2/a.glb", "sets/0/1/a.json"]
        {
            assert!(!is_made(name), "{name}");
        }
        assert!(is_of_city("tiles") && is_of_city("sets") && is_of_city("tiles/trees") && !is_of_city("tilesets"));
        assert!(is_of_city("tileset.json") && !is_of_city("town.cga") && !is_of_city("tiles.json"));
    }
}
