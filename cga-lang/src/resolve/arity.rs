//! Numbers of arguments in messages.

use super::arguments::word;
use super::context::Context;
use crate::diag::code::Code;
use crate::diag::{Diag, count, quoted};
use crate::ops::{self, Braces, Operation, Param};
use crate::syntax::ast::{Arg, Name};

/// Returns "2 arguments", "0 or 3 arguments" or "1, 3 or 4 arguments".
pub(crate) fn counts(counts: impl IntoIterator<Item = usize>) -> String {
    let mut list: Vec<usize> = counts.into_iter().collect();
    list.sort_unstable();
    list.dedup();
    let Some((last, rest)) = list.split_last() else { return "no arguments".into() };
    match rest {
        [] => count(*last, "argument"),
        rest => {
            let rest: Vec<String> = rest.iter().map(usize::to_string).collect();
            format!("{} or {last} arguments", rest.join(", "))
        }
    }
}

/// Reports a call with a wrong number of arguments. The help shows the calls of a word of the language.
pub(crate) fn wrong_count(cx: &mut Context, what: &str, name: &Name, takes: Vec<usize>, got: usize) {
    let message = format!("{what} `{}` takes {}, got {got}", name.text, counts(takes));
    let rows = match what {
        "function" => {
            usages(ops::functions(&name.text).filter(|row| row.old.is_none()).map(|row| call(row.name, row.params)))
        }
        _ => String::new(),
    };
    let diag = cx.diags.report(Code::ArgumentCount, name.span, message);
    if !rows.is_empty() {
        diag.help(format!("write {rows}"));
    }
}

/// Reports an operation without a row that takes the number of its arguments. The rows with the words of the arguments
/// count, otherwise all, and the help shows those whose number of arguments is nearest.
pub(crate) fn wrong_form<'c>(
    cx: &'c mut Context,
    name: &Name,
    rows: &[&'static Operation],
    args: &[Arg],
) -> &'c mut Diag {
    let words: Vec<Option<&str>> = args.iter().map(word).collect();
    let is_word = |param: &Param, word: Option<&str>| word.is_some_and(|word| param.kind.has_word(word));
    let known = |row: &Operation| row.params.iter().zip(&words).filter(|(param, word)| is_word(param, **word)).count();
    let is_old = rows.iter().all(|row| row.old.is_some());
    let current: Vec<&Operation> = rows.iter().copied().filter(|row| is_old || row.old.is_none()).collect();
    // A word that the row does not have is worse than a missing one.
    let strange = |param: &Param, word: Option<&str>| {
        param.kind.words().is_some_and(|words| word.is_some_and(|word| !words.has(word)))
    };
    let is_strange = |row: &Operation| row.params.iter().zip(&words).any(|(param, word)| strange(param, *word));
    let rank = |row: &Operation| (!is_strange(row), known(row));
    let most = current.iter().map(|row| rank(row)).max().unwrap_or_default();
    let mut rows: Vec<&Operation> = current.iter().copied().filter(|row| rank(row) == most).collect();
    rows.sort_by_key(|row| row.params.len());
    let takes = counts(rows.iter().flat_map(|row| ops::required(row.params)..=row.params.len()));
    // The words that other rows do not have at this place.
    let chooses = |(index, word): &(usize, &str)| {
        let has = |row: &&Operation| row.params.get(*index).is_some_and(|param| is_word(param, Some(word)));
        rows.iter().all(has) && !current.iter().all(has)
    };
    let chosen = words.iter().enumerate().filter_map(|(index, word)| Some((index, (*word)?))).filter(chooses);
    let chosen = quoted(chosen.map(|(_, word)| word));
    let with = if chosen.is_empty() { chosen } else { format!(" with {chosen}") };
    let message = format!("operation `{}` takes {takes}{with}, got {}", name.text, args.len());
    let diag = cx.diags.report(Code::ArgumentCount, name.span, message);
    let far = |row: &&Operation| {
        let (least, most) = (ops::required(row.params), row.params.len());
        least.saturating_sub(args.len()).max(args.len().saturating_sub(most))
    };
    let near = rows.iter().map(far).min();
    // Words that are one word, as in `center(x, z)`.
    let joined: String = words.iter().copied().flatten().collect();
    let is_joined = |row: &&Operation| {
        words.iter().all(Option::is_some) && matches!(row.params, [param] if is_word(param, Some(&joined)))
    };
    match rows.iter().find_map(|row| row.old) {
        Some(instead) => diag.help(instead),
        None if rows.iter().any(is_joined) => diag.help(format!("write `{}({joined})`", name.text)),
        None => diag.help(format!(
            "write {}",
            usages(rows.iter().filter(|row| Some(far(row)) == near).map(|row| form(row, &words)))
        )),
    }
}

/// Returns a call of a form of an operation: the words among the arguments that it takes, otherwise its parameters.
fn form(row: &Operation, words: &[Option<&str>]) -> String {
    // Parameters after the required ones of an operation with braces are rarely written, except words of the call.
    let is_given = |(param, word): (&Param, &Option<&str>)| word.is_some_and(|word| param.kind.has_word(word));
    let given = row.params.iter().zip(words).rposition(is_given).map_or(0, |last| last + 1);
    let shown = if row.braces == Braces::None { row.params.len() } else { given.max(ops::required(row.params)) };
    let param = |(index, param): (usize, &Param)| {
        let word = words.get(index).copied().flatten().filter(|word| param.kind.has_word(word));
        let only = match param.kind.words().map(|words| words.list) {
            Some([only]) => Some(*only),
            _ => None,
        };
        word.or(only).unwrap_or(param.name).to_owned()
    };
    let params: Vec<String> = row.params[..shown].iter().enumerate().map(param).collect();
    let tail = if row.braces == Braces::None { "" } else { " { … }" };
    format!("`{}({}){tail}`", row.name, params.join(", "))
}

/// Reports an argument that is a word of the operation, but not at this place or not together with another word. `row` is
/// the form that has the other word.
pub(crate) fn word_of_other_form(cx: &mut Context, row: &Operation, args: &[Arg], index: usize) -> bool {
    let words: Vec<Option<&str>> = args.iter().map(word).collect();
    let has = |row: &Operation, word: &str| row.params.iter().any(|param| param.kind.has_word(word));
    let Some(found) = words[index] else { return false };
    // The words that the forms take, or their first ones.
    let call = |row: &Operation| {
        let required = ops::required(row.params);
        let all = || std::iter::once(found).chain(words.iter().copied().flatten());
        let taken = |(place, param): (usize, &Param)| {
            let first = || param.kind.words().filter(|_| place < required)?.current().next();
            all().find(|word| param.kind.has_word(word)).or_else(first)
        };
        let words: Vec<Option<&str>> = row.params.iter().enumerate().map(taken).collect();
        form(row, &words)
    };
    if has(row, found) {
        let message = format!("`{found}` is at the wrong place among the arguments of `{}`", row.name);
        let help = format!("write {}", call(row));
        cx.diags.report(Code::UnknownWord, args[index].span, message).help(help);
        return true;
    }
    let is_form =
        |form: &&Operation| form.old.is_none() && (form.braces == Braces::None) == (row.braces == Braces::None);
    let others: Vec<&Operation> = ops::operations(row.name).filter(is_form).filter(|form| has(form, found)).collect();
    let decides = |word: &&str| has(row, word) && !others.iter().any(|form| has(form, word));
    let decisive = words.iter().copied().flatten().find(decides);
    let (Some(decisive), Some(other)) = (decisive, others.first()) else { return false };
    let message = format!("`{}` does not take `{found}` with `{decisive}`", row.name);
    let code = row.params[index].kind.words().map_or(Code::UnknownWord, |words| words.unknown);
    let help = format!("write {} or {}", call(row), call(other));
    let diag = cx.diags.report(code, args[index].span, message).help(help);
    if let Some(taken) = row.params[index].kind.words().filter(|words| !words.has(decisive)) {
        diag.note(format!("with `{decisive}` it takes {}", quoted(taken.current())));
    }
    true
}

/// A call with the names of the parameters: "`s(xSize, ySize, zSize)`".
pub(crate) fn call(name: &str, params: &[Param]) -> String {
    let params: Vec<&str> = params.iter().map(|param| param.name).collect();
    format!("`{name}({})`", params.join(", "))
}

/// Calls as alternatives: "`s(x, y, z)` or `s(xyz)`".
fn usages(calls: impl Iterator<Item = String>) -> String {
    let mut calls: Vec<String> = calls.collect();
    calls.dedup();
    calls.join(" or ")
}
