//! The files of a tile: a GLB, and beside it a description with a digest of all that the tile depends on.

use std::io;

use serde::{Deserialize, Serialize};

use crate::content::{Content, LotProblem};
use crate::glb_bounds::Bounds;
use crate::store::{Store, digest_of};

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

/// The name of the description of a tile.
pub fn description(glb: &str) -> String {
    format!("{}.json", glb.strip_suffix(".glb").unwrap_or(glb))
}

impl TileFile {
    /// The description of a finished tile. `None` if it must be made: it does not exist, has another digest, or its file is damaged.
    pub fn finished(store: &dyn Store, glb: &str, digest: &str) -> Option<Self> {
        let found: TileFile = serde_json::from_slice(&store.read(&description(glb)).ok()??).ok()?;
        let is_whole = || found.bytes == 0 || store.is_whole(glb, found.bytes, &found.content);
        (found.digest == digest && is_whole()).then_some(found)
    }

    /// Writes a tile. The description comes last, so a tile with a description is whole.
    ///
    /// # Errors
    /// Errors of the store.
    pub fn write(store: &dyn Store, glb: &str, digest: String, content: Option<Content>) -> io::Result<Self> {
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
            store.delete(glb)?;
        } else {
            store.write(glb, content.glb)?;
        }
        store.write(&description(glb), serde_json::to_vec(&file)?)?;
        Ok(file)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::Folder;

    #[test]
    fn a_tile_is_finished_if_its_digest_and_its_file_are_whole() {
        let folder = tempfile::tempdir().expect("a folder");
        let (store, name) = (Folder(folder.path().to_owned()), "0/1/2.glb");
        let damage = |bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).expect("room");
        let content = Content {
            glb: vec![7; 100],
            bounds: Bounds { low: [0.1, 0.2, 0.3], high: [1.0 / 3.0, 2.0, 3.0] },
            buildings: 3,
            problems: vec![LotProblem { id: "a".into(), is_lost: true, reason: "why".into() }],
            problems_left_out: 0,
        };
        assert_eq!(TileFile::finished(&store, name, "d"), None);
        let written = TileFile::write(&store, name, "d".into(), Some(content)).expect("room");
        assert_eq!(TileFile::finished(&store, name, "d"), Some(written));
        assert_eq!(TileFile::finished(&store, name, "e"), None);
        damage(&[7; 99]);
        assert_eq!(TileFile::finished(&store, name, "d"), None);
        damage(&[0; 100]);
        assert_eq!(TileFile::finished(&store, name, "d"), None);
        let divided = TileFile::write(&store, name, "d".into(), None).expect("room");
        assert!(divided.is_divided && !folder.path().join(name).exists());
        assert_eq!(TileFile::finished(&store, name, "d"), Some(divided));
    }
}
