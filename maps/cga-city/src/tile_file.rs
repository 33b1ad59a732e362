//! The files of a tile: a GLB, and beside it a description with a digest of all that the tile depends on.

use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::content::{Content, LotProblem};
use crate::glb_bounds::Bounds;

/// The description of a tile.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TileFile {
    /// The digest of the lots, the rules, the level and the program, in hexadecimal digits.
    pub digest: String,
    /// True if the lots make more bytes than a tile may have. Then there is no file, and the quarters of the cell have tiles.
    pub is_divided: bool,
    /// The bytes of the file; 0 without a file.
    pub bytes: u64,
    /// The digest of the file, in hexadecimal digits.
    pub content: String,
    /// The box around the buildings: the lowest and the highest corner as east, north and up in metres; without a file `None`.
    pub bounds: Option<[[f64; 3]; 2]>,
    /// The number of buildings.
    pub buildings: u64,
    /// The problems of its lots.
    pub problems: Vec<LotProblem>,
    /// The number of problems that are not listed.
    pub problems_left_out: u64,
}

/// The path of the description.
pub fn description(glb: &Path) -> PathBuf {
    glb.with_extension("json")
}

impl TileFile {
    /// The description of a finished tile. `None` if it must be made: it does not exist, has another digest, or its file is damaged.
    pub fn finished(glb: &Path, digest: &str) -> Option<Self> {
        let found: TileFile = serde_json::from_slice(&fs::read(description(glb)).ok()?).ok()?;
        (found.digest == digest && found.is_whole(glb)).then_some(found)
    }

    /// Returns true if the file has its bytes. A file system that was full or without power may have left others, also of the same length.
    fn is_whole(&self, glb: &Path) -> bool {
        if self.bytes == 0 {
            return true;
        }
        let has_length = fs::metadata(glb).is_ok_and(|file| file.len() == self.bytes);
        has_length && fs::read(glb).is_ok_and(|bytes| digest_of(&bytes) == self.content)
    }

    /// Writes a tile. The description comes last, so a tile with a description is whole.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn write(glb: &Path, digest: String, content: Option<Content>) -> io::Result<Self> {
        let is_divided = content.is_none();
        let content = content.unwrap_or_else(|| Content {
            glb: Vec::new(),
            bounds: Bounds::EMPTY,
            buildings: 0,
            problems: Vec::new(),
            problems_left_out: 0,
        });
        let file = TileFile {
            digest,
            is_divided,
            bytes: content.glb.len() as u64,
            content: digest_of(&content.glb),
            bounds: (!content.glb.is_empty()).then_some([content.bounds.low, content.bounds.high]),
            buildings: content.buildings,
            problems: content.problems,
            problems_left_out: content.problems_left_out,
        };
        if content.glb.is_empty() {
            remove(glb)?;
        } else {
            write(glb, &content.glb)?;
        }
        write(&description(glb), &serde_json::to_vec(&file)?)?;
        Ok(file)
    }
}

fn digest_of(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

/// Writes a file with its folders. A reader sees the old file or the new one, never a part.
///
/// # Errors
/// Errors of the file system.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let mut builder = tempfile::Builder::new();
    // A server may run as another user.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.prefix(".part-").tempfile_in(folder)?;
    file.write_all(bytes)?;
    file.persist(path)?;
    Ok(())
}

fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(why) if why.kind() != io::ErrorKind::NotFound => Err(why),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tile_is_finished_if_its_digest_and_its_file_are_whole() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("0/1/2.glb");
        let content = Content {
            glb: vec![7; 100],
            bounds: Bounds { low: [0.1, 0.2, 0.3], high: [1.0 / 3.0, 2.0, 3.0] },
            buildings: 3,
            problems: vec![LotProblem { id: "a".into(), is_lost: true, reason: "why".into() }],
            problems_left_out: 0,
        };
        assert_eq!(TileFile::finished(&path, "d"), None);
        let written = TileFile::write(&path, "d".into(), Some(content)).expect("room");
        assert_eq!(TileFile::finished(&path, "d"), Some(written));
        assert_eq!(TileFile::finished(&path, "e"), None);
        fs::write(&path, [7; 99]).expect("room");
        assert_eq!(TileFile::finished(&path, "d"), None);
        fs::write(&path, [0; 100]).expect("room");
        assert_eq!(TileFile::finished(&path, "d"), None);
        let divided = TileFile::write(&path, "d".into(), None).expect("room");
        assert!(divided.is_divided && !path.exists());
        assert_eq!(TileFile::finished(&path, "d"), Some(divided));
    }
}
