//! Images that several files share: each has an address in place of its bytes.

use std::fmt;
use std::sync::Arc;

use super::Glb;
use crate::asset::image::header::ImageKind;

/// The address of an image by its ending and its bytes.
type AddressOf = dyn Fn(&str, &[u8]) -> Option<String> + Send + Sync;

/// The addresses of images that several files share.
#[derive(Clone)]
pub(super) struct SharedImages(Arc<AddressOf>);

impl fmt::Debug for SharedImages {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("SharedImages")
    }
}

impl SharedImages {
    pub(super) fn address(&self, kind: ImageKind, bytes: &[u8]) -> Option<String> {
        let ending = match kind {
            ImageKind::Png => "png",
            ImageKind::Jpeg => "jpg",
        };
        (self.0)(ending, bytes)
    }
}

impl Glb {
    /// Calls a function with each image that the file would embed: with the ending of a file of its kind, `png` or `jpg`, and its bytes. If
    /// the function returns an address, relative to the file and escaped as in links, the file refers to it, and the caller writes the image
    /// there. So files of one city share their images. The file embeds images for which the function returns `None`.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use std::sync::{Arc, Mutex};
    ///
    /// use cga::sink::gltf::Glb;
    ///
    /// let images = Arc::new(Mutex::new(Vec::new()));
    /// let list = images.clone();
    /// let glb = Glb::new().with_shared_images(move |ending, bytes| {
    ///     let mut list = list.lock().ok()?;
    ///     list.push(bytes.to_vec());
    ///     Some(format!("images/{}.{ending}", list.len()))
    /// });
    /// assert!(glb.into_bytes().is_ok() && images.lock().unwrap().is_empty());
    /// ```
    pub fn with_shared_images(
        mut self,
        address: impl Fn(&str, &[u8]) -> Option<String> + Send + Sync + 'static,
    ) -> Self {
        self.shared_images = Some(SharedImages(Arc::new(address)));
        self
    }
}
