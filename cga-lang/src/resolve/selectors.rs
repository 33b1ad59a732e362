//! Axes of splits, kinds of components and their selectors.

use super::arguments::{bare, has_error, split_axis, word};
use super::arity::wrong_count;
use super::scope::Scope;
use super::tables::Use;
use crate::ast::{Arg, ArmMode, Binary, Comp, CompArm, CompValue, Expr, ExprKind, Name, Split, SplitItem, Unary};
use crate::code::Code;
use crate::diag::Diag;
use crate::ops::{self, Places, Selector};
use crate::span::Span;
use crate::suggest::nearest;

impl<'a> Scope<'_, 'a, '_> {
    pub(crate) fn split(&mut self, split: &'a Split) {
        self.split_args(split);
        self.items(&split.items);
    }

    fn split_args(&mut self, split: &'a Split) {
        if has_error(&split.args) {
            return;
        }
        let Some(axis) = split.args.first() else {
            let name = &split.name.text;
            let message = format!("a split needs an axis: `{name}(x)`, `{name}(y)` or `{name}(z)`");
            self.cx.diags.report(Code::UnknownAxis, split.name.span, message);
            return;
        };
        if split.is_in_texture_space() {
            if let Some(space) = split.args.get(1) {
                self.word("split", ["uvSpace", "unitSpace"].into_iter(), space);
            }
            if let Some(set) = split.args.get(2) {
                self.values(std::slice::from_ref(set));
            }
            if !(2..=3).contains(&split.args.len()) {
                wrong_count(self.cx, "operation", &split.name, vec![2, 3], split.args.len());
            }
            return;
        }
        if split_axis(split).is_none() {
            let shown = word(axis).map_or("this".into(), |word| format!("`{word}`"));
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

    pub(crate) fn items(&mut self, items: &'a [SplitItem]) {
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

    pub(crate) fn comp(&mut self, comp: &'a Comp) {
        let args: Vec<(&Expr, Span)> = comp.args.iter().map(|arg: &Arg| (&arg.value, arg.span)).collect();
        let place = self.comp_kind("operation", &comp.name, args.into_iter());
        for arm in &comp.arms {
            self.index(&arm.selector);
            self.arm(arm, place);
        }
    }

    pub(crate) fn arm(&mut self, arm: &'a CompArm, place: Places) {
        self.selector(&arm.selector, place);
        if arm.mode == ArmMode::Connected && place != Places::NONE && !place.connects() {
            let message = "only `comp` and `modify` take `=:`";
            self.cx.diags.report(Code::Syntax, arm.selector.span, message).help("write `:` or `=`");
        }
        self.ops(&arm.ops);
    }

    /// `comp(f) { selector : value }`.
    pub(crate) fn comp_value(&mut self, comp: &'a CompValue) {
        let place = self.comp_kind("function", &comp.name, comp.args.iter().map(|arg| (arg, arg.span)));
        for (selector, _, value) in &comp.arms {
            self.index(selector);
            self.selector(selector, place);
            // Words ask about the component that is to be selected; the value is none of them.
            let outer = self.place.take();
            self.expr(value);
            self.place = outer;
        }
    }

    /// The arguments of a comp: what selectors there are.
    fn comp_kind<'e>(
        &mut self,
        what: &str,
        name: &Name,
        args: impl ExactSizeIterator<Item = (&'e Expr, Span)>,
    ) -> Places {
        if 2 < args.len() {
            wrong_count(self.cx, what, name, vec![1, 2], args.len());
        }
        let mut args = args;
        let (kind, scope) = (args.next(), args.next());
        let mut place = Places::NONE;
        match kind.map(|(arg, span)| (arg, span, bare(arg).unwrap_or_default())) {
            Some((Expr { kind: ExprKind::Error, .. }, ..)) => {}
            Some((_, span, word)) => match ops::component(word) {
                Some(row) => place = row.place,
                None => self.unknown_component(word, span),
            },
            None => {
                let message = "`comp` needs a kind of component";
                self.cx.diags.report(Code::UnknownWord, name.span, message).help("write `comp(f)` for faces");
            }
        }
        if let Some((arg, span)) = scope {
            match bare(arg) {
                Some("zUp" | "noAlign") => {}
                _ if matches!(arg.kind, ExprKind::Error) => {}
                word => {
                    let shown = word.map_or("this".into(), |word| format!("`{word}`"));
                    let message = format!("{shown} is not a word of `comp`");
                    self.cx.diags.report(Code::UnknownWord, span, message).note("it knows `zUp`, `noAlign`");
                }
            }
        }
        place
    }

    fn unknown_component(&mut self, word: &str, span: Span) {
        let shown = if word.is_empty() { "this".into() } else { format!("`{word}`") };
        let message = format!("{shown} is not a kind of component");
        let all = ops::COMPONENTS.iter().map(|row| format!("`{}`", row.name)).collect::<Vec<_>>().join(", ");
        let diag = self.cx.diags.report(Code::UnknownWord, span, message);
        diag.note(format!("there are {all}")).help("write `comp(f)` for faces");
    }

    /// Resolves a selector: a word, an index or a condition made of words and values.
    pub(crate) fn selector(&mut self, selector: &'a Expr, place: Places) {
        if place.has_words_only() {
            return self.only_word(selector, place);
        }
        let outer = self.place.replace(place);
        self.condition(selector, place);
        self.place = outer;
    }

    /// Resolves a selector where only words can stand.
    fn only_word(&mut self, selector: &Expr, place: Places) {
        match &selector.kind {
            ExprKind::Error => {}
            ExprKind::Name(name) => match ops::selector(&name.text) {
                Some(row) => self.known_selector(name, row, place),
                None => _ = self.wrong_selector(name, place, &format!("unknown selector `{}`", name.text)),
            },
            _ => {
                let here = ops::selectors().filter(|row| row.on.has(place)).map(|row| format!("`{}`", row.name));
                let here = here.collect::<Vec<_>>().join(", ");
                let message = "a selector is a word here, not an index or a condition";
                self.cx.diags.report(Code::UnknownSelector, selector.span, message).note(format!("there are {here}"));
            }
        }
    }

    /// Where a name is a bool for certain it is a selector's word if it can be.
    /// Refuses a negative number as a selector of a comp. Those of `setback` wrap (*setback operation*).
    fn index(&mut self, selector: &Expr) {
        if let ExprKind::Unary(Unary::Minus, operand) = &selector.kind
            && let ExprKind::Number(number) = operand.kind
            && 0.0 < number
        {
            let message = format!("there is no component with the index -{number}");
            let diag = self.cx.diags.report(Code::UnknownSelector, selector.span, message);
            diag.note("components are numbered from 0 on").help("write the index of a component, or a selector");
        }
    }

    /// Resolves a part of a selector that must be a bool: the whole selector, or an operand of `!`, `&&` and `||`. The selector
    /// of a name goes before everything that is declared. Parentheses make the name an expression, as arithmetic does.
    fn condition(&mut self, part: &'a Expr, place: Places) {
        match &part.kind {
            ExprKind::Name(name) => self.selector_name(name, part.span == name.span, place),
            ExprKind::Unary(Unary::Not, part) => self.condition(part, place),
            ExprKind::Binary(Binary::And | Binary::Or, _, left, right) => {
                self.condition(left, place);
                self.condition(right, place);
            }
            _ => self.expr(part),
        }
    }

    fn selector_name(&mut self, name: &'a Name, is_bare: bool, place: Places) {
        let text = name.text.as_str();
        match ops::selector(text) {
            Some(row) if is_bare => self.known_selector(name, row, place),
            None if self.lookup(text).is_none() => {
                if !self.cx.globals.is_lost(self.at, text) {
                    self.wrong_selector(name, place, &format!("unknown selector `{text}`"));
                }
            }
            _ => self.expr_name(name),
        }
    }

    /// A selector's word, where components of that kind are selected.
    pub(crate) fn known_selector(&mut self, name: &Name, row: &'static Selector, place: Places) {
        self.note(name, Use::Selector(row.name));
        self.deprecated(name, row.old);
        if row.on.has(place) {
            return;
        }
        let diag = self.wrong_selector(name, place, &format!("selector `{}` cannot stand here", name.text));
        let kinds = ops::COMPONENTS.iter().filter(|kind| row.on.has(kind.place));
        let kinds: Vec<String> = kinds.map(|kind| format!("`comp({})`", kind.name)).collect();
        if !kinds.is_empty() {
            diag.note(format!("`{}` stands in {}", name.text, kinds.join(", ")));
        }
    }

    fn wrong_selector(&mut self, name: &Name, place: Places, message: &str) -> &mut Diag {
        let here = || ops::selectors().filter(|row| row.on.has(place) && row.old.is_none()).map(|row| row.name);
        let all: Vec<String> = here().filter(|name| !name.contains('.')).map(|name| format!("`{name}`")).collect();
        let longer = here().find(|row| row.rsplit_once('.').is_some_and(|(_, last)| last == name.text));
        let near = longer.or_else(|| nearest(&name.text, here()).filter(|near| *near != name.text));
        let by_name =
            [(Places::GROUPS, "groups"), (Places::MATERIALS, "materials")].into_iter().find(|(kind, _)| *kind == place);
        let diag = self.cx.diags.report(Code::UnknownSelector, name.span, message);
        if let Some((_, list)) = by_name.filter(|_| near.is_none()) {
            return diag.help(format!("one of a name is `findFirst(geometry.{list}, \"{}\")`", name.text));
        }
        diag.suggest(near).note(format!("there are {}", all.join(", ")))
    }
}
