//! Cities on one machine or many: the rows of GeoParquet and the rules of files become the tiles of `cga-city`, byte for byte.
//!
//! 1. [`job`]: a file in TOML names the lots, the rules and the store of the tiles.
//! 2. [`cga_city::units`]: lots are counted in cells of the map, and the curve of `cga-city` is cut into units, each with whole blocks of tiles.
//! 3. [`functions`]: functions for DataFusion group the lots by units and make the tiles of each. [`work`] and [`plan`] load their arguments.
//! 4. [`run`]: a unit has a file in the store when it is finished. The root of the city is made from these files alone.
//! 5. [`engine`]: queries run in this process, or on the machines of Ballista, with the same functions.
//!
//! A unit that is made twice, also on two machines at a time, has the same bytes, so lost machines and repeated work do no harm.
#![forbid(unsafe_code)]

mod arguments;
mod columns;
pub mod engine;
pub mod functions;
pub mod job;
mod lots;
pub mod plan;
pub mod program;
mod progress_bar;
pub mod run;
mod sql;
pub mod store;
pub mod threads;
mod town;
pub mod work;
