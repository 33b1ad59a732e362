//! Cities in units, for programs that make the tiles on many machines.
//!
//! 1. [`work`]: rules, columns and choices, as all machines know them.
//! 2. [`lot`]: a lot as machines send it to each other, and [`counts`]: lots in cells of the map.
//! 3. [`plan`]: the curve of all lots is cut into units, each with whole blocks of tiles. [`margin`]: the lots around a unit.
//! 4. [`make`]: the tiles of a unit, and its file.
//! 5. [`city`]: the root is made from the files of units alone. [`failed_rows`]: the table of rows that cannot be used.
//!
//! This module knows no engine, no table and no network. A unit that is made twice, also on two machines at a time, has the same bytes.

pub mod city;
pub mod compiled;
pub mod counts;
pub mod failed_rows;
pub mod lot;
pub mod make;
pub mod margin;
pub mod plan;
pub mod store;
pub mod work;
