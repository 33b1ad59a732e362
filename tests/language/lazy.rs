//! Attributes and constants that need each other on some paths: each is computed when it is first read.

use cga::{Error, Grammar, LimitKind, Shape, cga};

use crate::{lines, lot, model};

cga! {
    grammar Modes = r#"
        attr mode = 1
        attr a = case mode == 1 : 5 else : b * 2
        attr b = case mode == 1 : a / 2 else : case mode == 2 : 3 else : a
        attr name = case mode == 1 : "n" + short else : "long"
        attr short = case mode == 2 : name + "er" else : "s"
        attr list = case mode == 1 : [a, b] else : more[0 : 1]
        attr more = case mode == 1 : list else : [7, 8, 9]
        const total = case mode == 1 : a + b else : share * 2
        const share with ( one := 1 ) = case mode == 1 : total / 2 else : f(1 + one)
        f(n) = case n > 1 : f(n - 1) else : case mode == 1 : total else : a + 1
        Lot --> print("" + a + " " + b + " " + name + " " + short + " " + list + more + " " + total + " " + share)
    "#;
}

#[test]
fn a_condition_decides_which_one_needs_the_other() {
    assert_eq!(lines(&model(&Modes::default())), ["5 2.5 ns s (2)[5,2.5](2)[5,2.5] 7.5 3.75"]);
    let second = Modes { mode: 2.0, ..Modes::default() };
    assert_eq!(lines(&model(&second)), ["6 3 long longer (2)[7,8](3)[7,8,9] 14 7"]);
}

#[test]
fn a_cycle_that_a_run_closes_is_an_error_with_its_names() {
    let third = Modes { mode: 3.0, ..Modes::default() };
    match third.generate(&lot()) {
        Err(error @ Error::Cycle { .. }) => {
            let expected =
                "`a` needs its own value by way of `b`: set one of them, or change the conditions that lead there";
            assert_eq!(error.to_string(), expected);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_value_from_the_host_program_breaks_the_cycle() {
    let given = Modes { mode: 3.0, b: Some(4.0), ..Modes::default() };
    assert_eq!(lines(&model(&given)), ["8 4 long s (2)[7,8](3)[7,8,9] 18 9"]);
    let mut by_name = Modes { mode: 3.0, ..Modes::default() };
    by_name.set("a", 1.0.into()).unwrap();
    assert_eq!(lines(&model(&by_name)), ["1 1 long s (2)[7,8](3)[7,8,9] 4 2"]);
}

#[test]
fn one_that_needs_itself_is_a_cycle_too() {
    cga! { grammar Alone = "attr n = 1  attr a = case n > 1 : a + 1 else : 2  Lot --> print(a)"; }
    assert_eq!(lines(&model(&Alone::default())), ["2"]);
    let closed = Alone { n: 2.0, ..Alone::default() }.generate(&lot()).unwrap_err();
    assert_eq!(closed, Error::Cycle { names: vec!["a".into()] });
    assert_eq!(closed.to_string(), "`a` needs its own value: set it, or change the conditions that lead there");
}

#[test]
fn each_draws_its_own_random_numbers_whichever_is_read_first() {
    cga! { grammar Plain = "attr x = rand  attr y = rand  Lot --> print(x) print(y)"; }
    cga! {
        grammar Cyclic = r#"
            attr first = true
            attr x = case first : rand else : rand + 0 * y
            attr y = case first : rand + 0 * x else : rand
            Lot --> print(x) print(y)
        "#;
    }
    let plain = lines(&model(&Plain::default()));
    assert_eq!(lines(&model(&Cyclic::default())), plain);
    assert_eq!(lines(&model(&Cyclic { first: false, ..Cyclic::default() })), plain);
}

#[test]
fn rules_and_styles_set_them_as_others() {
    cga! {
        grammar Set = r#"
            attr mode = 1
            attr a = case mode == 1 : 5 else : b * 2
            attr b = case mode == 1 : a / 2 else : 3
            Lot --> set(a, 9) print(a) print(b) Next
            Next --> print(a + b)
            style Other extends Default
            attr a = 1
        "#;
    }
    assert_eq!(lines(&model(&Set::default())), ["9", "2.5", "11.5"]);
    assert_eq!(lines(&crate::model_of(&Set::default(), "Other$Lot")), ["9", "0.5", "9.5"]);
}

#[test]
fn an_import_that_starts_again_computes_them_again() {
    cga! {
        grammar Anew = r#"
            import imp : "rules/import/lazy.cga"
            Lot --> imp.Say imp(mode = 2).Say imp(b = 7).Say imp(mode = 2, b = 8).Say set(imp.a, 1) imp().Say imp(a = 3).Say
        "#;
    }
    let made = lines(&model(&Anew::default()));
    let said: Vec<&str> = made.iter().map(String::as_str).filter(|line| line.starts_with('a')).collect();
    let values =
        ["a5 b2.5 c7.5 d75", "a6 b3 c3 d3", "a5 b7 c12 d120", "a16 b8 c8 d8", "a5 b2.5 c7.5 d75", "a3 b1.5 c4.5 d45"];
    assert_eq!(said, values);
    let given = Anew { imp_b: Some(6.0), ..Anew::default() };
    let made = lines(&model(&given));
    assert_eq!(made.iter().filter(|line| line.starts_with('a')).nth(1).unwrap(), "a12 b6 c6 d6");
}

#[test]
fn long_cycles_need_no_more_than_the_stack() {
    // 400 attributes, each of which needs the next one unless it is the one in which the cycle is open.
    cga! { grammar Long in "rules/import/long.cga"; }
    let run = |on: f64| {
        let run =
            move || Long { on, ..Long::default() }.generate(&Shape::rectangle(1.0, 1.0)).map(|model| lines(&model));
        std::thread::spawn(run).join().unwrap()
    };
    assert_eq!(run(100.0).unwrap(), ["100"]);
    assert!(matches!(run(-1.0), Err(Error::Limit { what: LimitKind::Nesting, .. })));
}

#[test]
fn every_place_of_a_rule_reads_them() {
    cga! {
        grammar Places;
        attr mode = 1
        attr a = case mode == 1 : sum(comp(f) { b > 1 && all : b }) else : b * 2
        attr b = case mode == 1 : 2 else : sum(comp(e) { all = a })
        attr word = case mode == 1 : "w" else : other
        attr other = case mode == 1 : word + sum([a, b]) else : "o"
        const k = case mode == 1 : 1 else : l
        const l = case mode == 1 : k else : a
        twice(n) = n * a + k
        @StartRule
        Lot --> extrude(k + l) comp(f) { a > 1 && top : Top(a, b) | b : Indexed. | all : NIL }
        Top(n, m) --> split(x) { a / 4 : set(material.name, word + other) Slot(twice(b), k) | { ~b : NIL }* | ^(k / 4) : NIL }
        Slot(n, m) --> case n > a && m == l : t(k, max(k, l), l) print([a, b, k]) print(n) X. else : X.
    }
    assert_eq!(lines(&model(&Places::default())), ["(3)[2,2,1]", "5"]);
    let set = Places { mode: 2.0, b: Some(1.5), ..Places::default() };
    assert_eq!(lines(&model(&set)), ["(3)[3,1.5,3]", "7.5"]);
}
