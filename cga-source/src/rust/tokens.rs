//! Inline rules: Rust's tokens become ours.

use cga_lang::diag::code::Code;
use cga_lang::diag::{Diag, Diags};
use cga_lang::span::Span as TokenSpan;
use cga_lang::syntax::lex::{NO_UNITS, without_unit};
use cga_lang::syntax::token::{Sym, Tok, Tokens};
use proc_macro2::{Delimiter, Group, Literal, Spacing, Span, TokenStream, TokenTree};

/// Inline rules as tokens, and the places of the tokens.
#[derive(Clone, Debug)]
pub struct InlineTokens {
    /// The tokens.
    pub tokens: Tokens,
    /// The diagnostics of reading them.
    pub found: Vec<Diag>,
    /// The place where each token begins, and where it ends: a symbol or path of ours can be several tokens of Rust.
    pub spans: Vec<(Span, Span)>,
    /// The paths among the tokens: the number of the token, and its own tokens.
    pub paths: Vec<(u32, TokenStream)>,
    /// The Rust values, by handle.
    pub hosts: Vec<Host>,
}

/// A Rust value in the rules: `#name` or `#(…)`.
#[derive(Clone, Debug)]
pub struct Host {
    /// The expression.
    pub expr: TokenStream,
    /// Its place, without the `#`.
    pub span: Span,
}

/// Reads inline rules.
pub fn read_inline(stream: TokenStream) -> InlineTokens {
    let mut reader = InlineReader::default();
    reader.stream(stream);
    reader.report_lifetimes();
    let spans = &reader.spans;
    reader.tokens.join_names(|dot| {
        spans
            .get(dot + 1)
            .is_some_and(|next| is_close(spans[dot - 1].1, spans[dot].0) && is_close(spans[dot].1, next.0))
    });
    let InlineReader { tokens, spans, paths, hosts, diags, .. } = reader;
    InlineTokens { tokens, found: diags.finish(), spans, paths, hosts }
}

#[derive(Default)]
struct InlineReader {
    tokens: Tokens,
    /// Where each token begins and ends: a symbol or path of ours can be several tokens of Rust.
    spans: Vec<(Span, Span)>,
    paths: Vec<(u32, TokenStream)>,
    hosts: Vec<Host>,
    /// Relative sizes that Rust takes for lifetimes, without the quote.
    lifetimes: Vec<(TokenSpan, String)>,
    diags: Diags,
}

impl InlineReader {
    fn push(&mut self, token: Tok, first: Span, last: Span) -> TokenSpan {
        self.spans.push((first, last));
        TokenSpan::one(self.tokens.push(token))
    }

    fn push_one(&mut self, token: Tok, span: Span) {
        self.push(token, span, span);
    }

    /// Something that cannot be read; the parser passes over it.
    fn bad(&mut self, first: Span, last: Span, message: String, help: &str) {
        let at = self.push(Tok::Bad, first, last);
        self.diags.report(Code::UnknownCharacter, at, message).help(help);
    }

    fn stream(&mut self, stream: TokenStream) {
        let list: Vec<TokenTree> = stream.into_iter().collect();
        let mut at = 0;
        while at < list.len() {
            at += self.token(&list[at..]);
        }
    }

    /// Reads what `list` begins with; gives the number of Rust tokens it took.
    fn token(&mut self, list: &[TokenTree]) -> usize {
        match &list[0] {
            TokenTree::Group(group) => {
                self.group(group);
                1
            }
            TokenTree::Ident(_) => self.name(list),
            TokenTree::Literal(literal) => self.literal(literal, &list[1..]),
            TokenTree::Punct(sign) => match sign.as_char() {
                '#' => self.host(list),
                '.' if self.starts_fraction(list) => self.fraction(list),
                '\'' | '^' => self.relative(list),
                ':' if path_joint(list, 0) && matches!(list.get(2), Some(TokenTree::Ident(_))) => self.name(list),
                _ => self.symbol(list),
            },
        }
    }

    fn group(&mut self, group: &Group) {
        let (open, close) = match group.delimiter() {
            Delimiter::Parenthesis => (Sym::LParen, Sym::RParen),
            Delimiter::Brace => (Sym::LBrace, Sym::RBrace),
            Delimiter::Bracket => (Sym::LBracket, Sym::RBracket),
            // A group from another macro: its expression stays one value.
            Delimiter::None if is_simple(group) => return self.stream(group.stream()),
            Delimiter::None => (Sym::LParen, Sym::RParen),
        };
        self.push_one(Tok::Sym(open), group.span_open());
        self.stream(group.stream());
        self.push_one(Tok::Sym(close), group.span_close());
    }

    /// A name, or a Rust path of several.
    fn name(&mut self, list: &[TokenTree]) -> usize {
        let mut end = 0;
        let mut text = String::new();
        if path_joint(list, 0) {
            text.push_str("::");
            end = 2;
        }
        while let Some(TokenTree::Ident(name)) = list.get(end) {
            text.push_str(&name.to_string());
            end += 1;
            if !path_joint(list, end) || !matches!(list.get(end + 2), Some(TokenTree::Ident(_))) {
                break;
            }
            text.push_str("::");
            end += 2;
        }
        if end == 1 {
            let mut plain = text.strip_prefix("r#").map(str::to_owned).unwrap_or(text);
            end += dollars(list, &mut plain);
            // Rust reads the end of a leaf `a$1.` as a number.
            let leaf = plain.ends_with('.') && plain.pop().is_some();
            let last = list[end - 1].span();
            self.push(Tok::Ident(plain), list[0].span(), last);
            if leaf {
                self.push_one(Tok::Sym(Sym::Dot), last);
            }
        } else {
            let at = self.push(Tok::Path(text), list[0].span(), list[end - 1].span());
            self.paths.push((at.first, list[..end].iter().cloned().collect()));
        }
        end
    }

    fn literal(&mut self, literal: &Literal, rest: &[TokenTree]) -> usize {
        let span = literal.span();
        let written = literal.to_string();
        if written.starts_with(|c: char| c.is_ascii_digit() || c == '-') {
            let digits = match written.strip_prefix('-') {
                Some(digits) => {
                    self.push_one(Tok::Sym(Sym::Minus), span);
                    digits
                }
                None => &written,
            };
            self.number(digits, span, span);
            let close = rest.first().is_some_and(|next| !is_apart(span, next.span()));
            if written.ends_with('.') && close && begins_operator(rest) {
                // `1.==1` is `1 .== 1`.
                self.push_one(Tok::Sym(Sym::Dot), span);
            } else if !written.contains('.') && close && dots(rest) == 2 && begins_limit(&rest[2..]) {
                // `0..3`, a range of Rust: no dot belongs to a number.
                rest[..2].iter().for_each(|dot| self.push_one(Tok::Sym(Sym::Dot), dot.span()));
                return 3;
            } else if !written.contains('.') && close && dots(rest) == 2 {
                // Rust glues the dots of `1..==1`; the first one is the number's.
                return 2;
            }
        } else if let Some(text) = super::content::value(literal) {
            self.push_one(Tok::Str(text), span);
        } else if written.starts_with('\'') {
            let inside = written.trim_matches('\'');
            let help = match inside.parse::<u8>() {
                Ok(_) => format!("inline, write `^{inside}`"),
                Err(_) => "inline, write a relative size as `^0.5` and text as \"…\"".into(),
            };
            self.bad(span, span, format!("Rust reads `{written}` as a character"), &help);
        } else {
            self.bad(span, span, format!("`{written}` has no meaning in CGA"), "text is written \"…\"");
        }
        1
    }

    fn number(&mut self, written: &str, first: Span, last: Span) {
        match written.replace('_', "").parse::<f64>() {
            Ok(value) if value.is_finite() => _ = self.push(Tok::Number(value), first, last),
            Ok(_) => {
                let at = self.push(Tok::Bad, first, last);
                self.diags.report(Code::BadNumber, at, "this number is too large");
            }
            Err(_) => {
                let value = number_and_unit(written);
                let at = self.push(value.map_or(Tok::Bad, Tok::Number), first, last);
                let diag = self.diags.report(Code::BadNumber, at, format!("`{written}` is not a number in CGA"));
                match value {
                    Some(value) => diag.note(NO_UNITS).help(format!("write `{value}`")),
                    None => diag.help("write it in digits, like `12` or `0.5`"),
                };
            }
        }
    }

    /// Returns true at `.5`: digits directly after the dot, and no name directly before it, as in `X.5`.
    fn starts_fraction(&self, list: &[TokenTree]) -> bool {
        let Some(TokenTree::Literal(digits)) = list.get(1) else { return false };
        let behind_name = matches!(self.tokens.as_slice().last(), Some(Tok::Ident(_)))
            && self.spans.last().is_some_and(|(_, end)| !is_apart(*end, list[0].span()));
        digits.to_string().starts_with(|c: char| c.is_ascii_digit())
            && !is_apart(list[0].span(), digits.span())
            && !behind_name
    }

    fn fraction(&mut self, list: &[TokenTree]) -> usize {
        self.number(&format!(".{}", list[1]), list[0].span(), list[1].span());
        2
    }

    /// `#name`, `#(…)`, and `#[doc = "…"]`, which is how a doc comment arrives.
    fn host(&mut self, list: &[TokenTree]) -> usize {
        let span = list[0].span();
        if list.get(1).is_some_and(|next| is_apart(span, next.span())) {
            return self.comment(list);
        }
        let expr: TokenStream = match list.get(1) {
            Some(TokenTree::Ident(name)) if is_colour_name(&name.to_string()) => {
                let help = format!("write `\"#{name}\"`; the Rust value of this name is `#({name})`");
                return self.colour(&list[..2], help);
            }
            Some(TokenTree::Ident(name)) => TokenTree::from(name.clone()).into(),
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => {
                TokenTree::from(group.clone()).into()
            }
            // An expression that another macro put in. Invisible brackets would get lost.
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::None => {
                let mut visible = Group::new(Delimiter::Parenthesis, group.stream());
                visible.set_span(group.span());
                TokenTree::from(visible).into()
            }
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket => {
                if let Some(text) = doc(group) {
                    self.push_one(Tok::Doc(text), span);
                } else {
                    let help = "CGA's own annotations begin with `@`";
                    self.bad(span, group.span(), "attributes have no meaning inside rules".into(), help);
                }
                return 2;
            }
            // `#00ff00` begins with a number.
            Some(TokenTree::Literal(digits)) if is_colour(&digits.to_string()) => {
                return self.colour(&list[..2], format!("write `\"#{digits}\"`"));
            }
            _ => {
                let help = "a Rust value is `#name` or `#(expression)`; inline comments begin with `//`";
                self.bad(span, span, "`#` stands alone".into(), help);
                return 1;
            }
        };
        let handle = self.hosts.len() as u32;
        let place = list[1].span();
        self.hosts.push(Host { expr, span: place });
        self.push(Tok::Host(handle), span, place);
        2
    }

    /// `#00ff00`, a colour without quotes.
    fn colour(&mut self, list: &[TokenTree], help: String) -> usize {
        let [sign, digits] = list else { return list.len() };
        let at = self.push(Tok::Str(format!("#{digits}")), sign.span(), digits.span());
        self.diags.report(Code::Syntax, at, "a colour is text, and `#` begins a Rust value").help(help);
        2
    }

    /// `# …`, a comment of CGA: passes over the rest of its line.
    fn comment(&mut self, list: &[TokenTree]) -> usize {
        let span = list[0].span();
        self.bad(span, span, "`#` begins no comment here".into(), "comments among Rust begin with `//`");
        let line = span.start().line;
        1 + list[1..].iter().take_while(|token| token.span().start().line == line).count()
    }

    /// `^`, or `'` where Rust lets it through.
    fn relative(&mut self, list: &[TokenTree]) -> usize {
        let span = list[0].span();
        match list.get(1) {
            // `'0.5` comes as a lifetime named `0`, and rustc adds an error of its own.
            Some(TokenTree::Ident(name)) if name.to_string().starts_with(|c: char| c.is_ascii_digit()) => {
                let written: String = number_after(&list[1..]);
                let taken = (1 + written.matches('.').count() * 2 + 1).min(list.len());
                let last = list[taken - 1].span();
                let at = self.push(Tok::Bad, span, last);
                self.lifetimes.push((at, written.clone()));
                if let Ok(value) = written.parse() {
                    // The missing size must not cause a second diagnostic.
                    self.push(Tok::Number(value), list[1].span(), last);
                }
                taken
            }
            _ => {
                self.push_one(Tok::Sym(Sym::Quote), span);
                1
            }
        }
    }

    /// Reports all sizes like `'0.5` in one diagnostic: rustc reports each of them again.
    fn report_lifetimes(&mut self) {
        let Some((at, written)) = self.lifetimes.first() else { return };
        let message = format!("Rust cannot read the relative size `'{written}`");
        let diag = self.diags.report(Code::UnknownCharacter, *at, message);
        if 1 < self.lifetimes.len() {
            diag.note(format!("{} sizes begin with `'`: rustc underlines each", self.lifetimes.len()));
        }
        diag.help(format!("inline, write `^{written}`; a string or a `.cga` file takes `'{written}`"));
    }

    fn symbol(&mut self, list: &[TokenTree]) -> usize {
        let mut run = run(list);
        // The body of a `macro_rules!` does not say that the first dash of `-->` belongs to what follows.
        if run == "-" && begins_arrow(&list[1..]) {
            run.push_str("->");
        }
        let span = list[0].span();
        // The longest first; see `Sym::ALL`.
        match Sym::ALL.iter().find(|sym| run.starts_with(sym.text())) {
            Some(sym) => {
                let taken = sym.text().chars().count();
                self.push(Tok::Sym(*sym), span, list[taken - 1].span());
                taken
            }
            None => {
                let sign = run.chars().next().unwrap_or_default();
                let help = match (sign, list.get(1)) {
                    ('&', _) => "write `&&`".into(),
                    ('?', _) => "write `case condition : a else : b`".into(),
                    ('$', Some(TokenTree::Ident(name))) => format!("write `{name}`, or `#{name}` for a Rust value"),
                    _ => "take it away".into(),
                };
                self.bad(span, span, format!("`{sign}` has no meaning in CGA"), &help);
                1
            }
        }
    }
}

/// Returns true if white space separates two tokens. Without places (macro servers of editors) the answer is false.
fn is_apart(left: Span, right: Span) -> bool {
    let (end, start) = (left.end(), right.start());
    end.line < start.line || (end.line == start.line && end.column < start.column)
}

/// Returns true if no white space separates two tokens. Without places the answer is false.
fn is_close(left: Span, right: Span) -> bool {
    let (end, start) = (left.end(), right.start());
    let is_known = left.start().column < end.column;
    is_known && end.line == start.line && end.column == start.column
}

/// The value of a number with a unit.
fn number_and_unit(written: &str) -> Option<f64> {
    let unit = written.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.' || c == '_');
    let digits = written.strip_suffix(unit)?.replace('_', "");
    without_unit(digits.parse().ok()?, unit)
}

/// Returns true if the token makes a colour after `#`.
fn is_colour(digits: &str) -> bool {
    matches!(digits.len(), 3 | 6 | 8) && digits.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// Returns true if a name is a colour: `ff0000` and `ffffff`, but not `facade`.
fn is_colour_name(name: &str) -> bool {
    let is_number = name.bytes().any(|byte| byte.is_ascii_digit());
    is_colour(name) && 3 < name.len() && (is_number || name.bytes().all(|byte| name.starts_with(char::from(byte))))
}

/// The punctuation at a position up to the next space.
fn run(list: &[TokenTree]) -> String {
    let mut run = String::new();
    for token in list {
        let TokenTree::Punct(sign) = token else { break };
        run.push(sign.as_char());
        if sign.spacing() == Spacing::Alone {
            break;
        }
    }
    run
}

fn dots(list: &[TokenTree]) -> usize {
    run(list).chars().take_while(|c| *c == '.').count()
}

/// Returns true if a number or a name begins at a position.
fn begins_limit(list: &[TokenTree]) -> bool {
    match list.first() {
        Some(TokenTree::Literal(digits)) => digits.to_string().starts_with(|c: char| c.is_ascii_digit()),
        first => matches!(first, Some(TokenTree::Ident(_))),
    }
}

/// Returns true at an operator that works element by element after a dot.
fn begins_operator(list: &[TokenTree]) -> bool {
    let run = run(list);
    ["+", "-", "*", "/", "%", "!", "&&", "||", "==", "<", ">"].iter().any(|sign| run.starts_with(sign))
}

/// Appends `$` and the rest of the name; returns the number of Rust tokens read.
fn dollars(list: &[TokenTree], name: &mut String) -> usize {
    let mut end = 1;
    while let Some(token) = list.get(end) {
        let text = token.to_string();
        let goes_on = match token {
            TokenTree::Punct(sign) => sign.as_char() == '$',
            TokenTree::Ident(_) | TokenTree::Literal(_) => {
                let digits = text.strip_suffix('.').unwrap_or(&text);
                name.ends_with('$') && digits.chars().all(|c| c == '_' || c.is_alphanumeric())
            }
            TokenTree::Group(_) => false,
        };
        if !goes_on || is_apart(list[end - 1].span(), token.span()) {
            break;
        }
        name.push_str(&text);
        end += 1;
    }
    end - 1
}

/// Returns true at `->`.
fn begins_arrow(list: &[TokenTree]) -> bool {
    let sign = |at: usize| if let Some(TokenTree::Punct(sign)) = list.get(at) { Some(sign) } else { None };
    sign(0).is_some_and(|dash| dash.as_char() == '-' && dash.spacing() == Spacing::Joint)
        && sign(1).is_some_and(|tip| tip.as_char() == '>')
}

/// Returns true at `::`.
fn path_joint(list: &[TokenTree], at: usize) -> bool {
    let colon = |at: usize| match list.get(at) {
        Some(TokenTree::Punct(sign)) if sign.as_char() == ':' => Some(sign.spacing()),
        _ => None,
    };
    colon(at) == Some(Spacing::Joint) && colon(at + 1).is_some()
}

/// Returns true if a group from another macro means the same without its invisible brackets: one token, or a path.
fn is_simple(group: &Group) -> bool {
    let list: Vec<TokenTree> = group.stream().into_iter().collect();
    let in_path = |token: &TokenTree| match token {
        TokenTree::Ident(_) => true,
        TokenTree::Punct(sign) => sign.as_char() == ':',
        _ => false,
    };
    list.len() <= 1 || list.iter().all(in_path)
}

/// The text of `doc = "…"`.
fn doc(group: &Group) -> Option<String> {
    let list: Vec<TokenTree> = group.stream().into_iter().collect();
    match list.as_slice() {
        [TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Literal(text)] if *name == "doc" => {
            super::content::value(text).map(|text| text.trim().to_owned())
        }
        _ => None,
    }
}

/// The digits after a quote: `0`, or `0`, `.`, `5`.
fn number_after(list: &[TokenTree]) -> String {
    let mut text = list[0].to_string();
    if let (Some(TokenTree::Punct(dot)), Some(TokenTree::Literal(rest))) = (list.get(1), list.get(2))
        && dot.as_char() == '.'
    {
        text.push('.');
        text.push_str(&rest.to_string());
    }
    text
}
