//! Selectors of arms.

use super::arity::wrong_count;
use super::resolver::Resolver;
use super::tables::Use;
use crate::diag::code::Code;
use crate::diag::{Diag, quoted};
use crate::dialect::Dialect;
use crate::ops::{self, Selector, SelectorPlaces};
use crate::suggest::nearest;
use crate::syntax::ast::{Arm, ArmMode, Binary, CompValue, Expr, ExprKind, Name, Unary};

impl<'a> Resolver<'_, 'a, '_> {
    /// Resolves the selector of an arm.
    pub(crate) fn arm(&mut self, arm: &'a Arm, place: SelectorPlaces) {
        if place.connects() {
            self.index(&arm.selector);
        }
        self.selector(&arm.selector, place);
        if arm.mode == ArmMode::Connected && place != SelectorPlaces::NONE && !place.connects() {
            let message = "only `comp` and `modify` take `=:`";
            self.cx.diags.report(Code::Syntax, arm.selector.span, message).help("write `:` or `=`");
        }
    }

    /// Resolves `comp(f) { selector : value }`.
    pub(crate) fn comp_value(&mut self, comp: &'a CompValue) {
        let place = self.comp_args(comp);
        for (selector, _, value) in &comp.arms {
            self.index(selector);
            self.selector(selector, place);
            // Words read the component to be selected, so they are not available in the value.
            let outer = self.place.take();
            self.expr(value);
            self.place = outer;
        }
    }

    /// Resolves the arguments of `comp` as a value, like the arguments of the operation. Returns the selectors.
    fn comp_args(&mut self, comp: &'a CompValue) -> SelectorPlaces {
        let Some(row) = ops::operations(&comp.name.text).next() else { return SelectorPlaces::NONE };
        if comp.args.is_empty() {
            self.missing_word(&comp.name, row);
        } else if !row.takes(comp.args.len()) {
            let takes = (ops::required(row.params)..=row.params.len()).collect();
            wrong_count(self.cx, "function", &comp.name, takes, comp.args.len());
        }
        for (words, arg) in row.params.iter().filter_map(|param| param.kind.words()).zip(&comp.args) {
            if !matches!(arg.kind, ExprKind::Error) {
                self.word_expr(row.name, &[words], arg);
            }
        }
        row.places(comp.args.first().and_then(Expr::word))
    }

    /// Resolves a selector: a word, an index or a condition made of words and values.
    pub(crate) fn selector(&mut self, selector: &'a Expr, place: SelectorPlaces) {
        if place.has_words_only() {
            return self.only_word(selector, place);
        }
        let outer = self.place.replace(place);
        self.condition(selector, place);
        self.place = outer;
    }

    /// Resolves a selector where only words are allowed.
    fn only_word(&mut self, selector: &Expr, place: SelectorPlaces) {
        match &selector.kind {
            ExprKind::Error => {}
            ExprKind::Name(name) => match ops::selector(&name.text) {
                Some(row) => self.known_selector(name, row, place),
                None => _ = self.wrong_selector(name, place, &format!("unknown selector `{}`", name.text)),
            },
            _ => {
                let here = quoted(ops::selectors().filter(|row| row.on.has(place)).map(|row| row.name));
                let message = "a selector is a word here, not an index or a condition";
                self.cx.diags.report(Code::UnknownSelector, selector.span, message).note(format!("there are {here}"));
            }
        }
    }

    /// Reports a negative number as a selector of a comp: published rule files have it, and it finds nothing. Negative numbers of
    /// `setback` wrap (*setback operation*).
    fn index(&mut self, selector: &Expr) {
        if let ExprKind::Unary(Unary::Minus, operand) = &selector.kind
            && let ExprKind::Number(number) = operand.kind
            && 0.0 < number
        {
            let message = format!("no component has the index -{number}");
            let code = if self.dialect() == Dialect::Text { Code::SelectorHidden } else { Code::UnknownSelector };
            let diag = self.cx.diags.report(code, selector.span, message);
            diag.note("components are numbered from 0").help("write the index of a component, or a selector");
        }
    }

    /// Resolves a part of a selector that must be a bool: the whole selector, or an operand of `!`, `&&` and `||`. A
    /// selector takes precedence over declared names. Parentheses make the name an expression, as arithmetic does.
    fn condition(&mut self, part: &'a Expr, place: SelectorPlaces) {
        match &part.kind {
            ExprKind::Name(name) => self.selector_name(name, part.span == name.span, place),
            ExprKind::Unary(Unary::Not, part) => self.condition(part, place),
            ExprKind::Binary(Binary::And | Binary::Or, _, left, right) => {
                self.condition(left, place);
                self.condition(right, place);
            }
            ExprKind::Chain(_, links) if matches!(links[0].op, Binary::And | Binary::Or) => {
                part.parts().into_iter().for_each(|part| self.condition(part, place));
            }
            _ => self.expr(part),
        }
    }

    fn selector_name(&mut self, name: &'a Name, is_bare: bool, place: SelectorPlaces) {
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

    /// Resolves the word of a selector. Reports it if it does not select this kind of component.
    pub(crate) fn known_selector(&mut self, name: &Name, row: &'static Selector, place: SelectorPlaces) {
        self.note(name, Use::Selector(row.name));
        self.deprecated(name, row.old);
        if row.on.has(place) {
            return;
        }
        let diag = self.wrong_selector(name, place, &format!("selector `{}` is not allowed here", name.text));
        let kinds = ops::COMPONENTS.iter().filter(|kind| row.on.has(kind.place));
        let kinds: Vec<String> = kinds.map(|kind| format!("`comp({})`", kind.name)).collect();
        if !kinds.is_empty() {
            diag.note(format!("`{}` is allowed in {}", name.text, kinds.join(", ")));
        }
    }

    fn wrong_selector(&mut self, name: &Name, place: SelectorPlaces, message: &str) -> &mut Diag {
        let here = || ops::selectors().filter(|row| row.on.has(place) && row.old.is_none()).map(|row| row.name);
        let all = quoted(here().filter(|name| !name.contains('.')));
        let longer = here().find(|row| row.rsplit_once('.').is_some_and(|(_, last)| last == name.text));
        let near = longer.or_else(|| nearest(&name.text, here()).filter(|near| *near != name.text));
        let by_name = [(SelectorPlaces::GROUPS, "groups"), (SelectorPlaces::MATERIALS, "materials")]
            .into_iter()
            .find(|(kind, _)| *kind == place);
        let diag = self.cx.diags.report(Code::UnknownSelector, name.span, message);
        if let Some((_, list)) = by_name.filter(|_| near.is_none()) {
            return diag
                .help(format!("to find a component by name, write `findFirst(geometry.{list}, \"{}\")`", name.text));
        }
        diag.suggest(near).note(format!("there are {all}"));
        if !place.has_words_only() && ops::all_operations().any(|row| row.tags.contains(&name.text.as_str())) {
            diag.help(format!("`{0}` is a tag: write `isTagged(\"{0}\")`", name.text));
        }
        diag
    }
}
