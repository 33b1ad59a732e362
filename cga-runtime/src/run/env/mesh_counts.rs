//! The counts of meshes.

/// The meshes that operations made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct MeshCounts {
    pub(in crate::run::env) vertices: u64,
    /// The bytes of meshes, and of leaves that are meshes, besides the vertices that are counted.
    pub(in crate::run::env) bytes: u64,
}

impl MeshCounts {
    /// The counts since `before`.
    pub(crate) fn since(self, before: MeshCounts) -> Self {
        MeshCounts {
            vertices: self.vertices.saturating_sub(before.vertices),
            bytes: self.bytes.saturating_sub(before.bytes),
        }
    }
}
