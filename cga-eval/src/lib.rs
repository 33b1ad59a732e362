//! CGA rules that are loaded at run time.
#![forbid(unsafe_code)]

mod call;
mod code;
mod compile;
mod current;
mod diagnostic;
mod dispatch;
mod error;
#[cfg(feature = "live")]
mod live;
mod object;
mod program;
mod rule_file;
mod rule_loader;
mod run;
mod stack;
mod steps;
mod tables;
#[cfg(feature = "live")]
mod watch;

/// The names of the package `cga`, for the examples of this documentation: it is also shown there.
#[doc(hidden)]
pub mod facade {
    pub use cga_runtime::facade::*;

    #[cfg(feature = "live")]
    pub use crate::{Live, LiveError};
    pub use crate::{RuleFile, RuleFileError, RuleLoader};
}

pub use cga_source::FileList;
pub use diagnostic::RuleDiagnostic;
pub use error::RuleFileError;
#[cfg(feature = "live")]
pub use live::{Live, LiveError};
pub use rule_file::RuleFile;
pub use rule_loader::RuleLoader;
#[cfg(feature = "live")]
pub use watch::FileWatcher;
