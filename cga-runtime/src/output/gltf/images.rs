//! The images of a file, each once: embedded, or referenced by relative address.

use std::collections::HashMap;
use std::fmt::Write as _;

use super::binary::BinaryChunk;
use super::combine;
use super::json::quoted;
use super::shared_images::SharedImages;
use super::textures::{ImageKey, LookTexture};
use crate::asset::Assets;
use crate::asset::image::header::ImageKind;
use crate::output::interner::Interner;
use crate::output::texture::source::{self, ImageSource};

/// The images in the order in which looks first use them. Every image has one texture with the same number.
#[derive(Debug, Default)]
pub(super) struct Images<'a> {
    assets: Option<&'a Assets>,
    is_referenced: bool,
    shared: Option<&'a SharedImages>,
    images: Interner<GltfImage>,
    /// Only for look-ups, never iterated.
    by_key: HashMap<ImageKey, Option<usize>>,
}

#[derive(Debug, PartialEq, Hash)]
enum GltfImage {
    Referenced(String),
    Embedded { kind: ImageKind, bytes: Vec<u8> },
}

impl<'a> Images<'a> {
    /// The images of some textures.
    pub(super) fn of<'t>(
        textures: impl Iterator<Item = &'t LookTexture>,
        assets: Option<&'a Assets>,
        is_referenced: bool,
        shared: Option<&'a SharedImages>,
    ) -> Self {
        let mut images = Images { assets, is_referenced, shared, ..Images::default() };
        for texture in textures {
            images.add(&texture.image, texture.layer.shows_checkers());
        }
        images
    }

    /// The number of an image, if the file has it.
    pub(super) fn number(&self, key: &ImageKey) -> Option<usize> {
        self.by_key.get(key).copied().flatten()
    }

    /// The number of an image. If `shows_checkers`, a checker pattern takes the place of a broken file; else it is left out.
    fn add(&mut self, key: &ImageKey, shows_checkers: bool) -> Option<usize> {
        if let Some(known) = self.by_key.get(key) {
            return *known;
        }
        let number = match key {
            ImageKey::File(name) => match self.file(name, shows_checkers) {
                Some(GltfImage::Embedded { kind, bytes }) => Some(self.whole(kind, bytes)),
                image => image.map(|image| self.images.index(image)),
            },
            key => match combine::combined(self.assets, key) {
                Some(bytes) => Some(self.whole(ImageKind::Png, bytes)),
                None => key.file().and_then(|name| self.add(&ImageKey::File(name.clone()), shows_checkers)),
            },
        };
        self.by_key.insert(key.clone(), number);
        number
    }

    /// The number of an image with its bytes: by an address that several files share, or embedded.
    fn whole(&mut self, kind: ImageKind, bytes: Vec<u8>) -> usize {
        let address = self.shared.and_then(|shared| shared.address(kind, &bytes));
        self.images.index(address.map_or(GltfImage::Embedded { kind, bytes }, GltfImage::Referenced))
    }

    fn file(&self, name: &str, shows_checkers: bool) -> Option<GltfImage> {
        let has_file = || !name.starts_with("builtin:") && !self.assets.is_some_and(|assets| assets.is_embedded(name));
        if self.is_referenced && has_file() {
            return Some(GltfImage::Referenced(uri(name)));
        }
        Some(match source::find(self.assets, name) {
            ImageSource::File(header, bytes) => GltfImage::Embedded { kind: header.kind, bytes },
            ImageSource::Drawn(_) if !shows_checkers && !name.starts_with("builtin:") => return None,
            ImageSource::Drawn(image) => GltfImage::Embedded { kind: ImageKind::Png, bytes: combine::encoded(&image)? },
            ImageSource::Absent => GltfImage::Referenced(uri(name)),
        })
    }

    /// The members `textures` and `images`, each followed by a comma, and the views of embedded images.
    pub(super) fn write(self, json: &mut String, binary: &mut BinaryChunk<'_>) {
        if self.images.list.is_empty() {
            return;
        }
        let sources: Vec<String> =
            (0..self.images.list.len()).map(|number| format!("{{\"source\":{number}}}")).collect();
        let images = self.images.list.into_iter().map(|image| match image {
            GltfImage::Referenced(address) => format!("{{\"uri\":{}}}", quoted(&address)),
            GltfImage::Embedded { kind, bytes } => {
                let kind = match kind {
                    ImageKind::Png => "image/png",
                    ImageKind::Jpeg => "image/jpeg",
                };
                let view = binary.view(bytes.len(), "", move |to| to.bytes(&bytes, 0));
                format!("{{\"bufferView\":{view},\"mimeType\":\"{kind}\"}}")
            }
        });
        let images: Vec<String> = images.collect();
        let _ = write!(json, "\"textures\":[{}],\"images\":[{}],", sources.join(","), images.join(","));
    }
}

/// A path as a relative reference: with forward slashes, and all but the unreserved characters escaped.
fn uri(path: &str) -> String {
    let mut text = String::new();
    // A leading slash means the asset folder, which a reader does not know.
    for byte in path.strip_prefix('/').unwrap_or(path).bytes() {
        match byte {
            b'\\' => text.push('/'),
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => text.push(byte.into()),
            _ => text += &format!("%{byte:02X}"),
        }
    }
    text
}
