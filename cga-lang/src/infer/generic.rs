//! Parameters that have different types in different calls.
//!
//! They only occur in programs that do not type-check with one type per parameter. A call then waits for the types of
//! its arguments, and requests an instance of the declaration with these types if there is none yet;
//! `link/instantiate.rs` makes it.

use super::open::{Constraint, Overload, TypeUse};
use super::{Infer, Use, Var, VarState};
use crate::link::{Types, Wanted};
use crate::syntax::ast::{Name, Role};

/// The permitted reactions to a call.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    /// Wait, because not all bodies are read.
    Bodies,
    /// Choose among the existing declarations.
    Calls,
    /// Request declarations with other types.
    Wanting,
}

/// A request for a candidate with types that fit the call.
struct Wish {
    wanted: Wanted,
    /// True if a diagnostic about its arguments was already reported.
    poison: bool,
}

impl Infer<'_, '_, '_> {
    /// Returns true if a declaration may have instances with other types.
    pub(super) fn is_generic(&self, found: Use) -> bool {
        let program = self.cx.globals.program;
        let Some(item) = self.cx.globals.item(found).filter(|_| program.typed.on) else { return false };
        // An extension has only one form per import.
        let is_plain = item.home == item.instance && item.decl.role != Role::Extension;
        is_plain && !item.decl.params.is_empty() && program.typed.may_have(item.decl)
    }

    pub(super) fn has_generic(&self, candidates: &[Overload]) -> bool {
        self.cx.globals.program.typed.on && candidates.iter().any(|candidate| self.is_generic(candidate.found))
    }

    /// Marks the parameters of a candidate that may have another type: those that only calls restrict.
    fn loose(&mut self, candidate: &Overload) -> Vec<bool> {
        let item = self.cx.globals.item(candidate.found).filter(|_| self.is_generic(candidate.found));
        let Some(item) = item else { return vec![false; candidate.takes.len()] };
        let typed = &self.cx.globals.program.typed;
        let given = item.decl.params.iter().map(|param| typed.given((item.own, param.id())).is_some());
        let given: Vec<bool> = given.collect();
        let free =
            |takes: &Constraint| matches!(takes, Constraint::Var(var) if self.vars.state(*var) == VarState::Free);
        candidate.takes.iter().map(free).zip(given).map(|(free, given)| free || given).collect()
    }

    /// Chooses like `choose`, if some candidates may have instances with other types.
    pub(super) fn choose_generic(
        &mut self,
        name: &Name,
        candidates: &[Overload],
        args: &[TypeUse],
        result: Var,
        force: bool,
    ) -> bool {
        if self.stage == Stage::Bodies && !force {
            return false;
        }
        let all: Vec<(&Overload, Vec<bool>)> = candidates.iter().map(|own| (own, self.loose(own))).collect();
        let fitting: Vec<_> = all.iter().filter(|(candidate, _)| self.fits(candidate, args)).collect();
        if args.iter().any(|&(var, _)| self.is_free(var)) && !fitting.is_empty() {
            if force {
                // An existing instance that returns the required type is the likeliest.
                let likely = fitting.iter().find(|(candidate, _)| self.may_give(candidate, result));
                self.choose_this(name, likely.unwrap_or(&fitting[0]).0, args, result);
            } else {
                self.learn(&fitting, args);
            }
            return force;
        }
        if let Some((found, _)) = fitting.iter().find(|(candidate, _)| self.is_exact(candidate)) {
            self.choose_this(name, found, args, result);
            return true;
        }
        if self.stage != Stage::Wanting && !force {
            return false;
        }
        for (candidate, loose) in &all {
            let Some(Wish { wanted, poison }) = self.wish(candidate, loose, args) else { continue };
            if poison || self.cx.globals.program.typed.may_be(wanted.decl, &wanted.types) {
                if !poison {
                    self.wanted.push(wanted);
                }
                // The type is known once the instance exists.
                self.vars.poison(result);
                return true;
            }
        }
        match fitting.first() {
            Some((found, _)) => self.choose_this(name, found, args, result),
            None => self.none_fits(name, candidates, args, result),
        }
        true
    }

    fn may_give(&mut self, candidate: &Overload, result: Var) -> bool {
        let Some(needs) = self.vars.known(result) else { return true };
        self.taken(candidate.gives).is_none_or(|gives| gives == needs)
    }

    /// Binds the types of arguments on which all fitting candidates agree, if no other types are possible.
    fn learn(&mut self, fitting: &[&(&Overload, Vec<bool>)], args: &[TypeUse]) {
        for (index, &(var, span)) in args.iter().enumerate() {
            if !self.is_free(var) {
                continue;
            }
            let mut common = None;
            for (candidate, loose) in fitting {
                let ty = if loose[index] { None } else { self.taken(candidate.takes[index]) };
                if ty.is_none() || common.is_some_and(|common| common != ty) {
                    common = None;
                    break;
                }
                common = Some(ty);
            }
            if let Some(Some(ty)) = common {
                self.vars.bind(var, ty, span);
                self.moved = true;
            }
        }
    }

    /// The types that a declaration would need for a call.
    fn wish(&mut self, candidate: &Overload, loose: &[bool], args: &[TypeUse]) -> Option<Wish> {
        let item = self.cx.globals.item(candidate.found).filter(|_| loose.contains(&true))?;
        let decl = (item.instance, item.decl.name.id());
        let (mut types, mut poison) = (Types::new(), false);
        for ((takes, loose), &(var, _)) in candidate.takes.iter().zip(loose).zip(args) {
            let got = self.vars.known(var);
            types.push(got.filter(|_| *loose));
            poison |= *loose && got.is_none();
            let needs = if *loose { None } else { self.taken(*takes) };
            if let (Some(needs), Some(got)) = (needs, got)
                && needs != got
            {
                return None;
            }
        }
        Some(Wish { wanted: Wanted { decl, types }, poison })
    }

    /// Reports a call without a fitting candidate. With only one candidate, the argument is blamed.
    fn none_fits(&mut self, name: &Name, candidates: &[Overload], args: &[TypeUse], result: Var) {
        let found = candidates[0].found;
        let Some(item) = self.cx.globals.item(found).filter(|_| candidates.len() == 1).cloned() else {
            self.fits_none(name, candidates, args);
            return self.vars.poison(result);
        };
        let rule = matches!(found, Use::Rule(_)).then_some(name.span);
        self.cx.tables.uses.insert((self.own, name.id()), found);
        let first = self.calls.len();
        self.arguments(&item, args.to_vec(), rule);
        (first..self.calls.len()).for_each(|call| self.join_argument(call));
        if let Constraint::Var(own) = candidates[0].gives {
            _ = self.vars.join(result, own);
        }
    }
}
