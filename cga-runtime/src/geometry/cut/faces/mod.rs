//! Faces into pieces, one for each slab that they reach.

pub(super) mod first_edge;
pub(super) mod general;
pub(super) mod near_coplanar;
mod pieces;
pub(super) mod simple;
pub(super) mod triangle;
