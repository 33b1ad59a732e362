//! Texture space: the functions from points of the world to texture coordinates.
//!
//! A mesh may have explicit sets, a pair of coordinates for each corner. Rules add *implicit* sets: a function of the
//! point in the world, as `projectUV` makes it, or an explicit set that is moved, scaled or turned. So a rectangle or
//! a box stays one, a cut has nothing to do, and a sink computes coordinates where it writes vertices. Operations
//! that move geometry update these functions. Operations that change geometry in any other way write the explicit
//! sets first.
//!
//! A face that closes a cut, a *cap*, has the coordinates (0, 0), whatever the functions are. The next operation on
//! coordinates reaches it as any other face: its coordinates are then written into the explicit sets, and it is marked as
//! mapped.

mod bake;
mod coordinates;
pub(crate) mod kept;
mod projections;
mod shared_sets;

pub(crate) use coordinates::{Coordinates, CubeSides, UvSource, unit_cube_side};
pub(crate) use projections::Projections;
pub(crate) use shared_sets::SharedSets;

/// The units of work of a corner whose texture coordinates are computed.
const MAPPING: usize = 4;

/// The number of sets (*Texturing*: 0 to 9).
pub(crate) const SETS: usize = crate::geometry::mesh::UvSets::MOST;
