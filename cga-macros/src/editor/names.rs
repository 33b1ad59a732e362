//! The items of declarations, with the names in their bodies.

use cga_lang::compile::Compiled;
use cga_lang::editor::outline::{Part, PartKind};
use cga_lang::ir::Value;
use cga_lang::span::Span as TokenSpan;
use cga_lang::syntax::token::Tok;
use proc_macro2::{Literal, TokenStream};

use super::scopes::{Meaning, Scope};

/// The longest text of a declaration that is shown, in bytes.
const LONGEST: usize = 400;

/// The item of a declaration, with its parameters and their uses.
pub(super) fn item(scope: &Scope<'_>, part: &Part) -> TokenStream {
    let Some((token, name)) = part.name.and_then(|token| Some((token, scope.item(token)?))) else {
        return TokenStream::new();
    };
    let params = part.params.iter().filter_map(|token| {
        let (name, ty) = (scope.at(scope.plain(*token)?, *token), scope.ty(*token));
        Some(code!(#name: #ty))
    });
    let locals = part.locals.iter().filter_map(|token| {
        let (name, ty) = (scope.at(scope.plain(*token)?, *token), scope.ty(*token));
        Some(code!(let #name: #ty;))
    });
    // Parameters and local values are names of the function itself.
    let uses = part.words.iter().filter_map(|word| match scope.meaning(part, word)? {
        Meaning::Local => {
            let name = scope.at(scope.plain(word.token)?, word.token);
            Some(code!(#name;))
        }
        _ => None,
    });
    let (doc, ty) = (doc(scope, part), scope.ty(token));
    match part.kind {
        PartKind::Rule => code!(#[doc = #doc] pub fn #name(#(#params),*) { #(#locals)* #(#uses)* }),
        PartKind::Function => {
            code!(#[doc = #doc] pub fn #name(#(#params),*) -> #ty { #(#locals)* #(#uses)* loop {} })
        }
        PartKind::Const => {
            let value = known(scope.compiled, &name.to_string()).map_or_else(|| code!(computed!()), constant);
            code!(#[doc = #doc] pub const #name: #ty = #value;)
        }
        PartKind::Attr | PartKind::Other => TokenStream::new(),
    }
}

/// Names that the user's own module resolves: attributes, and Rust values and functions in the rules.
pub(super) fn outside(scope: &Scope<'_>) -> TokenStream {
    let grammar = scope.header.ident();
    let words = scope.parts.iter().flat_map(|part| part.words.iter().map(move |word| (part, word)));
    let fields = words.filter_map(|(part, word)| match scope.meaning(part, word)? {
        Meaning::Field => {
            let name = scope.at(scope.plain(word.token)?, word.token);
            Some(code!(grammar.#name;))
        }
        _ => None,
    });
    let rust = scope.source.tokens.as_slice().iter().zip(0..).filter_map(|(token, index)| match token {
        Tok::Path(text) => Some(scope.source.path(index, text)),
        // Without a header they are evaluated where the macro is called.
        Tok::Host(handle) if scope.header.name.is_some() => {
            Some(scope.source.hosts().get(*handle as usize)?.expr.clone())
        }
        _ => None,
    });
    code!(fn outside(grammar: &#grammar) { #(#fields)* #(_ = &#rust;)* })
}

/// The value of a constant, if it is known.
fn known<'a>(compiled: &'a Compiled, name: &str) -> Option<&'a Value> {
    let grammar = compiled.grammar.as_ref()?;
    grammar.globals.iter().find(|global| global.name == name)?.known.as_ref()
}

/// The doc comment of a declaration, then its text.
fn doc(scope: &Scope<'_>, part: &Part) -> String {
    let (first, end) = part.range;
    let span = TokenSpan { first, last: end.saturating_sub(1).max(first) };
    let text = scope.source.tokens.text(span, LONGEST, '^');
    let docs: Vec<&str> = part.docs.iter().map(|line| line.strip_prefix(' ').unwrap_or(line)).collect();
    let docs = docs.join("\n");
    format!("{docs}{}```text\n{text}\n```", if docs.is_empty() { "" } else { "\n\n" })
}

/// A constant as an editor shows it.
fn constant(value: &Value) -> TokenStream {
    match value {
        Value::Float(number) if number.is_finite() => {
            let digits = Literal::f64_unsuffixed(number.abs());
            if number.is_sign_negative() { code!(-#digits) } else { code!(#digits) }
        }
        Value::Float(_) => code!(::core::primitive::f64::NAN),
        Value::Bool(truth) => code!(#truth),
        Value::Text(text) => code!(#text),
        Value::Array(rows) => {
            let elements = rows.iter().flatten().map(constant);
            code!(&[#(#elements),*])
        }
    }
}
