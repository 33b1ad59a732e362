//! However deep the rules go, the stack suffices: also without optimisation, on a thread with two megabytes.

use cga::{Error, LimitKind, Limits, Model, Settings, Shape, cga};

/// Runs on a thread with the stack that threads usually have. Overflowing it would end the whole process.
fn on_a_small_stack<T: Send + 'static>(run: impl FnOnce() -> T + Send + 'static) -> T {
    let thread = std::thread::Builder::new().stack_size(2 * 1024 * 1024).spawn(run).expect("a thread");
    thread.join().expect("no panic")
}

fn lot() -> Shape {
    Shape::cuboid(8.0, 8.0, 8.0)
}

/// Allows a million levels.
fn deep() -> Settings {
    Settings { limits: Limits { depth: 1_000_000, ..Limits::default() }, ..Settings::default() }
}

fn names(model: &Model) -> Vec<&str> {
    model.leaves().map(|leaf| leaf.rule()).collect()
}

cga! {
    grammar Down;
    attr levels = 100000
    Lot --> Level(0)
    Level(n) --> case n < levels : Level(n + 1) else : End.
}

#[test]
fn endless_recursion_is_an_error() {
    let error = on_a_small_stack(|| Down::default().generate(&lot())).expect_err("too deep");
    let Error::Limit { what, limit, trail } = &error else { panic!("{error}") };
    assert_eq!(
        (*what, *limit, trail.len(), trail[0].as_str(), trail[1].as_str()),
        (LimitKind::Depth, 1024, 1026, "Lot", "Level")
    );
    assert_eq!(
        error.to_string(),
        "more depth than the limit of 1024 allows (in Lot > Level > Level > Level > Level > Level > … 1014 more … > \
         Level > Level > Level > Level > Level > Level)"
    );
}

#[test]
fn a_recursion_of_100000_levels_ends_where_the_limit_allows_it() {
    let model = on_a_small_stack(|| Down::default().generate_with(&lot(), &deep())).expect("no limit");
    assert_eq!(names(&model), ["End"]);
}

cga! {
    /// The constructs that take most of the stack: splits, comps and brackets side by side, in rules that call each other.
    grammar Heavy;
    attr levels = 1000
    Lot --> A(0)
    A(n) --> case n > levels : End. else : Many(n)
    @Allow(size_not_positive)
    Many(n) -->
        [ comp(f) { front : X. | back : X. | left : X. } ] [ comp(f) { front : X. | back = X. } ]
        [ comp(f) { front : X. | 1 : X. } ] [ comp(e) { border && scope.sx > n : X. | all =: NIL } ] [ split(x) { 1 : X. | ~1 : [ X. ] X. | { ~1 : X. }* } ]
        [ split(y) { 1 : X. | ~1 : X. } ] [ split(z) { 1 : X. | ~1 : NIL } ] [ [ [ color("#ffffff") X. ] ] ]
        set(material.name, "name " + n + " of " + levels) split(x) { ~1 : B(n, "a" + n, n > 3) | ^0 : A(n) }
    B(n, _text, _small) --> comp(f) { front = primitiveCube() s(8, 8, 8) A(n + 1) }
}

#[test]
fn heavy_rules_are_counted_as_what_they_are() {
    let model = on_a_small_stack(|| Heavy::default().generate_with(&lot(), &deep())).expect("no limit");
    assert_eq!(model.count("End"), 1);
}

cga! {
    /// Operations between successors: each has a whole shape of its own.
    grammar Changing;
    attr levels = 2000
    Lot --> A(0)
    A(n) --> case n > levels : End. else : Many(n)
    Many(n) -->
        r(0, 1, 0) X. s(^1, ^1, ^1) X. r(0, 1, 0) X. color(rand(1), 0, 0) X. r(0, 1, 0) X. t(^0, ^0, ^0) X. r(0, 1, 0) X.
        set(levels, levels) X. center(xyz) X. r(0, 1, 0) X. mirrorScope(false, true, false) X. alignScopeToAxes(y) X.
        set(material.opacity, rand(1)) X. r(0, 1, 0) X. r(0, 1, 0) X. r(0, 1, 0) X. r(0, 1, 0) X. r(0, 1, 0) X. A(n + 1)
}

#[test]
fn operations_between_successors_are_counted() {
    let model = on_a_small_stack(|| Changing::default().generate_with(&lot(), &deep())).expect("no limit");
    assert_eq!(model.count("End"), 1);
}

cga! { grammar Chain in "rules/chain.cga"; }

#[test]
fn a_chain_of_2000_rules_without_a_cycle_fits() {
    let model = on_a_small_stack(|| Chain::default().generate(&lot())).expect("no limit");
    assert_eq!(model.counts(), [("X", 2000), ("End", 1)]);
}

#[test]
fn a_recursion_that_fits_is_done_in_writing_order() {
    let rules = cga! {
        Lot --> Tree(0)
        Tree(n) --> case n < 3 : split(x) { ~1 : Tree(n + 1) | ~1 : Leaf(n) | ~1 : Tree(n + 1) } else : End.
        Leaf(n) --> case n == 0 : Zero. case n == 1 : One. else : Two.
    };
    let model = rules.generate(&lot()).expect("no limit");
    let names = names(&model).join(" ");
    assert_eq!(names, "End Two End One End Two End Zero End Two End One End Two End");
}

#[test]
fn what_waits_comes_later_but_in_the_same_order_every_time() {
    let rules = cga! {
        Lot --> Down(400)
        Down(n) --> case n > 0 : [ split(x) { ~1 : [ Down(n - 1) ] Level(n) } ] else : Bottom.
        Level(n) --> set(material.name, "" + n) Level.
    };
    let run = || {
        let model = rules.generate(&lot()).expect("no limit");
        model.leaves().map(|leaf| leaf.material().name.as_deref().unwrap_or_default().to_owned()).collect::<Vec<_>>()
    };
    let order = run();
    assert_eq!(order.len(), 401);
    let bottom = order.iter().position(String::is_empty).expect("the bottom");
    // The levels that fit come back up before those that waited go down.
    assert!(
        0 < bottom && order[..bottom].contains(&"400".into()) && order[bottom..].contains(&"1".into()),
        "{order:?}"
    );
    assert_eq!(order, run());
}

cga! {
    grammar Functions;
    attr depth = 1000
    total(n, so_far) = case n < 1 : so_far else : total(n - 1, so_far + 1)
    even(n) = case n < 1 : true else : odd(n - 1)
    odd(n) = case n < 1 : false else : even(n - 1)
    text(n) = case n < 1 : "" else : text(n - 1) + "a" + n + "b" + (n + 1) + "c" + (n + 2) + "d" + (n + 3)
    Sum --> s(total(depth, 0), 1, 1) X.
    Even --> case even(depth) : Even. else : Odd.
    Text --> set(material.name, text(depth)) X.
}

#[test]
fn functions_nest_as_deep_as_documented() {
    let run =
        |start: &'static str, depth: f64| on_a_small_stack(move || Functions { depth }.generate_from(start, &lot()));
    assert_eq!(run("Sum", 1000.0).expect("no limit").leaves().next().expect("a leaf").size().x, 1000.0);
    assert_eq!(names(&run("Even", 1001.0).expect("no limit")), ["Odd"]);
    for (start, trail) in [("Sum", "Sum"), ("Even", "Even")] {
        let error = run(start, 1e9).expect_err("too deep");
        assert_eq!(error, Error::Limit { what: LimitKind::Nesting, limit: 1024, trail: vec![trail.into()] });
    }
}

#[test]
fn functions_with_much_on_the_stack_nest_less_deep() {
    let run = |depth: f64| on_a_small_stack(move || Functions { depth }.generate_from("Text", &lot()));
    assert!(run(100.0).is_ok());
    let error = run(1e9).expect_err("too deep");
    assert!(matches!(error, Error::Limit { what: LimitKind::Nesting, limit: 100..1024, .. }), "{error}");
}

cga! {
    /// Functions that call themselves for components, and to ask about them.
    grammar Divided;
    attr depth = 10
    valued(n) = case n > 0 : 1 + comp(f) { 0 : valued(n - 1) | bottom = 7 }[0] else : 0
    asked(n) = case n > 0 : 1 + comp(fe) { asked(n - 1) == n - 1 && !inside : n - 1 | all : -1 }[0] else : 0
    Valued --> s(valued(depth), 1, 1) X.
    Asked --> s(asked(depth), 1, 1) X.
}

#[test]
fn functions_that_call_themselves_for_components_are_counted_as_what_they_are() {
    let run = |start: &'static str, depth: f64| {
        on_a_small_stack(move || Divided { depth }.generate_from(start, &Shape::rectangle(8.0, 8.0)))
    };
    for (start, fits) in [("Valued", 100.0), ("Asked", 50.0)] {
        let model = run(start, fits).expect("no limit");
        assert_eq!(model.leaves().next().expect("a leaf").size().x, fits, "{start}");
        let error = run(start, 1e9).expect_err("too deep");
        assert!(matches!(error, Error::Limit { what: LimitKind::Nesting, limit: 50..1024, .. }), "{start}: {error}");
    }
}

cga! { grammar Wide in "rules/wide.cga"; }

/// Runs with functions that go down so far, in as many rules as it takes.
fn wide(start: &'static str, depth: f64) -> Result<Model, Error> {
    on_a_small_stack(move || {
        let settings = Settings { start: Some(start.into()), ..deep() };
        Wide { depth, ..Wide::default() }.generate_with(&lot(), &settings)
    })
}

/// The depth at which functions stop nesting there, as the error reports it.
fn deepest(start: &'static str) -> f64 {
    match wide(start, 1e9) {
        Err(Error::Limit { what: LimitKind::Nesting, limit, .. }) => limit as f64,
        other => panic!("{:?}", other.map(|_| ())),
    }
}

#[test]
fn functions_with_many_locals_nest_as_deep_as_fits() {
    for (start, least) in [("Arrays", 30.0), ("Texts", 15.0)] {
        let deepest = deepest(start);
        assert!(least < deepest && deepest < 1024.0, "{start}: {deepest}");
        // The call with 0 is one too.
        assert!(wide(start, deepest - 1.0).is_ok(), "{start}");
        assert!(wide(start, deepest).is_err(), "{start}");
    }
}

#[test]
fn small_functions_above_big_ones_leave_less_for_them() {
    let (alone, below) = (deepest("Arrays"), deepest("Mixed") - 501.0);
    assert!(10.0 < below && below < alone, "{alone} {below}");
    assert!(wide("Mixed", below - 1.0).is_ok());
}

#[test]
fn rules_with_many_locals_and_arrays_are_counted_as_what_they_are() {
    for start in ["Locals", "Steps"] {
        assert_eq!(names(&wide(start, 0.0).expect("no limit")), ["End"], "{start}");
    }
}

#[test]
fn functions_that_go_down_inside_of_rules_that_go_down_fit_together() {
    let model = wide("Both", deepest("Both") - 1.0).expect("no limit");
    assert_eq!(model.count("End"), 1);
}

cga! { grammar Calls in "rules/functions.cga"; }

#[test]
fn a_chain_of_150_functions_with_arrays_fits() {
    let model = on_a_small_stack(|| Calls::default().generate(&lot())).expect("no limit");
    assert_eq!(model.leaves().next().expect("a leaf").size().x, 159.0);
}

cga! {
    grammar Doubling;
    f0(n) = f1(n) + f1(n) f1(n) = f2(n) + f2(n) f2(n) = f3(n) + f3(n) f3(n) = f4(n) + f4(n) f4(n) = f5(n) + f5(n)
    f5(n) = g0(n) + g0(n) g0(n) = g1(n) + g1(n) g1(n) = g2(n) + g2(n) g2(n) = g3(n) + g3(n) g3(n) = g4(n) + g4(n)
    g4(n) = g5(n) + g5(n) g5(n) = h0(n) + h0(n) h0(n) = h1(n) + h1(n) h1(n) = h2(n) + h2(n) h2(n) = h3(n) + h3(n)
    h3(n) = h4(n) + h4(n) h4(n) = h5(n) + h5(n) h5(n) = n + scope.sx
    Lot --> s(f0(1), 1, 1) X.
}

#[test]
fn doubling_17_times_is_no_recursion() {
    let model = Doubling::default().generate(&lot()).expect("no limit");
    assert_eq!(model.leaves().next().expect("a leaf").size().x, 131_072.0 * 9.0);
}

cga! {
    /// Operands in rules that call each other: what they defer runs on top of the stack.
    grammar Inlining;
    attr levels = 3000
    attr nested = 5
    @StartRule
    Recursive --> inline Level(0) End.
    Level(n) --> case n < levels : s(^0.999, ^1, ^1) X. Level(n + 1) else : X.
    @StartRule
    AfterDeep --> Deep(0)
    Deep(n) --> case n < levels : Deep(n + 1) else : inline Level(0) End.
    @StartRule
    AllTheWay --> Each(0)
    Each(n) --> case n < levels : inline { X. } Each(n + 1) else : End.
    @StartRule
    Nested --> Nest(nested)
    Nest(n) --> case n > 0 : inline { X. Nest(n - 1) } End. else : X.
    @StartRule
    Modified --> Modify(200)
    Modify(n) --> case n > 0 : modify(f) { top : s(^0.99, ^1, ^0.99) X. } Modify(n - 1) else : End.
    @StartRule
    Recomposed --> Recompose(nested)
    Recompose(n) --> case n > 0 : inline(recompose) { X. Recompose(n - 1) } End. else : X.
}

#[test]
fn operands_find_stack_or_end_with_an_error() {
    fn from(start: &str, nested: f64) -> Result<Model, Error> {
        let settings = Settings { start: Some(start.to_owned()), ..deep() };
        on_a_small_stack(move || Inlining { nested, ..Inlining::default() }.generate_with(&lot(), &settings))
    }
    for start in ["Recursive", "AfterDeep", "AllTheWay", "Modified"] {
        assert_eq!(names(&from(start, 0.0).expect("enough stack")), ["End"], "{start}");
    }
    for start in ["Nested", "Recomposed"] {
        assert_eq!(names(&from(start, 12.0).expect("enough stack")), ["End"]);
        let error = from(start, 100_000.0).expect_err("operands nest too deep");
        assert!(matches!(error, Error::Limit { what: LimitKind::Depth, .. }), "{start}: {error}");
    }
}
