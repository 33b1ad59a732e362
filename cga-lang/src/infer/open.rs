//! Expressions that are unclear when they are read: `+`, calls with several candidates, arrays. They are decided as
//! soon as enough is known, and at the end by the likeliest choice.

use super::{Infer, Type, Use, Var, VarState};
use crate::diag::code::Code;
use crate::link::InstanceId;
use crate::span::Span;
use crate::syntax::ast::{Binary, Name};

/// The maximum number of rounds. After them, the likeliest choice decides.
const MOST_ROUNDS: usize = 64;

/// A type and the place where it is needed.
pub(super) type TypeUse = (Var, Span);

/// An open expression.
pub(super) struct Open {
    own: InstanceId,
    kind: OpenKind,
    /// The type of its value. A rule has no value, and its type stays free.
    result: Var,
    /// The place of a mismatch of its value.
    at: Span,
}

/// The kinds of open expressions.
pub(super) enum OpenKind {
    /// `a + b`: a sum, or text.
    Plus(TypeUse, TypeUse),
    /// `a .+ b` and other operators that work element by element.
    Each(Binary, TypeUse, TypeUse),
    /// `[a, b]`: entries are elements or arrays.
    Array(Vec<TypeUse>),
    /// `a[i]` or `a[i, j]`: an element, or an array if an index is one.
    Index(TypeUse, Vec<TypeUse>),
    /// A call with several candidates, and its arguments.
    Call(Name, Vec<Overload>, Vec<TypeUse>),
}

/// A candidate of a call.
#[derive(Clone)]
pub(super) struct Overload {
    pub(super) found: Use,
    pub(super) takes: Vec<Constraint>,
    pub(super) gives: Constraint,
}

#[derive(Clone, Copy)]
pub(super) enum Constraint {
    /// Any type, or a word.
    Any,
    Type(Type),
    Var(Var),
}

impl Infer<'_, '_, '_> {
    /// Decides the expression if possible, otherwise lets it wait. Returns the type of its value.
    pub(super) fn wait(&mut self, kind: OpenKind, at: Span) -> Var {
        let result = self.free();
        self.open.push(Some(Open { own: self.own, kind, result, at }));
        // Most expressions are clear at once, and later ones use their types.
        self.decide(self.open.len() - 1, false);
        result
    }

    /// Decides all expressions that can be decided. The number of rounds is bounded; the likeliest choice decides the
    /// remaining ones.
    pub(super) fn propagate(&mut self) {
        for _ in 0..MOST_ROUNDS {
            let mut changed = false;
            // Forwards, then backwards, because chains of functions may be in either order.
            for index in (0..self.open.len()).chain((0..self.open.len()).rev()) {
                changed |= self.decide(index, false);
            }
            changed |= std::mem::take(&mut self.moved);
            if !changed {
                break;
            }
        }
    }

    /// Decides the remaining expressions in source order: as inferred if they have become clear, otherwise by the
    /// likeliest choice.
    pub(super) fn settle(&mut self) {
        for index in 0..self.open.len() {
            if !self.decide(index, false) {
                self.decide(index, true);
            }
        }
    }

    /// Returns true if a type became known. With `force`, the expression is decided in any case.
    fn decide(&mut self, index: usize, force: bool) -> bool {
        let Some(Open { own, mut kind, result, at }) = self.open[index].take() else { return false };
        let done = self.inside(own, |pass| match &mut kind {
            OpenKind::Plus(left, right) => pass.plus(*left, *right, result, at, force),
            OpenKind::Each(op, left, right) => pass.each(*op, at, *left, *right, result, force),
            OpenKind::Array(entries) => pass.array(entries, result, at, force),
            OpenKind::Index(array, indices) => pass.index(*array, indices, result, at, force),
            OpenKind::Call(name, candidates, args) => pass.choose(name, candidates, args, result, force),
        });
        if !done {
            self.open[index] = Some(Open { own, kind, result, at });
        }
        done
    }

    fn plus(&mut self, left: TypeUse, right: TypeUse, result: Var, at: Span, force: bool) -> bool {
        let (l, r) = (self.vars.state(left.0), self.vars.state(right.0));
        let text = VarState::Is(Type::Text);
        if l == text || r == text {
            self.gives(result, Type::Text, at, "this `+` gives");
            return true;
        }
        if l == VarState::Poison || r == VarState::Poison {
            // No further diagnostic is needed.
            return true;
        }
        let is_other = |state: VarState| matches!(state, VarState::Is(ty) if ty != Type::Float);
        let sum = self.vars.known(result) == Some(Type::Float)
            || (l == VarState::Is(Type::Float) && r == l)
            || (is_other(l) && r != VarState::Free)
            || (is_other(r) && l != VarState::Free);
        if sum || (force && self.vars.known(result).is_none_or(|ty| ty != Type::Text)) {
            self.need_var(left.0, left.1, Type::Float, "`+`");
            self.need_var(right.0, right.1, Type::Float, "`+`");
            self.gives(result, Type::Float, at, "this `+` gives");
            return true;
        }
        if force {
            for (var, _) in [left, right] {
                self.vars.bind(var, Type::Text, at);
            }
        }
        force
    }

    fn gives(&mut self, result: Var, ty: Type, at: Span, this_gives: &str) {
        if !self.vars.bind(result, ty, at)
            && let Some(needs) = self.vars.known(result)
        {
            let message = format!("{this_gives} a {}, but a {} is needed", ty.word(), needs.word());
            self.cx.diags.report(Code::TypeMismatch, at, message);
        }
    }

    fn each(&mut self, op: Binary, at: Span, left: TypeUse, right: TypeUse, result: Var, force: bool) -> bool {
        let states = [left, right].map(|(var, _)| self.vars.state(var));
        if states.contains(&VarState::Poison) {
            return true;
        }
        let (l, r) = (self.vars.known(left.0), self.vars.known(right.0));
        let who = format!("`.{}`", op.text());
        let this_gives = format!("this {who} gives");
        let element = match op {
            Binary::Sub | Binary::Mul | Binary::Div | Binary::Rem => Some(Type::Float),
            Binary::And | Binary::Or => Some(Type::Bool),
            Binary::Add => match (l, r) {
                (Some(a), Some(b)) if a.element() != Type::Text && b.element() != Type::Text => Some(Type::Float),
                (Some(ty), _) | (_, Some(ty)) if ty.element() == Type::Text => Some(Type::Text),
                _ if force => Some(Type::Float),
                _ => None,
            },
            _ => l.or(r).map(Type::element),
        };
        let Some(element) = element.or(force.then_some(Type::Float)) else { return false };
        let gives = match op {
            Binary::Add => element.array(),
            Binary::Sub | Binary::Mul | Binary::Div | Binary::Rem => Type::Floats,
            _ => Type::Bools,
        };
        let is_single = |ty: Option<Type>| ty.is_some_and(|ty| !ty.is_array());
        let ordered = matches!(op, Binary::Lt | Binary::Le | Binary::Gt | Binary::Ge);
        if ordered && element == Type::Bool {
            self.cx.diags.report(Code::TypeMismatch, at, "bools have no order").help("write `.==` or `.!=`");
            return true;
        }
        // Text can be joined with any type.
        let strict = !(op == Binary::Add && element == Type::Text);
        for (var, span) in [left, right] {
            if strict
                && let Some(ty) = self.vars.known(var)
                && ty.element() != element
            {
                let message =
                    format!("{who} needs a {} or {} here, got a {}", element.word(), element.array().word(), ty.word());
                self.cx.diags.report(Code::TypeMismatch, span, message);
                return true;
            }
        }
        if is_single(l) && is_single(r) {
            // `1.+2` is read like this and has no other meaning.
            self.gives(result, gives.element(), at, &this_gives);
            return true;
        }
        if !force && ((is_single(l) && r.is_none()) || (is_single(r) && l.is_none())) {
            return false;
        }
        self.gives(result, gives, at, &this_gives);
        match (self.vars.known(left.0), self.vars.known(right.0)) {
            (Some(_), Some(_)) => true,
            // One side is not an array, so the other side is.
            (Some(a), None) if !a.is_array() => self.vars.bind(right.0, element.array(), at),
            (None, Some(b)) if !b.is_array() => self.vars.bind(left.0, element.array(), at),
            _ if force => {
                for (var, _) in [left, right] {
                    if self.is_free(var) {
                        self.vars.bind(var, element.array(), at);
                    }
                }
                true
            }
            _ => false,
        }
    }

    fn array(&mut self, entries: &[TypeUse], result: Var, span: Span, force: bool) -> bool {
        let mut element = self.vars.known(result).filter(|ty| ty.is_array()).map(Type::element);
        let mut all_known = true;
        for &(var, place) in entries {
            match self.vars.state(var) {
                VarState::Is(ty) => match element {
                    None => element = Some(ty.element()),
                    Some(first) if first != ty.element() => {
                        let needs = format!("this array has elements of type {}, here is", first.word());
                        self.mismatch(place, &needs, ty);
                        self.gives(result, first.array(), span, "this is");
                        return true;
                    }
                    Some(_) => {}
                },
                VarState::Free => all_known = false,
                VarState::Poison => {}
            }
        }
        let Some(element) = element.or(force.then_some(Type::Float)) else { return false };
        self.gives(result, element.array(), span, "this is");
        if force {
            for &(var, place) in entries {
                if self.is_free(var) {
                    self.vars.bind(var, element, place);
                }
            }
        }
        all_known || force
    }

    fn index(&mut self, array: TypeUse, indices: &[TypeUse], result: Var, span: Span, force: bool) -> bool {
        let mut many = Some(false);
        for &(var, place) in indices {
            match self.vars.known(var) {
                Some(Type::Float) => {}
                Some(Type::Floats | Type::Bools) => many = Some(true),
                Some(ty) => {
                    self.mismatch(place, "an index is a float, an array of floats or an array of bools, not", ty);
                    return true;
                }
                None if force => _ = self.vars.bind(var, Type::Float, place),
                None if many != Some(true) => many = None,
                None => {}
            }
        }
        let found = match self.vars.state(array.0) {
            VarState::Poison => return true,
            VarState::Is(ty) if !ty.is_array() => {
                self.mismatch(array.1, "only arrays have elements, this is", ty);
                return true;
            }
            VarState::Is(ty) => Some(ty),
            VarState::Free => self.vars.known(result).map(Type::array),
        };
        let Some(found) = found.or(force.then_some(Type::Floats)) else { return false };
        self.vars.bind(array.0, found, array.1);
        let Some(many) = many.or(force.then_some(false)) else { return false };
        self.gives(result, if many { found } else { found.element() }, span, "this index gives");
        true
    }

    /// Removes candidates that do not fit, and decides if one is left.
    fn choose(
        &mut self,
        name: &Name,
        candidates: &mut Vec<Overload>,
        args: &[TypeUse],
        result: Var,
        force: bool,
    ) -> bool {
        if self.has_generic(candidates) {
            return self.choose_generic(name, candidates, args, result, force);
        }
        let fits: Vec<bool> = candidates.iter().map(|candidate| self.fits(candidate, args)).collect();
        if !fits.contains(&true) {
            self.fits_none(name, candidates, args);
            self.vars.poison(result);
            return true;
        }
        let mut keep = fits.into_iter();
        candidates.retain(|_| keep.next() == Some(true));
        let settled = args.iter().all(|&(var, _)| !self.is_free(var));
        if 1 < candidates.len() && !force && !(settled && candidates.iter().all(|candidate| self.is_exact(candidate))) {
            // The type that all candidates return is already known.
            if let Some(ty) = self.common(candidates) {
                self.vars.bind(result, ty, name.span);
            }
            return false;
        }
        let chosen = candidates.swap_remove(0);
        self.choose_this(name, &chosen, args, result);
        true
    }

    pub(super) fn choose_this(&mut self, name: &Name, chosen: &Overload, args: &[TypeUse], result: Var) {
        self.cx.tables.uses.insert((self.own, name.id()), chosen.found);
        for (takes, &(var, span)) in chosen.takes.iter().zip(args) {
            match takes {
                Constraint::Any => {}
                Constraint::Type(ty) => self.need_var(var, span, *ty, &format!("`{}`", name.text)),
                Constraint::Var(param) => _ = self.vars.join(var, *param),
            }
        }
        match chosen.gives {
            Constraint::Any => {}
            Constraint::Type(ty) => self.gives(result, ty, name.span, "this call gives"),
            Constraint::Var(var) => {
                if let Err((needs, got)) = self.vars.join(result, var) {
                    self.mismatch(name.span, &format!("a {} is needed, this is", needs.word()), got);
                }
            }
        }
    }

    /// The type, if known.
    pub(super) fn taken(&mut self, takes: Constraint) -> Option<Type> {
        match takes {
            Constraint::Any => None,
            Constraint::Type(ty) => Some(ty),
            Constraint::Var(var) => self.vars.known(var),
        }
    }

    pub(super) fn fits(&mut self, candidate: &Overload, args: &[TypeUse]) -> bool {
        candidate.takes.iter().zip(args).all(|(takes, &(var, _))| {
            let Some(got) = self.vars.known(var) else { return true };
            self.taken(*takes).is_none_or(|ty| ty == got)
        })
    }

    /// Returns true if the types of its parameters are known.
    pub(super) fn is_exact(&mut self, candidate: &Overload) -> bool {
        candidate.takes.iter().all(|takes| !matches!(takes, Constraint::Var(var) if self.is_free(*var)))
    }

    /// The type that all candidates return.
    fn common(&mut self, candidates: &[Overload]) -> Option<Type> {
        let mut types = candidates.iter().map(|candidate| self.taken(candidate.gives));
        let first = types.next()??;
        types.all(|ty| ty == Some(first)).then_some(first)
    }

    /// Reports the argument of an operation or function that has the wrong type in every form, if all forms need the same.
    fn wrong_in_all_forms(&mut self, name: &Name, candidates: &[Overload], args: &[TypeUse]) -> bool {
        if candidates.iter().any(|candidate| matches!(candidate.found, Use::Rule(_))) {
            return false;
        }
        for (index, &(var, span)) in args.iter().enumerate() {
            let mut types = candidates.iter().map(|candidate| candidate.takes.get(index).copied());
            let Some(Some(Constraint::Type(needs))) = types.next() else { continue };
            let is_same = types.all(|takes| matches!(takes, Some(Constraint::Type(ty)) if ty == needs));
            if is_same && self.vars.known(var).is_some_and(|got| got != needs) {
                self.need_var(var, span, needs, &format!("`{}`", name.text));
                return true;
            }
        }
        false
    }

    pub(super) fn fits_none(&mut self, name: &Name, candidates: &[Overload], args: &[TypeUse]) {
        if self.wrong_in_all_forms(name, candidates, args) {
            return;
        }
        let shown = |ty: Option<Type>| ty.map_or("…", Type::word);
        let got: Vec<&str> = args.iter().map(|&(var, _)| shown(self.vars.known(var))).collect();
        let span = args.first().map_or(name.span, |first| first.1.to(args[args.len() - 1].1));
        let mut forms: Vec<String> = Vec::new();
        for candidate in candidates {
            let takes: Vec<&str> = candidate.takes.iter().map(|takes| shown(self.taken(*takes))).collect();
            forms.push(format!("`{}({})`", name.text, takes.join(", ")));
        }
        forms.dedup();
        let message = format!("`{}` cannot take ({})", name.text, got.join(", "));
        let diag = if candidates.iter().all(|candidate| matches!(candidate.found, Use::Rule(_))) {
            self.no_rule(name.span, &name.text, span, message)
        } else {
            Some(self.cx.diags.report(Code::TypeMismatch, span, message))
        };
        if let Some(diag) = diag {
            diag.note(format!("the forms are {}", forms.join(", ")));
        }
    }
}
