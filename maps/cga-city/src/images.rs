//! Images that the tiles of a city share: each is one file `images/DIGEST.png`, however many tiles show it.

use std::collections::BTreeMap;
use std::io;
use std::sync::{Arc, Mutex, PoisonError};

use crate::store::{Store, digest_of};

/// Smaller images stay in the tiles: the address of an image and a request of a browser cost as much.
const LEAST_BYTES: usize = 1 << 10;

/// The way from the folder of a tile to the folder of the city.
const CITY: &str = "../../../..";

/// Images by their names, as in `images/DIGEST.png`.
pub type Images = BTreeMap<String, Vec<u8>>;

/// The images of a tile that is being made.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileImages(Arc<Mutex<Images>>);

impl TileImages {
    /// Takes an image. Returns its address in a tile; `None` for one that stays in the tile.
    pub(crate) fn take(&self, ending: &str, bytes: &[u8]) -> Option<String> {
        if bytes.len() < LEAST_BYTES {
            return None;
        }
        let name = format!("images/{}.{ending}", digest_of(bytes));
        let address = format!("{CITY}/{name}");
        self.0.lock().unwrap_or_else(PoisonError::into_inner).entry(name).or_insert_with(|| bytes.to_vec());
        Some(address)
    }

    /// The images so far.
    pub(crate) fn into_images(self) -> Images {
        std::mem::take(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// The digest in a name of an image.
fn digest_in(name: &str) -> Option<&str> {
    let (digest, ending) = name.strip_prefix("images/")?.split_once('.')?;
    let is_digest =
        digest.len() == 64 && digest.bytes().all(|byte| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte));
    (is_digest && ["png", "jpg"].contains(&ending)).then_some(digest)
}

/// Returns true for the name of an image of a city.
pub fn is_image(name: &str) -> bool {
    digest_in(name).is_some()
}

/// Returns true if a store has an image with its bytes, of a number.
pub(crate) fn is_whole(store: &dyn Store, name: &str, bytes: u64) -> bool {
    digest_in(name).is_some_and(|digest| store.is_whole(name, bytes, digest))
}

/// Writes the images that a store does not have.
///
/// # Errors
/// Errors of the store.
pub(crate) fn write(store: &dyn Store, images: Images) -> io::Result<()> {
    for (name, bytes) in images {
        if !is_whole(store, &name, bytes.len() as u64) {
            store.write(&name, bytes)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::Folder;

    #[test]
    fn images_are_named_by_their_contents_and_small_ones_stay() {
        let images = TileImages::default();
        let [first, second] = [vec![7; 5000], vec![8; 5000]];
        let address = images.take("png", &first).expect("large");
        assert_eq!(images.take("png", &first).as_ref(), Some(&address));
        assert_ne!(images.take("jpg", &second), Some(address.clone()));
        assert_eq!(images.take("png", &[7; 100]), None);
        let images = images.into_images();
        assert_eq!(images.len(), 2);
        assert!(images.keys().all(|name| is_image(name)));
        assert_eq!(address.strip_prefix("../../../../").and_then(|name| images.get(name)), Some(&first));
    }

    #[test]
    fn names_of_other_files_are_not_images() {
        let digest = "0".repeat(64);
        assert!(is_image(&format!("images/{digest}.png")));
        let upper = "A".repeat(64);
        for name in [
            "images/wall.png",
            &format!("images/{digest}.gif"),
            &format!("tiles/{digest}.png"),
            &format!("images/{upper}.jpg"),
        ] {
            assert!(!is_image(name), "{name}");
        }
    }

    #[test]
    fn a_damaged_image_is_written_again() {
        let folder = tempfile::tempdir().expect("a folder");
        let (store, images) = (Folder(folder.path().to_owned()), TileImages::default());
        images.take("png", &[9; 3000]).expect("large");
        let images = images.into_images();
        let name = images.keys().next().expect("an image").clone();
        write(&store, images.clone()).expect("room");
        assert!(is_whole(&store, &name, 3000));
        std::fs::write(folder.path().join(&name), [8; 3000]).expect("room");
        assert!(!is_whole(&store, &name, 3000));
        write(&store, images).expect("room");
        assert!(is_whole(&store, &name, 3000));
    }
}
