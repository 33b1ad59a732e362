//! Reads the header: attributes, levels, visibility, name and the source.

use cga_lang::diag::Level;
use cga_lang::diag::code::Code;
use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream, TokenTree};
use quote::quote;

use super::{Header, RulesText};
use crate::rust::problem::Problem;

/// Reads the header, if there is one. Where it is broken the problem goes with as much of it as there is.
pub fn read(input: TokenStream) -> (Header, Result<RulesText, Problem>) {
    let list: Vec<TokenTree> = input.into_iter().collect();
    let mut at = 0;
    let mut header = Header {
        attributes: TokenStream::new(),
        conditions: TokenStream::new(),
        has_doc: false,
        visibility: TokenStream::new(),
        name: None,
        runtime: quote!(::cga::__rt),
        levels: Vec::new(),
    };
    // `#[…]` and `@Allow(…)` in any order.
    let (mut attributes, mut levels, mut annotations) = (Vec::new(), Vec::new(), Vec::new());
    let mut runtime_at = Vec::new();
    loop {
        let start = at;
        while let (true, Some(TokenTree::Group(group))) = (is_sign(list.get(at), '#'), list.get(at + 1)) {
            if group.delimiter() != Delimiter::Bracket {
                break;
            }
            match runtime_path(group) {
                Some(path) => {
                    header.runtime = path;
                    runtime_at.extend([at, at + 1]);
                }
                None => attributes.push([list[at].clone(), list[at + 1].clone()]),
            }
            at += 2;
        }
        read_annotations(&list, &mut at, &mut levels, &mut annotations);
        if at == start {
            break;
        }
    }
    let visible = list.get(at).is_some_and(|token| is_word(token, "pub"));
    if visible {
        header.visibility.extend([list[at].clone()]);
        at += 1;
        if let Some(TokenTree::Group(group)) = list.get(at)
            && group.delimiter() == Delimiter::Parenthesis
        {
            header.visibility.extend([list[at].clone()]);
            at += 1;
        }
    }
    match (list.get(at), list.get(at + 1)) {
        (Some(word), Some(TokenTree::Ident(name))) if is_word(word, "grammar") => {
            header.take_attributes(attributes);
            header.name = Some(name.clone());
            header.levels = levels;
            let body = rest(&list, at + 2, annotations, name);
            (header, body)
        }
        (token, next) if visible || is_broken_header(token, next) => {
            let place = token.or(list.last()).map_or_else(Span::call_site, TokenTree::span);
            header.visibility = TokenStream::new();
            (header, Err(Problem::new(place, place, "the header is broken\nhelp: it is written `pub grammar Name`")))
        }
        _ => {
            // Without a header everything is rules, except an attribute that names the runtime.
            let is_rule = |at: usize| !runtime_at.contains(&at);
            let rules = list.into_iter().enumerate().filter(|(at, _)| is_rule(*at)).map(|(_, token)| token);
            (header, Ok(RulesText::Inline(rules.collect())))
        }
    }
}

impl Header {
    fn take_attributes(&mut self, attributes: Vec<[TokenTree; 2]>) {
        for attribute in attributes {
            let name = match &attribute[1] {
                TokenTree::Group(group) => group.stream().into_iter().next().map(|word| word.to_string()),
                _ => None,
            };
            self.has_doc |= name.as_deref() == Some("doc");
            if name.as_deref() == Some("cfg") {
                self.conditions.extend(attribute.clone());
            }
            self.attributes.extend(attribute);
        }
    }
}

fn is_word(token: &TokenTree, word: &str) -> bool {
    matches!(token, TokenTree::Ident(own) if own == word)
}

fn is_sign(token: Option<&TokenTree>, sign: char) -> bool {
    matches!(token, Some(TokenTree::Punct(own)) if own.as_char() == sign)
}

/// `grammar;`, or another word where `grammar` belongs: two names and `;`, which no rules begin with.
fn is_broken_header(token: Option<&TokenTree>, next: Option<&TokenTree>) -> bool {
    token.is_some_and(|token| is_word(token, "grammar")) && is_sign(next, ';')
}

/// Reads annotations before the header: levels for the whole grammar. Others stay with the rules, whose checks name them.
fn read_annotations(list: &[TokenTree], at: &mut usize, levels: &mut Vec<(Code, Level)>, others: &mut Vec<TokenTree>) {
    while let (true, Some(TokenTree::Ident(word))) = (is_sign(list.get(*at), '@'), list.get(*at + 1)) {
        let end = *at + 2 + usize::from(matches!(list.get(*at + 2), Some(TokenTree::Group(_))));
        match level(&word.to_string(), list.get(*at + 2)) {
            Some(list) => levels.extend(list),
            None => others.extend(list[*at..end].iter().cloned()),
        }
        *at = end;
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
    words.map(|token| Code::from_name(&token.to_string()).map(|code| (code, level))).collect()
}

/// The rest after the name: `;` and rules, `= "text";` or `in "path";`.
fn rest(list: &[TokenTree], at: usize, annotations: Vec<TokenTree>, name: &Ident) -> Result<RulesText, Problem> {
    let missing = |place: Span, help: &str| {
        Problem::new(place, place, format!("the rules of `{name}` are missing\nhelp: {help}"))
    };
    let after = list.get(at + 1);
    let place = after.map_or(name.span(), TokenTree::span);
    let body = match list.get(at) {
        sign if is_sign(sign, ';') => {
            return Ok(RulesText::Inline(annotations.into_iter().chain(list[at + 1..].iter().cloned()).collect()));
        }
        sign if is_sign(sign, '=') => {
            let (literals, taken) = literals(list.get(at + 1..).unwrap_or_default());
            let help = "write the rules as one string literal here, then `;`";
            literals.map(|literals| (RulesText::Text(literals), at + 1 + taken)).ok_or_else(|| missing(place, help))?
        }
        Some(word) if is_word(word, "in") => match after {
            Some(TokenTree::Literal(path)) => (RulesText::File(path.clone()), at + 2),
            _ => return Err(missing(place, "write the path of a `.cga` file as a string literal, then `;`")),
        },
        other => {
            let place = other.map_or(name.span(), TokenTree::span);
            let help = "after the grammar's name comes `;` and the rules, `= \"rules\";` or `in \"file.cga\";`";
            return Err(missing(place, help));
        }
    };
    let (body, end) = body;
    if let [sign, word, ..] = annotations.as_slice() {
        let message = format!(
            "`@{word}` does not set the level of a diagnostic\nhelp: before a grammar in text write only \
            `@Allow`, `@Warn` or `@Deny`, each with codes of diagnostics"
        );
        return Err(Problem::new(sign.span(), word.span(), message));
    }
    match list.get(end..).unwrap_or_default() {
        [] => Ok(body),
        [semi] if is_sign(Some(semi), ';') => Ok(body),
        [extra, ..] => Err(Problem::new(
            extra.span(),
            extra.span(),
            "nothing but `;` may follow here\nhelp: the rules belong into the text",
        )),
    }
}

/// One string literal, or `concat!("…", "…")`, and how many tokens that took.
fn literals(list: &[TokenTree]) -> (Option<Vec<Literal>>, usize) {
    match list {
        [TokenTree::Literal(text), ..] => (Some(vec![text.clone()]), 1),
        // Whatever group another macro put it in.
        [TokenTree::Group(group), ..] if group.delimiter() == Delimiter::None => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            (literals(&inner).0, 1)
        }
        [concat, bang, TokenTree::Group(group), ..] if is_word(concat, "concat") && is_sign(Some(bang), '!') => {
            let parts = group.stream().into_iter().filter(|token| !is_sign(Some(token), ','));
            let literal = |token| if let TokenTree::Literal(text) = token { Some(text) } else { None };
            (parts.map(literal).collect(), 3)
        }
        _ => (None, 0),
    }
}

/// `cga(crate = path)`: where the facade is when it is not `::cga`.
fn runtime_path(attribute: &Group) -> Option<TokenStream> {
    let mut list = attribute.stream().into_iter();
    let (Some(TokenTree::Ident(name)), Some(TokenTree::Group(group)), None) = (list.next(), list.next(), list.next())
    else {
        return None;
    };
    let mut inner = group.stream().into_iter();
    let is_crate = inner.next().is_some_and(|token| is_word(&token, "crate"));
    if name != "cga" || !is_crate || !is_sign(inner.next().as_ref(), '=') {
        return None;
    }
    let path: TokenStream = inner.collect();
    Some(quote!(#path::__rt))
}
