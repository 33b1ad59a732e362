//! Texture coordinates.

/// The coordinate that is cut.
#[derive(Clone, Copy)]
pub(super) struct Coordinate {
    pub(super) set: usize,
    /// 0 for u, 1 for v.
    pub(super) axis: usize,
}
