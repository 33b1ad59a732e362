//! Arrays in rules: construction, indexing, operators, measures, order.

mod build;
mod each;
mod index;
mod measure;
mod replace;
mod sort;

pub use build::*;
pub use each::*;
pub use index::*;
pub use measure::*;
pub use replace::*;
pub use sort::*;
