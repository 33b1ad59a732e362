//! Cuts faces into pieces, one or more per slab.

pub(super) mod chain;
pub(super) mod first_edge;
pub(super) mod general;
pub(super) mod near_coplanar;
pub(super) mod pieces;
pub(super) mod simple;
pub(super) mod triangle;
