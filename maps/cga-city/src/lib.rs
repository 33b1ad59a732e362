//! Cities as 3D Tiles 1.1: the lots of a map file and the rules of a file become a tree of GLB files with levels of detail.
//!
//! 1. [`lots`]: footprints are sorted on the disk along a curve through all cells of a quadtree, so a city may be larger than the memory.
//! 2. [`tree`]: the curve is cut into pieces. A piece of the near level has at most [`Options::lots_per_tile`](build::Options) lots, and each
//!    further level has pieces that are sixteen times as large, with simpler buildings.
//! 3. [`content`]: the buildings of a piece become a GLB with a feature for each building. A piece that becomes too large is cut again.
//! 4. [`tile_file`]: a tile has a file beside it with a digest of all that it depends on. A tile with the same digest is not made again.
//! 5. [`units`]: a city in parts, which other programs make on many machines.
//!
//! Equal lots and equal rules make equal bytes, with any number of threads, in any order of the lots, and after any number of interrupted runs.
#![forbid(unsafe_code)]

pub mod area;
pub mod build;
pub mod cell;
pub mod content;
pub mod glb_bounds;
pub mod images;
pub mod leftovers;
pub mod level;
pub mod lots;
pub mod problems;
pub mod program;
pub mod root;
pub mod rules;
pub mod store;
pub mod surroundings;
pub mod tally;
pub mod tile_file;
pub mod tileset;
pub mod tree;
pub mod units;
