//! The files that rules import.

use cga_lang::diag::Diags;
use cga_lang::link::candidates;
use cga_lang::syntax::lex::lex;
use cga_lang::syntax::parse::parse;
use cga_lang::syntax::token::Tokens;

/// The paths that rules import, as written, in order.
pub fn import_paths(tokens: &Tokens) -> Vec<String> {
    if !tokens.as_slice().iter().any(|token| token.ident() == Some("import")) {
        return Vec::new();
    }
    let mut diags = Diags::new();
    let imports = parse(tokens, &mut diags).imports;
    // The compiler reports the same.
    diags.finish();
    imports.into_iter().map(|import| import.path).collect()
}

/// The imports of a rule text, in order. Each has the names that its file may have, the likeliest first. `name` is the name of the text, as a
/// path with `/`.
pub fn imports(name: &str, text: &str) -> Vec<Vec<String>> {
    import_paths(&lex(text).tokens).iter().map(|path| candidates(path, name)).collect()
}
