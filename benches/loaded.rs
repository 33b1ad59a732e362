//! Loaded rules beside compiled ones, and the time to load rules.
//!
//! `cargo bench --features eval --bench loaded`; words after `--` choose rows by parts of their names.

mod common;
#[path = "../examples/district.rs"]
#[allow(dead_code, unreachable_pub, reason = "the rules are needed alone")]
mod district;
#[path = "../tests/inline.rs"]
#[allow(dead_code, unreachable_pub, reason = "tests share it")]
mod inline;
#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code, unreachable_pub, reason = "the pictures of the scenes are made elsewhere")]
mod scenes;

use cga::sink::buffers::Buffers;
use cga::{Grammar, RuleFile, Settings, Shape, cga};
use common::clock::{fastest, nanoseconds_each};
use common::table::{Table, number};

/// The seconds for which each row is repeated.
const SECONDS: f64 = 1.0;

cga! {
    /// The house of the README.
    grammar House;
    attr height = 17
    Lot    --> extrude(height) split(y) { ~1 : comp(f) { side : Facade } | 0.6 : Cornice }
    Cornice --> s(^1.05, ^1, ^1.07) center(xz) color("#8c4a3a") Cornice.
    Facade --> split(y) { 4 : Floor(2.4, "#31424c") | 0.35 : Ledge | { ~3.2 : Floor(2.4, "#56788c") }* }
    Ledge  --> color("#8c4a3a") extrude(0.4) Ledge.
    Floor(w, tint) --> split(x) { 0.7 : Pier | { ~w : Bay(tint) | 0.7 : Pier }* }
    Pier   --> color("#e3d5bb") extrude(0.22) Pier.
    Bay(tint) --> color("#cdb892") split(y) { 0.8 : Wall. | ~1 : Window(tint) | 0.35 : Wall. }
    Window(tint) --> [ t(0, 0, -0.2) color(tint) Glass. ] color("#f5f1e6") split(x) { 0.1 : Frame | ~1 : Bars | 0.1 : Frame }
    Bars   --> split(y) { 0.1 : Frame | ~2 : NIL | 0.08 : Frame | ~1 : NIL | 0.1 : Frame }
    Frame  --> t(0, 0, -0.2) extrude(0.26) Frame.
}

cga! {
    /// Workload A: walls, windows, frames and set-back glass.
    grammar Facades;
    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
}

cga! {
    /// Workload D: a cube with holes on `level` levels.
    grammar Menger;
    attr level = 3
    Lot  --> S(level)
    S(n) --> case n == 0 : Cube. else : split(y) { ~1 : F(n) | ~1 : H(n) | ~1 : F(n) }
    F(n) --> split(x) { ~1 : Q(n) | ~1 : O(n) | ~1 : Q(n) }
    H(n) --> split(x) { ~1 : O(n) | ~1 : NIL | ~1 : O(n) }
    Q(n) --> split(z) { ~1 : S(n - 1) | ~1 : S(n - 1) | ~1 : S(n - 1) }
    O(n) --> split(z) { ~1 : S(n - 1) | ~1 : NIL | ~1 : S(n - 1) }
}

/// Rules, compiled and loaded, and the shapes that they run on.
struct Subject {
    name: &'static str,
    text: String,
    compiled: Box<dyn Grammar>,
    shapes: Vec<Shape>,
}

fn subjects() -> Vec<Subject> {
    let here = include_str!("loaded.rs");
    let lots = || (0..40).map(|seed| Shape::rectangle(12.0, 10.0).seed(seed)).collect();
    let tower = scenes::scenes().swap_remove(0);
    let row =
        |name, text: &str, compiled: Box<dyn Grammar>, shapes| Subject { name, text: text.into(), compiled, shapes };
    let inline = |source: &str, name| inline::named(source, name).rules;
    vec![
        row("README's house", &inline(here, "House"), Box::<House>::default(), lots()),
        row(
            "tower",
            &inline(&format!("cga! {{\n{}\n}}", tower.rules), "Tower"),
            tower.grammar,
            tower.shapes.into_iter().map(|start| start.shape).collect(),
        ),
        row(
            "district's house",
            &inline(include_str!("../examples/district.rs"), "House"),
            Box::<district::House>::default(),
            lots(),
        ),
        row("A(40 x 40 m)", &inline(here, "Facades"), Box::<Facades>::default(), vec![Shape::cuboid(40.0, 40.0, 40.0)]),
        row("D(3)", &inline(here, "Menger"), Box::<Menger>::default(), vec![Shape::cuboid(27.0, 27.0, 27.0)]),
    ]
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word.as_str()));
    let mut table = Table::new(
        "Loaded rules: time",
        &["rules", "leaves", "compiled, ns a leaf", "loaded, ns a leaf", "loaded / compiled", "load, ms"],
    );
    for Subject { name, text, compiled, shapes } in subjects().into_iter().filter(|subject| wanted(subject.name)) {
        let loaded = RuleFile::from_text(&text).expect("good rules");
        let settings = Settings::default();
        let mut sessions = [compiled.session(&settings), Grammar::session(&loaded, &settings)]
            .map(|session| session.expect("the attributes are in their ranges"));
        let [a, b] = &mut sessions;
        let mut leaves = 0;
        let mut run = |session: &mut Box<dyn cga::DynSession + '_>| {
            let mut out = Buffers::new();
            leaves = 0;
            for shape in &shapes {
                leaves += session.run(shape, &mut out).expect("no limit is reached").leaves;
            }
        };
        let run = std::cell::RefCell::new(&mut run);
        let best = fastest(
            SECONDS,
            [&mut || run.borrow_mut()(a), &mut || run.borrow_mut()(b), &mut || drop(RuleFile::from_text(&text))],
        );
        let each = |at: usize| nanoseconds_each(best[at], leaves as usize);
        table.row(
            name,
            &[
                leaves.to_string(),
                number(each(0), 1),
                number(each(1), 1),
                number(each(1) / each(0), 2),
                number(best[2].as_secs_f64() * 1e3, 2),
            ],
        );
    }
    table.print();
    large();
}

/// The time to load 400 rules: the house of the README, forty times, with a number after each name.
fn large() {
    let house = inline::named(include_str!("loaded.rs"), "House").rules;
    let names = ["Lot", "Cornice", "Facade", "Ledge", "Floor", "Pier", "Bay", "Window", "Bars", "Frame", "height"];
    let numbered = |number: usize| {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let mut text = String::new();
        for part in house.split_inclusive(|c: char| !is_word(c)) {
            let word = part.trim_end_matches(|c: char| !is_word(c));
            text.push_str(word);
            if names.contains(&word) {
                text.push_str(&number.to_string());
            }
            text.push_str(&part[word.len()..]);
        }
        text
    };
    let text: String = (0..40).map(numbered).collect();
    let [best] = fastest(SECONDS, [&mut || drop(RuleFile::from_text(&text).expect("good rules"))]);
    println!("{} rules: {:.1} ms to load", text.matches("-->").count(), best.as_secs_f64() * 1e3);
}
