//! Reads of attributes of shapes.

pub(super) mod material;
pub(super) mod shape;
