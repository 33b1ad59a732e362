//! Loaded rules beside compiled ones, and the time to load rules.
//!
//! `cargo bench --features eval --bench loaded`; words after `--` choose rows by parts of their names.

mod common;
#[path = "../examples/district.rs"]
#[allow(dead_code, unreachable_pub, reason = "the rules are needed alone")]
mod district;
#[path = "../examples/front.rs"]
#[allow(dead_code, unreachable_pub, reason = "the rules are needed alone")]
mod front;
#[path = "../tests/inline.rs"]
#[allow(dead_code, unreachable_pub, reason = "tests share it")]
mod inline;
#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code, unreachable_pub, reason = "the pictures of the scenes are made elsewhere")]
mod scenes;
#[allow(unused_imports, reason = "workloads are run elsewhere")]
mod workloads;

use cga::sink::buffers::Buffers;
use cga::{Grammar, RuleFile, Settings, Shape};
use common::clock::{fastest, nanoseconds_each};
use common::table::{Table, number};
use workloads::facade::Facades;
use workloads::sponge::Menger;

/// The seconds for which each row is repeated.
const SECONDS: f64 = 1.0;

/// The source of the house front.
const FRONT: &str = include_str!("../examples/front.rs");

/// Rules, compiled and loaded, and the shapes that they run on.
struct Subject {
    name: &'static str,
    text: String,
    compiled: Box<dyn Grammar>,
    shapes: Vec<Shape>,
}

fn subjects() -> Vec<Subject> {
    let lots = || (0..40).map(|seed| Shape::rectangle(12.0, 10.0).seed(seed)).collect();
    let tower = scenes::scenes().swap_remove(0);
    let row =
        |name, text: &str, compiled: Box<dyn Grammar>, shapes| Subject { name, text: text.into(), compiled, shapes };
    let inline = |source: &str, name| inline::named(source, name).rules;
    vec![
        row("house front", &inline(FRONT, "House"), front::house(17.0), lots()),
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
        row(
            "A(40 x 40 m)",
            &inline(include_str!("workloads/facade.rs"), "Facades"),
            Box::<Facades>::default(),
            vec![Shape::cuboid(40.0, 40.0, 40.0)],
        ),
        row(
            "D(3)",
            &inline(include_str!("workloads/sponge.rs"), "Menger"),
            Box::<Menger>::default(),
            vec![Shape::cuboid(27.0, 27.0, 27.0)],
        ),
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

/// The time to load 400 rules: the house front, forty times, with a number after each name.
fn large() {
    let house = inline::named(FRONT, "House").rules;
    let names =
        ["Lot", "Ledge", "Cornice", "Walls", "Floor", "Pier", "Bay", "Door", "Window", "Bars", "Frame", "height"];
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
