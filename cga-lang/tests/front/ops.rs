//! The tables of the language's words: rows are well formed, no call fits two, and `tests/data/ops` has a call for each.

use cga_lang::compile::compile_text;
use cga_lang::diag::Level;
use cga_lang::ir::Type;
use cga_lang::ops::{
    self, Braces, COMPONENTS, Default, Needs, Operation, Param, ParamKind, SYNTAX, SelectorPlaces, Uses, component,
    required, selector, syntax,
};
use cga_lang::syntax::lex::lex;
use cga_lang::syntax::token::{Sym, Tok};
use std::collections::{HashMap, HashSet};

/// A row's name, parameters and text.
type Row = (&'static str, &'static [Param], &'static str);

fn operations() -> Vec<Row> {
    ops::all_operations().map(|row| (row.name, row.params, row.about)).collect()
}

fn functions() -> Vec<Row> {
    ops::all_functions().map(|row| (row.name, row.params, row.about)).collect()
}

fn is_line(text: &str) -> bool {
    !text.is_empty() && !text.ends_with('.') && !text.starts_with(char::is_uppercase) && text.chars().count() <= 90
}

fn is_name(text: &str) -> bool {
    text.split('.').all(|part| {
        part.starts_with(|c: char| c.is_ascii_alphabetic()) && part.chars().all(|c| c.is_ascii_alphanumeric())
    })
}

#[test]
fn parameters_are_well_formed() {
    for (name, params, ..) in operations().into_iter().chain(functions()) {
        assert!(is_name(name), "{name}");
        let mut names = HashSet::new();
        for (index, param) in params.iter().enumerate() {
            let place = format!("`{}` of `{name}`", param.name);
            assert!(is_name(param.name) && names.insert(param.name), "{place} has a name of its own");
            assert_eq!(param.default.is_some(), required(params) <= index, "{place}: defaults stand last");
            match (&param.kind, param.default) {
                (_, None)
                | (ParamKind::Value(Type::Bool), Some(Default::Bool(_)))
                | (ParamKind::Value(Type::Text), Some(Default::Text(_))) => {}
                (kind, Some(Default::Float(value))) => {
                    assert!(kind.ty() == Some(Type::Float) && value.is_finite(), "{place}");
                }
                (kind, Some(Default::Word(word))) => assert!(kind.has_word(word), "{place} knows `{word}`"),
                (kind, Some(default)) => panic!("{place}: {default:?} for {kind:?}"),
            }
            if let Some(words) = param.kind.words() {
                let known: HashSet<&str> = words.list.iter().copied().collect();
                assert!(!known.is_empty() && known.len() == words.list.len(), "{place} has each word once");
                assert!(known.iter().all(|word| is_name(word)), "{place}");
                for (word, instead) in words.old {
                    let is_new = known.contains(instead) || instead.contains('(');
                    assert!(known.contains(word) && is_new, "{place}: `{word}`");
                }
            }
        }
    }
}

#[test]
fn a_function_uses_the_shape_if_it_gets_one() {
    let of_shape = |uses: Uses| uses.but(Uses::SAYS | Uses::TREE_KEY);
    let fits = |needs: Needs, uses: Uses| match needs {
        Needs::Nothing => uses.is_none(),
        Needs::Env => of_shape(uses).is_none(),
        Needs::Shape => !of_shape(uses).is_none(),
        // Functions of the initial shape get the current shape too.
        Needs::Both => !uses.is_none(),
        Needs::Component => uses.has(Uses::WHOLE),
    };
    for row in ops::all_functions() {
        assert!(fits(row.needs, row.uses), "{}", row.name);
        assert!(!row.pure || row.uses.is_none(), "{}", row.name);
    }
    for row in ops::all_shape_attrs() {
        assert!(fits(row.needs, row.uses), "{}", row.name);
        assert!(row.set.is_some() || row.set_uses.is_none(), "{}", row.name);
    }
}

#[test]
fn a_word_is_the_same_variant_wherever_an_enum_is_used() {
    for rows in [operations(), functions()] {
        let mut variants: HashMap<(&str, &str), String> = HashMap::new();
        for (name, params, ..) in rows {
            for param in params {
                let Some(words) = param.kind.words() else { continue };
                let rust = words.rust;
                for word in words.list {
                    let variant = words.variant(word);
                    let first = variants.entry((rust, word)).or_insert_with(|| variant.clone());
                    assert_eq!(*first, variant, "`{word}` of {rust} in {name}");
                }
            }
        }
    }
}

#[test]
fn rows_have_a_text() {
    for (name, _, about) in operations().into_iter().chain(functions()) {
        assert!(is_line(about), "{name}: {about}");
    }
    for row in ops::selectors() {
        assert!(is_line(row.about), "{}: {}", row.name, row.about);
    }
    for row in SYNTAX {
        assert!(is_line(row.about), "{}: {}", row.name, row.about);
        assert_eq!(ops::operations(row.name).count(), 0, "{}", row.name);
        assert_eq!(syntax(row.name), Some(row));
    }
}

#[test]
fn old_rows_say_what_to_do_instead() {
    let operations = ops::all_operations().filter_map(|row| Some((row.name, row.old?)));
    let selectors = ops::selectors().filter_map(|row| Some((row.name, row.old?)));
    let functions = ops::all_functions().filter_map(|row| Some((row.name, row.old?)));
    for (name, old) in operations.chain(selectors).chain(functions) {
        assert!(is_line(old) && old.contains('`'), "{name}: {old}");
    }
}

/// Returns true if some arguments fit both lists.
fn overlap(a: &[Param], b: &[Param]) -> bool {
    let least = required(a).max(required(b));
    // More arguments only tell more kinds apart.
    least <= a.len().min(b.len()) && a.iter().zip(b).take(least).all(|(a, b)| a.kind.overlaps(&b.kind))
}

#[test]
fn no_call_fits_two_rows() {
    let rows: Vec<&Operation> = ops::all_operations().collect();
    for (index, a) in rows.iter().enumerate() {
        for b in rows[..index].iter().filter(|b| b.name == a.name && b.braces == a.braces) {
            assert!(!overlap(a.params, b.params), "{a:?}\n{b:?}");
        }
    }
    let rows = functions();
    for (index, a) in rows.iter().enumerate() {
        for b in rows[..index].iter().filter(|b| b.0 == a.0) {
            assert!(!overlap(a.1, b.1), "{a:?}\n{b:?}");
        }
    }
}

#[test]
fn selectors_and_components_are_found_by_name() {
    for row in ops::selectors() {
        assert_eq!(selector(row.name), Some(row), "{} stands once", row.name);
        assert!(row.on != SelectorPlaces::NONE, "{}", row.name);
    }
    assert_eq!(selector("fornt"), None);
    let mut places = SelectorPlaces::NONE;
    for row in COMPONENTS {
        assert_eq!(component(row.name), Some(row));
        assert!(!places.has(row.place), "{}", row.name);
        places = places.and(row.place);
        assert!(ops::selectors().any(|word| word.name == "all" && word.on.has(row.place)), "{}", row.name);
    }
    assert_eq!(places, SelectorPlaces::COMP);
    let on = |word, place| selector(word).is_some_and(|row| row.on.has(place));
    assert!(
        on("nutant", SelectorPlaces::FACES)
            && on("ridge", SelectorPlaces::EDGES)
            && !on("ridge", SelectorPlaces::FACE_EDGES)
    );
    assert!(on("border", SelectorPlaces::GROUPS) && !on("border", SelectorPlaces::HOLES));
    assert_eq!(component("faces"), None);
}

/// A call in the fixture: the operation, its arguments, and whether braces follow and have a bar.
struct Call {
    name: String,
    args: Vec<Given>,
    braces: Option<bool>,
}

#[derive(Debug)]
enum Given {
    Name(String),
    Value { ty: Type, prefix: Option<Sym> },
}

impl Call {
    fn fits(&self, row: &Operation) -> bool {
        let braces = match row.braces {
            Braces::None => self.braces.is_none(),
            Braces::Operands => self.braces == Some(true),
            Braces::Inline => self.braces != Some(true),
            _ => self.braces.is_some(),
        };
        let fit = |(param, arg): (&Param, &Given)| match (&param.kind, arg) {
            (ParamKind::Word(words), Given::Name(word)) => words.has(word),
            (kind, Given::Name(name)) => ops::shape_attr(name).is_some_and(|attr| attr.kind.ty() == kind.ty()),
            (ParamKind::Any, Given::Value { .. }) => true,
            (kind, Given::Value { ty, prefix }) => {
                let prefixed = match prefix {
                    None => true,
                    Some(Sym::Tilde) => *kind == ParamKind::Size,
                    Some(_) => matches!(kind, ParamKind::Length | ParamKind::Size),
                };
                kind.ty() == Some(*ty) && prefixed
            }
        };
        braces && row.takes(self.args.len()) && row.params.iter().zip(&self.args).all(fit)
    }
}

/// The name at a position, with its dots, and where it ends.
fn dotted(tokens: &[Tok], at: usize) -> Option<(String, usize)> {
    let mut name = tokens.get(at)?.ident()?.to_owned();
    let mut end = at + 1;
    while tokens.get(end).is_some_and(|token| token.is(Sym::Dot))
        && let Some(part) = tokens.get(end + 1).and_then(Tok::ident)
    {
        name = format!("{name}.{part}");
        end += 2;
    }
    Some((name, end))
}

/// The position behind the bracket that closes the one here.
fn behind(tokens: &[Tok], at: usize) -> usize {
    let mut depth = 0;
    for (index, token) in tokens.iter().enumerate().skip(at) {
        let Tok::Sym(sym) = token else { continue };
        depth += i32::from(matches!(sym, Sym::LParen | Sym::LBracket | Sym::LBrace));
        depth -= i32::from(matches!(sym, Sym::RParen | Sym::RBracket | Sym::RBrace));
        if depth == 0 {
            return index + 1;
        }
    }
    panic!("a bracket of the fixture is not closed");
}

/// The tokens between a pair of brackets, cut at a sign outside inner brackets.
fn parts(tokens: &[Tok], at: usize, end: usize, cut: Sym) -> Vec<&[Tok]> {
    let (mut list, mut start, mut next) = (Vec::new(), at + 1, at + 1);
    while next < end - 1 {
        if tokens[next].is(cut) {
            list.push(&tokens[start..next]);
            start = next + 1;
        }
        let opens = matches!(tokens[next], Tok::Sym(Sym::LParen | Sym::LBracket | Sym::LBrace));
        next = if opens { behind(tokens, next) } else { next + 1 };
    }
    list.push(&tokens[start..end - 1]);
    list.retain(|part| !part.is_empty());
    list
}

fn given(tokens: &[Tok]) -> Given {
    let prefix = match tokens[0] {
        Tok::Sym(sym @ (Sym::Quote | Sym::Tilde)) => Some(sym),
        _ => None,
    };
    let ty = match &tokens[usize::from(prefix.is_some())] {
        Tok::Number(_) | Tok::Sym(Sym::Minus) => Type::Float,
        Tok::Str(_) => Type::Text,
        Tok::Ident(word) if word == "true" || word == "false" => Type::Bool,
        Tok::Sym(Sym::LBracket) => match given(&tokens[1..]) {
            Given::Value { ty, .. } => ty.array(),
            Given::Name(name) => panic!("what is `{name}`?"),
        },
        _ => return Given::Name(dotted(tokens, 0).expect("a word").0),
    };
    Given::Value { ty, prefix }
}

/// Every call of an operation outside of arguments.
fn calls(tokens: &[Tok]) -> Vec<Call> {
    let (mut calls, mut at) = (Vec::new(), 0);
    while at < tokens.len() {
        let Some((name, mut end)) = dotted(tokens, at) else {
            at += 1;
            continue;
        };
        let is = |at: usize, sym: Sym| tokens.get(at).is_some_and(|token| token.is(sym));
        let mut args = Vec::new();
        if is(end, Sym::LParen) {
            let close = behind(tokens, end);
            args = parts(tokens, end, close, Sym::Comma).into_iter().map(given).collect();
            end = close;
        }
        if ops::operations(&name).next().is_some() {
            let braces = is(end, Sym::LBrace).then(|| 1 < parts(tokens, end, behind(tokens, end), Sym::Bar).len());
            calls.push(Call { name, args, braces });
        }
        at = end;
    }
    calls
}

/// The file with a call of each operation, and its text.
const FIXTURE: &str = "tests/language/every_operation.cga";
const CALLS: &str = include_str!("../../../tests/language/every_operation.cga");

#[test]
fn the_fixture_calls_every_operation_in_every_number_of_arguments() {
    let lexed = lex(CALLS);
    let mut met: HashSet<(*const Operation, usize)> = HashSet::new();
    for call in calls(lexed.tokens.as_slice()) {
        let rows: Vec<&Operation> = ops::operations(&call.name).filter(|row| call.fits(row)).collect();
        let [row] = rows[..] else { panic!("{FIXTURE}: `{}` with {:?} fits {rows:?}", call.name, call.args) };
        met.insert((row, call.args.len()));
        // The row that words and number alone lead to has at least the same of both.
        let words: Vec<Option<&str>> = call
            .args
            .iter()
            .map(|arg| match arg {
                Given::Name(name) => Some(name.as_str()),
                Given::Value { .. } => None,
            })
            .collect();
        let found = ops::operation(&call.name, &words).expect("a row");
        assert_eq!(found.words(&words), row.words(&words), "{FIXTURE}: `{}` with {:?}", call.name, call.args);
    }
    for row in ops::all_operations() {
        for count in required(row.params)..=row.params.len() {
            let is_met = met.contains(&(std::ptr::from_ref(row), count));
            assert!(is_met, "add a call of `{}` with {count} arguments to {FIXTURE}: {row:?}", row.name);
        }
    }
}

#[test]
fn nothing_in_the_fixture_is_taken_for_a_mistake() {
    let diags = compile_text(CALLS).compiled.diags;
    let mistakes: Vec<_> = diags.iter().filter(|diag| diag.level == Level::Error).collect();
    assert!(mistakes.is_empty(), "{FIXTURE}: {mistakes:#?}");
}
