//! Texts of rules: files of the package, and what diagnostics quote.

use std::io::Error;
use std::path::{Path, PathBuf};

use cga_source::{Root, read_text};
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

/// The path of an existing file or folder of a package, with links resolved. A link must not lead out of the package:
/// messages quote the files that are read, and other machines do not have the file.
pub(super) fn resolved(root: &Path, name: &str) -> Result<PathBuf, Error> {
    Root::new(root, "the package")?.resolved(Path::new(name))
}

/// The text of a rule file of a package.
pub(super) fn text(root: &Path, name: &str) -> Result<String, Error> {
    read_text(&resolved(root, name)?)
}

/// Makes the build follow the file, in the error case as well; the user's own literal keeps machine paths out.
pub(super) fn tracking(literal: &Literal) -> TokenStream {
    quote! {
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #literal));
    }
}
