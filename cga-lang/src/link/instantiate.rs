//! Declarations that are instantiated for several tuples of types.
//!
//! A parameter whose type the body leaves open may be of another type in each call. Each further tuple of types makes the
//! declaration an instance of its own, with its types given: an overload like any other. The checker finds out which are
//! wanted. Tokens and trees are shared; only the entries of the side tables are the instance's own.

use super::{InstanceId, Key, Program};
use crate::hash::FastMap;
use crate::ir::Type;
use crate::syntax::ast::Decl;
use crate::syntax::token::Tok;
use std::collections::{HashMap, HashSet};

/// Most tuples of types that a declaration is made for.
const MOST_OF_ONE: usize = 16;

/// Most such instances in all.
const MOST_IN_ALL: usize = 1000;

/// The types of the parameters; `None` for those that the body knows.
pub(crate) type Types = Vec<Option<Type>>;

/// A declaration that is wanted for some types.
pub(crate) struct Wanted {
    /// The instance of its file, and its name.
    pub(crate) decl: Key,
    pub(crate) types: Types,
}

/// The instances of declarations.
#[derive(Default)]
pub(crate) struct Instantiations {
    /// Whether calls may want some.
    pub(crate) wanting: bool,
    /// Whether parameters may be of several types at all.
    pub(crate) on: bool,
    /// Tokens that have one meaning in one place, in order: Rust values, which are computed once, and imports that dynamic
    /// calls replace rules of.
    single: Vec<u32>,
    /// Their numbers begin after those of the instances of files.
    list: Vec<Typed>,
    /// Types of parameters.
    types: FastMap<Key, Type>,
    /// By the declaration in the instance of its file: what it is made for, and what it cannot be.
    made: FastMap<Key, HashSet<Types>>,
}

/// A declaration with types of its own.
struct Typed {
    /// The instance of its file.
    home: InstanceId,
    /// Its index in the tree.
    decl: usize,
    /// Its types did not suit it.
    gone: bool,
}

impl Instantiations {
    /// The type that a parameter is given.
    pub(crate) fn given(&self, param: Key) -> Option<Type> {
        self.types.get(&param).copied().filter(|_| self.on)
    }

    /// Whether a declaration may have instances of its own.
    pub(crate) fn may_have(&self, decl: &Decl) -> bool {
        let at = self.single.partition_point(|token| *token < decl.span.first);
        self.single.get(at).is_none_or(|token| decl.span.last < *token)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.iter().all(|typed| typed.gone)
    }

    /// Whether there may be one more of a declaration.
    pub(crate) fn may_be(&self, decl: Key, types: &Types) -> bool {
        let made = self.made.get(&decl);
        self.wanting
            && self.list.len() < MOST_IN_ALL
            && made.is_none_or(|made| made.len() < MOST_OF_ONE && !made.contains(types))
    }
}

impl Program {
    /// Lets calls want instances of declarations.
    pub(crate) fn begin_instantiation(&mut self) {
        (self.typed.on, self.typed.wanting) = (true, true);
        let hosts = (0..).zip(self.tokens.as_slice()).filter(|(_, token)| matches!(token, Tok::Host(_)));
        let dynamic = self.instances.iter().flat_map(|instance| instance.dynamic.keys().copied());
        self.typed.single = hosts.map(|(at, _)| at).chain(dynamic).collect();
        self.typed.single.sort_unstable();
    }

    /// Gives a declaration its types, or instantiates it for others.
    pub(crate) fn instantiate(&mut self, wanted: Wanted) {
        let Wanted { decl: key @ (home, name), types } = wanted;
        if !self.typed.may_be(key, &types) {
            return;
        }
        let decls = &self.instances[home].file.ast.decls;
        let Ok(decl) = decls.binary_search_by_key(&name, |decl| decl.name.id()) else { return };
        let made = self.typed.made.entry(key).or_default();
        let own = if made.is_empty() { home } else { self.instances.len() + self.typed.list.len() };
        made.insert(types.clone());
        if own != home {
            self.typed.list.push(Typed { home, decl, gone: false });
        }
        for (param, ty) in decls[decl].params.iter().zip(types) {
            self.typed.types.extend(ty.map(|ty| ((own, param.id()), ty)));
        }
    }

    /// By instance of a file: the declarations with types of their own, with their numbers.
    pub(crate) fn typed_declarations(&self) -> HashMap<InstanceId, Vec<(InstanceId, &Decl)>> {
        let mut found: HashMap<InstanceId, Vec<(InstanceId, &Decl)>> = HashMap::new();
        for (own, typed) in (self.instances.len()..).zip(&self.typed.list).filter(|(_, typed)| !typed.gone) {
            let decl = &self.instances[typed.home].file.ast.decls[typed.decl];
            found.entry(typed.home).or_default().push((own, decl));
        }
        found
    }

    /// The instance in which the names of an instance are looked up.
    pub(crate) fn home(&self, own: InstanceId) -> InstanceId {
        own.checked_sub(self.instances.len()).map_or(own, |at| self.typed.list[at].home)
    }

    /// Whether it is a declaration with types of its own.
    pub(crate) fn is_typed(&self, own: InstanceId) -> bool {
        self.instances.len() <= own
    }

    /// Takes back every declaration with types of its own.
    pub(crate) fn take_back_all(&mut self) {
        self.typed.list.iter_mut().for_each(|typed| typed.gone = true);
    }

    /// Takes declarations back whose types do not suit them.
    pub(crate) fn take_back(&mut self, unsuited: &[InstanceId]) {
        for own in unsuited {
            self.typed.list[own - self.instances.len()].gone = true;
        }
    }
}
