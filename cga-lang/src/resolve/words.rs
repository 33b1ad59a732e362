//! Words among arguments: bare, as `sel("word")`, as text in old files, or computed.

use super::arguments::{plain, word};
use super::arity::{wrong_count, wrong_form};
use super::resolver::Resolver;
use super::tables::Use;
use crate::diag::code::Code;
use crate::diag::{RELATIVE, quoted};
use crate::dialect::Dialect;
use crate::ops::{self, Braces, Operation, Param, ParamKind, Words};
use crate::span::Span;
use crate::suggest::nearest;
use crate::syntax::ast::{Arg, Expr, ExprKind, Name};

/// The maximum length of a quoted argument in a message.
const LONGEST: usize = 40;

/// The length of names that are too short to be misspelt words.
const SHORT: usize = 2;

/// The rows whose words are among the arguments: of those that fit, the rows with the most words. Bare words take
/// precedence over text, because an operation may take the text as a value.
pub(crate) fn fitting(rows: &[&'static Operation], args: &[Arg], dialect: Dialect) -> Vec<&'static Operation> {
    let bare: Vec<Option<&str>> = args.iter().map(word).collect();
    let best = best(rows, &bare);
    if !best.is_empty() {
        return best;
    }
    let said: Vec<Option<&str>> = args
        .iter()
        .map(|arg| {
            plain(arg).filter(|value| dialect == Dialect::Text || !matches!(value.kind, ExprKind::Text(_)))?.word()
        })
        .collect();
    self::best(rows, &said)
}

fn best(rows: &[&'static Operation], words: &[Option<&str>]) -> Vec<&'static Operation> {
    let most = rows.iter().filter_map(|row| row.words(words)).max();
    rows.iter().copied().filter(|row| most.is_some() && row.words(words) == most).collect()
}

/// The number of arguments before the first one that is not the word that a row needs there.
pub(super) fn reach(row: &Operation, args: &[Arg]) -> usize {
    let fits = |(param, arg): &(&Param, &Arg)| match param.kind {
        ParamKind::Word(words) => word(arg).is_some_and(|word| words.has(word)),
        _ => true,
    };
    row.params.iter().zip(args).take_while(fits).count()
}

/// The number of arguments that are not the words that a row needs there.
pub(super) fn strange_words(row: &Operation, args: &[Arg]) -> usize {
    let is_strange = |(param, arg): &(&Param, &Arg)| match param.kind {
        ParamKind::Word(words) => !word(arg).is_some_and(|word| words.has(word)),
        _ => false,
    };
    row.params.iter().zip(args).filter(is_strange).count()
}

/// Returns true if an argument is a word of a form of an operation.
pub(super) fn is_word_of(row: &Operation, arg: &Arg) -> bool {
    let has =
        |word: &str| ops::operations(row.name).any(|row| row.params.iter().any(|param| param.kind.has_word(word)));
    word(arg).is_some_and(has)
}

/// The order in which arguments fit a row, as indices; `None` if a word is missing, if they are in this order, or if
/// `is_stray` is true for an argument that is not one of the words.
fn in_order(row: &Operation, args: &[Arg], mut is_stray: impl FnMut(&Arg) -> bool) -> Option<Vec<usize>> {
    let mut left: Vec<usize> = (0..args.len()).collect();
    let mut order = vec![None; args.len()];
    for (place, param) in order.iter_mut().zip(row.params).filter(|(_, param)| param.kind.words().is_some()) {
        let at = left.iter().position(|&index| word(&args[index]).is_some_and(|word| param.kind.has_word(word)))?;
        *place = Some(left.remove(at));
    }
    if left.iter().any(|&index| is_stray(&args[index])) {
        return None;
    }
    let mut left = left.into_iter();
    let order: Vec<usize> = order.into_iter().map(|place| place.or_else(|| left.next())).collect::<Option<_>>()?;
    (!order.is_sorted()).then_some(order)
}

impl<'a> Resolver<'_, 'a, '_> {
    /// Returns true if an argument computes its word in a run. Text does so where text can be a word; `sel` does so
    /// everywhere.
    fn is_computed(&mut self, arg: &Expr) -> bool {
        let text = self.dialect() == Dialect::Text;
        match &arg.kind {
            ExprKind::Call(name, args) if name.text == "sel" => args.len() == 1 && arg.word().is_none(),
            // `scope.sx` is not a word, and its value is not one either.
            ExprKind::Name(name) => {
                text && !matches!(self.lookup(&name.text), None | Some(Use::Shape(_) | Use::Builtin(_)))
            }
            ExprKind::Call(..) | ExprKind::Case(..) | ExprKind::Chance(..) | ExprKind::Index(..) => text,
            ExprKind::Binary(crate::syntax::ast::Binary::Add, ..) => text,
            _ => false,
        }
    }

    /// Returns true if an argument is the name of a declared value. Some words are functions of the language, too.
    pub(super) fn is_declared(&mut self, arg: &Arg) -> bool {
        word(arg).is_some_and(|word| !matches!(self.lookup(word), None | Some(Use::Builtin(_))))
    }

    /// Reports arguments that fit in another order: the words of a row are among them.
    pub(super) fn swapped(&mut self, name: &Name, rows: &[&'static Operation], args: &'a [Arg]) -> bool {
        let mut is_stray = |row, arg: &Arg| is_word_of(row, arg) && !self.is_declared(arg);
        let found = rows.iter().find_map(|row| Some((*row, in_order(row, args, |arg| is_stray(row, arg))?)));
        let Some((row, order)) = found else { return false };
        let text = |arg: &Arg| {
            let text = self.cx.globals.program.tokens.text(arg.span, LONGEST, RELATIVE);
            text.strip_prefix("- ").map_or(text.clone(), |rest| format!("-{rest}"))
        };
        let written: Vec<String> = order.iter().map(|&index| text(&args[index])).collect();
        let braces = if row.braces == Braces::None { "" } else { " { … }" };
        let meant = format!("{}({}){braces}", name.text, written.join(", "));
        let first = order.iter().enumerate().find(|(place, index)| place != *index).map_or(0, |(place, _)| place);
        let message = format!("the arguments of `{}` are in the wrong order", name.text);
        self.cx.diags.report(Code::UnknownWord, args[first].span, message).help(format!("write `{meant}`"));
        for (param, index) in row.params.iter().zip(order) {
            if !matches!(param.kind, ParamKind::Word(_)) {
                self.expr(&args[index].value);
            }
        }
        true
    }

    /// Reports an undeclared name among the arguments that is a word of another form of the operation, perhaps misspelt
    /// or at another place. `fitting` are the rows that take it as a value.
    pub(super) fn stray_word(&mut self, name: &Name, fitting: &[&'static Operation], args: &'a [Arg]) -> bool {
        let forms: Vec<&'static Operation> =
            ops::operations(&name.text).filter(|row| row.old.is_none() && row.braces == Braces::None).collect();
        for (index, arg) in args.iter().enumerate() {
            let Some(found) = word(arg) else { continue };
            let is_value = |row: &&Operation| matches!(row.params[index].kind, ParamKind::Value(_) | ParamKind::Length);
            if self.is_declared(arg) || !fitting.iter().all(is_value) {
                continue;
            }
            let words_at = |row: &Operation, place: usize| row.params.get(place).and_then(|param| param.kind.words());
            let is_near =
                |row: &&&Operation| words_at(row, index).and_then(|words| nearest(found, words.current())).is_some();
            if let Some(row) = forms.iter().filter(is_near).find(|row| row.takes(args.len())) {
                self.operation(std::slice::from_ref(row), args);
                return true;
            }
            if SHORT < found.len() && forms.iter().any(|row| is_near(&row)) {
                wrong_form(self.cx, name, &forms, args);
                return true;
            }
            let has_word = |row: &Operation, place: usize| words_at(row, place).is_some_and(|words| words.has(found));
            let place_in = |row: &'static Operation| (0..row.params.len()).find(|&place| has_word(row, place));
            if let Some((row, place)) = forms.iter().find_map(|row| Some((*row, place_in(row)?))) {
                let rows: Vec<_> = forms.iter().copied().filter(|row| row.takes(args.len())).collect();
                if self.swapped(name, &rows, args) {
                    return true;
                }
                let names = row.params.iter().map(|param| param.name).enumerate();
                let names = names.map(|(at, name)| if at == place { found } else { name });
                let shown: Vec<&str> = names.take(ops::required(row.params).max(place + 1)).collect();
                let message = format!("`{found}` is at the wrong place among the arguments of `{}`", name.text);
                let diag = self.cx.diags.report(Code::UnknownWord, arg.span, message);
                diag.help(format!("write `{}({})`", name.text, shown.join(", ")));
                return true;
            }
        }
        false
    }

    /// Resolves an argument that must be a word of one of several parameters.
    pub(crate) fn word(&mut self, name: &str, words: &[Words], arg: &'a Arg) {
        match plain(arg) {
            Some(value) => self.word_expr(name, words, value),
            None => self.unknown_word(name, words, "", arg.span),
        }
    }

    /// Reports a missing first argument, if it is a word.
    pub(super) fn missing_word(&mut self, name: &Name, row: &Operation) -> bool {
        let Some(words @ Words { unknown, .. }) = row.params.first().and_then(|param| param.kind.words()) else {
            return false;
        };
        let words: Vec<&str> = words.current().collect();
        let message = format!("`{}` needs a word in parentheses", name.text);
        let diag = self.cx.diags.report(unknown, name.span, message);
        diag.note(format!("it takes {}", quoted(&words)));
        diag.help(format!("write `{}({})`", name.text, words.first().unwrap_or(&"")));
        true
    }

    /// Reports an old word.
    pub(crate) fn old_word(&mut self, old: &str, new: &str, span: Span) {
        let message = format!("`{old}` is an old spelling");
        self.cx.diags.report(Code::OldSpelling, span, message).help(format!("write `{new}`"));
    }

    /// Resolves an expression that must be a word of one of several parameters.
    pub(crate) fn word_expr(&mut self, name: &str, words: &[Words], arg: &'a Expr) {
        if let ExprKind::Call(sel, args) = &arg.kind
            && sel.text == "sel"
            && args.len() != 1
        {
            return wrong_count(self.cx, "function", sel, vec![1], args.len());
        }
        let found = arg.word().unwrap_or_default();
        let (known, is_text) = (words.iter().any(|words| words.has(found)), matches!(arg.kind, ExprKind::Text(_)));
        match (known, is_text) {
            (true, false) => {}
            // Old files write the word as text, and CityEngine accepts it.
            (true, true) if self.dialect() == Dialect::Text => {
                let message = format!("`{found}` is a word; quotation marks are an old spelling");
                self.cx.diags.report(Code::OldSpelling, arg.span, message).help(format!("write `{found}`"));
            }
            _ if self.is_computed(arg) => {
                arg.parts().into_iter().for_each(|part| self.expr(part));
                let all = quoted(current(words));
                let message = format!("a word of `{name}` cannot be computed");
                let diag = self.cx.diags.report(Code::ComputedWord, arg.span, message);
                diag.note(format!("it takes {all}; only `set` can have a computed word"))
                    .help("write a call for each word, and choose among them with `case`");
            }
            _ => self.unknown_word(name, words, found, arg.span),
        }
    }

    fn unknown_word(&mut self, name: &str, words: &[Words], found: &str, span: Span) {
        let Some(first) = words.first() else { return };
        let list = current(words).into_iter();
        let shown = if found.is_empty() { "this".into() } else { format!("`{found}`") };
        let all = quoted(list.clone());
        let is_word = list.clone().any(|word| word == found);
        let shown = if is_word { "text".into() } else { shown };
        let diag = self.cx.diags.report(first.unknown, span, format!("{shown} is not a word of `{name}`"));
        diag.note(format!("it takes {all}"));
        if is_word {
            diag.help(format!("write `{found}`"));
        } else {
            diag.suggest(nearest(found, list.clone()).or_else(|| initial(found, list)));
        }
    }
}

/// The word that is the first letter of a longer one, as `f` of `faces`.
fn initial<'a>(found: &str, mut words: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    words.find(|word| word.len() == 1 && 2 < found.len() && found.starts_with(word))
}

/// The words of several parameters in their newest spelling, each once.
fn current(words: &[Words]) -> Vec<&'static str> {
    let mut list: Vec<&str> = Vec::new();
    for word in words.iter().copied().flat_map(Words::current) {
        if !list.contains(&word) {
            list.push(word);
        }
    }
    list
}
