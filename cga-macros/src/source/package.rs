//! Files of the package.

use std::io::Error;
use std::path::{Path, PathBuf};

use cga_source::{Root, read_text};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The path of an existing file or folder of a package, with links resolved. A link must not lead out of the package:
/// messages quote the files that are read, and other machines do not have the file.
pub(super) fn resolved(root: &Path, name: &str) -> Result<PathBuf, Error> {
    Root::new(root, "the package")?.resolved(Path::new(name))
}

/// The text of a rule file of a package.
pub(super) fn text(root: &Path, name: &str) -> Result<String, Error> {
    read_text(&resolved(root, name)?)
}

/// The path of the Rust file of a token, from the package's folder. Paths on disk are used: `file!` is relative to the workspace, and may be
/// remapped.
#[cfg(feature = "live")]
pub(super) fn rust_file(token: proc_macro2::Span) -> Option<String> {
    // The compiler runs in the folder from which its paths count.
    let file = token.local_file()?.canonicalize().ok()?;
    let package = Path::new(&std::env::var_os("CARGO_MANIFEST_DIR")?).canonicalize().ok()?;
    Some(file.strip_prefix(package).ok()?.to_str()?.replace('\\', "/"))
}

/// Makes the build follow the file, in the error case as well; the user's own literal keeps machine paths out.
pub(super) fn tracking(literal: &Literal) -> TokenStream {
    quote! {
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #literal));
    }
}
