//! Laws of street networks: no overlaps, no gaps, borders shared to the bit, correct coordinates.

mod cases;
mod large;
mod laws;
mod random;
mod shapes;

use super::*;
