//! Standard error. Its reader may stop reading, as `head` does.

use std::fmt::Display;
use std::io::Write as _;

/// Writes a line. A failure cannot be reported anywhere.
pub(crate) fn say(line: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{line}");
}
