//! Steps of a rule: which operation, rule or leaf each call is, and whether the words in it exist.

use super::arity::{counts, usage, wrong_count};
use super::names::{KeysSorted, Scope};
use super::{Door, Use};
use crate::ast::{Arg, Binary, Comp, Expr, ExprKind, Name, Op, OpKind, Prefix, Split, SplitItem, Unary};
use crate::code::Code;
use crate::diag::Level;
use crate::ir::Axis;
use crate::ops::{self, Operation, ParamKind, SELECTORS};
use crate::span::Span;
use crate::suggest::nearest;
use crate::words;

/// The axis of a split; `None` when it has none or an unknown one.
pub(crate) fn split_axis(split: &Split) -> Option<Axis> {
    match word(split.args.first()?)? {
        "x" => Some(Axis::X),
        "y" => Some(Axis::Y),
        "z" => Some(Axis::Z),
        _ => None,
    }
}

/// Whether the parts of a split shrink to their geometry: yes, if nothing else is said.
pub(crate) fn split_adjust(split: &Split) -> bool {
    split.args.get(1).and_then(word) != Some("noAdjust")
}

/// An argument that is a bare word.
fn word(arg: &Arg) -> Option<&str> {
    match &arg.value.kind {
        ExprKind::Name(name) if arg.prefix.is_none() => Some(&name.text),
        _ => None,
    }
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

fn has_error(args: &[Arg]) -> bool {
    args.iter().any(|arg| matches!(arg.value.kind, ExprKind::Error))
}

impl<'a> Scope<'_, 'a, '_> {
    pub(super) fn ops(&mut self, ops: &'a [Op]) {
        for (index, op) in ops.iter().enumerate() {
            self.op(op);
            if let (OpKind::Nil, Some(next)) = (&op.kind, ops.get(index + 1)) {
                let span = next.span.to(ops[ops.len() - 1].span);
                self.cx.diags.report(Code::AfterNil, span, "`NIL` has removed the shape, nothing happens here");
                // Still resolved, so that misspellings in it are found.
                for op in &ops[index + 1..] {
                    self.op(op);
                }
                return;
            }
        }
    }

    fn op(&mut self, op: &'a Op) {
        match &op.kind {
            OpKind::Leaf(_) | OpKind::Nil | OpKind::Error => {}
            OpKind::Dynamic { .. } | OpKind::Block(_) => {
                self.cx.diags.report(Code::Unsupported, op.span, "this is not supported yet");
            }
            OpKind::Call(name, args) if name.text == "set" => self.set(name, args),
            OpKind::Call(name, args) => self.shape_call(name, args),
            OpKind::Path(_, args) => self.values(args),
            OpKind::Push(ops) => self.ops(ops),
            OpKind::Split(split) => self.split(split),
            OpKind::Comp(comp) => self.comp(comp),
            OpKind::Case(arms, otherwise) => {
                for (condition, ops) in arms {
                    self.expr(condition);
                    self.ops(ops);
                }
                self.ops(otherwise);
            }
            OpKind::Chance(arms, otherwise) => {
                self.percentages(arms.iter().map(|(percent, _)| percent));
                for (_, ops) in arms {
                    self.ops(ops);
                }
                self.ops(otherwise);
            }
        }
    }

    /// Arguments that are plain values.
    fn values(&mut self, args: &'a [Arg]) {
        for arg in args {
            if let Some((prefix, span)) = arg.prefix {
                self.no_prefix(prefix, span);
            }
            self.expr(&arg.value);
        }
    }

    fn no_prefix(&mut self, prefix: Prefix, span: Span) {
        let sign = if prefix == Prefix::Relative { "'" } else { "~" };
        let diag = self.cx.diags.report(Code::MisplacedPrefix, span, format!("`{sign}` cannot stand here"));
        match prefix {
            Prefix::Relative => diag.note("only lengths can be relative to the scope"),
            Prefix::Floating => diag.note("only the sizes of a split can float"),
        };
    }

    fn shape_call(&mut self, name: &'a Name, args: &'a [Arg]) {
        if has_error(args) {
            for arg in args {
                self.expr(&arg.value);
            }
            return;
        }
        let mut rows = ops::operations(&name.text).filter(|row| row.takes(args.len()));
        if let Some(row) = rows.next() {
            self.operation(row, args);
            return self.note(name, Use::Operation(row));
        }
        match self.cx.globals.rule(&name.text, args.len()) {
            Some(index) => {
                self.values(args);
                self.note(name, Use::Rule(index));
            }
            None => {
                // What an operation with another number of arguments makes of these nobody can tell: its words would
                // look like unknown names and its relative lengths misplaced.
                if ops::operations(&name.text).next().is_none() {
                    for arg in args {
                        self.expr(&arg.value);
                    }
                }
                self.undefined(name, args.len());
            }
        }
    }

    /// A call that is neither an operation nor a rule.
    fn undefined(&mut self, name: &'a Name, count: usize) {
        let (text, globals) = (name.text.as_str(), &self.cx.globals);
        if globals.lost.contains(text) {
            return;
        }
        let takes: Vec<usize> =
            ops::operations(text).flat_map(|row| ops::required(row.params)..=row.params.len()).collect();
        if !takes.is_empty() {
            let rows: Vec<String> = ops::operations(text).map(|row| format!("`{}`", usage(row))).collect();
            let message = format!("operation `{text}` takes {}, got {count}", counts(takes));
            self.cx.diags.report(Code::ArgumentCount, name.span, message).help(format!("write {}", rows.join(" or ")));
            return;
        }
        if ops::functions(text).next().is_some() || words::is_later_function(text) {
            let message = format!("`{text}` is a function: it has a value, it does nothing to the shape");
            self.cx.diags.report(Code::NotAnOperation, name.span, message);
            return;
        }
        let inline = self.cx.door == Door::Inline;
        let others = globals.rules_named.get(text);
        let (message, near) = match others {
            Some(list) => {
                let message = format!("rule `{text}` takes {}, got {count}", counts(list.iter().map(|(own, _)| *own)));
                (message, None)
            }
            None => {
                let names = globals.rules_named.keys_sorted().chain(ops::all_operations().map(|row| row.name));
                let near = nearest(text, names.chain(["split", "comp", "set", "NIL"])).map(str::to_owned);
                (format!("there is no rule `{text}`"), near)
            }
        };
        let level = if inline { Level::Error } else { Level::Warning };
        let diag = self.cx.diags.report_as(Code::UndefinedRule, level, name.span, message);
        if !inline {
            diag.note(format!("it becomes a leaf named `{text}`"));
        }
        diag.suggest(near);
        if others.is_none() && count == 0 {
            diag.help(format!("write `{text}.` for a leaf"));
        }
        self.note(name, Use::Leaf);
    }

    fn operation(&mut self, row: &'static Operation, args: &'a [Arg]) {
        for (param, arg) in row.params.iter().zip(args) {
            match &param.kind {
                ParamKind::Word { words, .. } => self.word(row.name, words.iter().map(|(word, _)| *word), arg),
                kind => {
                    match arg.prefix {
                        Some((Prefix::Relative, _)) if *kind == ParamKind::Length => {}
                        Some((prefix, span)) => self.no_prefix(prefix, span),
                        None => {}
                    }
                    self.expr(&arg.value);
                }
            }
        }
    }

    /// An argument that must be one of some words.
    fn word(&mut self, name: &str, list: impl Iterator<Item = &'static str> + Clone, arg: &Arg) {
        let (found, all) = (word(arg).unwrap_or_default(), list.clone().collect::<Vec<_>>());
        if all.contains(&found) {
            return;
        }
        let shown = if found.is_empty() { "this".into() } else { format!("`{found}`") };
        let all = all.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ");
        self.cx
            .diags
            .report(Code::UnknownWord, arg.span, format!("{shown} is not a word of `{name}`"))
            .note(format!("it knows {all}"))
            .suggest(nearest(found, list));
    }

    fn set(&mut self, name: &'a Name, args: &'a [Arg]) {
        let [target, value] = args else {
            if !has_error(args) {
                wrong_count(self.cx, "operation", name, vec![2], args.len());
            }
            return;
        };
        self.values(std::slice::from_ref(value));
        let ExprKind::Name(attr) = &target.value.kind else {
            if !has_error(args) {
                let message = "`set` needs the name of an attribute";
                self.cx.diags.report(Code::NotSettable, target.span, message);
            }
            return;
        };
        let text = attr.text.as_str();
        // A parameter of that name hides nothing here: it could not be set anyway.
        let found = match self.cx.globals.values.get(text) {
            Some(Use::Attr(index)) => Ok(Use::SetAttr(*index)),
            Some(Use::Const(_)) => Err("a constant"),
            Some(_) => Err("a function"),
            None => match ops::shape_attr(text) {
                Some(row) if row.set.is_some() => Ok(Use::SetShape(row)),
                Some(_) => Err("given by the shape"),
                None if self.params.iter().any(|param| param.text == text) => Err("a parameter"),
                None => return self.unknown_target(attr),
            },
        };
        match found {
            Ok(found) => self.note(name, found),
            Err(what) => {
                let message = format!("`{text}` is {what}, it cannot be set");
                self.cx.diags.report(Code::NotSettable, attr.span, message);
            }
        }
    }

    fn unknown_target(&mut self, attr: &'a Name) {
        let (text, globals) = (attr.text.as_str(), &self.cx.globals);
        if globals.lost.contains(text) {
            return;
        }
        if words::is_later_attribute(text) {
            self.cx.diags.report(Code::Unsupported, attr.span, format!("`{text}` is not supported yet"));
            return;
        }
        let own = globals.attrs.iter().map(|decl| decl.name.text.as_str());
        let names = own.chain(ops::all_shape_attrs().filter(|row| row.set.is_some()).map(|row| row.name));
        let near = nearest(text, names).map(str::to_owned);
        let message = format!("there is no attribute `{text}`");
        self.cx.diags.report(Code::UnknownName, attr.span, message).suggest(near);
    }

    fn split(&mut self, split: &'a Split) {
        self.split_args(split);
        self.items(&split.items);
    }

    fn split_args(&mut self, split: &'a Split) {
        if has_error(&split.args) {
            return;
        }
        let Some(axis) = split.args.first() else {
            let message = "a split needs an axis: `split(x)`, `split(y)` or `split(z)`";
            self.cx.diags.report(Code::UnknownAxis, split.name.span, message);
            return;
        };
        if let Some("u" | "v") = word(axis) {
            self.cx.diags.report(Code::Unsupported, axis.span, "a split in texture space is not supported yet");
            return;
        }
        if split_axis(split).is_none() {
            let shown = word(axis).map_or("this".into(), |word| format!("`{word}`"));
            let diag = self.cx.diags.report(Code::UnknownAxis, axis.span, format!("{shown} is not an axis"));
            diag.help("write `x`, `y` or `z`");
        }
        if let Some(adjust) = split.args.get(1) {
            self.word("split", ["adjust", "noAdjust"].into_iter(), adjust);
        }
        if 2 < split.args.len() {
            wrong_count(self.cx, "operation", &split.name, vec![1, 2], split.args.len());
        }
    }

    fn items(&mut self, items: &'a [SplitItem]) {
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

    fn comp(&mut self, comp: &'a Comp) {
        match comp.args.first().map(|arg| (arg, word(arg).unwrap_or_default())) {
            Some((_, "f")) | Some((Arg { value: Expr { kind: ExprKind::Error, .. }, .. }, _)) => {}
            Some((arg, word @ ("e" | "fe" | "v" | "fv" | "g" | "m" | "h"))) => {
                self.cx.diags.report(Code::Unsupported, arg.span, format!("`comp({word})` is not supported yet"));
            }
            Some((arg, word)) => {
                let shown = if word.is_empty() { "this".into() } else { format!("`{word}`") };
                let message = format!("{shown} is not a kind of component");
                self.cx.diags.report(Code::UnknownWord, arg.span, message).help("write `comp(f)` for faces");
            }
            None => {
                let message = "`comp` needs a kind of component";
                self.cx.diags.report(Code::UnknownWord, comp.name.span, message).help("write `comp(f)` for faces");
            }
        }
        if let Some(second) = comp.args.get(1).filter(|_| !has_error(&comp.args)) {
            let text = word(second).unwrap_or("a second argument");
            self.cx.diags.report(Code::Unsupported, second.span, format!("`comp` with `{text}` is not supported yet"));
        }
        let faces = comp.args.first().and_then(word) == Some("f");
        for arm in &comp.arms {
            // Other components have other selectors.
            if faces {
                self.selector(&arm.selector);
            }
            self.ops(&arm.ops);
        }
    }

    fn selector(&mut self, selector: &'a Expr) {
        if is_condition(selector) {
            self.cx.diags.report(Code::Unsupported, selector.span, "conditions as selectors are not supported yet");
            return;
        }
        let ExprKind::Name(name) = &selector.kind else { return self.expr(selector) };
        let text = name.text.as_str();
        if let Some(&word) = SELECTORS.iter().find(|&&word| word == text) {
            self.note(name, Use::Selector(word));
        } else if let Some(found) = self.lookup(text) {
            self.note(name, found);
        } else if words::is_later_selector(text) {
            self.cx.diags.report(Code::Unsupported, name.span, format!("selector `{text}` is not supported yet"));
        } else if !self.cx.globals.lost.contains(text) {
            self.cx
                .diags
                .report(Code::UnknownSelector, name.span, format!("unknown selector `{text}`"))
                .suggest(nearest(text, SELECTORS.iter().copied()))
                .note(format!(
                    "there are {}",
                    SELECTORS.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
                ));
        }
    }
}
