//! Values: precedence climbing with C's levels.
//!
//! Every part comes with its depth, because a long chain makes as deep a tree as many brackets do, and whoever walks
//! the tree later must not run out of stack.

use super::{MAX_DEPTH, Parsed, Parser, Reported};
use crate::ast::{Arg, Binary, Expr, ExprKind, Name, Prefix, Unary};
use crate::code::Code;
use crate::span::Span;
use crate::token::{Sym, Tok};

/// A part and the depth of its tree.
type Part = (Expr, u32);

/// The level of `+` and `-`: what a size prefix reaches over.
const ADDITIVE: u8 = 5;

fn operator(token: &Tok) -> Option<(Binary, u8)> {
    let Tok::Sym(sym) = token else { return None };
    Some(match sym {
        Sym::OrOr => (Binary::Or, 1),
        Sym::AndAnd => (Binary::And, 2),
        Sym::EqEq => (Binary::Eq, 3),
        Sym::NotEq => (Binary::Ne, 3),
        Sym::Less => (Binary::Lt, 4),
        Sym::LessEq => (Binary::Le, 4),
        Sym::Greater => (Binary::Gt, 4),
        Sym::GreaterEq => (Binary::Ge, 4),
        Sym::Plus => (Binary::Add, ADDITIVE),
        Sym::Minus => (Binary::Sub, ADDITIVE),
        Sym::Star => (Binary::Mul, 6),
        Sym::Slash => (Binary::Div, 6),
        Sym::Percent => (Binary::Rem, 6),
        _ => return None,
    })
}

impl Parser<'_> {
    /// A value; `case` and percentages included.
    pub(super) fn value(&mut self) -> Parsed<Expr> {
        if self.at_branch() { self.branch_value() } else { self.expr() }
    }

    /// A value that is no branch block, unless in parentheses.
    pub(super) fn expr(&mut self) -> Parsed<Expr> {
        self.binary(0).map(|(expr, _)| expr)
    }

    /// A value that may have a size prefix.
    pub(super) fn arg(&mut self) -> Parsed<Arg> {
        let start = self.at;
        let prefix = match self.peek() {
            Some(Tok::Sym(Sym::Quote)) => Some((Prefix::Relative, self.span())),
            Some(Tok::Sym(Sym::Tilde)) => Some((Prefix::Floating, self.span())),
            _ => None,
        };
        let value = if prefix.is_some() {
            self.bump();
            self.binary(ADDITIVE)?.0
        } else {
            self.value()?
        };
        if self.is(Sym::Quote) && (self.nth_is(1, Sym::Comma) || self.nth_is(1, Sym::RParen)) {
            let span = self.span();
            self.diags
                .report(Code::StrayQuote, span, "`'` stands before a relative size, not behind it")
                .help("leave it out");
            self.bump();
        }
        Ok(Arg { prefix, value, span: self.span_from(start) })
    }

    fn binary(&mut self, least: u8) -> Parsed<Part> {
        let start = self.at;
        let (mut left, mut depth) = self.unary()?;
        while let Some((op, level)) = self.peek().and_then(operator) {
            if level < least {
                break;
            }
            let at = self.span();
            self.bump();
            let (right, right_depth) = self.binary(level + 1)?;
            depth = self.deepen(depth.max(right_depth))?;
            let kind = ExprKind::Binary(op, at, Box::new(left), Box::new(right));
            left = Expr { kind, span: self.span_from(start) };
        }
        if self.is(Sym::Dot) && self.nth(1).and_then(operator).is_some() {
            let span = self.span().to(self.span_at(self.at + 1));
            self.unsupported(span, "operators on the elements of an array are");
            return Err(Reported);
        }
        Ok((left, depth))
    }

    fn deepen(&mut self, depth: u32) -> Parsed<u32> {
        if MAX_DEPTH <= depth { self.too_deep() } else { Ok(depth + 1) }
    }

    fn unary(&mut self) -> Parsed<Part> {
        let start = self.at;
        let op = match self.peek() {
            Some(Tok::Sym(Sym::Minus)) => Unary::Minus,
            Some(Tok::Sym(Sym::Plus)) => Unary::Plus,
            Some(Tok::Sym(Sym::Bang)) => Unary::Not,
            Some(Tok::Sym(Sym::Quote | Sym::Tilde)) => {
                let (span, sign) = (self.span(), self.peek().map_or("it".into(), Tok::describe));
                self.diags
                    .report(Code::MisplacedPrefix, span, format!("{sign} cannot stand here"))
                    .help("it begins the size of a slot or a length: `'0.5 * a`, `'-a`, `~(a + b)`");
                return Err(Reported);
            }
            _ => return self.primary(),
        };
        self.bump();
        let (operand, depth) = self.nested(Self::unary)?;
        let depth = self.deepen(depth)?;
        Ok((Expr { kind: ExprKind::Unary(op, Box::new(operand)), span: self.span_from(start) }, depth))
    }

    fn primary(&mut self) -> Parsed<Part> {
        if self.at_border() {
            return self.fail("a value");
        }
        let span = self.span();
        let (kind, depth) = match self.peek() {
            Some(Tok::Number(value)) => (ExprKind::Number(*value), 1),
            Some(Tok::Str(text)) => (ExprKind::Text(text.clone()), 1),
            Some(Tok::Host(handle)) => (ExprKind::Host(*handle), 1),
            Some(Tok::Sym(Sym::LParen)) => return self.parentheses(),
            Some(Tok::Sym(Sym::LBracket)) => return self.array(span),
            Some(Tok::Ident(word)) => match word.as_str() {
                "true" => (ExprKind::Bool(true), 1),
                "false" => (ExprKind::Bool(false), 1),
                "case" | "else" => return self.fail("a value"),
                _ => return self.name_or_call(),
            },
            Some(Tok::Path(_)) => return self.name_or_call(),
            _ => return self.fail("a value"),
        };
        self.bump();
        Ok((Expr { kind, span }, depth))
    }

    fn array<T>(&mut self, span: Span) -> Parsed<T> {
        let span = self.layout.close(self.at).map_or(span, |close| span.to(self.span_at(close)));
        self.unsupported(span, "arrays are");
        Err(Reported)
    }

    fn parentheses(&mut self) -> Parsed<Part> {
        let start = self.at;
        let close = self.closing()?;
        self.bump();
        let (mut expr, depth) = self.nested(Self::deep_value)?;
        if self.at != close {
            return self.fail("`)`");
        }
        self.bump();
        // What a message underlines includes the parentheses.
        expr.span = self.span_from(start);
        Ok((expr, depth))
    }

    /// A value with its depth; a branch block's is not known, so it counts as its brackets do.
    fn deep_value(&mut self) -> Parsed<Part> {
        if !self.at_branch() {
            return self.binary(0);
        }
        let expr = self.branch_value()?;
        let depth = depth_of(&expr);
        if MAX_DEPTH < depth { self.too_deep() } else { Ok((expr, depth)) }
    }

    fn name_or_call(&mut self) -> Parsed<Part> {
        let start = self.at;
        let path = matches!(self.peek(), Some(Tok::Path(_)));
        let Some(mut name) = self.take_name() else { return self.fail("a name") };
        while !path && self.is(Sym::Dot) && !self.at_border() && self.tick() {
            let Some(Tok::Ident(part)) = self.nth(1) else { break };
            if self.layout.starts[self.at + 1] {
                break;
            }
            name.text.push('.');
            name.text.push_str(part);
            self.at += 2;
            name.span = self.span_from(start);
        }
        if self.is(Sym::LBracket) {
            let span = self.span();
            return self.array(span);
        }
        if !self.is(Sym::LParen) {
            if path {
                self.expected("`(`").help(format!("a Rust function is called as `{}()`", name.text));
                return Err(Reported);
            }
            let span = name.span;
            return Ok((Expr { kind: ExprKind::Name(name), span }, 1));
        }
        let (own, now) =
            (self.layout.functions.contains(&name.text), crate::ops::functions(&name.text).next().is_some());
        if crate::words::is_later_function(&name.text) && !now && !own {
            // Its arguments may be words or arrays, so they are not read.
            self.at = self.closing()? + 1;
            if self.is(Sym::LBrace) {
                self.at = self.closing()? + 1;
            }
            let span = name.span;
            return Ok((Expr { kind: ExprKind::Call(name, Vec::new()), span }, 1));
        }
        let args = self.call_args(&name)?;
        let depth = self.deepen(args.iter().map(|(_, depth)| *depth).max().unwrap_or(0))?;
        let args = args.into_iter().map(|(expr, _)| expr).collect();
        let kind = if path { ExprKind::Path(name, args) } else { ExprKind::Call(name, args) };
        Ok((Expr { kind, span: self.span_from(start) }, depth))
    }

    fn call_args(&mut self, name: &Name) -> Parsed<Vec<Part>> {
        let close = self.closing()?;
        self.bump();
        let mut args = Vec::new();
        while self.at < close && self.tick() {
            args.push(self.nested(Self::deep_value)?);
            if self.at < close && !self.eat(Sym::Comma) {
                return self.fail("`,` or `)`");
            }
            if self.at == close
                && self.span_at(self.at - 1) != self.span_at(close)
                && self.view_is(self.at - 1, Sym::Comma)
            {
                self.expected(&format!("another argument of `{}`", name.text));
                return Err(Reported);
            }
        }
        self.at = close + 1;
        Ok(args)
    }

    fn view_is(&self, at: usize, sym: Sym) -> bool {
        self.view.get(at).is_some_and(|&index| self.tokens[index as usize].is(sym))
    }
}

/// The depth of a tree whose parts are known to be bounded.
fn depth_of(expr: &Expr) -> u32 {
    let deepest = expr.parts().into_iter().map(depth_of).max().unwrap_or(0);
    deepest + 1
}
