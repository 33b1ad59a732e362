//! The connectivity of parts, from which they are made one mesh again.
//!
//! [`Origins`] records points, the edges that new points divide, and the movements of parts. [`Origins::settle`] finds the places of
//! the points: the original place and the movements of all parts at the point. [`Weld`] makes the mesh.
//!
//! A division makes the parts of a shape. Its *coarse* points are the points that its parts have at first: points of earlier
//! divisions, and new points at its cuts. A movement at a coarse point moves the edges to its coarse neighbours, and finer points
//! on these edges follow linearly. So a point that a later division adds to an edge is moved with the edge.

mod origins;
mod settle;
mod weld;

pub use origins::Origins;
pub use weld::{Weld, welded_wire};
