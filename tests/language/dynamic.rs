//! Imports whose values are computed again: `imp(h = 3).Rule`.

use cga::{Shape, cga};

use crate::{leaves, lines, model, rules, sum};

#[test]
fn a_dynamic_import_begins_with_what_the_static_one_says() {
    cga! { grammar Anew = r#"
        import imp : "rules/import/height.cga" (height = 20, Roof --> Mine.)
        Lot --> imp(height = 30).Lot imp( ).Lot"#; }
    let made = model(&Anew::default());
    assert_eq!((sum(&made, "height"), sum(&made, "double")), (Some(50.0), Some(100.0)));
    assert_eq!(leaves(&made), ["Mine", "Mine"]);
    rules! { grammar Lost = r#"import imp : "rules/import/height.cga"  Lot --> set(imp.height, 20) imp( ).Lot"#; }
    assert_eq!(sum(&model(&Lost::default()), "height"), Some(10.0));
    rules! { grammar Flows = r#"import imp : "rules/import/height.cga"  attr height = 4  Lot --> imp( ).Lot"#; }
    assert_eq!(sum(&model(&Flows::default()), "height"), Some(4.0));
}

#[test]
fn values_are_computed_where_the_call_stands() {
    rules! {
        grammar Called = r#"
            import imp : "rules/import/inner.cga"
            Lot --> split(x) { ~1 : Part(split.index + 5) | ~1 : Part(6) }
            Part(n) --> s(n, 1, 1) imp(h = n + scope.sx, name = "p" + split.index).Say
        "#;
    }
    assert_eq!(lines(&model(&Called::default())), ["p010 (2)[10,100]", "p112 (2)[12,120]"]);
}

#[test]
fn everything_that_depends_on_it_is_computed_again() {
    rules! {
        grammar Depends = r#"
            import imp : "rules/import/inner.cga"
            Lot --> imp(h = 7).Lot imp(k = 1).Say imp.Say print(imp.c)
        "#;
    }
    let made = model(&Depends::default());
    // Constants of the file are no exception.
    assert_eq!(sum(&made, "c"), Some(71.0));
    assert_eq!((sum(&made, "h"), sum(&made, "k"), sum(&made, "roof")), (Some(7.0), Some(70.0), Some(7.0)));
    assert_eq!(lines(&made), ["51", "inner5 (2)[5,1]", "inner5 (2)[5,50]"]);
}

#[test]
fn what_it_is_given_may_depend_on_the_value_so_far() {
    rules! {
        grammar Sofar = r#"
            import imp : "rules/import/inner.cga"
            Lot --> set(imp.h, 1) imp(h = imp.h + 1).Say imp(h = imp.h * 3, k = imp.h).Say imp(h = 8).Lot(imp.h)
        "#;
    }
    // All of the call is evaluated before anything changes, in whatever order it is written.
    let made = model(&Sofar::default());
    assert_eq!(lines(&made), ["inner2 (2)[2,20]", "inner3 (2)[3,1]"]);
    assert_eq!((sum(&made, "x"), sum(&made, "h")), (Some(1.0), Some(8.0)));
}

#[test]
fn rules_that_call_themselves_keep_the_values() {
    rules! {
        grammar Recursive = r#"
            import imp : "rules/import/inner.cga"
            Lot --> imp(h = 9).Deep(2) imp.Deep(0)
        "#;
    }
    let mut said = lines(&model(&Recursive::default()));
    said.sort();
    assert_eq!(said, ["5", "9", "9", "9"]);
}

#[test]
fn extensions_are_replaced_for_one_call() {
    rules! {
        grammar Once = r#"
            import imp : "rules/import/inner.cga" (h = 1, Roof(n) --> First.)
            Lot --> imp(Roof(n) --> print(n + mine) Second.).Lot imp.Lot imp(h = 3, Roof(x) --> Other(x)).Lot(2)
            attr mine = 40
            Other(x) --> print(x) Third.
        "#;
    }
    let made = model(&Once::default());
    assert_eq!(
        (lines(&made), leaves(&made)),
        (vec!["41".to_owned(), "3".to_owned()], vec!["Second", "First", "Third"])
    );
    assert_eq!((sum(&made, "h"), sum(&made, "x")), (Some(5.0), Some(2.0)));
}

#[test]
fn imports_of_the_import_start_again_too() {
    rules! {
        grammar Nested = r#"
            import a : "rules/import/outer.cga"
            Lot --> set(a.b.h, 50) a(h = 3).Lot a.b.Say
        "#;
    }
    let made = model(&Nested::default());
    assert_eq!((sum(&made, "outer"), sum(&made, "h"), sum(&made, "own")), (Some(3.0), Some(3.0), Some(31.0)));
    assert_eq!(lines(&made), ["inner50 (2)[2,20]"]);
}

#[test]
fn the_shape_goes_on_as_it_was() {
    rules! {
        grammar After = r#"
            import imp : "rules/import/inner.cga"
            Lot --> imp(h = 9).Say print(imp.h) t(1, 0, 0) imp.Say
        "#;
    }
    assert_eq!(lines(&model(&After::default())), ["5", "inner9 (2)[9,90]", "inner5 (2)[5,50]"]);
}

#[test]
fn given_values_count_in_any_case() {
    cga! { grammar Given = r#"import imp : "rules/import/inner.cga"  Lot --> imp(h = 3).Say imp.Say"#; }
    let rules = Given { imp_h: 8.0, ..Given::default() };
    assert_eq!(lines(&model(&rules)), ["inner3 (2)[3,30]", "inner8 (2)[8,80]"]);
    // The other values start from those that the host program gives.
    let rules = Given { imp_k: Some(7.0), imp_name: "host".into(), ..Given::default() };
    assert_eq!(lines(&model(&rules)), ["host3 (2)[3,7]", "host5 (2)[5,7]"]);
    cga! { grammar Own = r#"
        import imp : "rules/import/inner.cga"
        attr name = "outer"
        Lot --> set(imp.k, 1) imp(h = 3, Roof(n) --> X.).Say imp( ).Say"#; }
    assert_eq!(lines(&model(&Own::default())), ["outer3 (2)[3,30]", "outer5 (2)[5,50]"]);
    let rules = Own { imp_k: Some(7.0), imp_name: Some("host".into()), ..Own::default() };
    assert_eq!(lines(&model(&rules)), ["host3 (2)[3,7]", "host5 (2)[5,7]"]);
}

#[test]
fn dynamic_imports_stand_wherever_rules_do() {
    rules! {
        @Allow(undefined_rule)
        grammar Anywhere = r#"
            import imp : "rules/import/inner.cga"
            Lot --> Part(2) Chosen Leaf
            Part(n) --> extrude(1) split(x) { ~1 : imp(h = n + split.index).Say | ~1 : comp(f) { top : imp(h = comp.total * 10 + n).Say } }
            Chosen --> case imp.h == 5 : imp(name = "case").Say else : imp(name = "else").Say
            Leaf --> imp(h = 1).Nowhere [ imp(h = 2).Lot(9) ] t(0, 0, 0)
        "#;
    }
    let made = model(&Anywhere::default());
    assert_eq!(lines(&made), ["inner2 (2)[2,20]", "inner12 (2)[12,120]", "case5 (2)[5,50]"]);
    assert_eq!(leaves(&made), ["X", "X", "X", "imp.Nowhere", "Flat"]);
    assert_eq!((sum(&made, "x"), sum(&made, "h")), (Some(9.0), Some(2.0)));
}

#[test]
fn values_are_drawn_again_for_each_call_and_from_their_own_streams() {
    rules! { grammar Few = r#"import imp : "rules/import/drawn.cga"
    Lot --> imp( ).Show imp( ).Show imp(b = 1).Show print(rand())"#; }
    rules! { grammar More = r#"import imp : "rules/import/drawn.cga" (c = 1)
    Lot --> imp( ).Show imp( ).Show imp(b = 1).Show print(rand())"#; }
    // The line of `Lot` comes first.
    let (few, more) = (lines(&model(&Few::default())), lines(&model(&More::default())));
    let (first, second) = (&few[1..4], &few[4..7]);
    assert!(first.iter().zip(second).all(|(one, other)| one != other), "{few:?}");
    // `c` is given, or `b`: the others draw what they drew.
    for at in [0, 1, 2, 4, 5, 7] {
        assert_eq!(few[at], more[at], "{at}");
    }
    assert_eq!((few[8].as_str(), more[3].as_str()), ("1", "1"));
    let rest: f64 = few[0].parse().expect("a number");
    assert!((0.0..1.0).contains(&rest));
}

#[test]
fn what_goes_on_with_a_leaf_goes_on_with_it_in_every_call() {
    rules! {
        grammar Continued = r#"
            import imp : "rules/import/height.cga" ( Roof --> imp2( Roof --> Inner. ).Lot )
            import imp2 : "rules/import/height.cga"
            Lot --> imp.Lot imp( Roof --> Other. ).Lot imp2( Roof --> Third. ).Tall(3)
            imp2.Missing --> Found.
        "#;
    }
    // The override of an override is an import of its own, and so is what a call replaces.
    assert_eq!(leaves(&model(&Continued::default())), ["Inner", "Other", "Found"]);
}

#[test]
fn each_style_starts_its_own_values_again() {
    cga! { grammar Styled = r#"
        import imp : "rules/import/inner.cga"
        attr n = 7
        Lot --> imp(h = n).Say imp( ).Say imp(k = 1, h = 2).Say
        style Same
        attr other = 1
        style Big
        attr n = 9"#; }
    let said = |start: &str| {
        let made = Styled::default().generate_from(start, &Shape::cuboid(1.0, 1.0, 1.0)).expect("no limit");
        lines(&made)
    };
    assert_eq!(said("Lot"), ["inner7 (2)[7,70]", "inner5 (2)[5,50]", "inner2 (2)[2,1]"]);
    assert_eq!(said("Same$Lot"), said("Lot"));
    assert_eq!(said("Big$Lot")[0], "inner9 (2)[9,90]");
}
