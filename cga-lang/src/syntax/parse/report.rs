//! Diagnostics of the parser: the expected text, the found text, and the text to type.

use super::type_words::is_type;
use super::{MAX_DEPTH, Parsed, Parser, Reported};
use crate::diag::code::Code;
use crate::diag::{Diag, Line, RELATIVE};
use crate::ops::{operations, selector};
use crate::span::Span;
use crate::suggest::nearest;
use crate::syntax::ast::{Ast, Body};
use crate::syntax::lex::{NO_UNITS, without_unit};
use crate::syntax::token::{Sym, Tok};

/// The description of the contents of a rule's body.
pub(super) const STEP: &str = "an operation or a rule";

/// The description of the end of an argument.
pub(super) const LIST: &str = "`,` or `)`";

/// The description of the end of a size.
pub(super) const AFTER_SIZE: &str = "`:` after the size";

/// The description of the end of a selector.
pub(super) const AFTER_SELECTOR: &str = "`:` or `=` after the selector";

/// The number of tokens in which the start of a list is looked for.
const FAR: usize = 64;

/// The words that begin the last branch, in CGA and elsewhere.
const ELSE: [&str; 3] = ["else", "default", "otherwise"];

/// The words that begin a declaration.
const DECLARING: [&str; 6] = ["attr", "const", "style", "import", "version", "extension"];

/// The words that begin a declaration in other languages.
const ELSEWHERE: [&str; 8] = ["let", "var", "fn", "func", "function", "def", "static", "attribute"];

impl Parser<'_> {
    /// Reports a mistake at a position, unless the source has reported unreadable text directly beside it.
    pub(super) fn syntax(&mut self, at: usize, message: impl Into<Line>) -> &mut Diag {
        let span = self.span_at(at);
        self.syntax_over(at, span, message)
    }

    /// Reports a mistake at a position and underlines `span`.
    pub(super) fn syntax_over(&mut self, at: usize, span: Span, message: impl Into<Line>) -> &mut Diag {
        let list = if self.layout.beside_bad(at) { &mut self.muted } else { &mut self.diags };
        list.report(Code::Syntax, span, message)
    }

    /// Reports an unexpected token, with help for the usual mistakes.
    pub(super) fn expected(&mut self, what: &str) -> &mut Diag {
        if what == STEP && self.at_selector_without_bar() {
            return self.missing_bar();
        }
        if let Some(value) = self.number_with_unit() {
            return self.expected_only(what).note(NO_UNITS).help(format!("write `{value}`"));
        }
        let help = self.meant(what);
        let diag = self.expected_only(what);
        match help {
            Some(help) => diag.help(help),
            None => diag,
        }
    }

    /// Returns true if a `:` follows a selector that was read as a rule.
    fn at_selector_without_bar(&self) -> bool {
        let before = self.before(1).and_then(Tok::ident);
        let begins = self.before(2).is_none_or(|token| token.is(Sym::Arrow) || token.is(Sym::LBrace));
        !begins
            && matches!(self.peek(), Some(Tok::Sym(Sym::Colon | Sym::Assign)))
            && !self.at_border()
            && before.is_some_and(|word| selector(word).is_some() && !self.layout.has_rule(word))
    }

    /// Reports the missing `|` before such a selector, at its `:`.
    fn missing_bar(&mut self) -> &mut Diag {
        let word = self.layout.word(self.at - 1).unwrap_or_default();
        let sign = if self.is(Sym::Colon) { ":" } else { "=" };
        let diag = self.syntax(self.at - 1, format!("there is no `|` before the selector `{word}`"));
        diag.help(format!("write `| {word} {sign}`"))
    }

    /// Returns the help for the usual mistake with the current token.
    fn meant(&self, what: &str) -> Option<String> {
        let (step, next) = (what == STEP, self.nth(1));
        let before = self.before(1);
        let word = before.and_then(Tok::ident).unwrap_or_default();
        let is_operation = operations(word).next().is_some();
        Some(match self.peek()? {
            _ if self.at_border() => return None,
            Tok::Sym(Sym::Assign) if self.nth_is(1, Sym::Greater) => "write `>=`".into(),
            Tok::Sym(Sym::Assign) if self.nth_is(1, Sym::Less) => "write `<=`".into(),
            Tok::Sym(Sym::Assign) if self.nth_is(1, Sym::Bang) => "write `!=`".into(),
            Tok::Sym(Sym::Assign) if self.is_behind_set() => "write `,`: as in `set(name, value)`".into(),
            Tok::Sym(Sym::Assign) if step && is_plain(word) => {
                let is_literal = matches!(next, Some(Tok::Number(_) | Tok::Str(_)));
                let value = if is_literal { self.written(self.at + 1, self.at + 2) } else { "…".into() };
                format!("write `set({word}, {value})` to change an attribute")
            }
            Tok::Sym(Sym::Assign) => match self.named_argument(what) {
                Some(help) => help,
                None => "two values are compared with `==`".into(),
            },
            Tok::Sym(Sym::Dot)
                if what == LIST && (self.nth_is(1, Sym::Dot) || before.is_some_and(|token| token.is(Sym::Dot))) =>
            {
                "the ends of a range are two arguments: write `,` for `..`".into()
            }
            Tok::Number(value) if step && is_operation => format!("write `{word}({value})`"),
            Tok::Number(value) if step && self.nth_is(1, Sym::Colon) && self.begins_body() && *value <= 100.0 => {
                let percent = if *value < 1.0 { (*value * 1e8).round() / 1e6 } else { *value };
                format!("write `{percent}% :` for a chance")
            }
            Tok::Number(value) if step && self.nth_is(1, Sym::Colon) && 0.0 < *value && *value <= 100.0 => {
                format!("put `|` between the slots of a split; a percentage is `{value}% :`")
            }
            Tok::Sym(Sym::Tilde | Sym::Quote) | Tok::Number(_) if step => "put `|` between the slots of a split".into(),
            Tok::Sym(Sym::Colon)
                if step && selector(word).is_some() && self.before(2).is_some_and(|token| token.is(Sym::LBrace)) =>
            {
                format!("these braces have no selectors: leave out `{word} :`")
            }
            Tok::Sym(Sym::RParen | Sym::Comma | Sym::RBrace)
                if what == "a value" && before.is_some_and(|token| token.is(Sym::Percent)) =>
            {
                return self.percentage();
            }
            Tok::Ident(word) if word == "else" && what == "a value" && self.nth_is(1, Sym::Colon) => {
                "the rest is `all` in a `comp` and `remainder` in a setback".into()
            }
            Tok::Sym(Sym::Colon) if step && nearest(word, ELSE).is_some() => "did you mean `else`?".into(),
            Tok::Sym(Sym::Colon) if step && !word.is_empty() && !is_operation => {
                format!("put `|` between the parts of a split or comp; a rule begins with `{word} -->`")
            }
            Tok::Sym(Sym::Colon) if step => "put `|` between the parts of a split or comp".into(),
            token @ (Tok::Ident(_) | Tok::Path(_)) if [AFTER_SIZE, AFTER_SELECTOR].contains(&what) => {
                format!("write `:` before {}", token.describe())
            }
            Tok::Ident(name) if what == "`:`" && before.is_some_and(|token| token.is(Sym::Percent)) => {
                let Some(Tok::Number(percent)) = self.before(2) else { return None };
                format!("write `{percent}% : {name}`")
            }
            Tok::Ident(_) => return self.cast(),
            Tok::Sym(Sym::LBrace) if what == "a value" => match (next, self.nth_is(2, Sym::RBrace)) {
                (Some(Tok::Ident(name)), true) => format!("write `{name}`: a value has no braces"),
                _ => "a value has no braces: write `( … )` around a part of it".into(),
            },
            Tok::Sym(Sym::LBrace) if step => "slots come after a split: write `split(x) { … }`".into(),
            Tok::Sym(Sym::Quote) => {
                format!("`{RELATIVE}` begins a relative size; a power is `pow(base, exponent)`")
            }
            Tok::Sym(Sym::Star) if before.is_some_and(|token| token.is(Sym::Star)) => {
                "a power is `pow(base, exponent)`".into()
            }
            Tok::Sym(Sym::Plus) if before.is_some_and(|token| token.is(Sym::RBrace)) => {
                "a repeat ends with `}*`: write `}*` for `}+`".into()
            }
            Tok::Sym(Sym::Tilde) if self.nth_is(1, Sym::Colon) => match before {
                Some(Tok::Number(value)) => format!("write `~{value}`"),
                _ => "write the `~` before the size, as in `~2`".into(),
            },
            Tok::Sym(Sym::Star) if step => "`*` comes after the `}` of the repeated slots".into(),
            _ => return None,
        })
    }

    /// Returns the help for `name = value` among arguments, or for a parameter with a default.
    fn named_argument(&self, what: &str) -> Option<String> {
        let name = self.before(1).and_then(Tok::ident).filter(|_| what == LIST)?;
        let open = match self.before(2)? {
            Tok::Sym(Sym::LParen) => Some(self.at - 2),
            Tok::Sym(Sym::Comma) => (3..FAR.min(self.at)).map(|back| self.at - back).find(|&open| {
                self.layout.at(open).is_some_and(|token| token.is(Sym::LParen))
                    && self.layout.close(open).is_some_and(|close| self.at < close)
            }),
            _ => return None,
        };
        let close = open.and_then(|open| self.layout.close(open));
        let is_parameter = close.and_then(|close| self.layout.at(close + 1)).is_some_and(|token| token.is(Sym::Arrow));
        Some(match is_parameter {
            true => format!("a parameter has no default: write `{name}` alone, and a second rule without it"),
            false => format!("arguments have no names: leave out `{name} =`"),
        })
    }

    /// Returns the help for a percentage as a value.
    fn percentage(&self) -> Option<String> {
        let Some(Tok::Number(percent)) = self.before(2) else { return None };
        let share = (percent * 1e6).round() / 1e8;
        Some(match self.relative {
            true => format!("write `{RELATIVE}{share}` for {percent} % of the scope"),
            false => format!("`%` is the remainder of a division: write `{percent}`, or `{share}` for a share"),
        })
    }

    /// Returns the help for `as` and a type.
    fn cast(&self) -> Option<String> {
        let ty = self.nth(1).and_then(Tok::ident).filter(|ty| self.is_word("as") && is_type(ty))?;
        Some(match ty {
            "str" | "String" | "string" => "leave out `as`: `str(…)` makes text".into(),
            "bool" | "boolean" => "leave out `as`: `bool(…)` makes a truth value".into(),
            _ => format!("leave out `as {ty}`: every number is a float"),
        })
    }

    /// Returns true if the body of a rule begins here.
    fn begins_body(&self) -> bool {
        self.before(1).is_some_and(|token| token.is(Sym::Arrow))
    }

    /// Returns true directly after the name in a call of `set`.
    fn is_behind_set(&self) -> bool {
        let (mut back, is_part) = (1, |token: &Tok| token.ident().is_some() || token.is(Sym::Dot));
        while self.before(back).is_some_and(is_part) && back < 8 {
            back += 1;
        }
        self.before(back).is_some_and(|token| token.is(Sym::LParen))
            && self.before(back + 1).and_then(Tok::ident) == Some("set")
    }

    /// Converts the previous number, if the current token is its unit.
    pub(super) fn number_with_unit(&self) -> Option<f64> {
        let unit = self.peek().and_then(Tok::ident).filter(|_| !self.at_border())?;
        match self.before(1)? {
            Tok::Number(value) => without_unit(*value, unit),
            _ => None,
        }
    }

    /// Reports an unexpected token.
    pub(super) fn expected_only(&mut self, what: &str) -> &mut Diag {
        if self.at_border() && 0 < self.at {
            let tail = if self.layout.len() <= self.at { "the end" } else { "the next declaration" };
            return self.syntax(self.at - 1, format!("expected {what} after this, found {tail}"));
        }
        let found = self.peek().map_or("nothing".into(), Tok::describe);
        self.syntax(self.at, format!("expected {what}, found {found}"))
    }

    pub(super) fn fail<T>(&mut self, what: &str) -> Parsed<T> {
        Err(self.expected(what).into())
    }

    /// Passes over a required symbol.
    pub(super) fn expect(&mut self, sym: Sym) -> Parsed<()> {
        if self.eat(sym) { Ok(()) } else { self.fail(&format!("`{}`", sym.text())) }
    }

    /// Reports tokens after a declaration that do not belong to it.
    pub(super) fn leftover(&mut self, ast: &Ast) {
        let found = self.peek().map_or("nothing".into(), Tok::describe);
        match self.peek() {
            Some(token) if token.ident() == Some("else") => {
                self.syntax(self.at, "`else` without a `case` or percentage before it")
            }
            Some(Tok::Sym(Sym::RParen | Sym::RBrace | Sym::RBracket)) => {
                self.syntax(self.at, format!("this {found} has no matching opening bracket"))
            }
            Some(Tok::Sym(Sym::Semi)) => self
                .syntax(self.at, "declarations have no end symbol")
                .help("leave out the `;`: the next one begins by itself"),
            Some(Tok::Ident(word)) => {
                let near = nearest(word, DECLARING).map(|near| format!("did you mean `{near}`?"));
                let near = near.or_else(|| self.cast()).or_else(|| assigned(ast));
                let help = near.or_else(|| {
                    let is_other = ELSEWHERE.contains(&word.as_str());
                    is_other.then(|| "write `name = value`, `name(parameters) = value` or `const name = value`".into())
                });
                let diag = self.syntax(self.at, format!("unexpected {found}"));
                if let Some(help) = help {
                    diag.help(help);
                }
                diag
            }
            Some(Tok::Sym(Sym::Bar)) => self
                .syntax(self.at, format!("unexpected {found}"))
                .help("`|` separates the parts of a split or comp, between its braces"),
            _ => self.syntax(self.at, format!("unexpected {found}")),
        };
    }

    pub(super) fn too_deep<T>(&mut self) -> Parsed<T> {
        if !self.deep {
            self.deep = true;
            let span = self.span();
            self.diags
                .report(Code::TooDeep, span, format!("nested more than {MAX_DEPTH} deep"))
                .help("move a part into a rule or function of its own");
        }
        Err(Reported)
    }
}

/// Returns the help for `Rule --> name = value …`, which ends the rule and declares a function.
fn assigned(ast: &Ast) -> Option<String> {
    let [.., rule, function] = ast.decls.as_slice() else { return None };
    let is_empty = matches!(&rule.body, Body::Rule(ops) if ops.is_empty());
    let is_function = matches!(function.body, Body::Function(_)) && function.params.is_empty();
    (is_empty && is_function)
        .then(|| format!("in a rule write `set({}, …)` to change an attribute", function.name.text))
}

/// Returns true if the word may be the name of an attribute.
fn is_plain(word: &str) -> bool {
    word.starts_with(|c: char| c.is_lowercase() || c == '_') && operations(word).next().is_none()
}
