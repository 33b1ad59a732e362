//! Operations of a rule: resolves each call to an operation, rule or leaf, and checks its words.

use std::cmp::Reverse;

use super::arguments::{has_error, word};
use super::arity::{counts, word_of_other_form, wrong_count, wrong_form};
use super::globals::Namespace;
use super::resolver::Resolver;
use super::tables::Use;
use super::words::{fitting, is_word_of, reach, strange_words};
use super::{habits, overrides};
use crate::diag::code::Code;
use crate::diag::{Level, RELATIVE};
use crate::dialect::Dialect;
use crate::ops::{self, Braces, Operation, ParamKind, SelectorPlaces, Words};
use crate::span::Span;
use crate::suggest::nearest;
use crate::syntax::ast::{Arg, Block, BlockPart, Decl, Expr, ExprKind, Name, Op, OpKind, Override, Prefix};
use crate::syntax::walk::OpPart;
use crate::types::Type;

/// The maximum number of declarations of a rule that a message names.
const MOST_DECLARED: usize = 3;

/// Returns true if the braces have the contents that the row requires.
fn has_braces(row: &Operation, block: &Block) -> bool {
    match (row.braces, block.parts.first()) {
        (Braces::None, _) => false,
        (Braces::Operands, Some(BlockPart::Ops(list))) => list.len() != 1,
        (Braces::Inline, Some(BlockPart::Ops(list))) => list.len() == 1,
        _ => true,
    }
}

/// The candidate rows of an operation with braces: those that have the words of the arguments, otherwise all, the
/// likeliest first.
fn likely(block: &Block) -> Vec<&'static Operation> {
    let words: Vec<Option<&str>> = block.args.iter().map(word).collect();
    let has_words = |row: &Operation| row.words(&words).is_some();
    let takes = |row: &Operation| row.takes(words.len());
    let mut rows: Vec<_> = ops::operations(&block.name.text).filter(|row| has_braces(row, block)).collect();
    let decides = |row: &&Operation| has_words(row) && (takes(row) || !rows.iter().any(|row| takes(row)));
    if rows.iter().any(decides) {
        rows.retain(|row| has_words(row));
    }
    rows.sort_by_key(|row| (Reverse(reach(row, &block.args)), strange_words(row, &block.args)));
    rows
}

/// The calls of the declared rules: "`Floor(n)` or `Floor(n, height)`".
fn calls(name: &str, declared: &[&Decl]) -> String {
    let call = |decl: &&Decl| {
        let params: Vec<&str> = decl.params.iter().map(|param| param.text.as_str()).collect();
        if params.is_empty() { format!("`{name}`") } else { format!("`{name}({})`", params.join(", ")) }
    };
    let list: Vec<String> = declared.iter().take(MOST_DECLARED).map(call).collect();
    list.join(" or ")
}

/// The help for two arguments that may be one number with a comma.
fn comma(first: &Arg, second: &Arg) -> Option<String> {
    let whole = |arg: &Arg| match arg.value.kind {
        ExprKind::Number(value) if arg.prefix.is_none() && value.fract() == 0.0 && value < 1e9 => Some(value),
        _ => None,
    };
    let (first, second) = (whole(first)?, whole(second)?);
    // The zeros of `1,000` are not in the value.
    let number = if second == 0.0 { String::new() } else { format!(", write `{first}.{second}`") };
    Some(format!("if it is one number{number}: `.` is the decimal point, and nothing separates thousands"))
}

impl<'a> Resolver<'_, 'a, '_> {
    pub(crate) fn ops(&mut self, ops: &'a [Op]) {
        for (index, op) in ops.iter().enumerate() {
            self.op(op);
            if let (OpKind::Leaf(leaf), Some(OpKind::Call(next, _))) = (&op.kind, ops.get(index + 1).map(|op| &op.kind))
            {
                self.misspelt_import(leaf, next);
            }
        }
    }

    /// Reports `lbi.Lot` if an import `lib` exists. Otherwise it would be a leaf and a call.
    fn misspelt_import(&mut self, leaf: &Name, next: &Name) {
        let imports = self.cx.globals.program.instances[self.at].imports.keys().map(String::as_str);
        if let Some(near) = nearest(&leaf.text, imports) {
            let message = format!("`{}.` is a leaf here, and `{}` is called on its own", leaf.text, next.text);
            let diag = self.cx.diags.report_as(Code::UndefinedRule, Level::Warning, leaf.span, message);
            diag.help(format!("did you mean `{near}.{}`?", next.text));
        }
    }

    fn op(&mut self, op: &'a Op) {
        // The selectors of its arms.
        let mut place = SelectorPlaces::NONE;
        match &op.kind {
            // The unreadable text may be an argument, so the number of arguments is unknown.
            OpKind::Call(_, args) if self.has_unread(op.span) => args.iter().for_each(|arg| self.expr(&arg.value)),
            OpKind::Call(name, args) if name.text == "set" => self.set(name, args),
            OpKind::Call(name, args) => self.shape_call(name, args),
            OpKind::Dynamic { import, overrides, rule, args } => self.dynamic(import, overrides, rule, args),
            OpKind::Path(_, args) => self.values(args),
            OpKind::Block(block) => place = self.block(block),
            OpKind::Chance(arms, _) => self.percentages(arms.iter().map(|(percent, _)| percent)),
            OpKind::Leaf(_) | OpKind::Nil | OpKind::Push(_) | OpKind::Case(..) | OpKind::Error => {}
        }
        for part in op.parts() {
            match part {
                OpPart::Size(arg) | OpPart::Length(arg) => self.expr(&arg.value),
                OpPart::Depth(value) | OpPart::Condition(value) => self.expr(value),
                OpPart::Arm(arm) => self.arm(arm, place),
                OpPart::Ops(ops) => self.ops(ops),
            }
        }
    }

    /// Resolves arguments that are plain values.
    pub(crate) fn values(&mut self, args: &'a [Arg]) {
        for arg in args {
            if let Some((prefix, span)) = arg.prefix {
                self.no_prefix(prefix, span);
            }
            self.expr(&arg.value);
        }
    }

    fn no_prefix(&mut self, prefix: Prefix, span: Span) {
        let sign = if prefix == Prefix::Relative { RELATIVE } else { '~' };
        let diag = self.cx.diags.report(Code::MisplacedPrefix, span, format!("`{sign}` is not allowed here"));
        diag.note(prefix.place()).help(prefix.instead());
    }

    /// Resolves a call of an operation or a rule.
    fn shape_call(&mut self, name: &'a Name, args: &'a [Arg]) {
        if has_error(args) {
            // A word of the operation is not an unknown name.
            let is_word = |arg: &&Arg| {
                let params = || ops::operations(&name.text).flat_map(|row| row.params);
                word(arg).is_some_and(|word| params().any(|param| param.kind.has_word(word)))
            };
            args.iter().filter(|arg| !is_word(arg)).for_each(|arg| self.expr(&arg.value));
            return;
        }
        let rows: Vec<_> = ops::operations(&name.text).filter(|row| row.takes(args.len())).collect();
        let fitting = fitting(&rows, args, self.dialect());
        let rules = self.rules(name, args.len());
        if !rules.is_empty() && fitting.is_empty() {
            self.values(args);
            return self.note_open(name, rules);
        }
        match (fitting.as_slice(), rows.first()) {
            ([], None) => {
                // With a wrong number of arguments, their meaning is unknown: words would look like unknown names and
                // relative lengths misplaced. The same is true of the arguments of a function.
                if ops::operations(&name.text).next().is_none() && ops::functions(&name.text).next().is_none() {
                    args.iter().for_each(|arg| self.expr(&arg.value));
                }
                self.undefined(name, args);
            }
            ([], Some(_)) => self.wrong_words(name, &rows, args),
            _ if rules.is_empty() && self.stray_word(name, &fitting, args) => {}
            ([row, ..], _) => {
                self.operation(&fitting, args);
                self.about_old(name, Use::Operation(row));
                self.needs_braces(name, row);
                // The types decide. If both fit, the operation is called.
                let rules = rules.into_iter().filter(|_| row.overloads);
                self.note_open(name, fitting.iter().copied().map(Use::Operation).chain(rules).collect());
            }
        }
    }

    /// Resolves a call whose words do not fit any row.
    fn wrong_words(&mut self, name: &Name, rows: &[&'static Operation], args: &'a [Arg]) {
        if self.swapped(name, rows, args) {
            return;
        }
        let before = self.cx.diags.so_far().len();
        // A number in place of a first word belongs to a form without words, which takes fewer arguments.
        let plain: Vec<_> = ops::operations(&name.text)
            .filter(|row| row.params.iter().all(|param| param.kind.words().is_none()))
            .collect();
        let is_number = args.first().is_some_and(|arg| matches!(arg.value.kind, ExprKind::Number(_)));
        if !plain.is_empty() && is_number && rows.iter().all(|row| reach(row, args) == 0) {
            wrong_form(self.cx, name, &plain, args);
        } else {
            self.operation(&rows[..1], args);
        }
        if let [first, second] = args
            && let Some(help) = comma(first, second)
            && ops::operations(&name.text).any(|row| row.takes(1))
            && let Some(diag) = self.cx.diags.so_far().get_mut(before)
        {
            diag.span = first.span;
            diag.help(help);
        }
    }

    fn needs_braces(&mut self, name: &Name, row: &Operation) {
        if row.braces != Braces::None {
            let message = format!("`{}` needs braces after it", name.text);
            self.cx.diags.report(Code::Syntax, name.span, message).note(format!("it {}", row.about));
        }
    }

    /// The candidate rules of a call.
    fn rules(&self, name: &Name, count: usize) -> Vec<Use> {
        let globals = &self.cx.globals;
        let list = globals.rules(self.at, &name.text).into_iter();
        list.filter(|index| globals.rules[*index as usize].decl.params.len() == count).map(Use::Rule).collect()
    }

    /// Reports a call that is neither an operation nor a rule.
    fn undefined(&mut self, name: &'a Name, args: &[Arg]) {
        let (text, globals, at, count) = (name.text.as_str(), &self.cx.globals, self.at, args.len());
        if globals.is_lost(at, text) {
            return;
        }
        if ops::operations(text).next().is_some() {
            let help = habits::step(text).filter(|_| count <= 3);
            let diag = wrong_form(self.cx, name, &ops::operations(text).collect::<Vec<_>>(), args);
            if let Some(help) = help {
                diag.help(help);
            }
            return;
        }
        let declared: Vec<&Decl> =
            globals.rules(at, text).iter().map(|&index| globals.rules[index as usize].decl).collect();
        let others: Vec<usize> = declared.iter().map(|decl| decl.params.len()).collect();
        let function = ops::functions(text).next().is_some() || !globals.functions(at, text).is_empty();
        if function && others.is_empty() {
            let message = format!("`{text}` is a function: it has a value and does not change the shape");
            self.cx.diags.report(Code::NotAnOperation, name.span, message);
            return;
        }
        let inline = self.dialect() == Dialect::Inline;
        let habit = habits::step(text).filter(|_| others.is_empty());
        let (mut message, mut near) = (format!("there is no rule `{text}`"), None);
        if !others.is_empty() {
            message = format!("rule `{text}` takes {}, got {count}", counts(others.iter().copied()));
        } else if habit.is_none() {
            let others = ops::all_operations().map(|row| row.name).chain(["set", "NIL"]);
            near = globals.meant(at, text, Namespace::Rules, others).or_else(|| globals.leaf(at, text));
        }
        let level = if inline { Level::Error } else { Level::Warning };
        let is_value = self.lookup(text).is_some() && count == 0;
        let diag = self.cx.diags.report_as(Code::UndefinedRule, level, name.span, message);
        if !inline {
            diag.note(format!("it becomes a leaf named `{text}`"));
        }
        diag.suggest(near);
        if let Some(help) = habit {
            diag.help(help);
        }
        if !declared.is_empty() {
            diag.help(format!("write {}", calls(text, &declared)));
        }
        for decl in declared.iter().take(MOST_DECLARED) {
            diag.related("it is declared", decl.name.span);
        }
        if is_value {
            diag.note(format!("`{text}` is a value and does not change the shape"));
        }
        if others.is_empty() && count == 0 && !text.contains('.') {
            diag.help(format!("write `{text}.` for a leaf, or declare it: `{text} --> …`"));
        }
        self.note(name, Use::Leaf);
    }

    /// Resolves the arguments of an operation. If there are several rows, the types decide later.
    pub(super) fn operation(&mut self, rows: &[&'static Operation], args: &'a [Arg]) {
        // The first word of another place or form is reported; after it, the meaning of others is unknown.
        let mut has_stray = false;
        for (index, arg) in args.iter().enumerate() {
            let kinds = || rows.iter().map(|row| &row.params[index].kind);
            let takes = |prefix| {
                kinds().any(|kind| match kind {
                    ParamKind::Length => prefix == Prefix::Relative,
                    ParamKind::Size => true,
                    _ => false,
                })
            };
            if let Some((prefix, span)) = arg.prefix.filter(|(prefix, _)| !takes(*prefix)) {
                self.no_prefix(prefix, span);
            }
            match &rows[0].params[index].kind {
                ParamKind::Word(words) => {
                    let is_alike = |row: &&Operation| row.braces == rows[0].braces && row.takes(args.len());
                    let is_likely = |row: &&Operation| {
                        index <= reach(row, args) && strange_words(row, args) <= strange_words(rows[0], args)
                    };
                    let forms = ops::operations(rows[0].name).filter(is_alike).filter(is_likely);
                    let others = forms.filter_map(|row| row.params[index].kind.words()).filter(|other| other != words);
                    let all: Vec<Words> = [*words].into_iter().chain(others).collect();
                    let is_known = word(arg).is_some_and(|word| all.iter().any(|words| words.has(word)));
                    let is_stray = !is_known && is_word_of(rows[0], arg);
                    let is_reported = is_stray && (has_stray || word_of_other_form(self.cx, rows[0], args, index));
                    if !is_reported {
                        self.word(rows[0].name, &all, arg);
                    }
                    has_stray |= is_stray;
                    if let Some((old, new)) = word(arg).and_then(|word| words.old(word)) {
                        self.old_word(old, new, arg.span);
                    }
                }
                ParamKind::Selector => self.selector(&arg.value, SelectorPlaces::FACES.and(SelectorPlaces::SETBACK)),
                _ if kinds().all(|kind| kind.ty() == Some(Type::Text))
                    && arg.prefix.is_none()
                    && self.unquoted(rows[0].params[index].kind, &arg.value) => {}
                _ if is_word_of(rows[0], arg)
                    && !self.is_declared(arg)
                    && (has_stray || word_of_other_form(self.cx, rows[0], args, index)) =>
                {
                    has_stray = true;
                }
                _ => self.expr(&arg.value),
            }
        }
    }

    /// Resolves the name and arguments of an operation with braces. Returns the selectors of its arms.
    fn block(&mut self, block: &'a Block) -> SelectorPlaces {
        let all = likely(block);
        let rows: Vec<_> = all.iter().copied().filter(|row| row.takes(block.args.len())).collect();
        if !has_error(&block.args) {
            self.block_args(block, &all, &rows);
        }
        let first = block.args.first().and_then(|arg| arg.value.word());
        rows.first().or(all.first()).map_or(SelectorPlaces::NONE, |row| row.places(first))
    }

    /// Resolves the arguments of an operation with braces. `all` are its rows, `rows` those with the right number of
    /// arguments.
    fn block_args(&mut self, block: &'a Block, all: &[&'static Operation], rows: &[&'static Operation]) {
        let (name, args) = (&block.name, &block.args);
        let fitting = fitting(rows, args, self.dialect());
        if fitting.is_empty() && self.swapped(name, rows, args) {
            return;
        }
        // A word of another form needs another number of arguments, unless that form does not have the other words.
        let farthest = |rows: &[&Operation]| rows.iter().map(|row| reach(row, args)).max();
        let strange = |rows: &[&Operation]| rows.iter().map(|row| strange_words(row, args)).min();
        let is_other = farthest(rows) < farthest(all) && (rows.is_empty() || strange(all) < strange(rows));
        let rows = if fitting.is_empty() && is_other { &[] } else { rows };
        if let Some(row) = fitting.first().or(rows.first()).copied() {
            self.operation(if fitting.is_empty() { std::slice::from_ref(&row) } else { &fitting }, args);
            self.about_old(name, Use::Operation(row));
            self.note_open(name, fitting.into_iter().map(Use::Operation).collect());
        } else if let Some(row) = all.first() {
            if !(args.is_empty() && self.missing_word(name, row)) {
                let forms: Vec<_> = ops::operations(&name.text).filter(|row| has_braces(row, block)).collect();
                wrong_form(self.cx, name, &forms, args);
            }
        } else if !self.cx.globals.is_lost(self.at, &name.text) {
            let names = ops::all_operations().filter(|row| row.braces != Braces::None).map(|row| row.name);
            let near = nearest(&name.text, names).map(str::to_owned);
            let message = format!("`{}` does not take a `{{ … }}` block", name.text);
            let diag = self.cx.diags.report(Code::NotAnOperation, name.span, message).suggest(near);
            if let Some(help) = habits::step(&name.text) {
                diag.help(help);
            }
        }
    }

    /// Resolves `id(overrides).Rule(args)`.
    fn dynamic(&mut self, import: &'a Name, list: &'a [Override], rule: &'a Name, args: &'a [Arg]) {
        for own in list {
            if let Override::Value(_, value) = own {
                self.expr(value);
            }
        }
        self.values(args);
        let program = self.cx.globals.program;
        let own = &program.instances[self.at];
        let target = match (own.dynamic.get(&import.id()), own.imports.get(&import.text)) {
            (Some(&target), _) => target,
            (None, Some(Some(target))) => {
                overrides::list_of(self.cx, *target, list);
                *target
            }
            (None, Some(None)) => return,
            (None, None) if self.cx.globals.is_lost(self.at, &import.text) => return,
            (None, None) => {
                let near = nearest(&import.text, self.cx.globals.near(self.at, Namespace::Imports)).map(str::to_owned);
                let message = format!("there is no import `{}`", import.text);
                self.cx.diags.report(Code::UnknownName, import.span, message).suggest(near);
                return;
            }
        };
        for own in list {
            if let Override::Value(name, _) = own
                && let Some(Use::Attr(attr)) = self.cx.globals.value(target, &name.text)
            {
                self.cx.tables.targets.insert((self.own, name.id()), attr);
            }
        }
        let here = std::mem::replace(&mut self.at, target);
        let rules = self.rules(rule, args.len());
        if rules.is_empty() {
            self.undefined(rule, args);
        }
        self.note_open(rule, rules);
        self.at = here;
    }

    fn set(&mut self, name: &'a Name, args: &'a [Arg]) {
        let [target, value] = args else {
            if !has_error(args) {
                wrong_count(self.cx, "operation", name, vec![2], args.len());
            }
            return;
        };
        self.values(std::slice::from_ref(value));
        match &target.value.kind {
            ExprKind::Name(attr) => self.set_name(name, &attr.text, attr.span),
            // A word in text means the bare word, if it is known.
            ExprKind::Call(sel, words) if sel.text == "sel" => match words.as_slice() {
                [Expr { kind: ExprKind::Text(text), span, .. }] => self.set_name(name, text, *span),
                _ => {
                    self.expr(&target.value);
                    self.note(name, Use::Operation(&ops::SET_BY_NAME));
                }
            },
            _ if has_error(args) => {}
            _ => {
                let message = "`set` needs the name of an attribute";
                let diag = self.cx.diags.report(Code::NotSettable, target.span, message);
                if let ExprKind::Text(text) = &target.value.kind {
                    diag.help(format!("write `set({text}, …)`"));
                }
            }
        }
    }

    fn set_name(&mut self, set: &'a Name, text: &'a str, span: Span) {
        // Parameters do not hide attributes here, because they cannot be set.
        let found = match self.cx.globals.value(self.at, text) {
            Some(Use::Attr(index)) => Ok(Use::SetAttr(index)),
            Some(Use::Const(_)) => Err("a constant"),
            Some(_) => Err("a function"),
            None => match ops::shape_attr(text) {
                Some(row) if row.set.is_some() => Ok(Use::SetShape(row)),
                Some(_) => Err("given by the shape"),
                None if self.inner.iter().any(|inner| inner.text == text) => Err("a parameter"),
                None => return self.unknown_target(text, span),
            },
        };
        match found {
            Ok(found) => {
                self.about_old(&Name { text: text.to_owned(), span }, found);
                self.note(set, found);
            }
            Err(what) => {
                let message = format!("`{text}` is {what} and cannot be set");
                let diag = self.cx.diags.report(Code::NotSettable, span, message);
                if what == "a constant" {
                    diag.help(format!("declare it as an attribute: `attr {text} = …`"));
                }
            }
        }
    }

    fn unknown_target(&mut self, text: &'a str, span: Span) {
        let globals = &self.cx.globals;
        if globals.is_lost(self.at, text) {
            return;
        }
        let others = ops::all_shape_attrs().filter(|row| row.set.is_some()).map(|row| row.name);
        let part = |row: &&ops::ShapeAttr| row.name.rsplit('.').next() == Some(text);
        let longer = ops::all_shape_attrs().filter(|row| row.set.is_some()).find(part).map(|row| row.name.to_owned());
        let near =
            longer.or_else(|| globals.meant(self.at, text, Namespace::Attrs, others).map(|near| near.to_string()));
        let is_operation = ops::operations(text).next().is_some();
        let message = format!("unknown attribute `{text}`");
        let is_new = near.is_none() && !text.contains('.');
        let diag = self.cx.diags.report(Code::UnknownName, span, message).suggest(near);
        if is_new && !is_operation {
            diag.help(format!("declare it: `attr {text} = …`"));
        }
        if is_operation {
            diag.help(format!("`{text}` is an operation: write `{text}(…)`"));
        }
    }
}
