//! The pictures and pages of the gallery. Scopes and pivots are marked where the pictures of the pages mark them: x red, y
//! green, z blue.

mod borders;
mod captions;
mod cell;
pub mod chapter;
mod marks;
pub mod same;
pub mod scenes;
mod textured;
