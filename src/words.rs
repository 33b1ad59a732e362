//! The words of the language, for editors: operations, functions, attributes of shapes, selectors and annotations.
//!
//! Their documentation is shown at their uses in `cga!`. It is also in `docs/reference.md`.
//!
//! Only rust-analyzer sees this module. A macro makes it from the tables of the language, so that the tables stay the only
//! source.

cga_macros::words_for_editors!();
