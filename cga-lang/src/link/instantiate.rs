//! Declarations that are instantiated for several tuples of types.
//!
//! A parameter whose type the body leaves open may have another type in each call. Each further tuple of types
//! creates an instance of the declaration with these types: an overload like any other. The checker finds the
//! required tuples. Tokens and trees are shared; only the entries of the side tables belong to the instance.

use super::{InstanceId, Key, Program};
use crate::hash::FastMap;
use crate::ir::Type;
use crate::syntax::ast::Decl;
use crate::syntax::token::Tok;
use std::collections::{HashMap, HashSet};

/// The maximum number of type tuples of a declaration.
const MOST_OF_ONE: usize = 16;

/// The maximum number of such instances in a program.
const MOST_IN_ALL: usize = 1000;

/// The types of the parameters; `None` for parameters whose type the body determines.
pub(crate) type Types = Vec<Option<Type>>;

/// A request for a declaration with other types.
pub(crate) struct Wanted {
    /// The declaration in the instance of its file.
    pub(crate) decl: Key,
    pub(crate) types: Types,
}

/// The instances of declarations.
#[derive(Default)]
pub(crate) struct Instantiations {
    /// True if calls may request instances.
    pub(crate) wanting: bool,
    /// True if parameters may have several types.
    pub(crate) on: bool,
    /// Tokens that need one meaning per place, in order: Rust values, which are computed once, and imports whose
    /// rules are replaced by dynamic calls.
    single: Vec<u32>,
    /// The instances of declarations, numbered after the instances of files.
    list: Vec<Typed>,
    /// The given types of parameters.
    types: FastMap<Key, Type>,
    /// By declaration in the instance of its file: the tuples that were made, including the removed ones.
    made: FastMap<Key, HashSet<Types>>,
}

/// An instance of a declaration with its own types.
struct Typed {
    /// The instance of its file.
    home: InstanceId,
    /// Its index in the tree.
    decl: usize,
    /// True if the types do not fit the body.
    gone: bool,
}

impl Instantiations {
    /// The given type of a parameter.
    pub(crate) fn given(&self, param: Key) -> Option<Type> {
        self.types.get(&param).copied().filter(|_| self.on)
    }

    /// Returns true if a declaration may have instances of its own.
    pub(crate) fn may_have(&self, decl: &Decl) -> bool {
        let at = self.single.partition_point(|token| *token < decl.span.first);
        self.single.get(at).is_none_or(|token| decl.span.last < *token)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.iter().all(|typed| typed.gone)
    }

    /// Returns true if another instance of a declaration may be made.
    pub(crate) fn may_be(&self, decl: Key, types: &Types) -> bool {
        let made = self.made.get(&decl);
        self.wanting
            && self.list.len() < MOST_IN_ALL
            && made.is_none_or(|made| made.len() < MOST_OF_ONE && !made.contains(types))
    }
}

impl Program {
    /// Allows calls to request instances of declarations.
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

    /// The instances with their own types, by instance of the file, with their numbers.
    pub(crate) fn typed_declarations(&self) -> HashMap<InstanceId, Vec<(InstanceId, &Decl)>> {
        let mut found: HashMap<InstanceId, Vec<(InstanceId, &Decl)>> = HashMap::new();
        for (own, typed) in (self.instances.len()..).zip(&self.typed.list).filter(|(_, typed)| !typed.gone) {
            let decl = &self.instances[typed.home].file.ast.decls[typed.decl];
            found.entry(typed.home).or_default().push((own, decl));
        }
        found
    }

    /// The instance whose names are visible in `own`.
    pub(crate) fn home(&self, own: InstanceId) -> InstanceId {
        own.checked_sub(self.instances.len()).map_or(own, |at| self.typed.list[at].home)
    }

    /// Returns true if `own` is an instance of a declaration with its own types.
    pub(crate) fn is_typed(&self, own: InstanceId) -> bool {
        self.instances.len() <= own
    }

    /// Removes all instances of declarations with their own types.
    pub(crate) fn take_back_all(&mut self) {
        self.typed.list.iter_mut().for_each(|typed| typed.gone = true);
    }

    /// Removes the instances whose types do not fit.
    pub(crate) fn take_back(&mut self, unsuited: &[InstanceId]) {
        for own in unsuited {
            self.typed.list[own - self.instances.len()].gone = true;
        }
    }
}
