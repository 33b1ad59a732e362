//! Standard error. Its reader may stop reading, as `head` does.

use std::fmt::Display;
use std::io::Write as _;

use cga_geo::plain::plain;

/// The most characters of a line.
const MOST: usize = 2000;

/// Writes lines. Control characters, for example of a file's name, do not reach the terminal. A failure cannot be reported anywhere.
pub(crate) fn say(text: impl Display) {
    let text = text.to_string().replace('\t', "    ");
    let mut out = std::io::stderr().lock();
    let _ = text.split('\n').try_for_each(|line| writeln!(out, "{}", plain(line, MOST)));
}
