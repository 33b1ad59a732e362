//! Values: precedence climbing with C's levels.

use super::arms::has_values;
use super::{MAX_DEPTH, Parsed, Parser, Reported};
use crate::diag::RELATIVE;
use crate::diag::code::Code;
use crate::span::Span;
use crate::syntax::ast::{Arg, Binary, Expr, ExprKind, Link, Name, OPERATORS, Prefix, Unary};
use crate::syntax::token::{Sym, Tok};

/// The level of `+` and `-`, the lowest inside the operand of a size prefix.
const ADDITIVE: u8 = 5;

/// The level of `==`, the lowest above `&&`.
const COMPARISON: u8 = 3;

/// The largest number of operators in a row that are nested, which is the form that most checks know, and of `&&` and `||`, since what
/// one condition says limits the next ones.
const MOST_NESTED: usize = 32;
const MOST_CONDITIONS: usize = 120;

/// An operator between two values, as written.
struct Operator {
    op: Binary,
    /// Its level of precedence.
    level: u8,
    /// True if it works element by element.
    each: bool,
    /// The number of its tokens.
    length: usize,
    /// The CGA symbol for an operator of another language.
    meant: Option<Sym>,
}

impl Parser<'_> {
    /// Parses a value, including `case` and percentages.
    pub(super) fn expr(&mut self) -> Parsed<Expr> {
        self.binary(0)
    }

    /// Makes the expression that begins at `start`.
    pub(super) fn node(&mut self, kind: ExprKind, start: usize) -> Parsed<Expr> {
        self.node_over(kind, self.span_from(start))
    }

    /// Makes the expression of a span.
    fn node_over(&mut self, kind: ExprKind, span: Span) -> Parsed<Expr> {
        let mut expr = Expr { kind, span, depth: 1 };
        expr.depth += expr.parts().iter().map(|part| part.depth).max().unwrap_or(0);
        if MAX_DEPTH < expr.depth { self.too_deep() } else { Ok(expr) }
    }

    /// Parses an argument or a size, which may be relative or not.
    pub(super) fn sized(&mut self, relative: bool) -> Parsed<Arg> {
        let outside = std::mem::replace(&mut self.relative, relative);
        let result = self.arg();
        self.relative = outside;
        result
    }

    /// Parses a value that may have a size prefix.
    fn arg(&mut self) -> Parsed<Arg> {
        let start = self.at;
        let prefix = match self.peek() {
            Some(Tok::Sym(Sym::Quote)) => Some((Prefix::Relative, self.span())),
            Some(Tok::Sym(Sym::Tilde)) => Some((Prefix::Floating, self.span())),
            _ => None,
        };
        let value = if prefix.is_some() {
            self.bump();
            self.binary(ADDITIVE)?
        } else {
            self.expr()?
        };
        if self.is(Sym::Quote) && (self.nth_is(1, Sym::Comma) || self.nth_is(1, Sym::RParen)) {
            let span = self.span();
            self.diags
                .report(Code::StrayQuote, span, format!("`{RELATIVE}` comes before a relative size, not after it"))
                .help("leave it out");
            self.bump();
        }
        Ok(Arg { prefix, value, span: self.span_from(start) })
    }

    /// The operator here.
    fn operator(&self) -> Option<Operator> {
        let each = self.is(Sym::Dot);
        let meant = match (self.peek()?, self.nth(1)) {
            (Tok::Sym(Sym::Less), Some(Tok::Sym(Sym::Greater))) => Some((Sym::NotEq, 2)),
            // An arrow.
            (Tok::Sym(Sym::Minus), Some(Tok::Sym(Sym::Greater))) => return None,
            (Tok::Ident(_), _) => Some((self.operator_word()?, 1)),
            _ => None,
        };
        if let Some((meant, length)) = meant {
            let &(op, _, level) = OPERATORS.iter().find(|(_, sign, _)| *sign == meant)?;
            return Some(Operator { op, level, each: false, length, meant: Some(meant) });
        }
        let length = 1 + usize::from(each);
        let &(op, _, level) = OPERATORS.iter().find(|(_, sign, _)| self.nth_is(length - 1, *sign))?;
        Some(Operator { op, level, each, length, meant: None })
    }

    fn binary(&mut self, least: u8) -> Parsed<Expr> {
        let start = self.at;
        let mut left = self.unary()?;
        // The operators since the last one of another level.
        let (mut row, mut row_level) = (Vec::new(), 0);
        while let Some(Operator { op, level, each, length, meant }) = self.operator() {
            if level < least || !self.tick() {
                break;
            }
            if level != row_level {
                left = self.row(left, std::mem::take(&mut row))?;
                row_level = level;
            }
            if let Some(meant) = meant {
                self.no_operator(length, meant);
            }
            let at = self.span().to(self.span_at(self.at + length - 1));
            self.at += length;
            let operand = self.binary(level + 1)?;
            row.push((Link { op, at, operand }, each, self.span_from(start)));
        }
        self.row(left, row)
    }

    /// Makes the expression of operators of one level, each with the span up to its operand. Many of them are not nested,
    /// so that a long sum needs no deep tree.
    fn row(&mut self, first: Expr, row: Vec<(Link, bool, Span)>) -> Parsed<Expr> {
        let is_chained = |(link, each, _): &(Link, bool, Span)| !each && link.op.is_chained();
        let most = match row.first() {
            Some((Link { op: Binary::And | Binary::Or, .. }, ..)) => MOST_CONDITIONS,
            _ => MOST_NESTED,
        };
        if let Some(&(.., span)) = row.last()
            && most < row.len()
            && row.iter().all(is_chained)
        {
            let links = row.into_iter().map(|(link, ..)| link).collect();
            return self.node_over(ExprKind::Chain(Box::new(first), links), span);
        }
        let mut left = first;
        for (Link { op, at, operand }, each, span) in row {
            let kind = if each { ExprKind::Each } else { ExprKind::Binary };
            left = self.node_over(kind(op, at, Box::new(left), Box::new(operand)), span)?;
        }
        Ok(left)
    }

    fn unary(&mut self) -> Parsed<Expr> {
        let start = self.at;
        let each = self.is(Sym::Dot);
        let op = match self.nth(usize::from(each)) {
            Some(Tok::Sym(Sym::Minus)) => Unary::Minus,
            Some(Tok::Sym(Sym::Plus)) => Unary::Plus,
            Some(Tok::Sym(Sym::Bang)) => Unary::Not,
            Some(Tok::Sym(Sym::Quote | Sym::Tilde)) if !each => {
                self.misplaced_prefix();
                return Err(Reported);
            }
            _ if self.at_not() => return self.negation(),
            _ => return self.primary(),
        };
        self.at += 1 + usize::from(each);
        let operand = Box::new(self.nested(Self::unary)?);
        self.node(if each { ExprKind::EachUnary(op, operand) } else { ExprKind::Unary(op, operand) }, start)
    }

    /// Parses an operand of the word `not`, which includes comparisons in other languages.
    fn negation(&mut self) -> Parsed<Expr> {
        let start = self.at;
        self.bump();
        let operand = self.nested(|parser| parser.binary(COMPARISON))?;
        let negation = self.node(ExprKind::Unary(Unary::Not, Box::new(operand)), start)?;
        self.not_for_bang(start);
        Ok(negation)
    }

    fn misplaced_prefix(&mut self) {
        let (span, sign) = (self.span(), self.peek().map_or("it".into(), Tok::describe));
        let second = matches!(self.before(1), Some(Tok::Sym(Sym::Quote | Sym::Tilde)));
        let prefix = if self.is(Sym::Quote) { Prefix::Relative } else { Prefix::Floating };
        let negative = self.negative().filter(|_| self.relative && prefix == Prefix::Relative);
        let relative = self.relative;
        let diag = self.diags.report(Code::MisplacedPrefix, span, format!("{sign} is not allowed here"));
        if second {
            diag.note("a size is relative or floating, never both").help(format!("write `{RELATIVE}0.5` or `~0.5`"));
        } else if let Some(negative) = negative {
            diag.note("it comes before the whole size, and before its sign").help(format!("write `{negative}`"));
        } else if relative {
            let forms = format!("`{RELATIVE}0.5 * a`, `{RELATIVE}-a`, `~(a + b)`");
            diag.help(format!("it begins the size of a slot or a length: {forms}"));
        } else {
            diag.note(prefix.place()).help(prefix.instead());
        }
    }

    /// The relative size that is meant by a sign before it: `'-0.5` for `-'0.5`.
    fn negative(&self) -> Option<String> {
        let begins = matches!(self.before(2), Some(Tok::Sym(Sym::LParen | Sym::LBrace | Sym::Comma | Sym::Bar)));
        let is_minus = self.before(1).is_some_and(|token| token.is(Sym::Minus));
        let is_value = matches!(self.nth(1), Some(Tok::Number(_) | Tok::Ident(_)));
        (begins && is_minus && is_value).then(|| format!("{RELATIVE}-{}", self.written(self.at + 1, self.at + 2)))
    }

    fn primary(&mut self) -> Parsed<Expr> {
        if self.at_border() {
            return self.fail("a value");
        }
        let start = self.at;
        let mut part = self.atom()?;
        while self.is(Sym::LBracket) && self.tick() {
            part = self.index(part, start)?;
        }
        Ok(part)
    }

    fn atom(&mut self) -> Parsed<Expr> {
        if self.at_branch() {
            return self.branch_value();
        }
        let kind = match self.peek() {
            Some(Tok::Number(value)) => ExprKind::Number(*value),
            Some(Tok::Str(text)) => ExprKind::Text(text.clone()),
            Some(Tok::Host(handle)) => ExprKind::Host(*handle),
            Some(Tok::Sym(Sym::LParen)) => return self.parentheses(),
            Some(Tok::Sym(Sym::LBracket)) => return self.array(),
            Some(Tok::Ident(word)) => match word.as_str() {
                "true" => ExprKind::Bool(true),
                "false" => ExprKind::Bool(false),
                "else" => return self.fail("a value"),
                _ => return self.name_or_call(),
            },
            Some(Tok::Path(_)) => return self.name_or_call(),
            _ => return self.fail("a value"),
        };
        self.bump();
        self.node(kind, self.at - 1)
    }

    fn parentheses(&mut self) -> Parsed<Expr> {
        let start = self.at;
        let close = self.closing()?;
        self.bump();
        let mut expr = self.bracketed(false, Self::expr)?;
        if self.at != close {
            return self.fail("`)`");
        }
        self.bump();
        // The underlined text includes the parentheses.
        expr.span = self.span_from(start);
        Ok(expr)
    }

    fn name_or_call(&mut self) -> Parsed<Expr> {
        let start = self.at;
        let path = matches!(self.peek(), Some(Tok::Path(_)));
        let Some(name) = self.take_joined() else { return self.fail("a name") };
        if (self.is(Sym::LParen) || self.is(Sym::LBrace)) && has_values(&name.text) {
            return self.comp_value(name, start);
        }
        if !self.is(Sym::LParen) {
            return if path { self.no_call(&name) } else { self.node(ExprKind::Name(name), start) };
        }
        let args = self.call_args(&name.text)?;
        self.node(if path { ExprKind::Path(name, args) } else { ExprKind::Call(name, args) }, start)
    }

    /// Reports a path of Rust without arguments.
    pub(super) fn no_call<T>(&mut self, path: &Name) -> Parsed<T> {
        Err(self.expected("`(`").help(format!("a Rust function is called as `{}()`", path.text)).into())
    }

    /// Takes a name with all dots after it. A path of Rust has none.
    pub(super) fn take_joined(&mut self) -> Option<Name> {
        let mut end = self.at + 1;
        while self.layout.word(end - 1).is_some() && self.layout.is(end, Sym::Dot) && !self.layout.is_border(end + 1) {
            end += 2;
        }
        self.take_dotted(end)
    }

    pub(super) fn call_args(&mut self, name: &str) -> Parsed<Vec<Expr>> {
        let relative = std::mem::take(&mut self.relative);
        let args = self.between_commas(|parser| parser.bracketed(false, Self::expr));
        self.relative = relative;
        let args = args?;
        if self.layout.is(self.at - 2, Sym::Comma) {
            self.at -= 1;
            return self.fail(&format!("another argument of `{name}`"));
        }
        Ok(args)
    }
}
