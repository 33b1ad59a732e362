//! What stands before the rules: `#[doc] @Allow(…) pub grammar Tower` and how the rules follow.

use cga_lang::code::Code;
use cga_lang::diag::Level;
use proc_macro2::{Delimiter, Ident, Literal, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::door::Source;

/// What the user asked for.
pub(crate) struct Header {
    /// Outer attributes, doc comments among them.
    pub(crate) attributes: TokenStream,
    /// `pub` and the like; empty for the expression form.
    pub(crate) visibility: TokenStream,
    /// The struct; `None` for the expression form.
    pub(crate) name: Option<Ident>,
    /// Path to the runtime's hidden module.
    pub(crate) runtime: TokenStream,
    /// `@Allow(code)` and its like before the header: levels for the whole grammar.
    pub(crate) levels: Vec<(Code, Level)>,
}

/// The rules that follow a header.
pub(crate) enum Body {
    /// Inline tokens; annotations that stood before the header come first.
    Inline(TokenStream),
    /// A string literal.
    Text(Literal),
    /// A string literal that names a file.
    File(Literal),
    /// Neither: where, and what should stand there.
    Broken(Span, &'static str),
}

impl Header {
    /// The struct's name.
    pub(crate) fn ident(&self) -> Ident {
        self.name.clone().unwrap_or_else(|| format_ident!("Rules"))
    }

    /// The grammar's name for the user; empty for the expression form.
    pub(crate) fn label(&self) -> String {
        self.name.as_ref().map(ToString::to_string).unwrap_or_default()
    }

    /// Puts findings, rebuild tracking and output together: items, or a block when there is no header.
    pub(crate) fn wrap(&self, source: &Source, findings: &TokenStream, output: TokenStream) -> TokenStream {
        let tracking = source.tracking();
        if self.name.is_some() {
            return quote!(#findings #tracking #output);
        }
        let captures = source.hosts().iter().map(|host| &host.expr);
        let names = (0..source.hosts().len()).map(|index| capture(index as u32));
        quote!(match (#(&(#captures),)*) {
            (#(#names,)*) => { #findings #tracking #output }
        })
    }
}

/// The local that holds the value of a `#` use in the expression form.
pub(crate) fn capture(index: u32) -> Ident {
    Ident::new(&format!("_capture_{index}"), Span::mixed_site())
}

/// Reads the header, if there is one.
pub(crate) fn read(input: TokenStream) -> (Header, Body) {
    let list: Vec<TokenTree> = input.clone().into_iter().collect();
    let mut at = 0;
    let mut header = Header {
        attributes: TokenStream::new(),
        visibility: TokenStream::new(),
        name: None,
        runtime: quote!(::cga::__rt),
        levels: Vec::new(),
    };
    // `#[…]`.
    while let (Some(TokenTree::Punct(hash)), Some(TokenTree::Group(group))) = (list.get(at), list.get(at + 1)) {
        if hash.as_char() != '#' || group.delimiter() != Delimiter::Bracket {
            break;
        }
        match runtime_path(group.stream()) {
            Some(path) => header.runtime = path,
            None => header.attributes.extend([list[at].clone(), list[at + 1].clone()]),
        }
        at += 2;
    }
    let after_attributes = at;
    let mut levels = Vec::new();
    // What is no level stays with the rules, whose checks name it.
    let mut annotations = TokenStream::new();
    while let (Some(TokenTree::Punct(sign)), Some(TokenTree::Ident(word))) = (list.get(at), list.get(at + 1)) {
        if sign.as_char() != '@' {
            break;
        }
        let end = at + 2 + usize::from(matches!(list.get(at + 2), Some(TokenTree::Group(_))));
        match level(&word.to_string(), list.get(at + 2)) {
            Some(list) => levels.extend(list),
            None => annotations.extend(list[at..end].iter().cloned()),
        }
        at = end;
    }
    // `pub`, `pub(crate)`.
    if list.get(at).is_some_and(|token| token.to_string() == "pub") {
        header.visibility.extend([list[at].clone()]);
        at += 1;
        if let Some(TokenTree::Group(group)) = list.get(at) {
            if group.delimiter() == Delimiter::Parenthesis {
                header.visibility.extend([list[at].clone()]);
                at += 1;
            }
        }
    }
    match (list.get(at), list.get(at + 1)) {
        (Some(TokenTree::Ident(word)), Some(TokenTree::Ident(name))) if *word == "grammar" => {
            header.name = Some(name.clone());
            header.levels = levels;
            let body = rest(&list, at + 2, annotations, name.span());
            (header, body)
        }
        _ => {
            // No header: all of it is rules, but for an attribute that names the runtime.
            let doc = std::mem::take(&mut header.attributes);
            header.visibility = TokenStream::new();
            let rules = list[after_attributes..].iter().cloned();
            (header, Body::Inline(doc.into_iter().chain(rules).collect()))
        }
    }
}

/// `Allow(code, …)` and its like, when every code is known.
fn level(word: &str, codes: Option<&TokenTree>) -> Option<Vec<(Code, Level)>> {
    let level = match word {
        "Allow" => Level::Allow,
        "Warn" => Level::Warning,
        "Deny" => Level::Error,
        _ => return None,
    };
    let Some(TokenTree::Group(codes)) = codes else { return None };
    let words = codes.stream().into_iter().filter(|token| !matches!(token, TokenTree::Punct(_)));
    let code = |token: TokenTree| Code::ALL.iter().copied().find(|code| code.name() == token.to_string());
    words.map(|token| code(token).map(|code| (code, level))).collect()
}

/// What follows the name: `;` and rules, `= "text";` or `in "path";`.
fn rest(list: &[TokenTree], at: usize, annotations: TokenStream, name: Span) -> Body {
    let word = list.get(at).map(ToString::to_string).unwrap_or_default();
    let end = list.get(at + 2..).unwrap_or_default();
    let closed = matches!(end, []) || matches!(end, [semi] if semi.to_string() == ";");
    match (word.as_str(), list.get(at + 1)) {
        (";", _) => Body::Inline(annotations.into_iter().chain(list[at + 1..].iter().cloned()).collect()),
        ("=", Some(TokenTree::Literal(text))) if closed => Body::Text(text.clone()),
        ("in", Some(TokenTree::Literal(path))) if closed => Body::File(path.clone()),
        ("=", Some(token)) => Body::Broken(token.span(), "write the rules as one string literal here, then `;`"),
        ("in", Some(token)) => Body::Broken(token.span(), "write the path of a `.cga` file as a string literal, then `;`"),
        _ => {
            let place = list.get(at).map_or(name, TokenTree::span);
            Body::Broken(place, "after the grammar's name comes `;` and the rules, `= \"rules\";` or `in \"file.cga\";`")
        }
    }
}

/// `cga(crate = path)`: where the facade is when it is not `::cga`.
fn runtime_path(attribute: TokenStream) -> Option<TokenStream> {
    let mut list = attribute.into_iter();
    let (Some(TokenTree::Ident(name)), Some(TokenTree::Group(group)), None) = (list.next(), list.next(), list.next())
    else {
        return None;
    };
    let mut inner = group.stream().into_iter();
    let is_crate = inner.next().is_some_and(|token| token.to_string() == "crate");
    if name != "cga" || !is_crate || inner.next().is_none_or(|token| token.to_string() != "=") {
        return None;
    }
    let path: TokenStream = inner.collect();
    Some(quote!(#path::__rt))
}
