//! The attributes and constants that rules read and that may differ between two shapes of one size.
//!
//! A value differs between initial shapes if it is drawn, or depends on the shape; it differs between the shapes of a run if rules set
//! it. All other values are the same for a grammar with its given attributes.

use super::closure::closure;
use super::{Facts, Uses};
use crate::ir::{Expr, ExprKind, FunctionId, Global, GlobalId, Grammar, walk};
use std::ops::BitOr;

/// A set of attributes and constants whose values differ. Few have an entry of their own; the others are known by what they depend on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Reads(u64);

impl Reads {
    /// Nothing that differs.
    pub const NONE: Reads = Reads(0);
    /// Some other value that differs between initial shapes.
    pub const RUN: Reads = Reads(1 << 62);
    /// Some other value that differs between the shapes of a run.
    pub const SHAPE: Reads = Reads(1 << 63);

    /// The largest number of attributes and constants with an entry.
    const MOST: usize = 62;

    fn entry(number: usize) -> Self {
        Reads(1 << number)
    }

    /// Returns true if everything in `other` is read.
    pub fn has(self, other: Reads) -> bool {
        self.0 & other.0 == other.0
    }
}

impl BitOr for Reads {
    type Output = Reads;

    fn bitor(self, other: Reads) -> Reads {
        Reads(self.0 | other.0)
    }
}

impl FromIterator<Reads> for Reads {
    fn from_iter<I: IntoIterator<Item = Reads>>(list: I) -> Self {
        list.into_iter().fold(Reads::NONE, BitOr::bitor)
    }
}

/// The attributes and constants that differ, and who reads them.
#[derive(Clone, Debug, Default)]
pub(super) struct Differing {
    /// The attributes and constants with an entry, in the order of the entries.
    listed: Vec<GlobalId>,
    /// The set that a read of each attribute or constant belongs to.
    globals: Vec<Reads>,
    functions: Vec<Reads>,
}

impl Facts {
    /// The attributes and constants that are read by an expression, with the functions that it calls.
    pub fn reads(&self, expr: &Expr) -> Reads {
        let mut found = Reads::NONE;
        walk::parts(expr, &mut |part| found = found | self.part_reads(part));
        found
    }

    /// The attributes and constants that an expression reads without its parts.
    pub(super) fn part_reads(&self, expr: &Expr) -> Reads {
        match &expr.kind {
            ExprKind::Global(id) => self.differing.globals[id.0 as usize],
            ExprKind::Call(FunctionId(id), ..) => self.differing.functions[*id as usize],
            _ => Reads::NONE,
        }
    }

    /// The attributes and constants with an entry among them.
    pub fn listed(&self, reads: Reads) -> impl Iterator<Item = GlobalId> {
        let listed = self.differing.listed.iter().enumerate();
        listed.filter(move |(number, _)| reads.has(Reads::entry(*number))).map(|(_, id)| *id)
    }

    /// Finds who reads which attributes and constants. Uses of functions are known.
    pub(super) fn find_reads(&mut self, grammar: &Grammar) {
        let drawn = self.drawn(grammar);
        for (global, (id, is_drawn)) in grammar.globals.iter().zip((0..).zip(drawn)) {
            let reads = match (global.is_set, is_drawn) {
                (false, false) => Reads::NONE,
                // Reading it computes it: at most one reader may be the first.
                (true, true) if global.lazy => Reads::SHAPE,
                (false, true) if global.lazy => Reads::RUN,
                _ if self.differing.listed.len() < Reads::MOST => {
                    self.differing.listed.push(GlobalId(id));
                    Reads::entry(self.differing.listed.len() - 1)
                }
                (true, _) => Reads::SHAPE,
                (false, true) => Reads::RUN,
            };
            self.differing.globals.push(reads);
        }
        // Until they are known, calls add nothing.
        self.differing.functions = vec![Reads::NONE; grammar.functions.len()];
        let own = grammar.functions.iter();
        let own =
            own.map(|function| function.locals.iter().chain([&function.body]).map(|expr| self.reads(expr)).collect());
        let own: Vec<Reads> = own.collect();
        let calls: Vec<Vec<usize>> = grammar.functions.iter().map(walk::called_functions).collect();
        self.differing.functions = closure(&calls, &own);
    }

    /// By attribute or constant, true if its value may differ between initial shapes.
    fn drawn(&self, grammar: &Grammar) -> Vec<bool> {
        let globals = grammar.globals.len();
        // Functions come after the attributes and constants.
        let needed = |exprs: &mut dyn Iterator<Item = &Expr>| {
            let mut needed = Vec::new();
            exprs.for_each(|expr| {
                walk::parts(expr, &mut |part| match &part.kind {
                    ExprKind::Global(id) => needed.push(id.0 as usize),
                    ExprKind::Call(id, ..) => needed.push(globals + id.0 as usize),
                    _ => {}
                });
            });
            needed
        };
        let of_globals = grammar.globals.iter().map(|global| match global.known {
            Some(_) => Vec::new(),
            None => needed(&mut [&global.value].into_iter()),
        });
        let of_functions =
            grammar.functions.iter().map(|function| needed(&mut function.locals.iter().chain([&function.body])));
        let edges: Vec<Vec<usize>> = of_globals.chain(of_functions).collect();
        let is_drawn = |global: &Global| {
            global.lazy || (global.known.is_none() && !self.expr(&global.value).but(Uses::STATE).is_none())
        };
        let own: Vec<bool> =
            grammar.globals.iter().map(is_drawn).chain(grammar.functions.iter().map(|_| false)).collect();
        closure(&edges, &own).into_iter().take(globals).collect()
    }
}
