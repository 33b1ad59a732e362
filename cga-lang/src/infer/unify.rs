//! Type variables and their unification.

use crate::span::Span;
use crate::types::Type;

/// A type variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Var(u32);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum VarState {
    /// Nothing is known.
    Free,
    /// Known.
    Is(Type),
    /// A mistake was reported; the type is compatible with all types.
    Poison,
}

#[derive(Clone, Copy)]
struct Node {
    parent: u32,
    state: VarState,
    /// The place that determined the type.
    why: Option<Span>,
}

/// Sets of type variables with equal types.
#[derive(Default)]
pub(super) struct Vars {
    nodes: Vec<Node>,
}

impl Vars {
    pub(super) fn add(&mut self, state: VarState, why: Option<Span>) -> Var {
        let parent = self.nodes.len() as u32;
        self.nodes.push(Node { parent, state, why });
        Var(parent)
    }

    fn root(&mut self, var: Var) -> usize {
        let mut at = var.0 as usize;
        while self.nodes[at].parent as usize != at {
            let up = self.nodes[at].parent as usize;
            self.nodes[at].parent = self.nodes[up].parent;
            at = up;
        }
        at
    }

    pub(super) fn state(&mut self, var: Var) -> VarState {
        let root = self.root(var);
        self.nodes[root].state
    }

    pub(super) fn known(&mut self, var: Var) -> Option<Type> {
        match self.state(var) {
            VarState::Is(ty) => Some(ty),
            _ => None,
        }
    }

    pub(super) fn why(&mut self, var: Var) -> Option<Span> {
        let root = self.root(var);
        self.nodes[root].why
    }

    /// Marks a type as wrong and reported.
    pub(super) fn poison(&mut self, var: Var) {
        let root = self.root(var);
        if self.nodes[root].state == VarState::Free {
            self.nodes[root].state = VarState::Poison;
        }
    }

    /// Binds a free variable to a type. Returns false if it has another type.
    pub(super) fn bind(&mut self, var: Var, ty: Type, why: Span) -> bool {
        let root = self.root(var);
        let node = &mut self.nodes[root];
        match node.state {
            VarState::Free => {
                node.state = VarState::Is(ty);
                node.why = Some(why);
                true
            }
            VarState::Is(own) => own == ty,
            VarState::Poison => true,
        }
    }

    /// Joins two variables. If their types differ, returns both types and leaves the variables unchanged.
    pub(super) fn join(&mut self, a: Var, b: Var) -> Result<(), (Type, Type)> {
        let (a, b) = (self.root(a), self.root(b));
        match (self.nodes[a].state, self.nodes[b].state) {
            (VarState::Is(first), VarState::Is(second)) if first != second => return Err((first, second)),
            // A mistake in one place does not affect the other.
            (VarState::Poison, _) | (_, VarState::Poison) => {}
            (VarState::Is(_), VarState::Free) => self.nodes[b].parent = a as u32,
            _ => self.nodes[a].parent = b as u32,
        }
        Ok(())
    }
}
