//! The worked examples of the documents that this project started from, word for word, to the documented numbers.
//!
//! The pages: *split operation*, *Subdivision split*, *comp operation*, and those of the operations they use. What a page
//! shows only in a picture is taken from the picture.

#[path = "documented/example.rs"]
mod example;
#[path = "documented/pieces.rs"]
mod pieces;

#[path = "documented/split_operation.rs"]
mod split_operation;
