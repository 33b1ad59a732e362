//! Declarations with other types.
//!
//! A parameter whose type the body leaves open may be of another type in each call. For each further tuple of types the
//! declaration is read again, behind the tokens so far, with its types said beforehand: an overload like any other. The
//! checker says which are wanted.

use super::{InstanceId, Piece, Program};
use crate::ast::Decl;
use crate::hash::FastMap;
use crate::ir::Type;
use crate::span::Span;
use crate::token::Tok;
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// Most tuples of types that a declaration is made for.
const MOST_OF_ONE: usize = 16;

/// Most copies in all.
const MOST_COPIES: usize = 1000;

/// Most tokens of all copies.
const MOST_TOKENS: usize = 1_000_000;

/// The types of the parameters; `None` for those that the body knows.
pub(crate) type Types = Vec<Option<Type>>;

/// A declaration that is wanted for some types.
pub(crate) struct Wanted {
    /// Where it is declared.
    pub(crate) instance: InstanceId,
    /// The token of its name, as it was written.
    pub(crate) original: u32,
    pub(crate) types: Types,
}

/// What was read again.
#[derive(Default)]
pub(crate) struct Copies {
    /// Whether calls may want some.
    pub(crate) wanting: bool,
    /// Whether parameters may be of several types at all.
    pub(crate) on: bool,
    /// Tokens of what has one meaning in one place, in order: Rust values, which are computed once, and imports that dynamic
    /// calls replace rules of.
    single: Vec<u32>,
    /// In the order of their tokens.
    list: Vec<Copied>,
    /// Types of parameters, by their token.
    types: FastMap<u32, Type>,
    /// By the token of the original's name: what it is made for, and what it cannot be.
    made: FastMap<u32, HashSet<Types>>,
}

struct Copied {
    instance: InstanceId,
    tokens: Range<u32>,
    /// Where the original's tokens begin.
    from: u32,
    /// The token of its name.
    name: u32,
    gone: bool,
}

impl Copies {
    /// The type that a parameter has in a copy, or in an original of which there are copies.
    pub(crate) fn given(&self, param: u32) -> Option<Type> {
        self.types.get(&param).copied().filter(|_| self.on)
    }

    /// Whether a declaration may be read again.
    pub(crate) fn may_copy(&self, decl: &Decl) -> bool {
        let at = self.single.partition_point(|token| *token < decl.span.first);
        self.single.get(at).is_none_or(|token| decl.span.last < *token)
    }

    fn copy(&self, token: u32) -> Option<usize> {
        let at = self.list.partition_point(|copy| copy.tokens.start <= token).checked_sub(1)?;
        (token < self.list[at].tokens.end).then_some(at)
    }

    /// The instance that a copied token belongs to.
    pub(super) fn instance(&self, token: u32) -> Option<InstanceId> {
        self.copy(token).map(|at| self.list[at].instance)
    }

    /// The token that a token is a copy of, or itself.
    pub(crate) fn original(&self, token: u32) -> u32 {
        self.copy(token).map_or(token, |at| token - self.list[at].tokens.start + self.list[at].from)
    }

    /// A place as it was written.
    pub(crate) fn written(&self, span: Span) -> Span {
        Span { first: self.original(span.first), last: self.original(span.last) }
    }

    /// Whether a place is in a copy.
    pub(crate) fn is_copied(&self, span: Span) -> bool {
        self.copy(span.first).is_some()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.iter().all(|copy| copy.gone)
    }

    /// Whether there may be one more of a declaration, by the token of its original's name.
    pub(crate) fn may_be(&self, original: u32, types: &Types) -> bool {
        let made = self.made.get(&original);
        self.wanting
            && self.list.len() < MOST_COPIES
            && made.is_none_or(|made| made.len() < MOST_OF_ONE && !made.contains(types))
    }
}

impl Program {
    /// Lets calls want copies.
    pub(crate) fn begin_copies(&mut self) {
        (self.copies.on, self.copies.wanting) = (true, true);
        let hosts = (0..).zip(self.tokens.as_slice()).filter(|(_, token)| matches!(token, Tok::Host(_)));
        let dynamic = self.instances.iter().flat_map(|instance| instance.dynamic.keys().copied());
        self.copies.single = hosts.map(|(at, _)| at).chain(dynamic).collect();
        self.copies.single.sort_unstable();
    }

    /// Says the types of an original, or reads it again with others.
    pub(crate) fn copy(&mut self, wanted: Wanted) {
        let Wanted { instance: id, original, types } = wanted;
        if !self.copies.may_be(original, &types) {
            return;
        }
        let decls = &self.instances[id].ast.decls;
        let Ok(at) = decls.binary_search_by_key(&original, |decl| decl.name.id()) else { return };
        let made = self.copies.made.entry(original).or_default();
        let is_first = made.is_empty();
        made.insert(types.clone());
        if is_first {
            give(&mut self.copies.types, &decls[at], &types);
            return;
        }
        let (start, span) = (self.tokens.len() as u32, decls[at].span);
        let copied = start - self.copies.list.first().map_or(start, |first| first.tokens.start);
        if MOST_TOKENS < (copied + span.last - span.first) as usize {
            return;
        }
        self.tokens.repeat(span.first..span.last + 1);
        let tokens = start..self.tokens.len() as u32;
        let copy = decls[at].behind(start - span.first);
        give(&mut self.copies.types, &copy, &types);
        let own = &self.pieces[id];
        let (file, from) = (own.file, own.from + span.first - own.tokens.start);
        self.copies.list.push(Copied {
            instance: id,
            tokens: tokens.clone(),
            from: span.first,
            name: copy.name.id(),
            gone: false,
        });
        self.pieces.push(Piece { file, tokens, from });
        self.instances[id].ast.decls.push(copy);
    }

    /// Takes every copy back.
    pub(crate) fn take_back_all(&mut self) {
        let all: Vec<Span> = self.copies.list.iter().map(|copy| Span::one(copy.tokens.start)).collect();
        self.take_back(&all);
    }

    /// Takes the copies back that have these places: their types do not suit them.
    pub(crate) fn take_back(&mut self, places: &[Span]) {
        let mut gone: HashMap<InstanceId, HashSet<u32>> = HashMap::new();
        for place in places {
            let Some(at) = self.copies.copy(place.first) else { continue };
            let copy = &mut self.copies.list[at];
            copy.gone = true;
            gone.entry(copy.instance).or_default().insert(copy.name);
        }
        for (id, names) in gone {
            self.instances[id].ast.decls.retain(|decl| !names.contains(&decl.name.id()));
        }
    }
}

fn give(known: &mut FastMap<u32, Type>, decl: &Decl, types: &Types) {
    for (param, ty) in decl.params.iter().zip(types) {
        known.extend(ty.map(|ty| (param.id(), ty)));
    }
}
