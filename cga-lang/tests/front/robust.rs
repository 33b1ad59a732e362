//! Whatever comes in: no panic, always an end, and every finding stands on a token that exists.

use crate::common::random::Random;
use crate::print::{Spelling, print as print_tree};
use cga_lang::compile::{Dialect, compile, compile_text};
use cga_lang::diag::code::Code;
use cga_lang::diag::{Diags, Level};
use cga_lang::link::{NoFiles, Unit};
use cga_lang::snippet::{Lines, Quote, render};
use cga_lang::syntax::lex::{decode, lex};
use cga_lang::syntax::parse::parse;
use cga_lang::syntax::token::{Sym, Tok, Tokens};
use std::fs;

const NAMES: &[&str] = &[
    "A",
    "B",
    "Lot",
    "a",
    "b",
    "x",
    "y",
    "h",
    "attr",
    "const",
    "case",
    "else",
    "NIL",
    "split",
    "comp",
    "set",
    "f",
    "side",
    "top",
    "all",
    "scope",
    "sx",
    "index",
    "rand",
    "extrude",
    "color",
    "s",
    "t",
    "true",
    "false",
    "version",
    "import",
    "style",
    "start",
    "with",
    "front",
    "min",
    "str",
    "float",
    "report",
    "Range",
    "StartRule",
    "material",
    "geometry",
    "extends",
    "extension",
    "inline",
    "union",
    "setback",
    "scatter",
    "splitAndSetbackPerimeter",
    "remainder",
    "lib",
    "Handle",
];

fn token(random: &mut Random) -> Tok {
    match random.below(12) {
        0..5 => Tok::Ident((*random.pick(NAMES)).into()),
        5 => Tok::Number(random.below(120) as f64 / 2.0),
        6 if random.below(3) == 0 => Tok::Str("x".into()),
        7 if random.below(3) == 0 => Tok::Host(random.below(9) as u32),
        8 if random.below(3) == 0 => Tok::Path("crate::f".into()),
        9 if random.below(5) == 0 => Tok::Doc("words".into()),
        11 => Tok::Sym(*random.pick(&[Sym::LParen, Sym::RParen, Sym::LBrace, Sym::RBrace, Sym::Dot, Sym::Arrow])),
        10 if random.below(9) == 0 => Tok::Bad,
        _ => Tok::Sym(*random.pick(Sym::ALL)),
    }
}

/// The changed forms of each fixture. Without optimisation each takes ten times as long.
const CHANGES: usize = if cfg!(debug_assertions) { 12 } else { 200 };

/// The beginnings of each fixture, about.
const BEGINNINGS: usize = if cfg!(debug_assertions) { 30 } else { 1000 };

const DIALECTS: [Dialect; 2] = [Dialect::Inline, Dialect::Text];

fn try_tokens(tokens: &Tokens) {
    DIALECTS.into_iter().for_each(|dialect| try_dialect(tokens, dialect));
}

fn try_dialect(tokens: &Tokens, dialect: Dialect) {
    let compiled = compile(Unit::new(tokens.clone(), dialect), &mut NoFiles, &[]);
    for diag in &compiled.diags {
        let places = diag.notes.iter().filter_map(|note| note.related).chain([diag.span]);
        for place in places {
            assert!(place.first <= place.last && (place.last as usize) < tokens.len().max(1), "{diag:?}");
        }
    }
    if let Some(grammar) = &compiled.grammar {
        assert!(!crate::ir_print::print(grammar).is_empty() || grammar.rules.is_empty());
    }
}

fn try_text(text: &str) {
    let source = compile_text(text);
    let quote = Quote { name: "a.cga", lines: &Lines::new(text), ranges: &source.ranges };
    for diag in source.compiled.diags.iter().take(20) {
        assert!(!render(quote, diag).is_empty());
    }
    try_tokens(&source.tokens);
}

fn corpus() -> Vec<String> {
    let folders = ["lex", "parse", "check", "lower"];
    let paths = folders.into_iter().flat_map(crate::common::fixtures);
    paths.map(|path| crate::common::strip(&fs::read_to_string(path).expect("readable fixture"))).collect()
}

#[test]
fn random_tokens_never_panic() {
    let mut random = Random(1);
    for _ in 0..3000 {
        let length = random.below(60);
        try_tokens(&(0..length).map(|_| token(&mut random)).collect());
    }
}

#[test]
fn random_bytes_never_panic() {
    let mut random = Random(2);
    let pieces =
        ["\"", "\\", "\\u", "/*", "*/", "#", "\r\n", "\t", "é", "—", "“", "0x", "1.", ".", "'", "-->", "\0", "😀"];
    for _ in 0..3000 {
        let mut text = String::new();
        for _ in 0..random.below(40) {
            match random.below(3) {
                0 => text.push_str(pieces[random.below(pieces.len())]),
                1 => text.push(char::from(random.below(128) as u8)),
                _ => text.push_str(NAMES[random.below(NAMES.len())]),
            }
        }
        try_text(&text);
    }
}

#[test]
fn mutated_fixtures_never_panic() {
    let mut random = Random(3);
    for text in corpus() {
        let tokens = lex(&text).tokens;
        if tokens.is_empty() {
            continue;
        }
        for dialect in DIALECTS.into_iter().cycle().take(CHANGES) {
            let mut list = tokens.as_slice().to_vec();
            for _ in 0..=random.below(3) {
                let at = random.below(list.len());
                match random.below(4) {
                    0 if 1 < list.len() => _ = list.remove(at),
                    1 => list.insert(at, token(&mut random)),
                    2 => list[at] = token(&mut random),
                    _ => {
                        let other = random.below(list.len());
                        list.swap(at, other);
                    }
                }
            }
            let tokens = list.into_iter().collect();
            try_dialect(&tokens, dialect);
            try_printed(&tokens);
        }
    }
}

/// Checks that a tree without syntax errors is printed as text that parses to the same tree.
fn try_printed(tokens: &Tokens) {
    let mut diags = Diags::new();
    let ast = parse(tokens, &mut diags);
    let odd = |token: &Tok| matches!(token, Tok::Host(_) | Tok::Bad | Tok::Doc(_));
    if diags.finish().iter().any(|diag| diag.level == Level::Error) || tokens.as_slice().iter().any(odd) {
        return;
    }
    for spelling in [Spelling::Text, Spelling::Inline] {
        let text = print_tree(&ast, spelling);
        let (mut diags, lexed) = (Diags::new(), lex(&text));
        diags.append(lexed.diags);
        let again = parse(&lexed.tokens, &mut diags);
        assert!(!diags.has_errors(), "{text}\n{:?}", diags.finish());
        diags.finish();
        assert!(crate::common::shape(&again) == crate::common::shape(&ast), "{text}\n{}", print_tree(&again, spelling));
    }
}

#[test]
fn bytes_in_any_encoding_never_panic() {
    let mut random = Random(4);
    for text in corpus() {
        let mut bytes = match random.below(3) {
            0 => text.into_bytes(),
            1 => [vec![0xff, 0xfe], text.encode_utf16().flat_map(u16::to_le_bytes).collect()].concat(),
            _ => [vec![0xfe, 0xff], text.encode_utf16().flat_map(u16::to_be_bytes).collect()].concat(),
        };
        for _ in 0..random.below(20) {
            let at = random.below(bytes.len());
            bytes.insert(at, random.below(256) as u8);
        }
        try_text(&decode(&bytes));
    }
}

#[test]
fn every_beginning_of_a_fixture_never_panics() {
    for text in corpus() {
        let tokens = lex(&text).tokens;
        let step = 1 + tokens.len() / BEGINNINGS;
        for (length, dialect) in (0..tokens.len()).step_by(step).zip(DIALECTS.into_iter().cycle()) {
            try_dialect(&tokens.as_slice()[..length].iter().cloned().collect(), dialect);
        }
    }
}

#[test]
fn deep_nesting_is_an_error_and_no_overflow() {
    let count = 1_000;
    for (open, close) in [
        ("(", ")"),
        ("[ ", " ]"),
        ("split(x) { 1 : ", " }"),
        ("split(x) { { ", " } }"),
        ("comp(f) { all : ", " }"),
        ("case a : ", " else : X"),
        ("50% : ", " else : X"),
        ("- ", ""),
        ("! ", ""),
        ("min(1, ", ")"),
        ("1 + (", ")"),
        ("1 * 1 + ", ""),
        ("\"a\" + ", ""),
        ("(case a : 1 else : ", ")"),
        ("{", "}"),
        ("@", ""),
        ("@Range(", ")"),
        ("A(", ""),
        ("a b(c) = ", ""),
        ("[", "]"),
        ("a[", "]"),
        ("a", "[0]"),
        ("[1:", "]"),
        (".-", ""),
        ("1 .+ ", ""),
        ("comp(f) { all : ", " }"),
        ("comp(", ") { all : 1 }"),
        ("inline ", ""),
        ("inline { ", " }"),
        ("union { A | ", " }"),
        ("setback(1) { all : ", " }"),
        ("unknown { ", " }"),
        ("unknown { ~1 : ", " }"),
        ("splitAndSetbackPerimeter(1) { 1 : 2 : ", " }"),
        ("lib(R --> ", ").S"),
        ("lib(h = (", ")).S"),
        ("lib.", ""),
        ("B with ( b := ", " )"),
        ("style ", ""),
        ("import lib : \"a\" (", ")"),
        ("start ", ""),
    ] {
        for (head, inside) in [("A --> ", "X"), ("a = ", "1"), ("A --> s(", "1")] {
            try_text(&format!("{head}{}{inside}{}\nB --> X.", open.repeat(count), close.repeat(count)));
        }
    }
}

#[test]
fn nothing_is_looked_at_again_and_again() {
    // Some of these would take a minute if it were.
    let count = 20_000;
    for part in [
        "(",
        "[",
        "{",
        ") ",
        "] ",
        "} ",
        "( ] ",
        "A( ",
        "A(b, ",
        "lib.",
        "a.",
        "lib( ",
        "lib(h = ",
        "A with ( ",
        "[ lib( ).X ",
        "import lib : \"a\" ( ",
        "import lib : \"a\" ( ) ",
        "@Range( ",
        "case ",
        "case h + h = 3 ",
        "h + h = ",
        "A = X. ",
        "A --> ",
        "A. ",
        "\"",
        "\"x\n",
        "/* ",
        "? ",
        "| A ",
        "{ A | ",
        "split(x) { ",
        "1 : ",
        "style S ",
        "style S extends T ",
        "a := ",
        "inline ",
        "30% : ",
        "else ",
    ] {
        for head in ["", "import lib : \"a\"\nA --> ", "a = ", "A --> split(x) { ", "A with ( ", "A --> unknown { "] {
            let lexed = lex(&format!("{head}{}", part.repeat(count / part.len())));
            let mut diags = Diags::new();
            parse(&lexed.tokens, &mut diags);
            diags.finish();
        }
    }
}

#[test]
fn nesting_below_the_limit_compiles() {
    let text = |open: &str, inside: &str, close: &str| format!("{}{inside}{}", open.repeat(150), close.repeat(150));
    for body in [
        format!("extrude({})", text("(1 + ", "1", ")")),
        text("[ ", "X.", " ]"),
        text("split(x) { 1 : ", "X.", " }"),
        text("comp(f) { all : ", "X.", " }"),
        text("case scope.sx > 1 : ", "X.", " else : Y."),
    ] {
        let source = compile_text(&format!("A --> {body}"));
        assert_eq!(source.compiled.diags, []);
        assert!(!crate::ir_print::print(&source.compiled.grammar.expect("no findings")).is_empty());
    }
}

#[test]
fn long_grammars_take_time_in_proportion() {
    let one = "attr a_ = b_ + 1\nconst b_ = c_ * 2\nc_ = case true : 1 else : 2\nR_(i) --> case i > a_ : split(x) { { ~b_ : \
               color(\"#ffffff\") R_(i - 1) | 1 : X. }* } else : comp(f) { side : [ t(0, '1, 0) Y. ] S_ | top : NIL }\n\
               S_ --> s('1, c_, 0) [ X. ] [ R_(3) ]\n";
    let text: String = (0..2000).map(|number| one.replace('_', &number.to_string())).collect();
    let source = compile_text(&text);
    assert_eq!(source.compiled.diags, []);
    let grammar = source.compiled.grammar.expect("no findings");
    assert_eq!(grammar.globals.iter().filter(|global| global.attr.is_some()).count(), 2000);
    // The same in the worst order for a resolver that goes from the first declaration to the last.
    let chain: String = (0..3000).map(|number| format!("f{number}(x) = f{}(x) + x\n", number + 1)).collect();
    let source = compile_text(&format!("{chain}f3000(x) = x"));
    assert_eq!(source.compiled.diags, []);
    // Text that doubles from line to line must not be folded for ever.
    let double: String = (0..200).map(|number| format!("const t{} = t{number} + t{number}\n", number + 1)).collect();
    assert_eq!(compile_text(&format!("const t0 = \"ab\"\n{double}")).compiled.diags, []);
}

#[test]
fn wide_rules_take_time_in_proportion() {
    // Each of these takes minutes if every part is compared with every other one.
    let count = 5_000;
    let parts = |between: &str, part: &dyn Fn(usize) -> String| (0..count).map(part).collect::<Vec<_>>().join(between);
    let bars = |part: &dyn Fn(usize) -> String| parts(" | ", part);
    for (text, found) in [
        (format!("Lot --> split(x) {{ {} }}", bars(&|_| "{ 1 : A }*".into())), 0),
        (format!("Lot --> split(x) {{ {{ {} }}* }}", bars(&|_| "{ ~1 : A | 2 : A }*".into())), 0),
        (format!("Lot --> split(x) {{ {} }}", bars(&|_| "{ 0 : A }*".into())), count),
        (format!("Lot --> split(x) {{ {{ {} }}* }}", bars(&|_| "0 : A".into())), 1),
        (format!("Lot --> split(x) {{ {} }}", bars(&|_| "'1 : A".into())), count - 1),
        (format!("Lot --> {} else : A", parts(" ", &|at| format!("case scope.sx == {at} : A"))), 0),
        (format!("f(h) = {} else : 0\nLot --> extrude(f(1)) A", parts(" ", &|at| format!("case h == {at} : 1"))), 0),
        (
            format!(
                "f(h) = {} else : 0\nLot --> extrude(f(\"\")) A",
                parts(" ", &|at| format!("case h == \"{at}\" : 1"))
            ),
            0,
        ),
        (format!("Lot --> comp(f) {{ {} }}", bars(&|at| format!("{at} : A"))), 0),
        (format!("Lot --> comp(f) {{ {} }}", bars(&|at| format!("isTagged(\"{at}\") : A"))), 0),
        (format!("Lot --> comp(f) {{ {} }}", bars(&|_| "side : A".into())), count - 1),
        (format!("f = comp(f) {{ {} }}\nLot --> extrude(f[0]) A", bars(&|at| format!("{at} : 1"))), 0),
        (format!("A({}) --> X.\nLot --> NIL", parts(", ", &|at| format!("a{at}"))), count + 2),
    ] {
        let source = compile_text(&format!("@StartRule\nStart --> Lot\n{text}\nA --> X."));
        let diags = &source.compiled.diags;
        assert_eq!(diags.len(), found, "{}: {:?}", &text[..60], diags.first());
    }
}

/// The number of diagnostics, which must all be of one kind.
fn misfits(text: &str) -> usize {
    let source = compile_text(text);
    let found = &source.compiled.diags;
    assert!(found.iter().all(|diag| diag.code == Code::TypeMismatch), "{:?}", found[0]);
    assert_eq!(source.compiled.grammar.is_some(), found.is_empty());
    found.len()
}

#[test]
fn declarations_for_many_types_are_bounded() {
    let chain = |length: usize| -> String {
        let links: String = (0..length).map(|number| format!("f{number}(x) = f{}(x) + x\n", number + 1)).collect();
        format!("{links}f{length}(x) = x\nLot --> print(f0(1)) print(f0(\"a\"))")
    };
    assert_eq!(misfits(&chain(60)), 0);
    // It is the call that is blamed, not something on the way.
    let long = chain(1000);
    let source = compile_text(&long);
    assert_eq!(source.compiled.diags.len(), 1);
    assert!(long[source.ranges[source.compiled.diags[0].span.first as usize].start..].starts_with("\"a\""));
    // 216 tuples of types, of which 16 are made.
    let values = ["1", "true", "\"a\"", "[1]", "[true]", "[\"a\"]"];
    let calls: String =
        (0..216).map(|n| format!("print(p({}, {}, {}))\n", values[n % 6], values[n / 6 % 6], values[n / 36])).collect();
    assert_eq!(misfits(&format!("p(a, b, c) = str(a) + str(b) + str(c)\nLot --> {calls}")), 200);
    // 1,000 copies in all.
    let two: String = (0..1100)
        .map(|number| format!("id{number}(x) = x\nLot{number} --> print(id{number}(1)) print(id{number}(\"a\"))\n"))
        .collect();
    assert_eq!(misfits(&two), 100);
    // Whatever is called again is there already.
    let calls = "print(f(1)) print(f(\"a\")) print(f(f(true)))\n".repeat(3000);
    assert_eq!(misfits(&format!("f(x) = x\nLot --> {calls}")), 0);
}

#[test]
fn operators_in_a_row_are_not_nested() {
    // A tree as deep as this would overflow the stack.
    let chain = |operator: &str, operand: &str| format!("{operand}{}", format!(" {operator} {operand}").repeat(8_000));
    let arithmetic = ["+", "-", "*", "/", "%"]
        .into_iter()
        .flat_map(|operator| ["1", "h", "(2 - h)"].map(|operand| format!("extrude({})", chain(operator, operand))));
    let texts =
        ["\"a\"", "str(h)", "h", "h + \"a\""].map(|operand| format!("print(h + \"\" + {})", chain("+", operand)));
    let truths = ["&&", "||"].map(|operator| format!("case {} : A else : B", chain(operator, "scope.sx > h")));
    let selectors = ["&&", "||"].map(|operator| format!("comp(f) {{ {} : A | all : B }}", chain(operator, "front")));
    for body in arithmetic.chain(texts).chain(truths).chain(selectors) {
        let source = compile_text(&format!(
            "attr h = 2\n@StartRule\nLot --> t(h, 0, 0) A B Go\nGo --> {body}\nA --> X.\nB --> Y."
        ));
        let found: Vec<Code> = source.compiled.diags.iter().map(|diag| diag.code).collect();
        assert_eq!(found, [], "{}", &body[..40]);
        assert!(!crate::ir_print::print(&source.compiled.grammar.expect("no findings")).is_empty());
    }
    // The levels of operators and parentheses are kept, and the types before a text.
    let many = |count: usize, part: &str| part.repeat(count);
    for (value, folded) in [
        (format!("1{}", many(50, " + 2 * 3")), "301"),
        (format!("100{}", many(50, " - 1")), "50"),
        (format!("1{} == 51 && true", many(50, " + 1")), "true"),
        (format!("1{} + \"a\"{}", many(50, " + 1"), many(40, " + 1")), &format!("\"51a{}\"", many(40, "1"))),
        (format!("1 - (1{})", many(50, " - 1")), "50"),
    ] {
        let source = compile_text(&format!("const a = {value}\nLot --> print(a) X."));
        let printed = source.compiled.grammar.map(|grammar| crate::ir_print::print(&grammar));
        assert!(
            printed.as_ref().is_some_and(|text| text.contains(folded)),
            "{value}: {printed:?} {:?}",
            source.compiled.diags
        );
    }
    // A mistake in a long chain is found.
    let codes = |body: &str| -> Vec<Code> {
        compile_text(&format!("Lot --> {body}")).compiled.diags.iter().map(|diag| diag.code).collect()
    };
    assert_eq!(codes(&format!("extrude(1{} + true)", many(50, " + 1"))), [Code::TypeMismatch]);
    assert_eq!(codes(&format!("extrude(1{} / 0)", many(50, " * 1"))), [Code::DivisionByZero]);
    assert_eq!(codes(&format!("extrude(1{} + nothing)", many(50, " + 1"))), [Code::UnknownName]);
    // Operands refine each other, however many there are.
    for count in [3, 100, 500] {
        let all = |operator: &str, comparison: &str| {
            let parts: Vec<String> = (1..=count).map(|number| format!("scope.sx {comparison} {number}")).collect();
            codes(&format!("case {} : X. else : Y.", parts.join(operator)))
        };
        assert_eq!(all(" && ", "=="), [Code::CaseAlways], "{count}");
        assert_eq!(all(" || ", "!="), [Code::CaseAlways], "{count}");
        assert_eq!((all(" && ", "!="), all(" || ", "==")), (vec![], vec![]), "{count}");
    }
}
