//! Reads one rule file.

use std::fs::File;
use std::io::{Error, ErrorKind, Read as _, Result};
use std::path::Path;

use cga_lang::syntax::lex::{MOST_BYTES, TOO_LONG, decode};

/// The reason why pipes and devices are not read.
const NOT_REGULAR: &str = "it is not a regular file";

/// The text of a rule file of at most 1 MB. Bytes that are not UTF-8 are read as Latin-1.
///
/// # Errors
/// The file cannot be read, has more bytes, is a folder ([`ErrorKind::IsADirectory`]), or is a device, which may never end.
pub fn read_text(path: &Path) -> Result<String> {
    let about = std::fs::metadata(path)?;
    if about.is_dir() {
        return Err(Error::new(ErrorKind::IsADirectory, "it is a folder; name a rule file in it"));
    }
    if !about.is_file() {
        return Err(Error::other(NOT_REGULAR));
    }
    let file = File::open(path)?;
    // The path may lead to another file by now.
    if !file.metadata()?.is_file() {
        return Err(Error::other(NOT_REGULAR));
    }
    let mut bytes = Vec::new();
    file.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    if MOST_BYTES < bytes.len() {
        return Err(Error::other(TOO_LONG));
    }
    Ok(decode(&bytes).into_owned())
}
