//! The tests of the solver: a table of patterns with their pieces, and laws.

mod laws;
mod support;
mod table;
