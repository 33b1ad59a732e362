//! Texts of rules: files of the package, and what diagnostics quote.

use std::fs::File;
use std::io::{Error, ErrorKind, Read};
use std::path::{Path, PathBuf};

use cga_lang::syntax::lex::{MOST_BYTES, TOO_LONG, decode};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// A text that diagnostics quote.
pub(crate) struct QuotedText {
    /// The path, as the user writes it.
    pub(crate) name: String,
    /// The text as written, with escapes, at its position in its file.
    pub(crate) written: String,
    /// For each token, its bytes in `written`.
    pub(crate) ranges: Vec<std::ops::Range<usize>>,
}

/// The reason why a file outside of the package is not read. Nothing of it is quoted.
const LINK_OUTSIDE: &str = "a link leads out of the package, and files outside are not read";

/// The path of an existing file or folder of a package, with links resolved. A link must not lead out of the package:
/// messages quote the files that are read, and other machines do not have the file.
pub(super) fn resolved(root: &Path, name: &str) -> Result<PathBuf, Error> {
    let root = if root.as_os_str().is_empty() { Path::new(".") } else { root };
    let path = root.join(name).canonicalize()?;
    if path.starts_with(root.canonicalize()?) { Ok(path) } else { Err(Error::other(LINK_OUTSIDE)) }
}

/// The text of a file of a package, if it is one: a device never ends.
pub(super) fn text(root: &Path, name: &str) -> Result<String, Error> {
    let file = resolved(root, name)?;
    let about = std::fs::metadata(&file)?;
    if about.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if !about.is_file() {
        return Err(Error::other("not a regular file"));
    }
    let mut bytes = Vec::new();
    File::open(file)?.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    if MOST_BYTES < bytes.len() {
        return Err(Error::other(TOO_LONG));
    }
    Ok(decode(&bytes).into_owned())
}

/// Makes the build follow the file, in the error case as well; the user's own literal keeps machine paths out.
pub(super) fn tracking(literal: &Literal) -> TokenStream {
    quote! {
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #literal));
    }
}
