//! The files of a tile: a GLB, and beside it a description with a digest of all that the tile depends on.

use std::io;

use serde::{Deserialize, Serialize};

use crate::content::{Content, LotProblem};
use crate::images;
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
    /// The names and the bytes of the images that it shares with other tiles.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub images: Vec<(String, u64)>,
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
        let has_images = || found.images.iter().all(|(name, bytes)| images::is_whole(store, name, *bytes));
        let is_whole = || found.bytes == 0 || store.is_whole(glb, found.bytes, &found.content) && has_images();
        (found.digest == digest && is_whole()).then_some(found)
    }

    /// Writes a tile. The old description is deleted first and the new one comes last, so a description never belongs to another file, also
    /// after a run that was stopped.
    ///
    /// # Errors
    /// Errors of the store.
    pub fn write(store: &dyn Store, glb: &str, digest: String, content: Option<Content>) -> io::Result<Self> {
        let is_divided = content.is_none();
        let content = content.unwrap_or_default();
        let file = TileFile {
            digest,
            is_divided,
            bytes: content.glb.len() as u64,
            content: digest_of(&content.glb),
            images: content.images.iter().map(|(name, bytes)| (name.clone(), bytes.len() as u64)).collect(),
            bounds: (!content.glb.is_empty()).then_some([content.bounds.low, content.bounds.high]),
            buildings: content.buildings,
            problems: content.problems,
            problems_left_out: content.problems_left_out,
        };
        let description = description(glb);
        store.delete(&description)?;
        if content.glb.is_empty() {
            store.delete(glb)?;
        } else {
            images::write(store, content.images)?;
            store.write(glb, content.glb)?;
        }
        store.write(&description, serde_json::to_vec(&file)?)?;
        Ok(file)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glb_bounds::Bounds;
    use crate::store::Folder;

    /// A store that stops before the description of a tile, and compares sizes as remote stores do.
    struct Stopped(Folder);

    impl Store for Stopped {
        fn read(&self, name: &str) -> io::Result<Option<Vec<u8>>> {
            self.0.read(name)
        }

        fn write(&self, name: &str, bytes: Vec<u8>) -> io::Result<()> {
            if name.ends_with(".json") {
                return Err(io::Error::other("stopped"));
            }
            self.0.write(name, bytes)
        }

        fn delete(&self, name: &str) -> io::Result<()> {
            self.0.delete(name)
        }

        fn is_whole(&self, name: &str, count: u64, _: &str) -> bool {
            matches!(self.read(name), Ok(Some(bytes)) if bytes.len() as u64 == count)
        }
    }

    #[test]
    fn a_tile_that_is_half_written_has_no_description() {
        let folder = tempfile::tempdir().expect("a folder");
        let (store, name) = (Folder(folder.path().to_owned()), "0/1/2.glb");
        let content = |byte: u8| Content {
            glb: vec![byte; 100],
            bounds: Bounds { low: [0.0; 3], high: [1.0; 3] },
            buildings: 1,
            ..Content::default()
        };
        TileFile::write(&store, name, "d".into(), Some(content(7))).expect("room");
        let stopped = Stopped(store);
        assert!(TileFile::finished(&stopped, name, "d").is_some());
        TileFile::write(&stopped, name, "e".into(), Some(content(8))).expect_err("stopped");
        // The file has other bytes of the same number.
        assert_eq!(TileFile::finished(&stopped, name, "d"), None);
    }

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
            ..Content::default()
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
