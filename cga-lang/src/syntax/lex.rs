//! The lexer: CGA text to tokens.
//!
//! It never fails. Unreadable text is reported and becomes [`Tok::Bad`], and reading continues.

use crate::diag::code::Code;
use crate::diag::{Diag, Diags, Line};
use crate::span::Span;
use crate::syntax::token::{Sym, Tok, Tokens};
use std::ops::Range;

mod decode;
mod recovery;

pub use decode::{MOST_BYTES, TOO_LONG, decode};
pub use recovery::{NO_UNITS, without_unit};

/// The tokens of a text and their places in it.
#[derive(Clone, Debug, Default)]
pub struct Lexed {
    /// The tokens.
    pub tokens: Tokens,
    /// The byte range of each token in the text.
    pub ranges: Vec<Range<usize>>,
    /// The diagnostics of the lexer.
    pub diags: Vec<Diag>,
}

/// Reads CGA text.
pub fn lex(text: &str) -> Lexed {
    lex_joined(text, &[])
}

/// Reads CGA text that was joined from parts. The name of a rule does not continue in another part. `borders` has the
/// bytes at which the parts begin, in order.
pub fn lex_joined(text: &str, borders: &[usize]) -> Lexed {
    let mut lexer = Lexer { text, at: 0, tokens: Tokens::new(), ranges: Vec::new(), diags: Diags::new() };
    lexer.run();
    let ranges = &lexer.ranges;
    let touch = |left: usize| {
        let (end, next) = (ranges[left].end, ranges.get(left + 1).map(|next| next.start));
        next == Some(end) && borders.binary_search(&end).is_err()
    };
    lexer.tokens.join_names(|dot| touch(dot - 1) && touch(dot));
    Lexed { tokens: lexer.tokens, ranges: lexer.ranges, diags: lexer.diags.finish() }
}

struct Lexer<'a> {
    text: &'a str,
    /// The next byte, always at a character boundary.
    at: usize,
    tokens: Tokens,
    ranges: Vec<Range<usize>>,
    diags: Diags,
}

impl<'a> Lexer<'a> {
    fn run(&mut self) {
        while let Some(c) = self.peek() {
            let start = self.at;
            match c {
                // In joined files a byte order mark may be in the middle.
                c if c.is_whitespace() || c == '\u{feff}' => self.at += c.len_utf8(),
                '#' | '\'' if self.holds_colour() => self.colour(start),
                '\'' if self.holds_single_quotes() => self.single_quotes(start),
                '#' if self.holds_rust_value() => self.rust_value(start),
                '#' => _ = self.line(),
                '/' if self.rest().starts_with("///") && !self.rest().starts_with("////") => self.doc(start),
                '/' if self.rest().starts_with("//") => _ = self.line(),
                '/' if self.rest().starts_with("/*") => self.block_comment(start),
                '"' => self.string(start),
                '0'..='9' => self.number(start),
                '.' if self.starts_fraction() => self.number(start),
                c if starts_name(c) => self.name(start),
                ':' if self.rest().starts_with("::") && self.rest()[2..].starts_with(starts_name) => self.name(start),
                c => self.symbol(start, c),
            }
        }
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn skip_while(&mut self, test: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let end = rest.find(|c| !test(c)).unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    fn line(&mut self) -> &'a str {
        self.skip_while(|c| c != '\n' && c != '\r')
    }

    fn push(&mut self, start: usize, token: Tok) -> Span {
        self.ranges.push(start..self.at);
        Span::one(self.tokens.push(token))
    }

    fn bad(&mut self, start: usize, code: Code, message: impl Into<Line>) -> &mut Diag {
        let span = self.push(start, Tok::Bad);
        self.diags.report(code, span, message)
    }

    fn doc(&mut self, start: usize) {
        let line = &self.line()[3..];
        self.push(start, Tok::Doc(line.strip_prefix(' ').unwrap_or(line).trim_end().to_owned()));
    }

    fn block_comment(&mut self, start: usize) {
        match self.rest()[2..].find("*/") {
            Some(end) => self.at += end + 4,
            None => {
                self.line();
                self.bad(start, Code::UnclosedComment, "this comment is never closed").help("write `*/` at its end");
                self.at = self.text.len();
            }
        }
    }

    /// A dot begins a number if a digit follows and no name precedes it directly (`X.5`).
    fn starts_fraction(&self) -> bool {
        let before = self.text[..self.at].chars().next_back();
        self.rest()[1..].starts_with(|c: char| c.is_ascii_digit()) && !before.is_some_and(continues_name)
    }

    fn number(&mut self, start: usize) {
        self.skip_while(|c| c.is_ascii_digit());
        if let Some(after) = self.rest().strip_prefix('.') {
            // `0..3` is a range of Rust, so the dot does not belong to a number.
            if after.starts_with('.')
                && after[1..].starts_with(|c: char| c.is_ascii_digit() || starts_name(c))
                && let Some(whole) = self.text[start..self.at].parse().ok().filter(|whole: &f64| whole.is_finite())
            {
                self.push(start, Tok::Number(whole));
                for _ in 0..2 {
                    let dot = self.at;
                    self.at += 1;
                    self.push(dot, Tok::Sym(Sym::Dot));
                }
                return;
            }
            // `1.==1` is `1 .== 1`: the dot belongs to the operator (*changelog*, 2020.0). White space counts here,
            // as in `1. == 1`, because it does in CGA; the inline source compares the positions of the tokens.
            let operator =
                ["+", "-", "*", "/", "%", "!", "&&", "||", "==", "<", ">"].iter().any(|op| after.starts_with(op));
            if !operator && !after.starts_with(starts_name) {
                self.at += 1;
                self.skip_while(|c| c.is_ascii_digit());
            }
        }
        let exponent =
            self.rest().strip_prefix(['e', 'E']).map(|after| after.strip_prefix(['+', '-']).unwrap_or(after));
        if exponent.is_some_and(|after| after.starts_with(|c: char| c.is_ascii_digit())) {
            self.at += 1;
            self.skip_while(|c| c == '+' || c == '-');
            self.skip_while(|c| c.is_ascii_digit());
        }
        let digits = &self.text[start..self.at];
        let tail = self.skip_while(continues_name);
        if !tail.is_empty() {
            let message = format!("`{}` is neither a number nor a name", &self.text[start..self.at]);
            if let Some(value) = digits.parse().ok().and_then(|value| without_unit(value, tail)) {
                let span = self.push(start, Tok::Number(value));
                let diag = self.diags.report(Code::BadNumber, span, message);
                diag.note(NO_UNITS).help(format!("write `{value}`"));
            } else {
                let help = "put an operator between a number and a name, or begin the name with a letter";
                self.bad(start, Code::BadNumber, message).help(help);
            }
            return;
        }
        match digits.parse::<f64>() {
            Ok(value) if value.is_finite() => _ = self.push(start, Tok::Number(value)),
            _ => _ = self.bad(start, Code::BadNumber, "this number is too large"),
        }
    }

    /// Returns true if a colour that was meant as text begins here: `#ff0000`, `'#ff0000'`.
    fn holds_colour(&self) -> bool {
        let rest = self.rest().strip_prefix('\'').unwrap_or(self.rest());
        let Some(length) = recovery::colour(rest) else { return false };
        match self.tokens.as_slice().last() {
            Some(Tok::Sym(Sym::LParen | Sym::LBracket | Sym::Comma)) => recovery::is_no_comment(&rest[length..], true),
            Some(Tok::Sym(Sym::Assign | Sym::EqEq | Sym::NotEq)) => recovery::is_no_comment(&rest[length..], false),
            _ => false,
        }
    }

    /// Returns true if a Rust value of an inline rule begins here, `#height`, where a comment would hide the closing bracket.
    fn holds_rust_value(&self) -> bool {
        let Some(name) = self.rest().strip_prefix('#').filter(|rest| rest.starts_with(starts_name)) else {
            return false;
        };
        let length = name.find(|c| !continues_name(c)).unwrap_or(name.len());
        let in_brackets = matches!(self.tokens.as_slice().last(), Some(Tok::Sym(Sym::LParen | Sym::Comma)));
        in_brackets
            && name[length..].trim_start_matches([' ', '\t']).starts_with([')', ','])
            && recovery::is_no_comment(&name[length..], true)
    }

    /// Reads the name of a Rust value as a name of the rules.
    fn rust_value(&mut self, start: usize) {
        self.at += 1;
        let first = self.at;
        self.skip_while(continues_name);
        let name = self.text[first..self.at].to_owned();
        let help = format!("write `{name}`, and declare it: `attr {name} = …`");
        let span = self.push(start, Tok::Ident(name));
        let diag = self.diags.report(
            Code::Syntax,
            span,
            "`#` begins a comment in a file, and Rust values are for inline rules",
        );
        diag.help(help);
    }

    /// Returns true if text with single quotation marks begins here: `'hello'`. No relative size ends with one.
    fn holds_single_quotes(&self) -> bool {
        let Some(text) = recovery::single_quotes(self.rest()) else { return false };
        match self.tokens.as_slice().last() {
            Some(Tok::Sym(Sym::Assign | Sym::EqEq | Sym::NotEq | Sym::Plus)) => true,
            // Old files have a relative size with a second quotation mark: `'h'`.
            Some(Tok::Sym(Sym::LParen | Sym::LBracket | Sym::Comma)) => !text.chars().all(continues_name),
            _ => false,
        }
    }

    /// Reads text with single quotation marks.
    fn single_quotes(&mut self, start: usize) {
        let text = recovery::single_quotes(self.rest()).unwrap_or_default();
        self.at += text.len() + 2;
        let span = self.push(start, Tok::Str(text.to_owned()));
        let diag = self.diags.report(Code::Syntax, span, "text has double quotation marks");
        diag.help(format!("write `\"{text}\"`"));
    }

    /// Reads a colour without its quotation marks.
    fn colour(&mut self, start: usize) {
        let quoted = self.peek() == Some('\'');
        self.at += usize::from(quoted);
        let text = &self.rest()[..recovery::colour(self.rest()).unwrap_or_default()];
        self.at += text.len();
        self.at += usize::from(quoted && self.peek() == Some('\''));
        let span = self.push(start, Tok::Str(text.to_owned()));
        let diag = self.diags.report(Code::Syntax, span, "a colour is text, and `#` begins a comment");
        diag.help(format!("write `\"{text}\"`"));
    }

    fn name(&mut self, start: usize) {
        let mut path = false;
        loop {
            self.skip_while(continues_name);
            match self.rest().strip_prefix("::") {
                Some(after) if after.starts_with(starts_name) => {
                    path = true;
                    self.at += 2;
                }
                _ => break,
            }
        }
        let text = self.text[start..self.at].to_owned();
        self.push(start, if path { Tok::Path(text) } else { Tok::Ident(text) });
    }

    fn symbol(&mut self, start: usize, c: char) {
        if c == '^' {
            self.at += 1;
            self.push(start, Tok::Sym(Sym::Quote));
        } else if let Some(&sym) = Sym::ALL.iter().find(|sym| self.rest().starts_with(sym.text())) {
            self.at += sym.text().len();
            self.push(start, Tok::Sym(sym));
        } else {
            self.unknown(start, c);
        }
    }

    /// Reports an unknown character. If the intended token is clear, the token is used, so that the mistake is
    /// reported only once.
    fn unknown(&mut self, start: usize, c: char) {
        let (mut help, mut meant) = match lookalike(c) {
            Some((sym, text)) => (format!("write {text}"), sym.map(Tok::Sym)),
            None => (String::new(), None),
        };
        self.at += c.len_utf8();
        if meant == Some(Tok::Sym(Sym::Minus)) {
            self.skip_while(|next| next == c || next == '-');
            if self.rest().starts_with('>') {
                self.at += 1;
                meant = Some(Tok::Sym(Sym::Arrow));
                help = "write `-->`".into();
            }
        } else if matches!(c, '“' | '”' | '„')
            && let Some(end) = self.rest().find(['”', '“', '"', '\n', '\r'])
            && !self.rest()[end..].starts_with(['\n', '\r'])
        {
            meant = Some(Tok::Str(self.rest()[..end].to_owned()));
            self.at += end;
            self.at += self.peek().map_or(0, char::len_utf8);
        } else if meant.is_none() {
            self.skip_while(|next| next == c);
        }
        let shown = if is_invisible(c) { format!("U+{:04X}", c as u32) } else { format!("{c}") };
        let span = self.push(start, meant.unwrap_or(Tok::Bad));
        if c == '$' && self.rest().starts_with(starts_name) {
            let end = self.rest().find(|next| !continues_name(next)).unwrap_or(self.rest().len());
            help = format!("write `{}`", &self.rest()[..end]);
        }
        let diag = self.diags.report(Code::UnknownCharacter, span, format!("unknown character `{shown}`"));
        if !help.is_empty() {
            diag.help(help);
        }
    }

    fn string(&mut self, start: usize) {
        let end = closing_quote(&self.rest()[1..]);
        let Some(end) = end.filter(|&end| !holds_rules(&self.rest()[1..1 + end])) else {
            self.line();
            self.bad(start, Code::UnclosedString, "this string is never closed").help("write `\"` at its end");
            return;
        };
        let inside = &self.rest()[1..1 + end];
        self.at += end + 2;
        let (text, wrong) = unescape(inside);
        let span = self.push(start, Tok::Str(text));
        if let Some(wrong) = wrong {
            self.diags
                .report(Code::BadEscape, span, format!("`{wrong}` is not an escape, the backslash is kept"))
                .help("write `\\\\` for a backslash, or `/` in a path");
        }
    }
}

/// The token that an unknown character was meant as, if known, and the help text for it.
fn lookalike(c: char) -> Option<(Option<Sym>, &'static str)> {
    Some(match c {
        '‘' | '’' | '‛' | '′' | '`' | '´' => (Some(Sym::Quote), "the straight quote `'`"),
        '“' | '”' | '„' | '«' | '»' | '″' => (None, "straight quotes `\"…\"`"),
        '‐' | '‑' | '‒' | '–' | '—' | '−' => (Some(Sym::Minus), "the plain `-`"),
        '→' | '⟶' | '➔' => (Some(Sym::Arrow), "`-->`"),
        '×' | '·' | '∗' | '⋅' => (Some(Sym::Star), "`*`"),
        '°' => (None, "angles without a sign: they are degrees"),
        '÷' => (Some(Sym::Slash), "`/`"),
        '≤' => (Some(Sym::LessEq), "`<=`"),
        '≥' => (Some(Sym::GreaterEq), "`>=`"),
        '≠' => (Some(Sym::NotEq), "`!=`"),
        '˜' | '∼' | '～' => (Some(Sym::Tilde), "the plain `~`"),
        '¦' | '∣' | '｜' => (Some(Sym::Bar), "the plain `|`"),
        '&' => (Some(Sym::AndAnd), "`&&`"),
        '…' => (None, "out the code that the dots replace"),
        '?' => (None, "`case condition : a else : b`"),
        '\\' => (None, "`\\\\` inside a string; it has no meaning outside"),
        _ => return None,
    })
}

fn is_invisible(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}')
}

fn starts_name(c: char) -> bool {
    c == '_' || is_letter(c)
}

/// `$` is only allowed in names of rules, which the parser checks.
fn continues_name(c: char) -> bool {
    c == '_' || c == '$' || c.is_ascii_digit() || is_letter(c)
}

/// Letters that both CGA and Rust allow in names: Latin, Greek, Cyrillic, kana, Han, Hangul.
fn is_letter(c: char) -> bool {
    c.is_ascii_alphabetic()
        || (matches!(c, '\u{aa}'..='\u{2af}' | '\u{386}'..='\u{52f}' | '\u{3040}'..='\u{30ff}' | '\u{4e00}'..='\u{9fff}' | '\u{ac00}'..='\u{d7a3}')
            && c.is_alphabetic())
}

/// The position of the closing quotation mark. Strings may span several lines.
fn closing_quote(text: &str) -> Option<usize> {
    let mut escaped = false;
    text.bytes().position(|byte| {
        let found = byte == b'"' && !escaped;
        escaped = byte == b'\\' && !escaped;
        found
    })
}

/// Returns true if a string without a closing quotation mark contains declarations of later lines.
fn holds_rules(text: &str) -> bool {
    let begins = |line: &str| {
        let line = line.trim_start();
        line.contains("-->") || ["attr ", "const ", "import "].iter().any(|word| line.starts_with(word))
    };
    text.split(['\n', '\r']).skip(1).any(begins)
}

/// Resolves escapes and returns the first unknown one.
fn unescape(text: &str) -> (String, Option<String>) {
    let mut out = String::with_capacity(text.len());
    let mut wrong = None;
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        if c != '\\' {
            if c == '\r' && rest.starts_with('\n') {
                continue;
            }
            out.push(c);
            continue;
        }
        let after = rest.chars().next();
        rest = &rest[after.map_or(0, char::len_utf8)..];
        match after {
            Some('"') => out.push('"'),
            Some('\\') => out.push('\\'),
            Some('n') => out.push('\n'),
            Some('t') => out.push('\t'),
            Some('r') => out.push('\r'),
            Some('u') if hex4(rest).is_some() => {
                let mut unit = hex4(rest).unwrap_or_default();
                rest = &rest[4..];
                if let (0xD800..0xDC00, Some(low @ 0xDC00..0xE000)) = (unit, rest.strip_prefix("\\u").and_then(hex4)) {
                    unit = 0x10000 + ((unit - 0xD800) << 10) + (low - 0xDC00);
                    rest = &rest[6..];
                }
                out.push(char::from_u32(unit).unwrap_or(char::REPLACEMENT_CHARACTER));
            }
            other => {
                out.push('\\');
                out.extend(other);
                wrong = wrong.or_else(|| Some(format!("\\{}", other.map(String::from).unwrap_or_default())));
            }
        }
    }
    (out, wrong)
}

fn hex4(text: &str) -> Option<u32> {
    let digits = text.get(..4)?;
    if digits.bytes().all(|byte| byte.is_ascii_hexdigit()) { u32::from_str_radix(digits, 16).ok() } else { None }
}
