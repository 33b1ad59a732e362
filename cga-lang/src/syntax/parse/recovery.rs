//! Spellings of other languages with a clear meaning: `if`, `and`, `<>`, `=>`, types.
//!
//! They are recognised only where CGA would report a mistake, because a rule or attribute may have such a word as its
//! name.

use super::layout::Head;
use super::type_words::{is_binding, is_type};
use super::{Parsed, Parser};
use crate::diag::RELATIVE;
use crate::diag::code::Code;
use crate::ops::{operations, shape_attr};
use crate::span::Span;
use crate::syntax::ast::{Name, OpKind};
use crate::syntax::token::{Sym, Tok, Tokens};
use std::ops::Range;

/// The maximum length of quoted rules in a message, in bytes.
const LONGEST: usize = 40;

impl Parser<'_> {
    /// The text from one position to another, exclusive.
    pub(super) fn written(&self, from: usize, to: usize) -> String {
        let tokens: Tokens = (from..to).filter_map(|position| self.layout.at(position)).cloned().collect();
        let last = tokens.len().saturating_sub(1) as u32;
        tokens.text(Span { first: 0, last }, LONGEST, RELATIVE)
    }

    /// Reports and skips an assignment to an attribute of the shape, as in `scope.sy = 3`. The same tokens could be a
    /// leaf `scope.` before a function `sy`, which is never meant.
    pub(super) fn assignment(&mut self, name: &Name) -> Parsed<bool> {
        let Some(word) = self.peek().and_then(Tok::ident) else { return Ok(false) };
        if !self.nth_is(1, Sym::Assign) {
            return Ok(false);
        }
        let mut start = self.at - 2;
        let mut attribute = format!("{}.{word}", name.text);
        // The parts of a longer name look like leaves before this one.
        while shape_attr(&attribute).is_none()
            && let Some(first) = start.checked_sub(2)
            && self.layout.is(first + 1, Sym::Dot)
            && let Some(part) = self.layout.at(first).and_then(Tok::ident)
        {
            attribute = format!("{part}.{attribute}");
            start = first;
        }
        if shape_attr(&attribute).is_none() {
            return Ok(false);
        }
        self.at += 2;
        let (from, span) = (self.at, self.span_from(start));
        self.expr()?;
        let value = self.written(from, self.at);
        self.syntax_over(start, span, format!("`{attribute}` is changed by an operation"))
            .help(format!("write `set({attribute}, {value})`"));
        Ok(true)
    }

    /// Returns true if `if`, or a similar word, begins a condition here.
    pub(super) fn at_if(&self) -> bool {
        self.peek().and_then(Tok::ident).is_some_and(is_if)
            && !self.at_border()
            && self.begins_operand(1)
            && !self.layout.declares(self.peek().and_then(Tok::ident).unwrap_or_default())
            && self.condition(self.at + 1).is_some()
    }

    /// Returns true if the token `ahead` of the current one may begin a value but cannot follow a name.
    fn begins_operand(&self, ahead: usize) -> bool {
        !self.layout.is_border(self.at + ahead)
            && match self.nth(ahead) {
                Some(Tok::Ident(word)) => !matches!(word.as_str(), "case" | "else") && !is_if(word),
                Some(Tok::Number(_) | Tok::Str(_) | Tok::Host(_) | Tok::Path(_)) => true,
                Some(Tok::Sym(Sym::LParen | Sym::Bang)) => true,
                _ => false,
            }
    }

    /// The condition at `from`, and true if `{` follows it in place of `:`. Parentheses before a `{` are left out.
    fn condition(&self, from: usize) -> Option<(Range<usize>, bool)> {
        // True if a `{` belongs to an operation in between.
        let (mut at, mut has_step) = (from, false);
        while !self.layout.is_border(at) {
            match self.layout.at(at)? {
                Tok::Sym(Sym::Colon) => return (from < at).then_some((from..at, false)),
                Tok::Sym(Sym::LBrace) if has_step => return None,
                Tok::Sym(Sym::LBrace)
                    if self.layout.is(from, Sym::LParen) && self.layout.close(from) == Some(at - 1) =>
                {
                    return Some((from + 1..at - 1, true));
                }
                Tok::Sym(Sym::LBrace) => return (from < at).then_some((from..at, true)),
                Tok::Sym(Sym::Bar | Sym::Comma | Sym::Semi | Sym::RBrace | Sym::RBracket | Sym::RParen) => return None,
                Tok::Sym(Sym::LParen | Sym::LBracket) => at = self.layout.close(at)?,
                Tok::Sym(Sym::Percent) if self.layout.is(at + 1, Sym::Colon) => return None,
                Tok::Sym(Sym::Arrow) => has_step = true,
                // A `:` or `{` belongs to the inner branch.
                Tok::Ident(word) if matches!(word.as_str(), "case" | "else") || is_if(word) => return None,
                Tok::Ident(word) => has_step |= operations(word).next().is_some(),
                _ => {}
            }
            at += 1;
        }
        None
    }

    /// The text of the condition at `from`, and true if `{` follows it.
    fn written_condition(&self, from: usize) -> (String, bool) {
        let (tokens, braces) = self.condition(from).unwrap_or((from..from, false));
        (self.written(tokens.start, tokens.end), braces)
    }

    /// The message about `if`.
    pub(super) fn about_if(&self) -> String {
        let word = self.peek().map_or(String::new(), Tok::describe);
        format!("a condition begins with `case`, not with {word}")
    }

    /// Reports `if`, or `case` after `else`, and passes over these `count` words. Fails if the arms are in braces.
    pub(super) fn no_case(&mut self, count: usize, message: String) -> Parsed<()> {
        let (condition, braces) = self.written_condition(self.at + count);
        let span = self.span().to(self.span_at(self.at + count - 1));
        let rest = if braces { " … else : …" } else { "" };
        let diag = self.syntax_over(self.at, span, message).help(format!("write `case {condition} :{rest}`"));
        if braces {
            return Err(diag.into());
        }
        self.at += count;
        Ok(())
    }

    /// Reports an `if` after operations.
    pub(super) fn if_behind_steps<T>(&mut self) -> Parsed<T> {
        let (condition, _) = self.written_condition(self.at + 1);
        let diag = self.syntax(self.at, self.about_if());
        Err(diag.help(format!("after operations write `[ case {condition} : … else : … ]`")).into())
    }

    /// Returns true if a loop of another language begins here: `for i in`, `while scope.sx > 3 {`.
    pub(super) fn at_loop(&self) -> bool {
        let Some(word) = self.peek().and_then(Tok::ident) else { return false };
        !self.layout.declares(word)
            && match word {
                "for" => self.nth_is_name(1) && self.nth(2).and_then(Tok::ident) == Some("in"),
                "while" => self.begins_operand(1) && self.condition(self.at + 1).is_some_and(|(_, braces)| braces),
                _ => false,
            }
    }

    /// Reports a loop of another language.
    pub(super) fn no_loop<T>(&mut self) -> Parsed<T> {
        let word = self.peek().map_or(String::new(), Tok::describe);
        let diag = self.syntax(self.at, format!("rules have no loops, and {word} is not an operation"));
        let diag = diag.help("`split(x) { { ~size : … }* }` repeats a slot");
        Err(diag.help("a rule that calls itself under a `case` repeats operations").into())
    }

    /// Returns true if a variable of another language begins here: `let name = …` among operations.
    pub(super) fn at_binding(&self) -> bool {
        self.peek().and_then(Tok::ident).is_some_and(is_binding) && self.nth_is_name(1) && self.nth_is(2, Sym::Assign)
    }

    /// Reports and passes over such a variable.
    pub(super) fn binding(&mut self) -> Parsed<OpKind> {
        let name = self.layout.word(self.at + 1).unwrap_or_default().to_owned();
        self.syntax(self.at, "values of a rule have their names before its arrow")
            .help(format!("write `Rule with ( {name} := … ) --> …`"));
        self.at += 3;
        self.expr()?;
        Ok(OpKind::Error)
    }

    /// Returns true if a further condition follows the `else` here.
    pub(super) fn at_else_if(&self) -> bool {
        let next = self.nth(1).and_then(Tok::ident);
        self.is_word("else")
            && next.is_some_and(|word| word == "case" || is_if(word))
            && self.condition(self.at + 2).is_some()
    }

    /// The operator that the current word means between two values.
    pub(super) fn operator_word(&self) -> Option<Sym> {
        if self.at_border() {
            return None;
        }
        match self.peek()?.ident()? {
            "and" | "AND" => Some(Sym::AndAnd),
            "or" | "OR" => Some(Sym::OrOr),
            _ => None,
        }
    }

    /// Reports that the current `length` tokens are not an operator, and suggests the intended one.
    pub(super) fn no_operator(&mut self, length: usize, meant: Sym) {
        let span = self.span().to(self.span_at(self.at + length - 1));
        let found = self.written(self.at, self.at + length).replace(' ', "");
        self.syntax_over(self.at, span, format!("`{found}` is not an operator"))
            .help(format!("write `{}`", meant.text()));
    }

    /// Returns true if a `not` before a value begins here.
    pub(super) fn at_not(&self) -> bool {
        let next_is_operand = match self.nth(1) {
            // `not(a)` may be a function of the file.
            Some(Tok::Sym(Sym::LParen)) => !self.layout.declares("not"),
            Some(Tok::Ident(word)) if matches!(word.as_str(), "and" | "or" | "AND" | "OR") => false,
            Some(Tok::Sym(Sym::Bang)) => !self.nth_is(2, Sym::Assign),
            _ => self.begins_operand(1),
        };
        matches!(self.peek().and_then(Tok::ident), Some("not" | "NOT")) && next_is_operand
    }

    /// Reports the `not` at `start`, after its operand.
    pub(super) fn not_for_bang(&mut self, start: usize) {
        let operand = self.written(start + 1, self.at);
        let whole = self.at == start + 2 || self.layout.close(start + 1) == Some(self.at - 1);
        let operand = if whole { operand } else { format!("({operand})") };
        let word = self.layout.at(start).map_or(String::new(), Tok::describe);
        self.syntax(start, format!("{word} is not an operator")).help(format!("write `!{operand}`"));
    }

    /// Reports and passes over the tokens written in place of `:`, if there are any.
    pub(super) fn slipped_colon(&mut self, behind: &str) -> bool {
        let length = match (self.peek(), self.nth(1)) {
            (Some(Tok::Sym(Sym::Assign | Sym::Minus)), Some(Tok::Sym(Sym::Greater))) => 2,
            (Some(Tok::Sym(Sym::Assign | Sym::Arrow)), _) => 1,
            _ => return false,
        };
        let span = self.span().to(self.span_at(self.at + length - 1));
        let found = self.written(self.at, self.at + length).replace(' ', "");
        self.syntax_over(self.at, span, format!("expected `:` after {behind}, found `{found}`")).help("write `:`");
        self.at += length;
        true
    }

    /// Reports and passes over a type before the name of an attribute or constant, if there is one.
    pub(super) fn type_before_name(&mut self, word: &str) {
        let next = self.at + 1;
        let declared = !self.layout.is_border(next) || self.layout.head(next) == Some(Head::Function);
        if self.peek().and_then(Tok::ident).is_some_and(is_type) && self.nth_is_name(1) && declared {
            let rest = self.written(next, self.layout.border(next + 1));
            self.no_types(self.at, format!("{word} {}", rest.trim_end_matches([' ', ';'])));
            self.bump();
        }
    }

    /// Reports and passes over a type before the name of a parameter, if there is one.
    pub(super) fn type_before_parameter(&mut self) {
        if let (Some(word), Some(name)) = (self.peek().and_then(Tok::ident), self.nth(1).and_then(Tok::ident))
            && is_type(word)
        {
            self.no_types(self.at, name.to_owned());
            self.bump();
        }
    }

    /// Reports and passes over `: float` after a name, if it is there.
    pub(super) fn type_behind_name(&mut self, so: impl FnOnce() -> String) {
        if self.is(Sym::Colon) && self.nth(1).and_then(Tok::ident).is_some_and(is_type) {
            self.no_types(self.at + 1, so());
            self.at += 2;
        }
    }

    fn no_types(&mut self, at: usize, so: String) {
        let span = self.span_at(at);
        if self.layout.at(at).and_then(Tok::ident).is_some_and(is_binding) {
            let message = format!("`{}` does not begin a declaration", self.written(at, at + 1));
            self.diags.report(Code::Syntax, span, message).help(format!("write `{so}`"));
            return;
        }
        self.diags
            .report(Code::Syntax, span, "types cannot be declared")
            .note("the type of a value follows from its expression")
            .help(format!("write `{so}`"));
    }
}

/// Returns true if a word begins a condition in other languages.
fn is_if(word: &str) -> bool {
    matches!(word, "if" | "If" | "IF" | "elif" | "elsif" | "elseif" | "when")
}
