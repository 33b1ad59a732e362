//! Sources of files other than a folder.

use std::borrow::{Borrow, Cow};
use std::collections::BTreeMap;

/// Files by name, for programs without a folder of assets: packed games, and programs in a browser.
///
/// A name is a path below the top of the assets, with forward slashes and without a slash in front: `trees/oak.glb`.
/// Meshes, images, tables and text files all come from here, also files that other files name, such as the images of a
/// mesh. A source gives the same bytes each time; runs keep what they have read.
///
/// Maps and lists of names and bytes are sources:
///
/// ```
/// # use cga_runtime::facade as cga;
/// use cga::Assets;
///
/// let triangle = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// let assets = Assets::from_source([("signs/triangle.obj", triangle.as_slice())]);
/// # #[cfg(feature = "obj")]
/// assert_eq!(assets.mesh("signs/triangle.obj")?.area(), 0.5);
/// assert!(assets.mesh("signs/circle.obj").is_err());
/// # Ok::<(), cga_runtime::asset::AssetError>(())
/// ```
pub trait AssetSource: Send + Sync {
    /// The bytes of the file with a name; `None` for an unknown name.
    fn bytes(&self, name: &str) -> Option<Cow<'_, [u8]>>;

    /// The names of all files, in any order, for functions such as `fileSearch`.
    fn names(&self) -> Vec<String>;

    /// Returns true if a file has this name.
    fn has(&self, name: &str) -> bool {
        self.bytes(name).is_some()
    }
}

impl<N: Borrow<str> + Ord + Send + Sync, B: AsRef<[u8]> + Send + Sync> AssetSource for BTreeMap<N, B> {
    fn bytes(&self, name: &str) -> Option<Cow<'_, [u8]>> {
        self.get(name).map(|bytes| Cow::Borrowed(bytes.as_ref()))
    }

    fn names(&self) -> Vec<String> {
        self.keys().map(|name| name.borrow().to_owned()).collect()
    }
}

macro_rules! lists {
    ($($list:ty $(, const $length:ident)?;)*) => {$(
        /// The first file with a name counts.
        impl<N: AsRef<str> + Send + Sync, B: AsRef<[u8]> + Send + Sync $(, const $length: usize)?> AssetSource for $list {
            fn bytes(&self, name: &str) -> Option<Cow<'_, [u8]>> {
                let (_, bytes) = self.iter().find(|(known, _)| known.as_ref() == name)?;
                Some(Cow::Borrowed(bytes.as_ref()))
            }

            fn names(&self) -> Vec<String> {
                self.iter().map(|(name, _)| name.as_ref().to_owned()).collect()
            }
        }
    )*};
}

lists! {
    Vec<(N, B)>;
    [(N, B); LENGTH], const LENGTH;
}
