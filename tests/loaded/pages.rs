//! The examples of the reference's pages give the same bytes, compiled and loaded.

use cga::{Grammar, Model, RuleFile};
use cga_tests::inline;
use cga_tests::outcome::bytes;
use cga_tests::pages::{self, assets};
use cga_tests::tree::root;

/// The parts of a model that are compared.
fn shown(model: &Model) -> String {
    format!("{:?}\n{:?}\n{}", model.counts(), model.faults(), bytes(model))
}

/// The rules that examples of propagation share, which their text does not show.
fn shared(rules: &str) -> String {
    if !rules.ends_with(" Visualize\n") {
        return String::new();
    }
    let source = std::fs::read_to_string(root().join("tests/pages/tags.rs")).expect("the page");
    let list = inline::grammars(&source).into_iter().map(|grammar| grammar.rules);
    let mut rules = list.filter_map(|rules| Some(rules[rules.find("Visualize -->")?..].to_owned()));
    rules.next_back().expect("the shared rules")
}

#[test]
fn examples_give_the_same() {
    let (settings, mut count) = (assets::settings(), 0);
    for example in pages::all() {
        let shape = (example.start)();
        let rules = format!("{}\n{}", example.rules, shared(example.rules));
        let loaded = RuleFile::loader().named("Page").text(&rules);
        let loaded = loaded.unwrap_or_else(|error| panic!("{}: {error}", example.title));
        let [a, b] = [(example.run)(&shape, &settings), loaded.generate_with(&shape, &settings)]
            .map(|model| model.map(|model| shown(&model)).map_err(|error| error.to_string()));
        assert_eq!(a, b, "{}", example.title);
        count += 1;
    }
    assert!(100 < count, "{count} examples");
}
