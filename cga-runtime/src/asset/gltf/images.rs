//! The images of a file. Images in other files keep their names; embedded ones get a name from their number.

use std::collections::{BTreeSet, HashMap};

use super::GltfError;
use super::document::Document;
use crate::asset::embedded_image::EmbeddedImage;
use crate::asset::image::header::{self, ImageKind};
use crate::value::text::Text;

/// The images that materials use.
#[derive(Default)]
pub(super) struct MaterialImages {
    /// By the number in the file. `None` for an image that cannot be shown.
    by_index: HashMap<usize, Option<Text>>,
    /// The names of images of views, by the view. Several images may have one view.
    by_view: HashMap<usize, Option<Text>>,
    /// The names of images with an alpha channel.
    with_alpha: BTreeSet<Text>,
    /// The names of images in files of their own.
    files: BTreeSet<Text>,
    bytes_of_views: usize,
    /// The embedded images, in the order of their first use.
    pub(super) embedded: Vec<EmbeddedImage>,
    /// The numbers of images that are neither PNG nor JPEG.
    pub(super) unknown: Vec<usize>,
}

impl MaterialImages {
    /// The name of an image that was added.
    pub(super) fn known(&self, index: usize) -> Option<Option<&Text>> {
        self.by_index.get(&index).map(Option::as_ref)
    }

    /// Returns true if the image with a name has an alpha channel.
    pub(super) fn has_alpha(&self, name: Option<&Text>) -> bool {
        name.is_some_and(|name| self.with_alpha.contains(name))
    }

    /// Adds an image in a file of its own. `has_alpha` looks into the file, once for each name.
    pub(super) fn refer(&mut self, index: usize, name: &str, has_alpha: impl FnOnce() -> bool) -> Option<Text> {
        let name = Text::from(name);
        let has_alpha = self.files.insert(name.clone()) && has_alpha();
        self.add(index, name, has_alpha)
    }

    /// Adds an image in a view, whose bytes are copied once.
    ///
    /// # Errors
    /// The views of all images have more bytes than the file.
    pub(super) fn embed_view(
        &mut self,
        index: usize,
        view: usize,
        document: &Document<'_>,
    ) -> Result<Option<Text>, GltfError> {
        if let Some(name) = self.by_view.get(&view).cloned() {
            self.by_index.insert(index, name.clone());
            return Ok(name);
        }
        let bytes = document.view(view)?.bytes;
        self.bytes_of_views += bytes.len();
        if document.byte_count() < self.bytes_of_views {
            return Err(GltfError::item("images", index, "the data of images overlap"));
        }
        let name = self.embed(index, bytes);
        self.by_view.insert(view, name.clone());
        Ok(name)
    }

    /// Adds an embedded image. `None` if it is neither PNG nor JPEG.
    pub(super) fn embed(&mut self, index: usize, bytes: &[u8]) -> Option<Text> {
        let Ok(header) = header::header(bytes) else {
            self.unknown.push(index);
            self.by_index.insert(index, None);
            return None;
        };
        let end = match header.kind {
            ImageKind::Png => "png",
            ImageKind::Jpeg => "jpg",
        };
        let name = format!("#{index}.{end}");
        self.embedded.push(EmbeddedImage { name: name.clone(), bytes: bytes.to_vec() });
        self.add(index, Text::from(name), header.has_alpha)
    }

    fn add(&mut self, index: usize, name: Text, has_alpha: bool) -> Option<Text> {
        if has_alpha {
            self.with_alpha.insert(name.clone());
        }
        self.by_index.insert(index, Some(name.clone()));
        Some(name)
    }
}
