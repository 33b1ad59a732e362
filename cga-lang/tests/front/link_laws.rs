//! Programs of several files made at random: no panic, always an end, and every finding stays inside its file.

use crate::common::random::Random;
use crate::ir_print::print;
use cga_lang::compile::{Compiled, Dialect, compile};
use cga_lang::diag::Level;
use cga_lang::diag::code::Code;
use cga_lang::link::{Files, Unit, candidates};
use cga_lang::syntax::lex::lex;
use cga_lang::syntax::token::{Sym, Tok, Tokens};
use std::collections::BTreeMap;

/// The programs of each test. Without optimisation each takes ten times as long.
const PROGRAMS: usize = if cfg!(debug_assertions) { 200 } else { 3000 };

/// Files by name.
struct Disk {
    files: BTreeMap<String, Tokens>,
    opened: usize,
}

impl Disk {
    fn unit(&self, name: &str) -> Unit {
        Unit { name: name.into(), tokens: self.files[name].clone(), dialect: Dialect::Text, found: Vec::new() }
    }

    fn compile(&mut self, root: &str) -> Compiled {
        let unit = self.unit(root);
        compile(unit, self, &[])
    }

    /// Checks that the result of linking is consistent.
    fn check(&self, compiled: &Compiled) {
        let mut end = 0;
        for (at, file) in compiled.files.iter().enumerate() {
            assert_eq!(file.tokens.start, end, "files follow each other");
            assert_eq!(file.tokens.len(), self.files[&file.name].len(), "{} is there as a whole", file.name);
            assert!(compiled.files[..at].iter().all(|other| other.name != file.name), "{} is there twice", file.name);
            end = file.tokens.end;
        }
        let mut seen = std::collections::HashSet::new();
        for diag in &compiled.diags {
            let places = diag.notes.iter().filter_map(|note| note.related).chain([diag.span]);
            for place in places {
                let (first, last) = (compiled.locate(place.first), compiled.locate(place.last));
                assert_eq!(first.0, last.0, "{diag:?}");
                let length = self.files[&compiled.files[first.0].name].len();
                assert!(first.1 <= last.1 && (last.1 as usize) < length.max(1), "{diag:?}");
            }
            let (file, token) = compiled.locate(diag.span.first);
            assert!(
                seen.insert((file, token, diag.span.last - diag.span.first, diag.code, &diag.message)),
                "twice: {diag:?}"
            );
        }
        if let Some(grammar) = &compiled.grammar {
            print(grammar);
        }
    }
}

impl Files for Disk {
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String> {
        self.opened += 1;
        let names = candidates(path, from);
        let name = names.iter().find(|name| self.files.contains_key(*name)).ok_or("there is no such file")?;
        Ok(self.unit(name))
    }
}

const FILES: [&str; 6] = ["a.cga", "b.cga", "c.cga", "rules/d.cga", "rules/e.cga", "f.cga"];
const PATHS: [&str; 9] =
    ["a.cga", "b.cga", "c.cga", "d.cga", "rules/d.cga", "../c.cga", "/p/rules/e.cga", "f.cga", "missing.cga"];
const IDS: [&str; 4] = ["p", "q", "r", "lib"];
const ATTRS: [&str; 4] = ["h", "w", "text", "flag"];
const RULES: [&str; 4] = ["Lot", "Wall", "Roof", "Part"];
const STYLES: [&str; 4] = ["S", "T", "U", "Default"];

/// A name, perhaps with names of imports before it.
fn dotted(random: &mut Random, names: &[&str]) -> String {
    let mut name = String::new();
    while random.below(3) == 0 {
        name += &format!("{}.", random.pick(&IDS));
    }
    name + *random.pick(names)
}

fn value(random: &mut Random) -> String {
    match random.below(9) {
        0 => "\"t\"".into(),
        1 => "true".into(),
        2 => format!("{} + {}", dotted(random, &ATTRS), random.below(9)),
        3 => dotted(random, &ATTRS),
        4 => format!("{}({})", dotted(random, &["f", "g"]), dotted(random, &ATTRS)),
        5 => format!("case {} == {} : 1 else : 2", dotted(random, &ATTRS), dotted(random, &ATTRS)),
        _ => random.below(9).to_string(),
    }
}

fn overrides(random: &mut Random) -> String {
    let one = |random: &mut Random| match random.below(5) {
        0 => (*random.pick(&ATTRS)).to_owned(),
        1 | 2 => format!("{} = {}", random.pick(&ATTRS), value(random)),
        _ => format!("{}{} --> {}", random.pick(&RULES), random.pick(&["", "(x)"]), steps(random)),
    };
    let list: Vec<String> = (0..random.below(4)).map(|_| one(random)).collect();
    format!("({})", list.join(", "))
}

fn steps(random: &mut Random) -> String {
    let one = |random: &mut Random| match random.below(10) {
        0 => format!("extrude({})", value(random)),
        1 => format!("set({}, {})", dotted(random, &ATTRS), value(random)),
        2 => format!("{}{}.{}", random.pick(&IDS), overrides(random), random.pick(&RULES)),
        3 => format!("{}({})", dotted(random, &RULES), value(random)),
        4 => "split(x) { ~1 : Wall | 2 : lib.Roof }".into(),
        5 => format!("{}.", dotted(random, &RULES)),
        6 => dotted(random, &["start", "NIL"]),
        _ => dotted(random, &RULES),
    };
    let list: Vec<String> = (0..1 + random.below(3)).map(|_| one(random)).collect();
    list.join(" ")
}

fn file(random: &mut Random) -> String {
    let mut text = String::new();
    for _ in 0..random.below(4) {
        text += &format!("import {}", random.pick(&IDS));
        if random.below(3) == 0 {
            text += &format!("({})", random.pick(&STYLES));
        }
        text += &format!(" : \"{}\"", random.pick(&PATHS));
        if random.below(2) == 0 {
            text += &overrides(random);
        }
        text.push('\n');
    }
    for _ in 0..random.below(12) {
        text += &match random.below(9) {
            0 => format!("style {} extends {}\n", random.pick(&STYLES[..3]), random.pick(&STYLES)),
            1 | 2 => format!("attr {} = {}\n", random.pick(&ATTRS), value(random)),
            3 => format!("const {} = {}\n", random.pick(&["k", "h"]), value(random)),
            4 => format!("{}(x) = {}\n", random.pick(&["f", "g"]), value(random)),
            5 => format!("{}.{} --> {}\n", random.pick(&IDS), random.pick(&RULES), steps(random)),
            6 => format!("extension {}{} --> {}\n", random.pick(&RULES), random.pick(&["", "(x)"]), steps(random)),
            7 => format!("start {} --> {}\n", random.pick(&RULES), steps(random)),
            _ => format!("{}{} --> {}\n", random.pick(&RULES), random.pick(&["", "(x)"]), steps(random)),
        };
    }
    text
}

fn disk(random: &mut Random) -> Disk {
    let files = FILES.iter().map(|name| ((*name).to_owned(), lex(&file(random)).tokens)).collect();
    Disk { files, opened: 0 }
}

#[test]
fn random_programs_of_files_never_panic() {
    let mut random = Random(11);
    let (mut whole, mut large) = (0, 0);
    for _ in 0..PROGRAMS {
        let mut disk = disk(&mut random);
        let compiled = disk.compile("a.cga");
        disk.check(&compiled);
        whole += usize::from(compiled.grammar.is_some());
        large += usize::from(3 < compiled.files.len());
        let again = disk.compile("a.cga");
        assert_eq!(format!("{:?}", compiled.diags), format!("{:?}", again.diags), "the same twice");
    }
    assert!(5 < whole && 50 < large, "the programs are no test: {whole} without errors, {large} of many files");
}

#[test]
fn changed_tokens_of_files_never_panic() {
    let mut random = Random(12);
    let words = ["import", "style", "extends", "start", "extension", "p", "lib", "Lot", "h", "Default", "with", "attr"];
    for _ in 0..PROGRAMS {
        let mut disk = disk(&mut random);
        for tokens in disk.files.values_mut().filter(|tokens| !tokens.is_empty()) {
            let mut list = tokens.as_slice().to_vec();
            for _ in 0..=random.below(4) {
                let at = random.below(list.len());
                let token = match random.below(4) {
                    0 => Tok::Ident((*random.pick(&words)).into()),
                    1 => Tok::Str((*random.pick(&PATHS)).into()),
                    2 => Tok::Bad,
                    _ => Tok::Sym(*random.pick(Sym::ALL)),
                };
                match random.below(3) {
                    0 => list.insert(at, token),
                    1 => list[at] = token,
                    _ if 1 < list.len() => _ = list.remove(at),
                    _ => {}
                }
            }
            *tokens = list.into_iter().collect();
        }
        let compiled = disk.compile("a.cga");
        disk.check(&compiled);
    }
}

fn disk_of(files: impl IntoIterator<Item = (String, String)>) -> Disk {
    Disk { files: files.into_iter().map(|(name, text)| (name, lex(&text).tokens)).collect(), opened: 0 }
}

/// The number of diagnostics of a kind.
fn count_of(compiled: &Compiled, code: Code) -> usize {
    compiled.diags.iter().filter(|diag| diag.code == code).count()
}

#[test]
fn what_multiplies_by_imports_is_bounded() {
    // Each file imports the next one twice: two to the power of forty instances.
    let level = |number: usize| {
        let next = number + 1;
        (
            format!("f{number}.cga"),
            format!("import a : \"f{next}.cga\" import b : \"f{next}.cga\" attr h = 1 Lot --> a.Lot b.Lot"),
        )
    };
    let last = ("f40.cga".to_owned(), "attr h = 1 Lot --> X.".to_owned());
    let mut disk = disk_of((0..40).map(level).chain([last]));
    let compiled = disk.compile("f0.cga");
    disk.check(&compiled);
    assert_eq!(count_of(&compiled, Code::CannotImport), 1);
    assert!(disk.opened < 3000, "{} files opened", disk.opened);
    // As many styles, each with an import of its own.
    let styles: String = (0..2000).map(|number| format!("style S{number} attr h = {number} ")).collect();
    let mut disk = disk_of([
        ("a.cga".into(), format!("import b : \"b.cga\" attr h = 1 Lot --> b.Lot {styles}")),
        ("b.cga".into(), "attr h = 1 Lot --> extrude(h)".into()),
    ]);
    let compiled = disk.compile("a.cga");
    disk.check(&compiled);
    assert_eq!(count_of(&compiled, Code::CannotImport), 1);
    // One large file in many places.
    let imports: String = (0..900).map(|number| format!("import i{number} : \"b.cga\" ")).collect();
    let large: String = (0..1000).map(|number| format!("R{number} --> extrude(1) X.\n")).collect();
    let mut disk = disk_of([("a.cga".into(), format!("{imports} Lot --> i0.R0")), ("b.cga".into(), large)]);
    let compiled = disk.compile("a.cga");
    disk.check(&compiled);
    assert_eq!(count_of(&compiled, Code::CannotImport), 1);
}

#[test]
fn a_long_file_may_have_many_styles() {
    let lines = (0..8_000).map(|number| format!("R{number} --> extrude({number}) X.\n"));
    let styles = (0..10).map(|number| format!("style S{number} R{number} --> X.\n"));
    let mut disk = disk_of([("a.cga".into(), lines.chain(styles).collect())]);
    let compiled = disk.compile("a.cga");
    disk.check(&compiled);
    assert!(compiled.diags.iter().all(|diag| diag.level != Level::Error), "{:?}", compiled.diags.first());
    // A rule is one function in all styles.
    assert_eq!(compiled.grammar.map(|grammar| grammar.rules.len()), Some(8_000));
}

/// Each instance has a list of the styles: 1,000 instances of 36,000 styles took 600 MB.
#[test]
fn many_styles_have_few_instances() {
    let styles: String = (0..8_000).map(|number| format!("style S{number}\n")).collect();
    let mut disk = disk_of([("a.cga".into(), format!("{styles} Lot --> X."))]);
    let compiled = disk.compile("a.cga");
    let found: Vec<String> = compiled.diags.iter().map(|diag| diag.message.to_string()).collect();
    assert_eq!(found, ["styles and imports multiply these rules to more than 250000 declarations"]);
}

/// Each of them may have a megabyte.
#[test]
fn files_have_a_limit_in_all() {
    let long = |number: usize| (format!("f{number}.cga"), "(".repeat(900_000));
    let imports: String = (0..9).map(|number| format!("import i{number} : \"f{number}.cga\"\n")).collect();
    let mut disk = disk_of((0..9).map(long).chain([("a.cga".into(), format!("{imports} Lot --> X."))]));
    let compiled = disk.compile("a.cga");
    let found = |message: &str| compiled.diags.iter().filter(|diag| diag.message.to_string() == message).count();
    assert_eq!(found("more than 2000000 tokens in all files"), 1);
    assert!(disk.opened < 5, "{} files are read", disk.opened);
}

/// A megabyte of `@` took 700 MB.
#[test]
fn signs_of_annotations_in_a_row_are_reported_twice() {
    let mut disk = disk_of([("a.cga".into(), format!("{}\nLot --> X.", "@".repeat(1000)))]);
    assert_eq!(count_of(&disk.compile("a.cga"), Code::Syntax), 2);
}

#[test]
fn chains_and_rings_of_files_and_styles_end() {
    for count in [2, 10, 150] {
        let link = |number: usize| {
            let next = (number + 1) % count;
            (format!("f{number}.cga"), format!("import n : \"f{next}.cga\" attr h = n.h Lot --> n.Lot"))
        };
        let mut disk = disk_of((0..count).map(link));
        let compiled = disk.compile("f0.cga");
        disk.check(&compiled);
        assert!(compiled.grammar.is_none(), "{count} files in a ring");
        let style = |number: usize| format!("style S{number} extends S{} Lot --> A{number}. ", (number + 1) % count);
        let text: String = (0..count).map(style).collect();
        let mut disk = disk_of([("a.cga".into(), format!("Lot --> X. {text}"))]);
        let compiled = disk.compile("a.cga");
        disk.check(&compiled);
        assert_eq!(count_of(&compiled, Code::UnknownStyle), 1, "{count} styles in a ring");
    }
}

#[test]
fn long_lists_take_time_in_proportion() {
    let count = 2500;
    let list = |one: &dyn Fn(usize) -> String| (0..count).map(one).collect::<Vec<_>>();
    let library = list(&|number| format!("attr x{number} = 1 extension E{number} --> X.")).join("\n");
    for (name, overrides) in [
        ("attributes", list(&|number| format!("x{number} = {number}")).join(", ")),
        ("rules", list(&|number| format!("E{number} --> Y.")).join(", ")),
        ("unknown ones", list(&|number| format!("y{number} = {number}")).join(", ")),
    ] {
        let main = format!("import lib : \"lib.cga\" ({overrides}) Lot --> lib.E7");
        let mut disk = disk_of([("a.cga".into(), main), ("lib.cga".into(), library.clone())]);
        let compiled = disk.compile("a.cga");
        disk.check(&compiled);
        assert_eq!(compiled.diags.len(), if name == "unknown ones" { count } else { 0 }, "{name}");
    }
    // Attributes that flow in, misspelt names, overloads.
    let main = list(&|number| format!("attr x{number} = 2 A{number} --> extrude(x{number}z) B{number}z")).join("\n");
    let mut disk = disk_of([("a.cga".into(), format!("import lib : \"lib.cga\" {main}")), ("lib.cga".into(), library)]);
    let compiled = disk.compile("a.cga");
    disk.check(&compiled);
    assert_eq!(compiled.diags.len(), 2 * count);
    let same = list(&|_| "R(a) --> R(a) f(a) = case a == 1 : f(a) else : 1".into()).join("\n");
    let mut disk = disk_of([("a.cga".into(), same)]);
    let compiled = disk.compile("a.cga");
    disk.check(&compiled);
    assert_eq!(count_of(&compiled, Code::DuplicateName), 2 * (count - 1));
}

#[test]
fn a_file_is_parsed_once() {
    // Two styles, fifty imports, and a mistake in the imported file.
    let imports: String = (0..50).map(|number| format!("import i{number} : \"b.cga\" ")).collect();
    let calls: String = (0..50).map(|number| format!("i{number}.R ")).collect();
    let main = format!("{imports} Lot --> {calls} style S attr h = 1");
    let mut disk = disk_of([("a.cga".into(), main), ("b.cga".into(), "R --> X.  Q --> split(x) { ~1 }".into())]);
    let compiled = disk.compile("a.cga");
    disk.check(&compiled);
    let names: Vec<&str> = compiled.files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["a.cga", "b.cga"]);
    assert_eq!(compiled.diags.iter().filter(|diag| compiled.locate(diag.span.first).0 == 1).count(), 1);
    // Without the mistake there is one rule for all imports.
    disk.files.insert("b.cga".into(), lex("R --> X.").tokens);
    let compiled = disk.compile("a.cga");
    assert_eq!(compiled.files.len(), 2);
    assert_eq!(compiled.grammar.map(|grammar| grammar.rules.len()), Some(2));
}

#[test]
fn a_declaration_with_several_tuples_of_types_has_one_tree() {
    let text = "f(x) = x  R(x) --> print(f(x))  Lot --> R(1) R(\"a\") R(true) R([1])";
    let mut disk = disk_of([("a.cga".into(), text.into())]);
    let compiled = disk.compile("a.cga");
    disk.check(&compiled);
    assert_eq!(compiled.files[0].tokens.len(), lex(text).tokens.len());
    let grammar = compiled.grammar.expect("no error");
    assert_eq!((grammar.functions.len(), grammar.rules.len()), (4, 5));
    assert!(grammar.functions.iter().all(|function| function.span == grammar.functions[0].span));
}
