//! The reference: every word of the tables with its signatures, a sentence, an example and the page of Esri's reference.
//!
//! The tables of [`ops`](crate::ops) have the signatures and the state of each row. The files `*.txt` beside this one have
//! the rest, in the order of the page. `tests/front/reference` compares both and writes `docs/reference.md`.

mod entry;
mod markdown;
mod pages;
mod signature;
mod text;
mod word;

pub use entry::{Entry, Form, Section, entries};
pub use markdown::page;
pub use pages::{page_address, page_title};
pub use signature::Signature;
pub use text::{Doc, docs};
pub use word::{Word, words};
