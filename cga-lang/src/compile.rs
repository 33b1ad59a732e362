//! The whole way from tokens to a grammar, in one call.

use crate::check::{Outcome, check};
use crate::code::Code;
use crate::diag::{Diag, Diags, Level};

pub use crate::door::Door;
use crate::index::Named;
use crate::ir::Grammar;
use crate::lex::lex;
use crate::link::{Files, NoFiles, Piece, Program, Unit, link};
use crate::lower::lower;
use crate::skeleton::Skeleton;
use crate::span::Span;
use crate::token::Tokens;
use std::collections::HashSet;
use std::ops::Range;

/// How often a program may be checked for copies of declarations with other types: what calls in copies want is known only
/// when these are there.
const MOST_ROUNDS: usize = 200;

/// How often at least, however large it is.
const LEAST_ROUNDS: usize = 16;

/// Tokens that may be checked so.
const MOST_CHECKED: usize = 4_000_000;

/// What became of some tokens.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The grammar; `None` when there was an error.
    pub grammar: Option<Grammar>,
    /// Every finding, in source order. Those about a file that was read several times are there once.
    pub diags: Vec<Diag>,
    /// The public names, errors or not.
    pub names: Skeleton,
    /// Where the names of the compiled file are declared and used, errors or not.
    pub index: Vec<Named>,
    /// What was read: names of files. The first is what was compiled.
    pub files: Vec<String>,
    /// Where each file is among the tokens that spans count. A file that is imported several times is there as often.
    pub pieces: Vec<Piece>,
}

impl Compiled {
    /// The file of a token, by number, and the token's index in that file alone.
    pub fn locate(&self, token: u32) -> (usize, u32) {
        let at = self.pieces.partition_point(|piece| piece.tokens.start <= token);
        match at.checked_sub(1).map(|at| &self.pieces[at]) {
            Some(piece) => (piece.file, token - piece.tokens.start + piece.from),
            None => (0, token),
        }
    }
}

/// Compiles a file and what it imports, with levels of diagnostics for the grammar as a whole (`@Allow` and its like before
/// the header). An error that was found in the tokens leaves no grammar.
pub fn compile(root: Unit, files: &mut dyn Files, levels: &[(Code, Level)]) -> Compiled {
    let mut diags = Diags::new();
    let mut program = link(root, files, &mut diags);
    let read = diags.finish();
    let outcome = checked(&program, levels, false, &read);
    if !outcome.1.misfit {
        return finish(&program, outcome);
    }
    copy(&mut program, levels, &read);
    finish(&program, checked(&program, levels, true, &read))
}

fn checked<'p>(program: &'p Program, levels: &[(Code, Level)], last: bool, read: &[Diag]) -> (Vec<Diag>, Outcome<'p>) {
    let mut diags = Diags::new();
    diags.append(read.to_vec());
    let outcome = check(program, levels, last, &mut diags);
    (diags.finish(), outcome)
}

fn finish(program: &Program, (diags, outcome): (Vec<Diag>, Outcome)) -> Compiled {
    let grammar = outcome.checked.map(|checked| lower(&checked));
    let names = Skeleton::new(program, &outcome.attrs, grammar.as_ref());
    let (pieces, files) = (program.pieces.clone(), program.files.clone());
    Compiled { grammar, diags: once(diags, &pieces), names, index: outcome.index, files, pieces }
}

/// Makes copies of declarations that calls use with several types, until there is one for each or enough was tried.
fn copy(program: &mut Program, levels: &[(Code, Level)], read: &[Diag]) {
    program.begin_copies();
    let rounds = (MOST_CHECKED / program.tokens.len().max(1)).clamp(LEAST_ROUNDS, MOST_ROUNDS);
    for round in 0..=rounds {
        if round == rounds {
            // Half of a chain of calls would be blamed in the middle.
            program.copies.on = false;
            program.take_back_all();
            return;
        }
        let (_, Outcome { wanted, unsuited, .. }) = checked(program, levels, false, read);
        if wanted.is_empty() && unsuited.is_empty() {
            break;
        }
        program.take_back(&unsuited);
        wanted.into_iter().for_each(|wanted| program.copy(wanted));
    }
    program.copies.wanting = false;
    // What has one type only is said as if there were no others.
    program.copies.on = !program.copies.is_empty();
}

/// Moves findings about a file that was read several times to its first reading, and leaves out the copies.
fn once(diags: Vec<Diag>, pieces: &[Piece]) -> Vec<Diag> {
    if pieces.len() < 2 {
        return diags;
    }
    let token = |token: u32| {
        let at = pieces.partition_point(|piece| piece.tokens.start <= token).saturating_sub(1);
        let first = pieces.iter().find(|piece| piece.file == pieces[at].file).unwrap_or(&pieces[at]);
        token - pieces[at].tokens.start + pieces[at].from + first.tokens.start
    };
    let mut all = Diags::new();
    all.append(
        diags
            .into_iter()
            .map(|diag| diag.moved(|span| Span { first: token(span.first), last: token(span.last) }))
            .collect(),
    );
    let mut all = all.finish();
    // What differs in a second place only is said once.
    let mut seen = HashSet::new();
    all.retain(|diag| seen.insert((diag.span, diag.code, diag.message.clone())));
    all
}

/// A compiled text.
#[derive(Clone, Debug)]
pub struct Source {
    /// The tokens.
    pub tokens: Tokens,
    /// Bytes of the text, one range a token: what [`render`](crate::snippet::render) needs.
    pub ranges: Vec<Range<usize>>,
    /// What became of it; findings about characters are among the others.
    pub compiled: Compiled,
}

/// Compiles CGA text that imports nothing.
pub fn compile_text(text: &str) -> Source {
    let lexed = lex(text);
    let root = Unit { found: lexed.diags, ..Unit::new(lexed.tokens.clone(), Door::Text) };
    let compiled = compile(root, &mut NoFiles, &[]);
    Source { tokens: lexed.tokens, ranges: lexed.ranges, compiled }
}
