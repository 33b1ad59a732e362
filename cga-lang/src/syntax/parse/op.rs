//! Operations of a rule: operations, successors, leaves, brackets.
//!
//! A `[` after an operation pushes, because an operation has no value to index. A `[` after a value indexes.

use super::block::needs_arguments;
use super::item::is_keyword;
use super::report::{LIST, STEP};
use super::{Parsed, Parser, Reported};
use crate::diag::code::Code;
use crate::ops::{self, ParamKind};
use crate::syntax::ast::{Arg, Expr, Name, Op, OpKind};
use crate::syntax::token::{Sym, Tok};

impl Parser<'_> {
    /// Parses operations up to the first token that does not begin one. A branch block must come first. With
    /// `in_arm`, the operations are an arm, so a further `case` belongs to the outer block.
    pub(super) fn ops(&mut self, in_arm: bool) -> Parsed<Vec<Op>> {
        let mut ops = Vec::new();
        while !self.at_border() && self.tick() {
            if self.at_branch() {
                if !ops.is_empty() {
                    if in_arm {
                        break;
                    }
                    if self.at_if() {
                        return self.if_behind_steps();
                    }
                    let (last, written) = match self.at_percent() {
                        true => (self.at + 1, "[ 50% : … else : … ]"),
                        false => (self.at, "[ case … else : … ]"),
                    };
                    let span = self.span().to(self.span_at(last));
                    self.diags
                        .report(Code::BranchNotFirst, span, "a branch block must come first in a rule's body")
                        .help(format!("put it in brackets: `{written}`"));
                }
                let branch = self.branch_ops(in_arm)?;
                ops.push(branch);
                if in_arm {
                    break;
                }
                continue;
            }
            match self.peek() {
                Some(Tok::Sym(Sym::Bar | Sym::RBrace | Sym::RBracket | Sym::RParen)) => break,
                Some(Tok::Sym(Sym::Comma)) if self.comma_ends || self.size_follows() || self.arm_follows() => break,
                Some(Tok::Sym(sym @ (Sym::Semi | Sym::Comma))) => {
                    let help = match sym {
                        Sym::Semi => "leave out the `;`: a rule runs to the next declaration",
                        _ => "leave out the `,`: operations need no separator",
                    };
                    self.syntax(self.at, "operations have no end symbol").help(help);
                    self.bump();
                }
                Some(token) if token.ident() == Some("else") => break,
                _ => ops.push(self.op()?),
            }
        }
        Ok(ops)
    }

    /// Returns true if a size follows the current token, which was then meant as `|`.
    fn size_follows(&self) -> bool {
        matches!(self.nth(1), Some(Tok::Number(_) | Tok::Sym(Sym::Tilde | Sym::Quote)))
    }

    /// Returns true if an arm of a comp follows the current token, as in `top : Roof, side : Wall`.
    fn arm_follows(&self) -> bool {
        matches!(self.nth(1), Some(Tok::Ident(word)) if word != "case" && ops::selector(word).is_some())
            && matches!(self.nth(2), Some(Tok::Sym(Sym::Colon | Sym::Assign)))
    }

    pub(super) fn op(&mut self) -> Parsed<Op> {
        let start = self.at;
        let kind = match self.peek() {
            _ if self.at_border() => return self.fail(STEP),
            _ if self.at_loop() => return self.no_loop(),
            _ if self.at_binding() => self.binding()?,
            Some(Tok::Ident(_)) => self.op_with_name()?,
            Some(Tok::Path(_)) => self.rust()?,
            Some(Tok::Sym(Sym::LBracket)) => self.brackets()?,
            Some(Tok::Number(_)) if self.nth_is(1, Sym::Percent) => {
                self.at += 2;
                return self.fail("`:`");
            }
            Some(Tok::Host(_)) => {
                return Err(self.expected(STEP).help("a Rust value is allowed in expressions only").into());
            }
            _ => return self.fail(STEP),
        };
        Ok(Op { kind, span: self.span_from(start) })
    }

    /// Parses an operation that begins with a name: a call, a block, a leaf, `NIL`, or a rule of an import.
    fn op_with_name(&mut self) -> Parsed<OpKind> {
        let end = self.layout.name_end(self.at);
        let Some(name) = self.take_dotted(end) else { return self.fail("a name") };
        match name.text.as_str() {
            "NIL" => {
                if self.is(Sym::Dot) {
                    self.syntax(self.at, "`NIL` is not a leaf and has no dot").help("leave out the dot");
                    self.bump();
                }
                return Ok(OpKind::Nil);
            }
            "else" | "case" => {
                self.at -= 1;
                return self.fail(STEP);
            }
            _ => {}
        }
        // An old file may declare a rule with that name; then the braces decide.
        let own = self.layout.has_rule(&name.text) && !is_keyword(&name.text);
        if !own && self.at_inlined(&name.text) {
            return self.inlined(name);
        }
        if self.is(Sym::LParen) && self.layout.holds_overrides(self.at) {
            return self.dynamic(name);
        }
        if self.is(Sym::LParen) && !own && self.layout.is_import(self.at - 1) && !name.text.contains('.') {
            let close = self.closing()?;
            self.syntax(close, format!("`{}` is an import and cannot be called, only its rules can", name.text))
                .help(format!("write `{}(…).Rule`", name.text));
            self.at = close + 1;
            return Ok(OpKind::Error);
        }
        if self.eat(Sym::Dot) {
            return self.leaf(name);
        }
        let args = if self.is(Sym::LParen) { Some(self.args(&name.text)?) } else { None };
        if args.is_some() && self.is(Sym::Dot) {
            let is_operation = ops::operations(&name.text).next().is_some();
            if is_operation {
                self.syntax(self.at, "operations are not joined by a dot").help("leave out the dot");
            } else {
                self.syntax(self.at, "a leaf has no arguments")
                    .help(format!("write `{}.`, or leave out the dot", name.text));
            }
            self.bump();
            if !is_operation {
                return Ok(OpKind::Error);
            }
        }
        let has_args = args.is_some();
        let args = args.unwrap_or_default();
        if self.is(Sym::LBrace) {
            return self.block(name, args);
        }
        if !own && let Some(usage) = self.missing_braces(&name.text) {
            let lacks_args = !has_args && needs_arguments(&name.text);
            let is_step = !lacks_args && !matches!(self.peek(), Some(Tok::Number(_) | Tok::Str(_) | Tok::Host(_)));
            let goes_on = self.at_border() || is_step && !self.at_part();
            self.lacks_brace = true;
            self.expected(if lacks_args { "`(`" } else { "`{`" }).help(usage);
            return if goes_on { Ok(OpKind::Error) } else { Err(Reported) };
        }
        Ok(OpKind::Call(name, args))
    }

    /// Parses a leaf after its dot. It is a function of its own, so that nested operations need little stack.
    fn leaf(&mut self, name: Name) -> Parsed<OpKind> {
        if self.assignment(&name)? {
            return Ok(OpKind::Error);
        }
        // Arguments of a leaf, as in old files, have no effect.
        if self.is(Sym::LParen) {
            let start = self.at;
            self.args("")?;
            let span = self.span_from(start);
            self.diags
                .report(Code::OldSpelling, span, "a leaf has no arguments; these have no effect")
                .help("leave them out");
        }
        Ok(OpKind::Leaf(name))
    }

    fn rust(&mut self) -> Parsed<OpKind> {
        let Some(path) = self.take_name() else { return self.fail("a path") };
        if !self.is(Sym::LParen) {
            return self.no_call(&path);
        }
        Ok(OpKind::Path(path, self.args("")?))
    }

    fn brackets(&mut self) -> Parsed<OpKind> {
        let close = self.closing()?;
        self.bump();
        let ops = self.bracketed(false, |parser| parser.ops(false)).unwrap_or_else(|Reported| {
            let span = self.span();
            self.at = close;
            vec![Op { kind: OpKind::Error, span }]
        });
        if self.at != close {
            self.expected("`]`");
            self.at = close;
        }
        self.bump();
        Ok(OpKind::Push(ops))
    }

    /// Returns true if a slot or an arm begins here, as in `front : Wall. | …`.
    fn at_part(&self) -> bool {
        let mut at = self.at;
        while !self.layout.is_border(at) && !self.at_branch() {
            match self.layout.at(at) {
                Some(Tok::Sym(Sym::Colon | Sym::Assign)) => return true,
                Some(Tok::Sym(Sym::LParen | Sym::LBracket | Sym::LBrace)) => match self.layout.close(at) {
                    Some(close) => at = close,
                    None => return false,
                },
                Some(Tok::Sym(Sym::Bar | Sym::RParen | Sym::RBracket | Sym::RBrace)) => return false,
                _ => {}
            }
            at += 1;
        }
        false
    }

    /// Parses the `( … )` of an operation, or of something without parameters that can be relative. An argument that cannot be read becomes an error value, which silences further diagnostics
    /// about the call.
    pub(super) fn args(&mut self, name: &str) -> Parsed<Vec<Arg>> {
        let close = self.closing()?;
        self.bump();
        let mut args = Vec::new();
        while self.at < close && self.tick() {
            let start = self.at;
            let relative = takes_relative(name, args.len());
            let result = self.bracketed(false, |parser| parser.sized(relative)).and_then(|arg| {
                let more = self.at < close;
                if more && !self.is(Sym::Comma) {
                    return self.fail(LIST);
                }
                if more && self.at + 1 == close {
                    self.bump();
                    return self.fail("an argument");
                }
                Ok(arg)
            });
            match result {
                Ok(arg) => args.push(arg),
                Err(Reported) => {
                    let span = self.span_from(start);
                    args.push(Arg { prefix: None, value: Expr::error(span), span });
                    break;
                }
            }
            if self.at < close {
                self.bump();
            }
        }
        self.at = close + 1;
        Ok(args)
    }
}

/// Returns true if an argument of an operation can be relative to the scope.
fn takes_relative(name: &str, index: usize) -> bool {
    let mut params = ops::operations(name).filter_map(|row| row.params.get(index));
    params.any(|param| matches!(param.kind, ParamKind::Length | ParamKind::Size))
}
