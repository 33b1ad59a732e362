//! The reason why a command ends.

use crate::status::Status;

/// The reason why a command ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Problem {
    pub(crate) status: Status,
    pub(crate) message: String,
}

impl Problem {
    pub(crate) fn failed(message: impl ToString) -> Self {
        Problem { status: Status::Failed, message: message.to_string() }
    }

    pub(crate) fn unusable(message: impl ToString) -> Self {
        Problem { status: Status::Unusable, message: message.to_string() }
    }
}
