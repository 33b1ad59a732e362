//! Rules in Rust code: what `cga!` has between its braces.

mod block;
mod content;
mod header;
mod literal;
mod problem;
mod tokens;

pub use block::{RustRules, find_rules, shown};
pub use content::value;
pub use header::{Header, RulesText, read as read_header};
pub use literal::{QuotedText, TextTokens, read_text};
pub use problem::Problem;
pub use tokens::{Host, InlineTokens, read_inline};
