//! Rules and functions that share a name.

use cga::cga;

use crate::{leaves, lines, model, rules};

#[test]
fn functions_differ_in_number_and_types_of_their_parameters() {
    cga! {
        grammar Functions = r#"
            kind = "none"
            kind(x) = "number " + (x + 0)
            kind(x, y) = kind(x) + " and " + kind(y)
            what(x) = "number" + (0 * x)
            what(x) = x + " text" + len(x)
            what(x) = case x : "yes" else : "no"
            what(x) = "numbers" + sum(x .+ 0)
            Lot --> print(kind) print(kind(1)) print(kind(1, 2)) print(what(1)) print(what("a")) print(what(true)) print(what([1, 2]))
        "#;
    }
    assert_eq!(
        lines(&model(&Functions::default())),
        ["none", "number 1", "number 1 and number 2", "number0", "a text1", "yes", "numbers3"]
    );
}

#[test]
fn rules_differ_in_number_and_types_of_their_parameters() {
    cga! {
        grammar Rules = r#"
            Lot --> Part Part(1) Part("a") Part(true) Part([1, 2]) Part(1, 2)
            Part --> None.
            Part(n) --> print(n + 1) Number.
            Part(t) --> print(len(t)) Text.
            Part(b) --> print(!b) Truth.
            Part(a) --> print(a .* 2) Array.
            Part(a, b) --> print(a + b + 0) Two.
        "#;
    }
    let model = model(&Rules::default());
    assert_eq!(leaves(&model), ["None", "Number", "Text", "Truth", "Array", "Two"]);
    assert_eq!(lines(&model), ["2", "1", "false", "(2)[2,4]", "3"]);
}

#[test]
fn own_functions_come_before_those_of_the_language() {
    cga! {
        grammar Own = r#"
            max(a, b) = a + b
            clamp(a) = a * 2
            Lot --> print(max(1, 2)) print(min(1, 2)) print(clamp(4)) print(clamp(7, 0, 5))
        "#;
    }
    assert_eq!(lines(&model(&Own::default())), ["3", "1", "8", "5"]);
}

#[test]
fn a_rule_a_function_and_an_attribute_may_share_a_name() {
    rules! {
        grammar Shared = r#"
            attr Wall = 3
            Height(x) = x * 2
            Lot --> Wall Height
            Wall --> print(Wall) X.
            Height --> print(Height(Wall)) Y.
        "#;
    }
    let model = model(&Shared::default());
    assert_eq!((lines(&model), leaves(&model)), (vec!["3".to_owned(), "6".to_owned()], vec!["X", "Y"]));
}

#[test]
fn a_function_takes_what_its_body_can_do_something_with() {
    cga! {
        // The example of the page *sum*.
        grammar Sums = r#"
            const x = cumsum([1:5])
            const y = cumsum(["a","b","c","d","e"])
            const z = cumsum([false,true,true,false,true])
            cumsum(array) = case size(array) < 2 : [ sum(array) ]
                            else : [ cumsum(array[0:size(array)-2]), sum(array) ]
            Lot --> print(x) print(y) print(z)
        "#;
    }
    assert_eq!(lines(&model(&Sums::default())), ["(5)[1,3,6,10,15]", "(5)[a,ab,abc,abcd,abcde]", "(5)[0,1,2,2,3]"]);
}

#[test]
fn each_call_has_types_of_its_own() {
    rules! {
        grammar Calls = r#"
            f(x) = x
            g(x) = f(x)
            pair(a, b) = str(a) + ":" + str(b)
            even(n, v) = case n == 0 : v else : odd(n - 1, v)
            odd(n, v) = case n == 0 : v else : even(n - 1, v)
            add(a, b) = a + b
            twice(v) with ( w := f(v) ) = w + w
            Lot --> print(len(f("abc"))) print(1 - f(3)) print(g(true)) print(g("b")) print(g([1, 2]))
                    print(pair(1, "a")) print(pair("a", true)) print(pair(1, 2))
                    print(even(3, "v")) print(even(4, 2)) print(odd(3, [1]))
                    print(add(1, 2)) print(add("a", "b")) print(add("a", 1)) print(f(f("z") + f(1))) print(twice(2)) print(twice("w"))
        "#;
    }
    assert_eq!(
        lines(&model(&Calls::default())),
        [
            "3", "-2", "true", "b", "(2)[1,2]", "1:a", "a:true", "1:2", "v", "2", "(1)[1]", "3", "ab", "a1", "z1", "4",
            "ww"
        ]
    );
}

#[test]
fn a_rule_is_called_with_several_types() {
    rules! {
        grammar Several = r#"
            start Lot --> R(1, 3) R("a", 2) R(true, 1) R("b", 1)
            R(v, n) --> case n == 0 : Done(v) else : split(x) { ~1 : R(v, n - 1) }
            Done(v) --> print(v) Show(v + "!")
            Show(t) --> print(t) X.
        "#;
    }
    let model = model(&Several::default());
    assert_eq!(leaves(&model), ["X", "X", "X", "X"]);
    assert_eq!(lines(&model), ["true", "b", "a", "true!", "b!", "1", "a!", "1!"]);
}

#[test]
fn rust_values_go_where_they_fit() {
    let (number, text) = (4.0, "t".to_owned());
    let rules = cga! {
        f(x) = x
        half(x) = f(x) / 2
        Lot --> print(f("a" + #text)) print(half(#number)) print(f(2 * #number)) R(#number * 1) R("" + #text)
        R(v) --> print(f(v)) X.
    };
    assert_eq!(lines(&model(&rules)), ["at", "2", "8", "4", "t"]);
}

#[test]
fn styles_call_with_types_of_their_own() {
    cga! {
        grammar Styled = r#"
            f(x) = x
            Lot --> print(f(1)) Own
            Own --> print(f("default")) X.
            style Other
            Own --> print(f(true)) print(f([1])) X.
        "#;
    }
    let rules = Styled::default();
    assert_eq!(lines(&model(&rules)), ["1", "default"]);
    let other = rules.generate_from("Other$Lot", &crate::lot()).expect("no limit");
    assert_eq!(lines(&other), ["1", "true", "(1)[1]"]);
}

#[test]
fn functions_and_rules_of_an_import_have_types_of_each_call() {
    rules! {
        grammar Imports = r#"
            import imp : "rules/import/generic.cga"
            import two : "rules/import/generic.cga" (own = 5)
            Lot --> print(imp.f("a")) print(imp.f(true)) imp.R("r") two.R(2) two.R([1])
                    imp(own = 7).R("anew") imp(own = 8).R(1)
        "#;
    }
    assert_eq!(lines(&model(&Imports::default())), ["a", "true", "r 3", "2 5", "(1)[1] 5", "anew 7", "1 8"]);
}

#[test]
fn generic_and_other_overloads_share_a_name() {
    rules! {
        grammar Mixed = r#"
            attr a = what(1)
            const b = what("t") + what(true)
            what(x) = "any " + str(x)
            what(x) = "text" + len(x)
            both(x, y) = case x == y : what(x) else : what(y)
            first(l) = l[0]
            wrap(x) = [x, x]
            Lot --> print(a) print(b) print(both("a", "b")) print(both(1, 2)) print(first(wrap("w"))) print(first(wrap(3)) - 1)
        "#;
    }
    let rules = Mixed::default();
    assert_eq!(lines(&model(&rules)), ["any 1", "text1any true", "text1", "any 2", "w", "2"]);
}

#[test]
fn a_rust_value_beside_generic_functions_is_computed_once() {
    let count = std::cell::Cell::new(0);
    let next = || {
        count.set(count.get() + 1);
        count.get()
    };
    let rules = cga! {
        f(x) = x + #(next())
        g(x) = x
        Lot --> print(f(g(10))) print(g("a")) print(f(20)) X.
    };
    assert_eq!(lines(&model(&rules)), ["11", "a", "21"]);
    assert_eq!(count.get(), 1);
}
