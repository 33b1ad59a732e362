//! Attributes: when they are evaluated, where `set` reaches, what a run is given.

use cga::{Array, Grammar, cga};

use crate::{lines, lot, model, rules};

#[test]
fn attributes_and_constants_are_evaluated_once_on_the_initial_shape() {
    cga! {
        grammar Once = r#"
            attr width = said("attr", scope.sx)
            const depth = said("const", scope.sz)
            now = said("function", scope.sx)
            said(what, value) with ( line := print(what) ) = case line == "" : 0 else : value
            Lot --> s(1, 1, 1) print(width) print(depth) print(now) A
            A --> s(7, 1, 1) print(width) print(depth) print(now) X.
        "#;
    }
    let said = lines(&model(&Once::default()));
    assert_eq!(said, ["attr", "const", "2", "2", "function", "1", "2", "2", "function", "7"]);
}

#[test]
fn attributes_may_depend_on_one_another_in_any_order() {
    cga! { grammar Order = "attr a = b + c  const c = d * 2  attr b = f(1)  f(x) = x + d  attr d = 4  Lot --> print(a) print(b) X."; }
    assert_eq!(lines(&model(&Order::default())), ["13", "5"]);
    assert_eq!(lines(&model(&Order { d: 1.0, ..Order::default() })), ["4", "2"]);
    assert_eq!(lines(&model(&Order { b: Some(10.0), ..Order::default() })), ["18", "10"]);
}

#[test]
fn set_reaches_what_comes_of_the_shape_and_nothing_else() {
    rules! {
        grammar Reach = r#"
            attr n = 1
            attr list = [1, 2]
            attr text = "a"
            attr yes = false
            all = text + n + list[0] + yes
            Lot --> print(all) [ set(n, 2) set(text, "b") Show ] Show set(list, [5]) split(x) { ~1 : set(yes, true) Show | ~1 : Show }
                    set(n, n + 10) Show Show
            Show --> print(all) Deeper
            Deeper --> print(all) set(n, 0) Leaf
            Leaf --> print(all) X.
        "#;
    }
    let said = lines(&model(&Reach::default()));
    // `Show` and `Deeper` print the same, `Leaf` the changed number. Lines come level by level.
    let (all, last) = (
        ["b21false", "a11false", "a15true", "a15false", "a115false", "a115false"],
        ["b01false", "a01false", "a05true", "a05false", "a05false", "a05false"],
    );
    let expected = [&["a11false"][..], &all, &all, &last].concat();
    assert_eq!(said, expected);
}

#[test]
fn set_changes_nothing_that_was_computed_from_the_attribute() {
    rules! {
        grammar Computed = "attr a = 1  attr b = a * 10  const c = b + 1  f = a * 100
            Lot --> set(a, 2) print(a) print(b) print(c) print(f) X.";
    }
    assert_eq!(lines(&model(&Computed::default())), ["2", "10", "11", "200"]);
}

#[test]
fn functions_are_evaluated_on_the_shape_that_asks() {
    rules! {
        grammar Asks = r#"
            attr n = 3
            area = scope.sx * scope.sz
            part = "part " + split.index + " of " + split.total
            scaled(x) = x * n + area
            Lot --> print(area) split(x) { ~1 : print(area) print(part) Part }*
            Part --> s(1, 1, 3) print(scaled(10)) [ set(n, 4) print(scaled(10)) ] X.
        "#;
    }
    let said = lines(&model(&Asks::default()));
    assert_eq!(said, ["4", "2", "part 0 of 2", "2", "part 1 of 2", "33", "43", "33", "43"]);
}

#[test]
fn an_attribute_that_prints_is_asked_only_when_it_is_not_given() {
    cga! { grammar Silent = r#"attr a = print(scope.sx)  Lot --> X."#; }
    assert_eq!(lines(&model(&Silent::default())), ["2"]);
    assert!(lines(&model(&Silent { a: Some(1.0) })).is_empty());
}

#[test]
fn arrays_come_from_the_host_program() {
    cga! {
        grammar Given = r#"
            attr heights = [1, 2, 3]
            attr names = ["a"; "b"]
            attr drawn = [rand(), rand()]
            attr open = [true, false]
            Lot --> print(heights) print(names) print(size(drawn)) print(open) X.
        "#;
    }
    assert_eq!(Given::default().heights, Array::from([1.0, 2.0, 3.0]));
    assert_eq!((Given::default().drawn, Given::default().names.rows()), (None, 2));
    let rules = Given {
        heights: vec![vec![1.0, 2.0], vec![3.0, 4.0]].into(),
        names: Array::default(),
        drawn: Some(Array::from([0.5])),
        open: [true].into(),
    };
    assert_eq!(lines(&model(&rules)), ["(2x2)\n   1   2\n   3   4", "(0)[]", "1", "(1)[true]"]);
    let mut rules: Box<dyn Grammar> = Box::new(rules);
    rules.set_text("heights", "[9; 8]").expect("an array of numbers");
    rules.set_text("names", r#"["x, y"]"#).expect("an array of texts");
    assert_eq!(lines(&rules.generate(&lot()).expect("a model"))[..2], ["(2x1)\n   9\n   8", "(1)[x, y]"]);
}
