//! Styles: rules, attributes, constants and functions that take the place of others.

use cga::{Grammar, cga};

use crate::{leaves, lines, model, model_of, rules, sum};

cga! { grammar Styled in "rules/import/styles.cga"; }

#[test]
fn a_style_takes_the_place_of_what_it_builds_on() {
    let rules = Styled::default();
    assert_eq!(rules.start_rules()[0].name, "Lot");
    for (start, size, printed, leaf) in [
        ("Lot", 1.0, "plain2", "Plain"),
        ("Default$Lot", 1.0, "plain2", "Plain"),
        ("Large$Lot", 10.0, "plain11", "Large"),
        ("Huge$Lot", 100.0, "huge100", "Large"),
    ] {
        let made = model_of(&rules, start);
        assert_eq!((sum(&made, "size"), sum(&made, "edge")), (Some(size), Some(size / 10.0)), "{start}");
        assert_eq!((lines(&made), leaves(&made)), (vec![printed.to_owned()], vec![leaf]), "{start}");
    }
    assert_eq!(
        (lines(&model_of(&rules, "Huge$Extra")), leaves(&model_of(&rules, "Huge$Top"))),
        (vec!["huge".to_owned()], vec!["Large"])
    );
    assert!(rules.generate_from("Large$Extra", &crate::lot()).is_err(), "it belongs to another style");
}

#[test]
fn one_field_sets_an_attribute_in_every_style() {
    // Its default differs from style to style, so it is `None` until somebody sets it.
    let rules = Styled { size: Some(4.0), kind: Some("mine".into()) };
    for (start, printed) in [("Lot", "mine5"), ("Large$Lot", "mine5"), ("Huge$Lot", "mine4")] {
        let made = model_of(&rules, start);
        assert_eq!((sum(&made, "size"), lines(&made)), (Some(4.0), vec![printed.to_owned()]), "{start}");
    }
    assert_eq!(rules.attributes().len(), 2);
}

#[test]
fn styles_have_start_rules_and_imports() {
    cga! {
        grammar Own = r#"
            import imp : "rules/import/inner.cga"
            attr h = 3
            draw = rand()
            @StartRule
            Lot --> imp.Say Next
            Next --> A.
            style Tall
            attr h = 30
            Next --> print(h) Next2
            Next2 --> B.
            style Odd extends Tall
            @StartRule
            Begin --> Lot
            draw = 7
            Next2 --> print(draw) C.
        "#;
    }
    let rules = Own::default();
    assert_eq!(lines(&model(&rules)), ["inner3 (2)[3,30]"]);
    assert_eq!(lines(&model_of(&rules, "Tall$Lot")), ["inner30 (2)[30,300]", "30"]);
    assert_eq!(lines(&model_of(&rules, "Odd$Begin")), ["inner30 (2)[30,300]", "30", "7"]);
    assert_eq!(leaves(&model_of(&rules, "Odd$Lot")), ["X", "C"]);
}

#[test]
fn an_import_may_ask_for_a_style() {
    cga! { grammar Plain = r#"import imp : "rules/import/styles.cga"  Lot --> imp.Lot"#; }
    cga! { grammar Large = r#"import imp(Large) : "rules/import/styles.cga"  Lot --> imp.Lot"#; }
    cga! { grammar Huge = r#"import imp(Huge, Large) : "rules/import/styles.cga"  Lot --> imp.Lot print(imp.grown(3))"#; }
    rules! { grammar Both = r#"
        import one(Large) : "rules/import/styles.cga"
        import two : "rules/import/styles.cga" (size = 3)
        Lot --> one.Lot two.Lot"#; }
    assert_eq!((sum(&model(&Plain::default()), "size"), leaves(&model(&Plain::default()))), (Some(1.0), vec!["Plain"]));
    assert_eq!(
        (sum(&model(&Large::default()), "size"), leaves(&model(&Large::default()))),
        (Some(10.0), vec!["Large"])
    );
    assert_eq!(lines(&model(&Huge::default())), ["300", "huge100"]);
    let both = model(&Both::default());
    assert_eq!((sum(&both, "size"), leaves(&both)), (Some(13.0), vec!["Large", "Plain"]));
}

#[test]
fn only_the_style_default_is_overridden_by_an_import() {
    rules! { grammar Over = r#"
        import imp(Large) : "rules/import/styles.cga" (kind = "given")
        attr size = 5
        Lot --> imp.Lot"#; }
    let made = model(&Over::default());
    // `size` comes from the style, which nothing flows into; `kind` comes from `Default`.
    assert_eq!((sum(&made, "size"), lines(&made)), (Some(10.0), vec!["given11".to_owned()]));
}

#[test]
fn the_same_seed_gives_the_same_numbers_in_every_style() {
    rules! { grammar Drawn = "attr a = rand()  Lot --> print(a) print(rand()) X.  style S  Other --> Y."; }
    assert_eq!(lines(&model(&Drawn::default())), lines(&model_of(&Drawn::default(), "S$Lot")));
}

#[test]
fn a_style_takes_the_place_of_one_overload() {
    rules! {
        grammar Overloaded = r#"
            attr b = 2
            f(x) = x * 1
            f(s) = len(s)
            Lot --> print(f(2)) print(f("abc")) print(b)
            style S
            attr c = 3
            f(x) = x * c
        "#;
    }
    let rules = Overloaded::default();
    assert_eq!(lines(&model_of(&rules, "Lot")), ["2", "3", "2"]);
    assert_eq!(lines(&model_of(&rules, "S$Lot")), ["6", "3", "2"]);
}

#[test]
fn the_selectors_of_styles_keep_their_text() {
    rules! {
        grammar Selected = r#"
            Lot --> comp(f) { 0 + 0 : print(comp.sel) }
            style S
            Lot --> comp(f) { 0 : print(comp.sel) }
        "#;
    }
    let rules = Selected::default();
    assert_eq!(lines(&model_of(&rules, "Lot")), ["0 + 0"]);
    assert_eq!(lines(&model_of(&rules, "S$Lot")), ["0"]);
}

#[test]
fn values_may_need_each_other_in_turn() {
    cga! {
        grammar Turned = r#"
            attr a = 2
            attr b = a + 1
            attr c = f
            f = a * 10
            Lot --> print(a) print(b) print(c)
            style S
            attr a = b + 1
            attr b = 7
            style T extends S
            f = case a > 100 : c else : b
        "#;
    }
    let rules = Turned::default();
    assert_eq!(lines(&model_of(&rules, "Lot")), ["2", "3", "20"]);
    assert_eq!(lines(&model_of(&rules, "S$Lot")), ["8", "7", "80"]);
    assert_eq!(lines(&model_of(&rules, "T$Lot")), ["8", "7", "7"]);
    let given = Turned { a: Some(30.0), ..Turned::default() };
    assert_eq!(lines(&model_of(&given, "Lot")), ["30", "31", "300"]);
    assert_eq!(lines(&model_of(&given, "S$Lot")), ["30", "7", "300"]);
}

#[test]
fn locals_of_other_styles_are_not_computed() {
    rules! {
        grammar Locals = r#"
            f(x) with ( y := rand(1) + x ) = y > 0
            Lot with ( p := rand(1) ) --> print(p) print(f(1)) print(rand(1)) Next("a")
            Next(t) with ( q := len(t) ) --> print(q) split(x) { ~1 : print(q) }
            style S
            f(x) with ( z := print(x)  y := z ) = y > 0
            Lot with ( t := "none"  p := print(t) ) --> print(rand(1)) Next(p)
            Next(t) with ( r := t + "!"  q := print(r) ) --> split(x) { ~1 : print(q + "?") }
        "#;
    }
    rules! { grammar First = "Lot --> print(rand(1))"; }
    let rules = Locals::default();
    let plain = lines(&model_of(&rules, "Lot"));
    assert_eq!((plain.len(), &plain[3..]), (5, &["1".to_owned(), "1".to_owned()][..]));
    let first = lines(&model(&First::default()));
    assert_eq!(plain[0], first[0], "the first random number is the local's");
    assert_eq!(lines(&model_of(&rules, "S$Lot")), ["none", &first[0], "none!", "none!?"]);
}

#[test]
fn constants_of_styles_are_not_folded_into_rules_of_others() {
    rules! {
        grammar Constants = r#"
            const a = 1
            const b = a * 2
            const c = a * 0
            f(x) = x + b
            Lot --> print(a + b) print(f(c)) set(v, a) Next
            Next --> print(v)
            attr v = 5
            style S
            const a = 3
            style T
            const b = rand(1) * 0 + 4
            Next --> print(-v)
        "#;
    }
    let rules = Constants::default();
    assert_eq!(lines(&model_of(&rules, "Lot")), ["3", "2", "1"]);
    assert_eq!(lines(&model_of(&rules, "S$Lot")), ["9", "6", "3"]);
    assert_eq!(lines(&model_of(&rules, "T$Lot")), ["5", "4", "-1"]);
}
