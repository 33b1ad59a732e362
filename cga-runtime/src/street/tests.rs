//! Laws of street networks: nothing overlaps, nothing is left out, borders are shared to the bit, coordinates are right.

mod cases;
mod laws;
mod random;
mod shapes;

use super::*;
