//! The exit status of a command.

use std::process::ExitCode;

/// The exit status of a command: 0, 1 or 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// All went well.
    Success,
    /// The rules have errors, a run ended early, or a part of a file was left out.
    Failed,
    /// A file cannot be read or written, or the arguments are wrong.
    Unusable,
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        ExitCode::from(status as u8)
    }
}
