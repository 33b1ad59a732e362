//! The declarations and uses of names in the compiled file, for editors. With errors, the index has all names that
//! are known.

use crate::ir::Type;
use crate::resolve::globals::Globals;
use crate::resolve::tables::{Tables, Use};
use crate::syntax::ast::Name;
use std::collections::HashMap;

/// The kind of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum NameKind {
    /// An attribute.
    Attr,
    /// A constant.
    Const,
    /// A function.
    Function,
    /// A rule.
    Rule,
    /// A parameter or local value of the declaration whose name is the token.
    Param(u32),
}

/// A declared name.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// The kind of declaration.
    pub kind: NameKind,
    /// The name as written.
    pub name: String,
    /// The type of its value, if known; `None` for a rule.
    pub ty: Option<Type>,
    /// The token of its declaration.
    pub token: u32,
    /// The tokens of its uses, in order.
    pub uses: Vec<u32>,
}

/// Collects the names of the compiled file in the style `Default`.
pub(crate) fn index(globals: &Globals, tables: &Tables) -> Vec<Named> {
    let program = globals.program;
    let Some(&root) = program.roots.first() else { return Vec::new() };
    let mut list = Vec::new();
    // The index in the list, by kind and number.
    let mut places: HashMap<(NameKind, u32), usize> = HashMap::new();
    let mut add = |kind: NameKind, number: u32, name: &Name| {
        // Names with dots are several tokens.
        if !name.text.contains('.') {
            places.insert((kind, number), list.len());
            let ty = tables.at(root).ty(name).filter(|_| kind != NameKind::Rule);
            list.push(Named { kind, name: name.text.clone(), ty, token: name.id(), uses: Vec::new() });
        }
    };
    let globals_of = [
        (NameKind::Attr, &globals.attrs),
        (NameKind::Const, &globals.consts),
        (NameKind::Function, &globals.functions),
        (NameKind::Rule, &globals.rules),
    ];
    let mut scopes = Vec::new();
    for (kind, items) in globals_of {
        for (number, item) in (0..).zip(items).filter(|(_, item)| !item.origin && item.own == root) {
            add(kind, number, &item.decl.name);
            let owner = item.decl.name.id();
            (0..).zip(item.decl.inner()).for_each(|(number, name)| add(NameKind::Param(owner), number, name));
            scopes.push((item.decl.span.first, item.decl.span.last, owner));
        }
    }
    scopes.sort_unstable();
    let uses = tables.uses.iter().filter(|((own, _), _)| *own == root);
    let mut uses: Vec<(u32, Use)> = uses.map(|((_, token), found)| (*token, *found)).collect();
    uses.sort_unstable_by_key(|(token, _)| *token);
    for (token, found) in uses {
        let key = match found {
            Use::Attr(index) => (NameKind::Attr, index),
            // In `set(name, …)` the name is a use of the attribute.
            Use::SetAttr(index) => (NameKind::Attr, index),
            Use::Const(index) => (NameKind::Const, index),
            Use::Function(index) => (NameKind::Function, index),
            Use::Rule(index) => (NameKind::Rule, index),
            Use::Param(index) => {
                let at = scopes.partition_point(|(first, ..)| *first <= token);
                let Some(&(_, last, owner)) = at.checked_sub(1).and_then(|at| scopes.get(at)) else { continue };
                if last < token {
                    continue;
                }
                (NameKind::Param(owner), index)
            }
            _ => continue,
        };
        let token = if matches!(found, Use::SetAttr(_)) { token + 2 } else { token };
        let Some(named) = places.get(&key).and_then(|at| list.get_mut(*at)) else { continue };
        if program.tokens.as_slice().get(token as usize).and_then(|tok| tok.ident()) == Some(named.name.as_str()) {
            named.uses.push(token);
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::NameKind;
    use crate::compile::compile_text;

    #[test]
    fn names_are_known_with_an_error_elsewhere() {
        let text = "attr h = 1  Lot --> A(h) set(h, 2)  A(n) --> t(n, h, n) Lot  B --> nothing(";
        let source = compile_text(text);
        assert!(source.compiled.grammar.is_none());
        let shown: Vec<(NameKind, &str, usize)> =
            source.compiled.index.iter().map(|it| (it.kind, it.name.as_str(), it.uses.len())).collect();
        let of_a = source.compiled.index.iter().find(|it| it.name == "A").expect("a rule").token;
        for expected in [
            (NameKind::Attr, "h", 3),
            (NameKind::Rule, "Lot", 1),
            (NameKind::Rule, "A", 1),
            (NameKind::Param(of_a), "n", 2),
        ] {
            assert!(shown.contains(&expected), "{expected:?} in {shown:?}");
        }
    }
}
