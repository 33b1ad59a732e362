//! Images inside mesh files.

/// An image inside a mesh file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmbeddedImage {
    /// Its name in the materials of the mesh: `#`, its number in the file, and `.png` or `.jpg`.
    pub name: String,
    /// The bytes of the PNG or JPEG file.
    pub bytes: Vec<u8>,
}
