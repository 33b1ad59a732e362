//! The whole way from tokens to a grammar, in one call.

use crate::check::{CheckOutcome, check};
use crate::diag::code::Code;
use crate::diag::{Diag, Diags, Level};

pub use crate::dialect::Dialect;
use crate::editor::index::Named;
use crate::editor::public_names::{PublicName, public_names};
use crate::infer::Inferred;
use crate::ir::Grammar;
use crate::link::{FileTokens, Files, NoFiles, Program, SourceFile, Unit, link};
use crate::lower::lower;
use crate::syntax::lex::lex;
use crate::syntax::token::Tokens;
use std::ops::Range;
use std::rc::Rc;

/// Most rounds of checks that find out which declarations are wanted for which types: the wishes of a declaration are known
/// only when it is there.
const MOST_ROUNDS: usize = 200;

/// Rounds that large programs have, too.
const LEAST_ROUNDS: usize = 16;

/// Declarations that all rounds together may check.
const MOST_CHECKED: usize = 100_000;

/// The result of compiling tokens.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The grammar; `None` when there was an error.
    pub grammar: Option<Grammar>,
    /// All diagnostics, in source order.
    pub diags: Vec<Diag>,
    /// The public names, errors or not: the attributes.
    pub names: Vec<PublicName>,
    /// The places where names of the compiled file are declared and used, also after errors.
    pub index: Vec<Named>,
    /// The files that were read: the one that is compiled, then those that are imported, each once.
    pub files: Vec<FileTokens>,
}

impl Compiled {
    /// The file of a token, by number, and the token's index in that file alone.
    pub fn locate(&self, token: u32) -> (usize, u32) {
        let after = self.files.partition_point(|file| file.tokens.start <= token);
        let at = after.saturating_sub(1);
        (at, token - self.files.get(at).map_or(0, |file| file.tokens.start))
    }
}

/// Compiles a file and what it imports, with levels of diagnostics for the grammar as a whole (`@Allow` and its like before
/// the header). An error that was found in the tokens leaves no grammar.
pub fn compile(root: Unit, files: &mut dyn Files, levels: &[(Code, Level)]) -> Compiled {
    let mut diags = Diags::new();
    let mut program = link(root, files, &mut diags);
    let read = diags.finish();
    let outcome = checked(&program, levels, false, &read);
    if !outcome.1.types.misfit {
        return finish(&program, outcome);
    }
    instantiate(&mut program, levels, &read);
    finish(&program, checked(&program, levels, true, &read))
}

fn checked<'p>(
    program: &'p Program,
    levels: &[(Code, Level)],
    last: bool,
    read: &[Diag],
) -> (Vec<Diag>, CheckOutcome<'p>) {
    let mut diags = Diags::new();
    diags.append(read.to_vec());
    let outcome = check(program, levels, last, &mut diags);
    (diags.finish(), outcome)
}

fn finish(program: &Program, (diags, outcome): (Vec<Diag>, CheckOutcome)) -> Compiled {
    let grammar = outcome.checked.map(|checked| lower(&checked));
    let names = public_names(program, &outcome.attrs, grammar.as_ref());
    let piece = |file: &Rc<SourceFile>| FileTokens { name: file.name.clone(), tokens: file.tokens.clone() };
    let files = program.files.iter().map(piece).collect();
    Compiled { grammar, diags, names, index: outcome.index, files }
}

/// Instantiates declarations that calls use with several types, until there is one for each or enough was tried.
fn instantiate(program: &mut Program, levels: &[(Code, Level)], read: &[Diag]) {
    program.begin_instantiation();
    let rounds = (MOST_CHECKED / program.declarations().max(1)).clamp(LEAST_ROUNDS, MOST_ROUNDS);
    for round in 0..=rounds {
        if round == rounds {
            // Half of a chain of calls would be blamed in the middle.
            program.typed.on = false;
            program.take_back_all();
            return;
        }
        let Inferred { wanted, unsuited, .. } = checked(program, levels, false, read).1.types;
        if wanted.is_empty() && unsuited.is_empty() {
            break;
        }
        program.take_back(&unsuited);
        wanted.into_iter().for_each(|wanted| program.instantiate(wanted));
    }
    program.typed.wanting = false;
    // A declaration with one type is reported as if there were no instances.
    program.typed.on = !program.typed.is_empty();
}

/// A compiled text.
#[derive(Clone, Debug)]
pub struct CompiledText {
    /// The tokens.
    pub tokens: Tokens,
    /// Bytes of the text, one range a token: what [`render`](crate::snippet::render) needs.
    pub ranges: Vec<Range<usize>>,
    /// The result, with diagnostics about characters.
    pub compiled: Compiled,
}

/// Compiles CGA text that imports nothing.
pub fn compile_text(text: &str) -> CompiledText {
    let lexed = lex(text);
    let root = Unit { found: lexed.diags, ..Unit::new(lexed.tokens.clone(), Dialect::Text) };
    let compiled = compile(root, &mut NoFiles, &[]);
    CompiledText { tokens: lexed.tokens, ranges: lexed.ranges, compiled }
}
