//! Chance: probabilities, the draws of stochastic rules, streams of random numbers.

use cga::{Grammar, cga};

use crate::{clean, each_is, leaves, lines, lot, model, rules};

fn seeded(grammar: &dyn Grammar, seed: u64) -> cga::Model {
    clean(grammar.generate(&lot().seed(seed)).expect("a model"))
}

#[test]
fn certain_and_impossible() {
    each_is! { ""
        "p(2)" => "true",
        "p(-one)" => "false",
        "p(one)" => "true",
        "p(zero)" => "false",
    }
}

#[test]
fn a_stochastic_rule_draws_until_one_is_true() {
    cga! { grammar Shares = "Lot --> print(30% : 1 5% : 2 5% : 3 else : 4) print(rand()) Next
        Next --> 30% : A 5% : B 5% : C else : D
        A --> print(rand()) X.  B --> print(rand()) X.  C --> print(rand()) X.  D --> print(rand()) X."; }
    rules! { grammar Draws = "
        which = case p(0.3) : 1 else : case p(0.05/0.7) : 2 else : case p(0.05/0.65) : 3 else : 4
        Lot --> print(which) print(rand()) Next
        Next --> case p(0.3) : A else : case p(0.05/0.7) : B else : case p(0.05/0.65) : C else : D
        A --> print(rand()) X.  B --> print(rand()) X.  C --> print(rand()) X.  D --> print(rand()) X."; }
    let mut seen = [0; 4];
    for seed in 0..1000 {
        let (shares, draws) = (lines(&seeded(&Shares::default(), seed)), lines(&seeded(&Draws::default(), seed)));
        // The numbers that follow tell how many draws were used up.
        assert_eq!(shares, draws, "seed {seed}");
        seen[shares[0].parse::<usize>().expect("1 to 4") - 1] += 1;
    }
    // Three standard deviations are below 50.
    for (count, expected) in seen.into_iter().zip([300_i32, 50, 50, 600]) {
        assert!((count - expected).abs() < 50, "{seen:?}");
    }
}

#[test]
fn nothing_is_drawn_for_what_is_certain_to_be_left() {
    rules! { grammar One = "Lot --> print(rand()) print(100% : 1 else : 2) print(rand())"; }
    rules! { grammar Other = "Lot --> print(rand()) print(case p(1) : 1 else : 2) print(rand())"; }
    assert_eq!(lines(&model(&One::default())), lines(&model(&Other::default())));
}

#[test]
fn an_attribute_is_drawn_once_from_a_stream_of_its_own() {
    rules! { grammar Few = "attr a = rand()  const c = rand()
    Lot --> print(a) print(c) print(rand()) Next  Next --> print(a) print(c) X."; }
    cga! { grammar Many = "attr first = rand()  attr twice = a + rand() + rand()  const c = rand()  attr a = rand()
        draw = rand()
        Lot --> print(a) print(c) print(rand()) Next  Next --> print(a) print(c) X."; }
    for seed in 0..20 {
        let few = lines(&seeded(&Few::default(), seed));
        assert_eq!(few[..2], few[3..], "drawn once");
        assert_ne!(few[0], few[1], "each its own");
        assert_eq!(few, lines(&seeded(&Many::default(), seed)), "others change nothing");
        // Giving it a value changes none of the others' numbers.
        let given = lines(&seeded(&Many { a: Some(3.0), ..Many::default() }, seed));
        assert_eq!((given[0].as_str(), &given[1], &given[2]), ("3", &few[1], &few[2]));
    }
    assert_ne!(lines(&seeded(&Few::default(), 1)), lines(&seeded(&Few::default(), 2)));
}

#[test]
fn a_function_is_drawn_at_each_use_from_the_stream_of_the_shape() {
    rules! { grammar Uses = "draw = rand()  Lot --> print(draw) print(draw) [ print(draw) ] print(draw) A
    A --> print(draw) X."; }
    rules! { grammar Written = "Lot --> print(rand()) print(rand()) [ print(rand()) ] print(rand()) A
    A --> print(rand()) X."; }
    let uses = lines(&model(&Uses::default()));
    assert_eq!(uses, lines(&model(&Written::default())));
    for (at, own) in uses.iter().enumerate() {
        assert!(!uses[at + 1..].contains(own), "{uses:?}");
    }
}

#[test]
fn a_part_of_the_rules_does_not_disturb_the_others() {
    rules! { grammar Plain = "Lot --> split(x) { ~1 : A | ~1 : B }  A --> X.  B --> print(rand()) [ 50% : Y. else : Z. ]"; }
    rules! { grammar Busy = "Lot --> split(x) { ~1 : A | ~1 : B }  A --> print(\"a\") [ 50% : X. else : [ Y. ] A2 ]  A2 --> s(rand(), 1, 1) X.
    B --> print(rand()) [ 50% : Y. else : Z. ]"; }
    for seed in 0..20 {
        let (plain, busy) = (seeded(&Plain::default(), seed), seeded(&Busy::default(), seed));
        assert_eq!(lines(&plain)[0], lines(&busy)[1]);
        assert_eq!(leaves(&plain).last(), leaves(&busy).last());
    }
}
