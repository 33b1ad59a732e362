//! Names for editors and for programs that use a grammar with errors.

pub mod index;
pub mod public_names;
