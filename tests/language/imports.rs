//! Imports: what is found behind the name, which values attributes have, extensions, leaves that are continued.

use cga::{Grammar, cga};

use crate::{leaves, lines, lot, model, model_of, rules, sum};

#[test]
fn attributes_flow_into_an_import() {
    cga! { grammar Flows = r#"import imp : "rules/import/height.cga" attr height = 20  Lot --> imp.Lot"#; }
    cga! { grammar Keeps = r#"import imp : "rules/import/height.cga" (height) attr height = 20  Lot --> imp.Lot"#; }
    rules! { grammar KeepsAll = r#"import imp : "rules/import/height.cga" () attr height = 20  Lot --> imp.start"#; }
    cga! { grammar Gives = r#"import imp : "rules/import/height.cga" (height = 20)  Lot --> imp.Lot"#; }
    let doubled: [(&dyn Grammar, f64); 4] =
        [(&Flows::default(), 20.0), (&Keeps::default(), 10.0), (&KeepsAll::default(), 10.0), (&Gives::default(), 20.0)];
    for (rules, height) in doubled {
        let made = model(rules);
        assert_eq!((sum(&made, "height"), sum(&made, "double")), (Some(height), Some(2.0 * height)));
    }
    // Values of the host program are passed on to the import. A value that it gives the import itself has precedence.
    assert_eq!(sum(&model(&Flows { height: 7.0, ..Flows::default() }), "double"), Some(14.0));
    assert_eq!(sum(&model(&Flows { imp_height: Some(3.0), ..Flows::default() }), "double"), Some(6.0));
    assert_eq!(sum(&model(&Keeps { imp_double: Some(3.0), ..Keeps::default() }), "double"), Some(3.0));
}

#[test]
fn an_override_is_evaluated_where_it_is_written() {
    rules! {
        grammar Written = r#"
            import imp : "rules/import/inner.cga" (h = base + drawn * 0, name = "mine" + imp.h)
            attr base = 30
            attr drawn = rand()
            const h = 1000
            Lot --> imp.Lot imp.Say
        "#;
    }
    let made = model(&Written::default());
    assert_eq!((sum(&made, "h"), sum(&made, "k"), sum(&made, "c")), (Some(30.0), Some(300.0), Some(301.0)));
    assert_eq!(lines(&made), ["mine3030 (2)[30,300]"]);
}

#[test]
fn an_override_may_refer_to_what_it_overrides() {
    rules! { grammar Itself = r#"
        import imp : "rules/import/inner.cga" (h = imp.h + 1, k = imp.k + imp.h)
        Lot --> imp.Lot"#; }
    let made = model(&Itself::default());
    // `h` is 5 + 1; `k` would have been 6 * 10, and 6 more.
    assert_eq!((sum(&made, "h"), sum(&made, "k")), (Some(6.0), Some(66.0)));
}

#[test]
fn an_override_reaches_attributes_further_down() {
    rules! { @Allow(old_spelling) grammar Deep = r#"
        import imp : "rules/import/outer.cga" (b.h = base + imp.b.h)
        attr base = 30
        Lot --> imp.Lot imp(b.h = 8).Lot"#; }
    let made = model(&Deep::default());
    // The inner file writes 5.
    assert_eq!((sum(&made, "h"), sum(&made, "own")), (Some(35.0 + 8.0), Some(351.0 + 81.0)));
    assert_eq!(sum(&made, "outer"), Some(4.0));
}

#[test]
fn functions_constants_and_rules_of_an_import_are_at_hand() {
    rules! {
        grammar Uses = r#"
            import imp : "rules/import/inner.cga"
            attr h = 7
            own = imp.twice(imp.h) + imp.c
            Lot --> print(own) print(imp.twice("a")) print(imp.tall) print(imp.list[1]) s(1, 1, 1) print(imp.width) imp.Lot(4)
        "#;
    }
    let made = model(&Uses::default());
    assert_eq!(lines(&made), ["85", "aa", "true", "70", "1"]);
    assert_eq!((sum(&made, "x"), sum(&made, "h"), sum(&made, "roof")), (Some(4.0), Some(7.0), Some(7.0)));
    assert_eq!(leaves(&made), ["Flat"]);
}

#[test]
fn start_stands_for_the_rules_that_are_marked_so() {
    rules! { grammar Starts = r#"import imp : "rules/import/inner.cga"
        start Begin --> imp.start start(9)
        start Begin(n) --> imp.start(n)"#; }
    let made = model(&Starts::default());
    assert_eq!((sum(&made, "x"), sum(&made, "h")), (Some(9.0), Some(10.0)));
    assert_eq!(Starts::default().start_rules(), [cga::StartRule::new("Begin").marked()]);
}

#[test]
fn one_file_imported_twice_has_attributes_of_its_own() {
    cga! {
        grammar Twice = r#"
            import one : "rules/import/inner.cga" (h = 1)
            import two : "rules/import/inner.cga" (h = 2, Roof(n) --> report("two", n) Two.)
            Lot --> set(one.name, "changed") one.Say two.Say one.Lot two.Lot
        "#;
    }
    let made = model(&Twice::default());
    assert_eq!(lines(&made), ["changed1 (2)[1,10]", "inner2 (2)[2,20]"]);
    assert_eq!((sum(&made, "h"), sum(&made, "roof"), sum(&made, "two")), (Some(3.0), Some(1.0), Some(2.0)));
    assert_eq!(leaves(&made), ["X", "X", "Flat", "Two"]);
    let rules = Twice { one_h: 4.0, ..Twice::default() };
    assert_eq!(lines(&model(&rules)), ["changed4 (2)[4,40]", "inner2 (2)[2,20]"]);
}

#[test]
fn sites_of_a_file_share_rules_and_keep_their_values() {
    cga! {
        grammar Sites = r#"
            import x : "rules/import/wing.cga"
            import y : "rules/import/wing.cga" (own = 5)
            import own : "rules/import/site.cga" (width = 4)
            Lot --> s(20, 0, 6) [ x.Wing ] [ y.Wing ] own.Row
            Fails --> x.Fails y.Fails own.Fails
        "#;
    }
    let made = model(&Sites::default());
    assert_eq!(
        made.counts(),
        [("x.a.Panel", 10), ("Trim", 59), ("x.b.Panel", 20), ("y.a.Panel", 4), ("y.b.Panel", 20), ("own.Panel", 5)]
    );
    let colours = |name: &str| {
        let leaves = made.leaves_of(name).map(|leaf| leaf.material().color());
        leaves.map(|color| [color.r, color.g, color.b]).collect::<Vec<_>>()
    };
    for (name, colour) in [
        ("x.a.Panel", [1.0, 0.0, 0.0]),
        ("x.b.Panel", [0.0, 0.0, 1.0]),
        ("y.a.Panel", [1.0, 0.0, 0.0]),
        ("y.b.Panel", [0.0, 0.0, 1.0]),
        ("own.Panel", [1.0, 0.0, 0.0]),
    ] {
        assert!(colours(name).iter().all(|own| *own == colour), "{name}");
    }
    let trims: Vec<f64> = colours("Trim").iter().map(|[_, _, blue]| *blue).collect();
    let sites = [(10, 0.5), (20, 0.25), (4, 1.25), (20, 0.25), (5, 1.0)];
    let expected: Vec<f64> = sites.iter().flat_map(|&(count, half)| vec![f64::min(half, 1.0); count]).collect();
    assert_eq!(trims, expected);

    let made = Sites::default().generate_from("Fails", &lot()).expect("a model");
    // Breadth first.
    assert_eq!(
        lines(&made),
        ["4", "2", "6", "5", "15", "5", "#ff0000", "3", "#ff0000", "7", "#0000ff", "6", "#ff0000", "16", "#0000ff"]
    );
    let trails: Vec<String> = made.faults().iter().map(|fault| fault.trail.join(" ")).collect();
    assert_eq!(
        trails,
        [
            "Fails x.Fails x.a.Fails",
            "Fails x.Fails x.b.Fails",
            "Fails y.Fails y.a.Fails",
            "Fails y.Fails y.b.Fails",
            "Fails own.Fails"
        ]
    );
}

#[test]
fn imports_of_imports() {
    cga! { grammar Flows = r#"
        import a : "rules/import/outer.cga"
        attr h = 7
        Lot --> print(a.b.h) print(a.b.twice(a.h)) a.Lot a.b.Say"#; }
    let made = model(&Flows::default());
    assert_eq!(lines(&made), ["7", "14", "inner7 (2)[7,70]"]);
    assert_eq!((sum(&made, "outer"), sum(&made, "h"), sum(&made, "own")), (Some(7.0), Some(7.0), Some(71.0)));
    let inner = Flows { a_b_h: Some(1.0), ..Flows::default() };
    let made = model(&inner);
    assert_eq!((sum(&made, "outer"), sum(&made, "h"), sum(&made, "own")), (Some(7.0), Some(1.0), Some(11.0)));

    cga! { grammar Keeps = r#"
        import a : "rules/import/outer.cga" ()
        attr h = 7
        Lot --> a.Lot"#; }
    let made = model(&Keeps::default());
    assert_eq!((sum(&made, "outer"), sum(&made, "h")), (Some(2.0), Some(2.0)));

    cga! { grammar Gives = r#"
        import a : "rules/import/outer.cga" (h = 30, own = 4)
        Lot --> a.Lot"#; }
    let made = model(&Gives::default());
    assert_eq!((sum(&made, "outer"), sum(&made, "h"), sum(&made, "own")), (Some(30.0), Some(30.0), Some(4.0)));
}

#[test]
fn an_extension_is_replaced_by_what_the_importing_file_says() {
    rules! {
        grammar Replaced = r##"
            import imp : "rules/import/inner.cga" (Roof(x) --> color(tint) report("mine", x + h) Mine(x))
            attr h = 100
            attr tint = "#ff0000"
            Mine(x) --> print(x) Top.
            Lot --> imp.Lot
            Plain --> imp.Roof(3)
        "##;
    }
    let made = model(&Replaced::default());
    // Names in the replacement mean declarations of the importing file; `h` flowed into the import.
    assert_eq!((sum(&made, "mine"), sum(&made, "roof")), (Some(200.0), None));
    assert_eq!((leaves(&made), lines(&made)), (vec!["Top"], vec!["100".to_owned()]));
    assert_eq!(made.leaves().next().expect("a leaf").material().color().r, 1.0);
    // Called from outside it is the file's own.
    let made = model_of(&Replaced::default(), "Plain");
    assert_eq!((sum(&made, "roof"), leaves(&made)), (Some(3.0), vec!["Flat"]));
}

#[test]
fn an_extension_may_forward_to_the_one_it_replaces() {
    rules! {
        grammar Forwards = r#"
            import imp : "rules/import/inner.cga" (Roof(n) --> MyRoof(n + 1))
            extension MyRoof(n) --> imp.Roof(n)
            Lot --> imp.Lot
        "#;
    }
    let made = model(&Forwards::default());
    assert_eq!((sum(&made, "roof"), leaves(&made)), (Some(6.0), vec!["Flat"]));
    rules! {
        grammar Through = r#"
            import a : "rules/import/outer.cga" (Cover(n) --> report("cover", n) Mine.)
            import c : "rules/import/outer.cga"
            Lot --> a.Over c.Over
        "#;
    }
    let made = model(&Through::default());
    assert_eq!((sum(&made, "cover"), sum(&made, "roof"), leaves(&made)), (Some(2.0), Some(2.0), vec!["Mine", "Flat"]));
}

#[test]
fn a_rule_marked_as_start_can_replace_an_extension() {
    rules! {
        grammar Started = r#"
            import roof : "rules/import/height.cga"
            import imp : "rules/import/inner.cga" (h = 8, Roof(n) --> s(n, 1, n) roof.start)
            Lot --> imp.start
        "#;
    }
    let made = model(&Started::default());
    assert_eq!((sum(&made, "height"), leaves(&made)), (Some(10.0), vec!["Flat"]));
    assert_eq!(made.leaves().next().expect("a leaf").size().x, 8.0);
}

#[test]
fn leaves_of_an_import_are_continued() {
    rules! {
        grammar Continued = r#"
            import imp : "rules/import/inner.cga"
            attr mine = 2
            Lot --> imp.Open(4)
            imp.Missing --> print("none") None.
            imp.Missing(n) --> print(n * mine) One.
        "#;
    }
    let made = model(&Continued::default());
    assert_eq!((lines(&made), leaves(&made)), (vec!["8".to_owned(), "none".to_owned()], vec!["One", "None"]));
    rules! { @Allow(undefined_rule) grammar Left = r#"import imp : "rules/import/inner.cga"  Lot --> imp.Open(4) imp.Nowhere"#; }
    assert_eq!(leaves(&model(&Left::default())), ["Missing", "Missing", "imp.Nowhere"]);
}

#[test]
fn set_changes_an_attribute_of_an_import_for_what_follows() {
    rules! {
        grammar Sets = r#"
            import imp : "rules/import/inner.cga"
            Lot --> [ set(imp.h, 1) imp.Set imp.Say ] set(imp.list, [imp.h]) imp.Say imp.Set
        "#;
    }
    // Nothing else is computed again.
    assert_eq!(lines(&model(&Sets::default())), ["2", "50", "inner1 (2)[5,50]", "inner5 (1)[5]", "6", "50"]);
}

#[test]
fn inline_rules_import_too() {
    cga! {
        grammar Inline;
        import imp : "rules/import/inner.cga" (h = 4, Roof(n) --> Mine(n))
        Lot --> imp.Lot imp(h = 6).Say
        Mine(n) --> print(n) Top.
    }
    let made = model(&Inline::default());
    assert_eq!((lines(&made), leaves(&made)), (vec!["inner6 (2)[6,60]".to_owned(), "4".to_owned()], vec!["Top", "X"]));
    let height = 9;
    let rules = cga! {
        import imp : "rules/import/inner.cga" (h = #height)
        Lot --> imp.Lot
    };
    assert_eq!(sum(&model(&rules), "k"), Some(90.0));
}
