//! The standard streams. A reader may stop reading, as `head` does: the rest is dropped, and the command goes on.

use std::fmt::Display;
use std::io::{ErrorKind, Result, Write, stderr, stdout};

/// A stream whose reader may stop reading.
pub(crate) struct Stream<W>(pub(crate) W);

impl<W: Write> Write for Stream<W> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        match self.0.write(bytes) {
            Err(why) if why.kind() == ErrorKind::BrokenPipe => Ok(bytes.len()),
            written => written,
        }
    }

    fn flush(&mut self) -> Result<()> {
        match self.0.flush() {
            Err(why) if why.kind() == ErrorKind::BrokenPipe => Ok(()),
            flushed => flushed,
        }
    }
}

/// Writes a line to standard error. A failure cannot be reported anywhere.
pub(crate) fn say(line: impl Display) {
    let _ = writeln!(stderr().lock(), "{line}");
}

/// Writes a text to standard output.
///
/// # Errors
/// A sentence about the output.
pub(crate) fn print(text: &str) -> std::result::Result<(), String> {
    let mut out = Stream(stdout().lock());
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|why| unwritten(&why))
}

/// The sentence for standard output that cannot be written.
pub(crate) fn unwritten(why: &std::io::Error) -> String {
    format!("cannot write to standard output: {why}")
}
