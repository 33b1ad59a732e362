//! `with`: values computed when a definition is entered.

use cga::cga;

use crate::{lines, model, rules};

#[test]
fn locals_are_computed_once_in_order() {
    cga! {
        grammar Locals = r#"
            dist(x1, y1, x2, y2) with ( dx := x2 - x1  dy := y2 - y1 ) = sqrt(dx*dx + dy*dy)
            attr a with ( x := "ex" y := x + "ample" ) = y
            const b with ( x := [0, 1, 2]  y := 1 ) = x[y]
            f(a) with ( x := a  y := x ) = y
            # A local hides what has its name outside.
            hidden(n) with ( a := n * 2 ) = a
            Lot --> print(rint(1000 * dist(1, 1, 2, 2))) print(a) print(b) print(f(7)) print(hidden(4)) Area Drawn Rule(2)
            Area with ( area := geometry.area ) --> s('2, 0, '2) print(area) print(geometry.area)
            Drawn with ( d := rand() ) --> print(d == d) print(rand() == rand())
            Rule(n) with ( m := n * 10  k := m + 1 ) --> print(k) split(x) { ~1 : print(k + split.index) Inner(k) }*
            Inner(k) with ( m := k ) --> print(m) X.
        "#;
    }
    let model = model(&Locals { ..Locals::default() });
    assert_eq!(
        lines(&model),
        ["1414", "example", "1", "7", "8", "4", "16", "true", "false", "21", "21", "22", "21", "21"]
    );
}

#[test]
fn a_local_sees_the_shape_as_it_was_when_the_definition_was_entered() {
    rules! {
        grammar Entered = r#"
            width with ( w := scope.sx ) = w
            say(x) with ( y := print(x) ) = y + y
            Lot --> print(width) s(1, 1, 1) print(width) print(say(3)) Rule
            Rule with ( w := width  h := w + 1 ) --> s(5, 5, 5) print(w) print(h) [ s(7, 1, 1) print(w) print(width) ] X.
        "#;
    }
    assert_eq!(lines(&model(&Entered::default())), ["2", "1", "3", "6", "1", "2", "1", "7"]);
}

#[test]
fn a_function_that_calls_itself_has_locals_for_each_call() {
    rules! {
        grammar Deep = r#"
            sum(n) with ( rest := n - 1 ) = case n <= 0 : 0 else : n + sum(rest)
            Lot --> print(sum(10)) Count(3)
            Count(n) with ( less := n - 1  text := "n" + n ) --> print(text) [ case less > 0 : Count(less) else : End. ]
        "#;
    }
    assert_eq!(lines(&model(&Deep::default())), ["55", "n3", "n2", "n1"]);
}

#[test]
fn an_attribute_with_locals_can_be_given() {
    cga! { grammar Given = "attr h with ( x := scope.sx ) = x * 2  Lot --> print(h)"; }
    assert_eq!(lines(&model(&Given::default())), ["4"]);
    assert_eq!(lines(&model(&Given { h: Some(1.0) })), ["1"]);
}
