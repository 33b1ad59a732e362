//! The results of a rule: leaves, reports, prints.

use cga::{Value, cga};

use crate::{leaves, lines, model, sum};

#[test]
fn reports_count_and_add_up() {
    cga! { grammar Reported = r#"import imp : "rules/import/height.cga" (height = 10)  Lot --> imp.Lot"#; }
    let model = model(&Reported::default());
    let summary = model.reported("height").expect("reported").summary();
    assert_eq!((summary.count, summary.sum), (1, 10.0));
}

#[test]
fn only_operations_make_a_leaf_and_a_division_makes_none() {
    cga! {
        grammar Leaves = r##"
            @StartRule
            Lot --> Painted Divided Parts Pushed Two Gone
            Painted --> color("#ff0000") s(1, 1, 1)
            Divided --> split(x) { ~1 : color("#00ff00") | ~1 : NIL }
            Parts --> extrude(1) comp(f) { top : t(0, 0, 1) | side = s('1, '1, 1) }
            Pushed --> [ s(1, 1, 1) ] t(1, 0, 0)
            Two --> A. s(1, 1, 1) B. color("#0000ff")
            Gone --> [ C. ] NIL
            Split --> split(x) { ~1 : A. } t(1, 0, 0) B
            B --> s(1, 1, 1)
        "##;
    }
    let made = model(&Leaves::default());
    assert_eq!(leaves(&made), ["Painted", "Divided", "Parts", "Parts", "Pushed", "A", "B", "C"]);
    assert_eq!(leaves(&crate::model_of(&Leaves::default(), "Split")), ["A", "B"]);
}

#[test]
fn values_of_one_key_are_kept_apart_by_type() {
    cga! {
        grammar Mixed = r#"
            Lot --> report("k.a", 1) report("k.a", true) report("k.a", "x") report("k.b", scope.sx) report("k.a", 2)
        "#;
    }
    let model = model(&Mixed::default());
    assert_eq!((sum(&model, "k.a"), sum(&model, "k.b")), (Some(3.0), Some(2.0)));
    assert_eq!(model.reports().iter().len(), 4);
    assert_eq!(model.reports().group("k").count, 5);
}

#[test]
fn angles_of_faces() {
    cga! {
        grammar Angles = r#"
            Lot --> extrude(1) comp(f) { all : print(geometry.angle(zenith) == 90 - geometry.angle(maxSlope)) X. }
        "#;
    }
    let all = lines(&model(&Angles::default()));
    assert!(all.len() == 6 && all.iter().all(|line| line == "true"), "{all:?}");
}

#[test]
fn what_is_printed_keeps_its_value_and_the_rule() {
    cga! { grammar Printing = r#"attr a = print(scope.sx)  Lot --> print(print(1) + 1) B  B --> print("b") X."#; }
    let model = model(&Printing::default());
    let said: Vec<(&str, Value)> = model.prints().iter().map(|line| (line.rule.as_str(), line.value.clone())).collect();
    assert_eq!(said, [("", 2.0.into()), ("Lot", 1.0.into()), ("Lot", 2.0.into()), ("B", "b".into())]);
}
