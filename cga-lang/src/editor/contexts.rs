//! The context of each name in a declaration: an operation, a value, a selector or a word of a parameter.

use super::view::View;
use crate::ops::{Braces, operations};
use crate::syntax::token::{Sym, Tok};

/// The context of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Context {
    /// An operation, a rule or a leaf.
    Operation,
    /// A value: an attribute, a constant, a parameter, a function.
    Value,
    /// A selector of components.
    Selector,
    /// The name of an annotation.
    Annotation,
    /// An argument that is a name alone: a value, or a word of the parameter.
    Argument {
        /// The token of the operation or function.
        call: u32,
        /// The number of the argument.
        number: usize,
    },
}

/// The tokens between two brackets, or all of a body.
struct Frame {
    kind: Kind,
    /// True before the colon of `case`.
    is_condition: bool,
    /// The colons that are missing before the operations of a slot or arm begin.
    missing: u8,
    /// The last operation: its braces may follow.
    call: Option<usize>,
    /// The comma or bracket before the current argument.
    comma: usize,
    /// The number of the current argument.
    number: usize,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Operations,
    Values,
    /// The arguments of the name at a position.
    Arguments(usize),
    /// Slots or arms, with the number of colons before the operations and the context before them.
    Arms(u8, Context),
}

impl Frame {
    fn new(kind: Kind, position: usize) -> Self {
        let missing = if let Kind::Arms(colons, _) = kind { colons } else { 0 };
        Frame { kind, is_condition: false, missing, call: None, comma: position, number: 0 }
    }

    fn context(&self) -> Context {
        match self.kind {
            _ if self.is_condition => Context::Value,
            Kind::Operations => Context::Operation,
            Kind::Arms(_, before) if 0 < self.missing => before,
            Kind::Arms(..) => Context::Operation,
            Kind::Values | Kind::Arguments(_) => Context::Value,
        }
    }
}

/// Calls `found` with the names of an annotation or a body and their contexts, in order. Names after a dot belong to the name
/// before them. `body` is the position of the body, which has operations in a rule.
pub(super) fn contexts(view: &View<'_>, body: usize, end: usize, is_rule: bool, found: &mut dyn FnMut(usize, Context)) {
    let root = if is_rule { Kind::Operations } else { Kind::Values };
    let mut frames = vec![Frame::new(root, body)];
    for position in body..end {
        let Some(token) = view.at(position) else { break };
        let depth = frames.len();
        let Some(frame) = frames.last_mut() else { break };
        match token {
            Tok::Ident(_) if is_field(view, position) => {
                // `Leaf. Name`, or a rule of an import.
                let is_operation = frame.context() == Context::Operation;
                frame.call = if is_operation { Some(position) } else { frame.call };
                if is_operation && view.is_apart(position) {
                    found(position, Context::Operation);
                }
            }
            Tok::Ident(word) => {
                let context = frame.context();
                match (context, word.as_str(), frame.kind) {
                    (Context::Operation, "case", _) => frame.is_condition = true,
                    (Context::Operation, ..) => frame.call = Some(position),
                    _ => {}
                }
                let argument = match frame.kind {
                    Kind::Arguments(call) if is_alone(view, frame.comma, position) => view.list.get(call).copied(),
                    _ => None,
                };
                let number = frame.number;
                found(position, argument.map_or(context, |call| Context::Argument { call, number }));
            }
            Tok::Sym(Sym::Colon) if frame.is_condition => frame.is_condition = false,
            Tok::Sym(Sym::Colon | Sym::Assign) if matches!(frame.kind, Kind::Arms(..)) => {
                frame.missing = frame.missing.saturating_sub(1);
            }
            Tok::Sym(Sym::Bar) => {
                (frame.is_condition, frame.call) = (false, None);
                if let Kind::Arms(colons, _) = frame.kind {
                    frame.missing = colons;
                }
            }
            Tok::Sym(Sym::Comma) => {
                (frame.comma, frame.number) = (position, frame.number + 1);
            }
            Tok::Sym(open @ (Sym::LParen | Sym::LBracket | Sym::LBrace)) => {
                let kind = inner(view, frame, *open, position);
                frames.push(Frame::new(kind, position));
            }
            Tok::Sym(Sym::RParen | Sym::RBracket | Sym::RBrace) if 1 < depth => _ = frames.pop(),
            _ => {}
        }
    }
}

/// Returns true for a name after a dot and a name.
fn is_field(view: &View<'_>, position: usize) -> bool {
    1 < position && view.is(position - 1, Sym::Dot) && view.ident(position - 2).is_some()
}

/// Returns true if the name, or the name with dots that begins with it, is the whole argument so far.
fn is_alone(view: &View<'_>, comma: usize, position: usize) -> bool {
    comma + 1 == position && !view.is(position + 1, Sym::LParen)
}

/// The kind of the frame after an opening bracket.
fn inner(view: &View<'_>, frame: &Frame, open: Sym, position: usize) -> Kind {
    let in_operations = frame.context() == Context::Operation;
    let name = position.checked_sub(1).filter(|before| view.ident(*before).is_some());
    match open {
        Sym::LParen => name.map_or(Kind::Values, Kind::Arguments),
        Sym::LBracket if in_operations => Kind::Operations,
        Sym::LBracket => Kind::Values,
        // `{ { size : operations }* }`
        _ if matches!(frame.kind, Kind::Arms(..)) && !in_operations => frame.kind,
        _ => {
            let name = frame.call.and_then(|call| view.ident(call)).unwrap_or_default();
            match operations(name).map(|row| row.braces).find(|braces| *braces != Braces::None) {
                Some(Braces::Slots(_)) => Kind::Arms(1, Context::Value),
                Some(Braces::Sections) => Kind::Arms(2, Context::Value),
                Some(Braces::Arms(_) | Braces::Components | Braces::Modified) => Kind::Arms(1, Context::Selector),
                Some(Braces::None | Braces::Ops | Braces::Operands | Braces::Inline) | None => Kind::Operations,
            }
        }
    }
}
