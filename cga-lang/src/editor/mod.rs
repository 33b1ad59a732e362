//! Names for editors and for programs that use a grammar with errors.

mod contexts;
pub mod index;
pub mod outline;
pub mod public_names;
mod view;

pub use contexts::Context;
