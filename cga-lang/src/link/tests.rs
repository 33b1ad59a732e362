//! Files for the tests of other modules.

use super::{Files, Unit};
use crate::dialect::Dialect;
use crate::syntax::lex::lex;

/// A provider with one library for all paths.
pub(crate) struct Library(pub(crate) &'static str);

impl Files for Library {
    fn open(&mut self, path: &str, _: &str) -> Result<Unit, String> {
        Ok(unit(path, self.0))
    }
}

/// A file of CGA text.
pub(crate) fn unit(name: &str, text: &str) -> Unit {
    let lexed = lex(text);
    Unit { name: name.into(), tokens: lexed.tokens, dialect: Dialect::Text, found: lexed.diags }
}
