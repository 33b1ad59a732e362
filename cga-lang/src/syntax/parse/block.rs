//! Operations with braces: `split(x) { ~1 : A }`, `setback(2) { front : A | remainder : B }`.
//!
//! The operation's row in the table defines the contents of the braces. Without a row the parser guesses, so that it
//! can read the rest of the rule; the check of names reports the unknown operation.

use super::{Parsed, Parser, Reported};
use crate::diag::code::Code;
use crate::ops::{self, Braces, Measure};
use crate::syntax::ast::{Arg, Block, BlockPart, Name, Op, OpKind, Section};
use crate::syntax::token::{Sym, Tok};

/// Returns the kind of braces after an operation, if the table has the operation.
fn block_of(name: &str) -> Option<Braces> {
    let mut rows = ops::operations(name).map(|row| row.braces).filter(|braces| *braces != Braces::None);
    // Old rows, such as the row of `union`, have no braces.
    rows.clone().find(|braces| *braces != Braces::Inline).or_else(|| rows.next())
}

/// Returns true if an operation needs arguments.
pub(super) fn needs_arguments(name: &str) -> bool {
    ops::operations(name).all(|row| 0 < ops::required(row.params))
}

impl Parser<'_> {
    /// Parses the braces after a name and its arguments.
    pub(super) fn block(&mut self, name: Name, args: Vec<Arg>) -> Parsed<OpKind> {
        let braces = match block_of(&name.text) {
            Some(known) => known,
            None => self.guess()?,
        };
        let part = match braces {
            Braces::Slots(_) => {
                let (items, repeat) = self.slots()?;
                BlockPart::Slots(items, repeat)
            }
            Braces::Sections => return self.perimeter(name, args),
            Braces::Arms(_) | Braces::Components | Braces::Modified => BlockPart::Arms(self.arms_of_block()?),
            Braces::Ops | Braces::Inline | Braces::None => BlockPart::Ops(self.operands(&name, 1)?),
            Braces::Operands => BlockPart::Ops(self.operands(&name, 2)?),
        };
        if !matches!(part, BlockPart::Slots(..)) {
            self.not_repeated(&name.text);
        }
        Ok(OpKind::Block(Block { name, args, parts: vec![part] }))
    }

    /// Returns the help for an operation without its braces.
    pub(super) fn missing_braces(&self, name: &str) -> Option<String> {
        let inside = match block_of(name)? {
            Braces::None => return None,
            Braces::Inline => return Some(format!("write `{name} Rule` or `{name} {{ operations }}`")),
            Braces::Sections => "{ length : depth : operations | … } { remainder : operations }",
            Braces::Slots(_) => "{ size : operations | … }",
            Braces::Arms(_) | Braces::Components | Braces::Modified => "{ selector : operations | … }",
            Braces::Ops => "{ operations }",
            Braces::Operands => "{ operations | operations }",
        };
        let arguments =
            ops::operations(name).min_by_key(|row| ops::required(row.params)).map_or(String::new(), |row| {
                if ops::required(row.params) == 0 {
                    return String::new();
                }
                match row.params[0].kind.words().map(|words| words.list[0]) {
                    Some(word) if ops::required(row.params) == 1 => format!("({word})"),
                    Some(word) => format!("({word}, …)"),
                    None => "(…)".to_owned(),
                }
            });
        Some(format!("write `{name}{arguments} {inside}`"))
    }

    /// Guesses the contents of the braces of an unknown operation from arm separators, sizes and bars.
    fn guess(&mut self) -> Parsed<Braces> {
        let close = self.closing()?;
        let (mut at, mut arms, mut size, mut bar) = (self.at + 1, false, false, false);
        let (mut first, mut branch) = (true, false);
        while at < close {
            match self.layout.at(at) {
                Some(Tok::Sym(Sym::Quote | Sym::Tilde)) if first => size = true,
                Some(Tok::Sym(Sym::LBrace)) if first => size = true,
                Some(Tok::Ident(word)) if first => branch = word == "case",
                Some(Tok::Number(_)) if first => {
                    branch = self.layout.at(at + 1).is_some_and(|token| token.is(Sym::Percent));
                }
                Some(Tok::Sym(Sym::Colon | Sym::Assign)) => arms |= !branch,
                Some(Tok::Sym(Sym::Bar)) => bar = true,
                _ => {}
            }
            first = self.layout.at(at).is_some_and(|token| token.is(Sym::Bar));
            at = self.layout.close(at).unwrap_or(at) + 1;
        }
        let star = self.layout.at(close + 1).is_some_and(|token| token.is(Sym::Star));
        Ok(match (size || star, arms, bar) {
            (true, _, _) => Braces::Slots(Measure::Length),
            (_, true, _) => Braces::Components,
            (_, _, true) => Braces::Operands,
            _ => Braces::Ops,
        })
    }

    /// Parses `count` sequences of operations, separated by `|`. A sequence that cannot be read is an error step, and so is one that
    /// is left out: one sequence alone is the old form of boolean operations.
    fn operands(&mut self, name: &Name, count: usize) -> Parsed<Vec<Vec<Op>>> {
        let close = self.closing()?;
        let mut list = self.between_bars(None, |parser| {
            let start = parser.at;
            Ok(parser.ops(false).unwrap_or_else(|Reported| {
                parser.skip_to_bar(close);
                vec![Op { kind: OpKind::Error, span: parser.span_from(start) }]
            }))
        })?;
        if list.len() != count {
            let message = match count {
                1 => format!("`{}` takes one sequence of operations, got {}", name.text, list.len()),
                _ => format!("`{}` takes two sequences of operations, `{{ A | B }}`, got {}", name.text, list.len()),
            };
            self.syntax_over(close, name.span, message);
            list.resize_with(count.max(list.len()), || vec![Op { kind: OpKind::Error, span: name.span }]);
        }
        Ok(list)
    }

    fn perimeter(&mut self, name: Name, args: Vec<Arg>) -> Parsed<OpKind> {
        let sections = self.between_bars(Some("length : depth : operations"), Self::section)?;
        let mut parts = vec![BlockPart::Sections(sections, self.eat(Sym::Star))];
        if self.is(Sym::LBrace) {
            parts.push(BlockPart::Arms(self.arms_of_block()?));
        } else {
            self.expected("`{`").help("write `{ remainder : operations }` after the sections");
        }
        Ok(OpKind::Block(Block { name, args, parts }))
    }

    fn section(&mut self) -> Parsed<Section> {
        let usage = "a section is `length : depth : operations`";
        if self.is(Sym::LBrace) {
            // *splitAndSetbackPerimeter operation*: the forms have one level.
            return Err(self
                .expected("a length")
                .help("sections have no groups: `*` after the braces repeats all")
                .into());
        }
        let length = self.sized(true)?;
        if !self.eat(Sym::Colon) {
            return Err(self.expected("`:` after the length").help(usage).into());
        }
        let depth = self.expr()?;
        if !self.eat(Sym::Colon) {
            return Err(self.expected("`:` after the depth").help(usage).into());
        }
        Ok(Section { length, depth, ops: self.ops(false)? })
    }

    /// Returns true if `inline …`, or `union Rule` as written before 2025, continues here after its name.
    pub(super) fn at_inlined(&self, name: &str) -> bool {
        if !ops::operations(name).any(|row| row.braces == Braces::Inline) {
            return false;
        }
        let next = match self.is(Sym::LParen).then(|| self.layout.close(self.at)) {
            Some(Some(close)) => close + 1,
            Some(None) => return false,
            None => self.at,
        };
        let brace = self.layout.at(next).is_some_and(|token| token.is(Sym::LBrace));
        let step = matches!(self.layout.at(next), Some(Tok::Ident(word)) if !matches!(word.as_str(), "case" | "else"));
        (step && !self.layout.is_border(next)) || (brace && block_of(name) == Some(Braces::Inline))
    }

    /// Returns true if an operation can follow `inline` without braces: a rule or a subdivision (*Rule inlining*).
    fn can_inline(&self, op: &Op) -> bool {
        let is_operation = |name: &str| name == "set" || ops::operations(name).next().is_some();
        match &op.kind {
            OpKind::Call(name, _) => self.layout.has_rule(&name.text) || !is_operation(&name.text),
            OpKind::Block(block) => block_of(&block.name.text).is_none_or(Braces::divides),
            OpKind::Dynamic { .. } | OpKind::Error => true,
            _ => false,
        }
    }

    /// Parses `inline(mode) Rule`, `inline comp(f) { … }` or `subtract(swap) Rule`, after the name.
    pub(super) fn inlined(&mut self, name: Name) -> Parsed<OpKind> {
        let args = if self.is(Sym::LParen) { self.args(&name.text)? } else { Vec::new() };
        if self.is(Sym::LBrace) {
            return self.block(name, args);
        }
        let op = self.nested(Self::op)?;
        if !self.can_inline(&op) {
            let message = format!("`{}` takes a rule, a subdivision or operations in braces", name.text);
            let written = if block_of(&name.text) == Some(Braces::Operands) { "{ Operand. | … }" } else { "{ … }" };
            self.diags
                .report(Code::Syntax, op.span, message)
                .help(format!("put braces around it: `{} {written}`", name.text));
        }
        Ok(OpKind::Block(Block { name, args, parts: vec![BlockPart::Ops(vec![vec![op]])] }))
    }
}
