//! Texts of rules: files of the package, and what diagnostics quote.

use std::fs::File;
use std::io::{Error, Read};
use std::path::Path;

use cga_lang::syntax::lex::decode;
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

/// Most bytes of a rule file. The largest ones people have published have less than a hundredth of it.
const MOST_BYTES: u64 = 64 << 20;

/// The text of a file, if it is one: a device never ends.
pub(super) fn text(file: &Path) -> Result<String, Error> {
    let about = std::fs::metadata(file)?;
    if !about.is_file() {
        return Err(Error::other("not a regular file"));
    }
    let mut bytes = Vec::new();
    File::open(file)?.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    if MOST_BYTES < bytes.len() as u64 {
        return Err(Error::other("it has more than 64 MB"));
    }
    Ok(decode(&bytes).into_owned())
}

/// Makes the build follow the file, in the error case as well; the user's own literal keeps machine paths out.
pub(super) fn tracking(literal: &Literal) -> TokenStream {
    quote! {
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #literal));
    }
}
