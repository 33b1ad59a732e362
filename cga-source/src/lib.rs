//! Where rules come from: files on the disk and in memory, and Rust code.
#![forbid(unsafe_code)]

mod file_list;
mod imports;
mod read;
mod root;
mod rule_files;
#[cfg(feature = "rust")]
pub mod rust;

pub use file_list::FileList;
pub use imports::{import_paths, imports};
pub use read::read_text;
pub use root::Root;
pub use rule_files::RuleFiles;

#[cfg(test)]
mod tests;
