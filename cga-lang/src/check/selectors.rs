//! Axes of splits, kinds of components and their selectors.

use super::arity::wrong_count;
use super::names::Scope;
use super::{Use, shapes, words};
use crate::ast::{Arg, Binary, Comp, CompArm, Expr, ExprKind, Name, Split, SplitItem, Unary};
use crate::code::Code;
use crate::ir::Axis;
use crate::ops::{self, Places};
use crate::span::Span;
use crate::suggest::nearest;

/// The axis of a split; `None` when it has none, an unknown one or one of the texture space.
pub(crate) fn split_axis(split: &Split) -> Option<Axis> {
    match words::word(split.args.first()?)? {
        "x" => Some(Axis::X),
        "y" => Some(Axis::Y),
        "z" => Some(Axis::Z),
        _ => None,
    }
}

/// Whether the parts of a split shrink to their geometry: yes, if nothing else is said.
pub(crate) fn split_adjust(split: &Split) -> bool {
    split.args.get(1).and_then(words::word) != Some("noAdjust")
}

/// Whether a selector is a condition by its form.
pub(super) fn is_condition(selector: &Expr) -> bool {
    use Binary::{And, Eq, Ge, Gt, Le, Lt, Ne, Or};
    matches!(
        selector.kind,
        ExprKind::Unary(Unary::Not, _)
            | ExprKind::Bool(_)
            | ExprKind::Binary(And | Or | Eq | Ne | Lt | Le | Gt | Ge, ..)
    )
}

/// What does not run yet, and where it stands.
pub(super) type Later = Option<(Span, String)>;

impl<'a> Scope<'_, 'a, '_> {
    pub(super) fn split(&mut self, split: &'a Split) {
        self.split_args(split);
        self.items(&split.items);
    }

    fn split_args(&mut self, split: &'a Split) {
        if shapes::has_error(&split.args) {
            return;
        }
        let Some(axis) = split.args.first() else {
            let name = &split.name.text;
            let message = format!("a split needs an axis: `{name}(x)`, `{name}(y)` or `{name}(z)`");
            self.cx.diags.report(Code::UnknownAxis, split.name.span, message);
            return;
        };
        if let Some("u" | "v") = words::word(axis)
            && !split.is_by_area()
        {
            self.not_implemented(axis.span, "a split in texture space", None);
            if let Some(space) = split.args.get(1) {
                self.word("split", ["uvSpace", "unitSpace"].into_iter(), space);
            }
            if let Some(set) = split.args.get(2) {
                self.expr(&set.value);
            }
            if !(2..=3).contains(&split.args.len()) {
                wrong_count(self.cx, "operation", &split.name, vec![2, 3], split.args.len());
            }
            return;
        }
        if split_axis(split).is_none() {
            let shown = words::word(axis).map_or("this".into(), |word| format!("`{word}`"));
            let diag = self.cx.diags.report(Code::UnknownAxis, axis.span, format!("{shown} is not an axis"));
            diag.help("write `x`, `y` or `z`");
        }
        if let Some(adjust) = split.args.get(1) {
            self.word(&split.name.text, ["adjust", "noAdjust"].into_iter(), adjust);
        }
        if 2 < split.args.len() {
            wrong_count(self.cx, "operation", &split.name, vec![1, 2], split.args.len());
        }
    }

    pub(super) fn items(&mut self, items: &'a [SplitItem]) {
        for item in items {
            match item {
                SplitItem::Slot(size, ops) => {
                    self.expr(&size.value);
                    self.ops(ops);
                }
                SplitItem::Group(items, _) => self.items(items),
            }
        }
    }

    pub(super) fn comp(&mut self, comp: &'a Comp) {
        let args: Vec<(&Expr, Span)> = comp.args.iter().map(|arg: &Arg| (&arg.value, arg.span)).collect();
        let (place, runs) = self.comp_kind(comp.name.span, args.into_iter());
        let arms: Vec<Later> = comp.arms.iter().map(|arm| self.arm(arm, place)).collect();
        if let Some((span, what)) = arms.into_iter().fold(runs, Option::or) {
            self.not_implemented(span, &what, None);
            self.cx.tables.later.insert(comp.name.id());
        }
    }

    pub(super) fn arm(&mut self, arm: &'a CompArm, place: Places) -> Later {
        let later = self.selector(&arm.selector, place);
        self.ops(&arm.ops);
        let connected = arm.mode == crate::ast::ArmMode::Connected;
        later.or_else(|| connected.then(|| (arm.selector.span, "`comp` with `=:`".into())))
    }

    /// The arguments of a comp: what selectors there are, and what does not run yet.
    pub(super) fn comp_kind<'e>(
        &mut self,
        name: Span,
        mut args: impl Iterator<Item = (&'e Expr, Span)>,
    ) -> (Places, Later) {
        let (kind, scope) = (args.next(), args.next());
        let (mut place, mut later) = (Places::NONE, None);
        match kind.map(|(arg, span)| (arg, span, bare(arg).unwrap_or_default())) {
            Some((Expr { kind: ExprKind::Error, .. }, ..)) => {}
            Some((_, span, word)) => match ops::component(word) {
                Some(row) => {
                    place = row.place;
                    later = (!row.now).then(|| (span, format!("`comp({word})`")));
                }
                None => self.unknown_component(word, span),
            },
            None => {
                let message = "`comp` needs a kind of component";
                self.cx.diags.report(Code::UnknownWord, name, message).help("write `comp(f)` for faces");
            }
        }
        if let Some((arg, span)) = scope {
            match bare(arg) {
                Some("zUp") => {}
                Some("noAlign") => later = later.or_else(|| Some((span, "`comp` with `noAlign`".into()))),
                _ if matches!(arg.kind, ExprKind::Error) => {}
                word => {
                    let shown = word.map_or("this".into(), |word| format!("`{word}`"));
                    let message = format!("{shown} is not a word of `comp`");
                    self.cx.diags.report(Code::UnknownWord, span, message).note("it knows `zUp`, `noAlign`");
                }
            }
        }
        (place, later)
    }

    fn unknown_component(&mut self, word: &str, span: Span) {
        let shown = if word.is_empty() { "this".into() } else { format!("`{word}`") };
        let message = format!("{shown} is not a kind of component");
        let all = ops::COMPONENTS.iter().map(|row| format!("`{}`", row.name)).collect::<Vec<_>>().join(", ");
        let diag = self.cx.diags.report(Code::UnknownWord, span, message);
        diag.note(format!("there are {all}")).help("write `comp(f)` for faces");
    }

    /// Resolves a selector: a word, an index or a condition made of words and values.
    pub(super) fn selector(&mut self, selector: &'a Expr, place: Places) -> Later {
        let later = self.selector_part(selector, place);
        later.or_else(|| is_condition(selector).then(|| (selector.span, "a condition as selector".into())))
    }

    fn selector_part(&mut self, selector: &'a Expr, place: Places) -> Later {
        match &selector.kind {
            ExprKind::Name(name) => self.selector_word(name, place),
            ExprKind::Unary(Unary::Not, part) => self.selector_part(part, place),
            ExprKind::Binary(Binary::And | Binary::Or, _, left, right) => {
                let (left, right) = (self.selector_part(left, place), self.selector_part(right, place));
                left.or(right)
            }
            ExprKind::Call(name, _) if name.text == "isTagged" => {
                self.expr(selector);
                Some((selector.span, "`isTagged`".into()))
            }
            _ => {
                self.expr(selector);
                None
            }
        }
    }

    fn selector_word(&mut self, name: &'a Name, place: Places) -> Later {
        let text = name.text.as_str();
        if self.inner.iter().any(|inner| inner.text == text) {
            self.expr_name(name);
            return None;
        }
        if let Some(row) = ops::selector(text) {
            self.note(name, Use::Selector(row.name));
            self.deprecated(name, row.old);
            if !row.on.has(place) {
                self.wrong_selector(name, place, &format!("selector `{text}` cannot stand here"));
                return None;
            }
            return (!row.now.has(place)).then(|| (name.span, format!("selector `{text}`")));
        }
        if self.lookup(text).is_some() {
            self.expr_name(name);
        } else if !self.cx.globals.is_lost(self.at, text) {
            self.wrong_selector(name, place, &format!("unknown selector `{text}`"));
        }
        None
    }

    fn wrong_selector(&mut self, name: &Name, place: Places, message: &str) {
        let here = || ops::selectors().filter(|row| row.on.has(place) && row.old.is_none()).map(|row| row.name);
        let all: Vec<String> = here().filter(|name| !name.contains('.')).map(|name| format!("`{name}`")).collect();
        let near = nearest(&name.text, here()).filter(|near| *near != name.text);
        let diag = self.cx.diags.report(Code::UnknownSelector, name.span, message);
        diag.suggest(near).note(format!("there are {}", all.join(", ")));
    }
}

/// An expression that is a bare word.
pub(super) fn bare(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) => Some(&name.text),
        _ => None,
    }
}
