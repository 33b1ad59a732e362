//! What can be told before parsing: which bracket closes which, and where declarations begin.
//!
//! A rule's body has no end of its own: it runs to the next declaration. `Name -->`, `attr name` and `@` begin one
//! wherever they stand, even inside brackets that were left open. `name =` does so only outside brackets, because
//! in a comp block it is an arm.

use crate::token::{Sym, Tok};
use std::collections::HashSet;

const NONE: u32 = u32::MAX;

/// Tokens looked at to find out whether a parameter list and then `-->` follow; a bound keeps this linear.
const LONGEST_HEAD: usize = 100;

pub(super) struct Layout {
    close: Vec<u32>,
    /// Whether a declaration begins at a position.
    pub(super) starts: Vec<bool>,
    /// Names of rules.
    pub(super) rules: HashSet<String>,
    /// Names of functions.
    pub(super) functions: HashSet<String>,
}

/// How a declaration goes on behind its name and parameters.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Head {
    /// With `-->`.
    Rule,
    /// With `=`.
    Function,
    /// With something that was meant to be `-->`; how many tokens it has.
    Slip(usize),
}

impl Layout {
    pub(super) fn new(tokens: &[Tok], view: &[u32]) -> Self {
        let at = |position: usize| view.get(position).map(|&index| &tokens[index as usize]);
        let mut layout = Layout {
            close: vec![NONE; view.len()],
            starts: vec![false; view.len()],
            rules: HashSet::new(),
            functions: HashSet::new(),
        };
        let mut open: Vec<usize> = Vec::new();
        let mut quiet = 0;
        for position in 0..view.len() {
            let Some(token) = at(position) else { break };
            if position < quiet {
                continue;
            }
            quiet = import_end(&at, position);
            let head = head(&at, position);
            if head == Some(Head::Rule) || keyword(&at, position) {
                open.clear();
                layout.starts[position] = true;
            } else if head.is_some() && open.is_empty() {
                layout.starts[position] = true;
            }
            if let (Some(Head::Rule | Head::Slip(_)), Some(name)) = (head, token.ident()) {
                layout.rules.insert(name.to_owned());
            }
            if let (Some(Head::Function), true, Some(name)) = (head, open.is_empty(), token.ident()) {
                layout.functions.insert(name.to_owned());
            }
            match token {
                Tok::Sym(Sym::LParen | Sym::LBracket | Sym::LBrace) => open.push(position),
                Tok::Sym(sym) => {
                    if let Some(opener) = opener(*sym)
                        && let Some(depth) = open.iter().rposition(|&start| at(start).is_some_and(|t| t.is(opener)))
                    {
                        layout.close[open[depth]] = position as u32;
                        open.truncate(depth);
                    }
                }
                _ => {}
            }
        }
        layout
    }

    /// The position of the bracket that closes the one at `position`.
    pub(super) fn close(&self, position: usize) -> Option<usize> {
        self.close.get(position).filter(|&&close| close != NONE).map(|&close| close as usize)
    }
}

fn opener(sym: Sym) -> Option<Sym> {
    match sym {
        Sym::RParen => Some(Sym::LParen),
        Sym::RBracket => Some(Sym::LBracket),
        Sym::RBrace => Some(Sym::LBrace),
        _ => None,
    }
}

/// Whether a word or sign that only declarations have stands there.
fn keyword<'t>(at: &impl Fn(usize) -> Option<&'t Tok>, position: usize) -> bool {
    let ident = |ahead: usize| at(position + ahead).and_then(Tok::ident);
    match at(position) {
        Some(Tok::Sym(Sym::At)) => true,
        Some(Tok::Ident(word)) => match word.as_str() {
            "attr" | "const" | "import" => ident(1).is_some(),
            "version" => matches!(at(position + 1), Some(Tok::Str(_))),
            "style" => ident(1).is_some() && head(at, position + 1).is_none(),
            "start" | "extension" => ident(1).is_some() && head(at, position + 1) == Some(Head::Rule),
            _ => false,
        },
        _ => false,
    }
}

/// Whether a name follows something that only an expression goes on behind.
fn in_condition<'t>(at: &impl Fn(usize) -> Option<&'t Tok>, position: usize) -> bool {
    match position.checked_sub(1).and_then(at) {
        Some(Tok::Ident(word)) => word == "case",
        Some(Tok::Sym(sym)) => matches!(sym, Sym::AndAnd | Sym::OrOr | Sym::Bang | Sym::EqEq | Sym::NotEq),
        _ => false,
    }
}

/// Where an import's own declarations end, so that they do not count as the grammar's.
fn import_end<'t>(at: &impl Fn(usize) -> Option<&'t Tok>, position: usize) -> usize {
    let is = |position: usize, sym: Sym| at(position).is_some_and(|token| token.is(sym));
    if at(position).and_then(Tok::ident) != Some("import")
        || !is(position + 2, Sym::Colon)
        || !is(position + 4, Sym::LParen)
    {
        return 0;
    }
    after_brackets(at, position + 4).unwrap_or(0)
}

/// The position behind the parentheses that begin at `position`, unless they are long or never closed.
fn after_brackets<'t>(at: &impl Fn(usize) -> Option<&'t Tok>, position: usize) -> Option<usize> {
    let mut depth = 0;
    for next in position..position + LONGEST_HEAD {
        let token = at(next)?;
        depth += i32::from(token.is(Sym::LParen)) - i32::from(token.is(Sym::RParen));
        if depth == 0 {
            return Some(next + 1);
        }
    }
    None
}

/// How a declaration of the name at `position` goes on, if there is one.
pub(super) fn head<'t>(at: &impl Fn(usize) -> Option<&'t Tok>, position: usize) -> Option<Head> {
    if at(position)?.ident()? == "with" {
        return None;
    }
    let is = |position: usize, sym: Sym| at(position).is_some_and(|token| token.is(sym));
    let mut next = position + 1;
    let mut names = true;
    if is(next, Sym::LParen) {
        next += 1;
        while let Some(token) = at(next)
            && !token.is(Sym::RParen)
        {
            names &= token.is(Sym::Comma) || matches!(token, Tok::Ident(_));
            next += 1;
            if token.is(Sym::LParen) || position + LONGEST_HEAD < next {
                return None;
            }
        }
        next += 1;
    }
    if at(next).and_then(Tok::ident) == Some("with") && is(next + 1, Sym::LParen) {
        next = after_brackets(at, next + 1)?;
    }
    if is(next, Sym::Arrow) {
        return Some(Head::Rule);
    }
    // `case h = 3 :` means `==`, and the parser says so.
    if !names || in_condition(at, position) {
        return None;
    }
    let slips: [&[Sym]; 4] = [
        &[Sym::Minus, Sym::Greater],
        &[Sym::Minus, Sym::Minus, Sym::Greater],
        &[Sym::Assign, Sym::Greater],
        &[Sym::EqEq, Sym::Greater],
    ];
    for slip in slips {
        if slip.iter().enumerate().all(|(ahead, &sym)| is(next + ahead, sym)) {
            return Some(Head::Slip(slip.len()));
        }
    }
    is(next, Sym::Assign).then_some(Head::Function)
}
