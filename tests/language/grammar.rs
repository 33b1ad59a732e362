//! Grammars as values: attributes, start rules, limits, random choices.

use cga::{Attribute, Error, Grammar, LimitKind, Limits, Model, Range, Settings, Shape, Sink, ValueType, cga};

fn lot() -> Shape {
    Shape::rectangle(10.0, 10.0)
}

fn names(model: &Model) -> Vec<&str> {
    model.leaves().map(|leaf| leaf.rule()).collect()
}

fn only(what: Limits) -> Settings {
    Settings { limits: what, ..Settings::default() }
}

cga! {
    /// A house.
    @Allow(unused_attribute, unused_parameter, rule_not_reached)
    pub grammar House;

    @Group("Size", "Main")
    @Range(min = 3, max = 60, stepsize = 0.5)
    @Order(2)
    /// Height in metres.
    attr height = 2 * 6
    @Description("How deep the windows lie.")
    @Range(min = 0, max = 1, restricted = false)
    attr depth = 0.2
    @Group("Look")
    attr colour = "#ff0000"
    @Hidden
    attr lit = false
    attr storeys = rint(rand(2, 5))
    attr label = "house " + storeys

    @StartRule
    Lot --> extrude(height) set(material.name, label) split(y) { { ~height / storeys : Storey }* }
    Storey --> color(colour) Wall.
    Other --> Storey Storey
    Named(n) --> Wall.
}

#[test]
fn attributes_are_fields_and_a_table() {
    let house = House::default();
    assert_eq!((house.height, house.depth, house.lit, house.storeys), (12.0, 0.2, false, None));
    assert_eq!((house.colour.as_str(), &house.label), ("#ff0000", &None));
    let table = house.attributes();
    let height = Attribute::new("height", 12.0)
        .range(Range::new(3.0, 60.0, 0.5, true))
        .group(["Size", "Main"])
        .about("Height in metres.")
        .order(2.0);
    // A group goes on until the next one.
    let depth = Attribute::new("depth", 0.2)
        .range(Range::new(0.0, 1.0, 0.0, false))
        .group(["Size", "Main"])
        .about("How deep the windows lie.");
    assert_eq!(table[..2], [height, depth]);
    let rest = table[2..].iter().map(|row| (row.name.as_str(), row.ty, row.default.clone(), row.hidden));
    assert_eq!(
        rest.collect::<Vec<_>>(),
        [
            ("colour", ValueType::Text, Some("#ff0000".into()), false),
            ("lit", ValueType::Bool, Some(false.into()), true),
            ("storeys", ValueType::Float, None, false),
            ("label", ValueType::Text, None, false),
        ]
    );
}

#[test]
fn attributes_can_be_read_and_set_by_name() {
    let mut grammar: Box<dyn Grammar> = Box::new(House::default());
    assert_eq!((grammar.get("height"), grammar.get("colour")), (Ok(12.0.into()), Ok("#ff0000".into())));
    assert!(grammar.get("storeys").is_err());
    for (name, text) in [("height", "20"), ("storeys", "5"), ("lit", "true"), ("label", "Nº 5")] {
        assert_eq!(grammar.set_text(name, text), Ok(()));
        assert_eq!(grammar.get(name).map(|value| value.to_string()), Ok(text.to_owned()));
    }
    assert_eq!(grammar.generate(&lot()).expect("no limit").len(), 5);
    let refused = grammar.set("height", 61.0.into()).expect_err("out of range");
    assert_eq!(refused.to_string(), "attribute `height`: 61 is outside of 3 to 60");
}

#[test]
fn a_computed_attribute_is_drawn_from_the_seed_unless_it_is_given() {
    let storeys = |seed| House::default().generate(&lot().seed(seed)).expect("no limit").len();
    let drawn: Vec<usize> = (0..50).map(storeys).collect();
    assert!((2..=5).all(|count| drawn.contains(&count)) && drawn.iter().all(|count| (2..=5).contains(count)));
    let house = House { storeys: Some(7.0), ..House::default() };
    let model = house.generate(&lot()).expect("no limit");
    // Values that are computed from a given value follow it.
    assert_eq!(model.leaves().next().expect("a leaf").material().name.as_deref(), Some("house 7"));
    assert_eq!(model.len(), 7);
}

#[test]
fn a_restricted_range_is_checked_when_a_run_begins() {
    let run = |height, depth| House { height, depth, ..House::default() }.generate(&lot());
    assert!(run(60.0, 5.0).is_ok());
    for wrong in [2.0, 61.0, f64::NAN, f64::INFINITY] {
        let error = run(wrong, 0.2).expect_err("out of range");
        assert_eq!(
            error,
            Error::Attribute { name: "height".into(), message: format!("{wrong} is outside of 3 to 60") }
        );
    }
}

#[test]
fn a_program_can_choose_among_grammars() {
    cga! { grammar Flat; Lot --> Flat. }
    let rules = cga! { Lot --> Value. };
    let list: [Box<dyn Grammar>; 3] = [Box::new(House::default()), Box::new(Flat::default()), Box::new(rules)];
    let models = list.iter().map(|grammar| grammar.generate(&lot()).expect("no limit").rules().join(" "));
    assert_eq!(models.collect::<Vec<_>>(), ["Wall", "Flat", "Value"]);
    assert_eq!(list.iter().map(|grammar| grammar.name()).collect::<Vec<_>>(), ["House", "Flat", ""]);
    let mut model = Model::new();
    let report = list[0].run(&lot(), &Settings::default(), &mut model as &mut dyn Sink).expect("no limit");
    assert_eq!(report.leaves as usize, model.len());
}

#[test]
fn runs_start_where_they_are_told_to() {
    let house = House::default();
    let starts = house.start_rules().iter().map(|start| (start.name.as_str(), start.marked, start.hidden));
    assert_eq!(starts.collect::<Vec<_>>(), [("Lot", true, false), ("Storey", false, false), ("Other", false, false)]);
    assert_eq!(house.generate_from("Other", &lot()).expect("no limit").len(), 2);
    let error = house.generate_from("Named", &lot()).expect_err("it has a parameter");
    assert_eq!(error.to_string(), "`Named` is not a start rule; the start rules are Lot, Storey, Other");
    cga! { grammar First; Helper(_n) --> X. First --> Helper(1) Second --> Y. }
    assert_eq!(names(&First::default().generate(&lot()).expect("no limit")), ["X"]);
}

#[test]
fn a_limit_ends_a_run_with_the_trail() {
    let rules = cga! { Lot --> extrude(10) split(y) { { 0.1 : Slab }* } Slab --> split(x) { { 0.1 : Tile. }* } };
    let limits = Limits { shapes: 500, ..Limits::default() };
    let error = rules.generate_with(&lot(), &only(limits)).expect_err("too many");
    assert_eq!(error, Error::Limit { what: LimitKind::Shapes, limit: 500, trail: vec!["Lot".into(), "Slab".into()] });
    assert_eq!(rules.generate(&lot()).expect("10000 tiles").len(), 10_000);
}

#[test]
fn the_limit_of_depth_counts_rules_that_reach_themselves() {
    let rules = cga! {
        attr deep = 1
        Lot --> A(0)
        A(n) --> case n < deep : B(n + 1) else : End.
        B(n) --> A(n)
    };
    let run = |deep: f64, depth| {
        let mut rules = rules.clone();
        rules.deep = deep;
        rules.generate_with(&lot(), &only(Limits { depth, ..Limits::default() })).map(|model| model.len())
    };
    assert_eq!(run(5.0, 10), Ok(1));
    let error = run(6.0, 10).expect_err("12 levels");
    assert!(matches!(error, Error::Limit { what: LimitKind::Depth, limit: 10, .. }), "{error}");
    assert_eq!(
        run(100.0, 0).map_err(|error| error.to_string()),
        Err("more depth than the limit of 0 allows (in Lot > A)".into())
    );
}

#[test]
fn equal_seeds_give_equal_models() {
    let rules = cga! {
        Lot --> extrude(rand(5, 10)) comp(f) { side : Front | top : Roof. }
        Front --> split(x) { { ~rand(1, 3) : Bay }* }
        Bay --> 50% : Window(rand) 25% : NIL else : Wall.
        Window(n) --> s(^1, ^n, ^1) Window.
    };
    let print = |seed| {
        let model = rules.generate(&lot().seed(seed)).expect("no limit");
        model.leaves().map(|leaf| format!("{} {:?}\n", leaf.rule(), leaf.scope())).collect::<String>()
    };
    assert_eq!(print(1), print(1));
    assert_ne!(print(1), print(2));
}

#[test]
fn shares_of_a_stochastic_rule_hold_over_many_seeds() {
    let rules = cga! {
        Lot --> 30% : A. 20% : B else : split(x) { ~1 : Value(40% : 1 else : 2) }
        B --> 50% : B1. else : B2.
        Value(n) --> case n == 1 : One. else : Two.
    };
    let mut model = Model::new();
    for seed in 0..10_000 {
        rules.run(&lot().seed(seed), &Settings::default(), &mut model).expect("no limit");
    }
    // Three standard deviations are below 150.
    for (name, expected) in [("A", 3000), ("B1", 1000), ("B2", 1000), ("One", 2000), ("Two", 3000)] {
        let count = model.count(name);
        assert!(count.abs_diff(expected) < 150, "{name}: {count} instead of about {expected}");
    }
}

#[test]
fn set_changes_an_attribute_for_a_shape_and_its_descendants() {
    let rules = cga! {
        attr height = 1
        attr name = "a"
        attr wide = true
        width = case wide : 2 else : 1
        Lot --> [ set(height, height + 1) set(name, name + "b") set(wide, !wide) Part ] Part
        Part --> s(width, height, 1) set(material.name, name) Part.
    };
    let model = rules.generate(&lot()).expect("no limit");
    let leaves =
        model.leaves().map(|leaf| (leaf.size().x, leaf.size().y, leaf.material().name.clone().unwrap_or_default()));
    assert_eq!(leaves.collect::<Vec<_>>(), [(1.0, 2.0, "ab".into()), (2.0, 1.0, "a".into())]);
}

#[test]
fn brackets_work_on_a_copy() {
    let rules = cga! {
        Lot --> s(2, 4, 6) [ s(1, 1, 1) center(xyz) t(1, 0, 0) [ s(3, 3, 3) center(x) In. ] ] [ NIL ] [ [ NIL ] A. ] center(x) Out.
    };
    let model = rules.generate(&lot()).expect("no limit");
    let leaves = model.leaves().map(|leaf| (leaf.rule(), leaf.size().x, leaf.scope().origin.x));
    // In: at 0.5 after centring the box of 1 in the one of 2, 1.5 after the move, and 0.5 with its middle kept.
    assert_eq!(leaves.collect::<Vec<_>>(), [("In", 3.0, 0.5), ("A", 2.0, 0.0), ("Out", 2.0, 4.0)]);
}

#[test]
fn a_branch_may_stand_in_brackets() {
    let rules = cga! {
        Lot --> [ case scope.sx > 5 : Wide. NIL Wider. else : Narrow. ] [ 100% : Sure. else : Never. ] End.
        Small --> s(1, 1, 1) Lot
    };
    assert_eq!(names(&rules.generate(&lot()).expect("no limit")), ["Wide", "Wider", "Sure", "End"]);
    assert_eq!(names(&rules.generate_from("Small", &lot()).expect("no limit")), ["Narrow", "Sure", "End"]);
}

#[test]
fn overloads_differ_in_their_number_of_parameters() {
    let rules = cga! {
        Lot --> Part Part(1) Part(1, 2)
        Part --> f(0, 0, 0)
        Part(a) --> Pair(a)
        Part(a, b) --> s(f(a), f(a, b), 1) Two.
        f(_x, _y, _z) --> Zero.
        Pair(x) --> s(f(x), 1, 1) One.
        f(x) = x + 1
        f(x, y) = f(x) + f(y)
    };
    let model = rules.generate(&lot()).expect("no limit");
    let leaves = model.leaves().map(|leaf| (leaf.rule(), leaf.size().x, leaf.size().y));
    assert_eq!(leaves.collect::<Vec<_>>(), [("Zero", 10.0, 0.0), ("One", 2.0, 1.0), ("Two", 2.0, 5.0)]);
}

#[test]
fn what_follows_nil_still_runs() {
    let rules = cga! {
        Lot --> extrude(3) comp(f) { top : report("a", geometry.area) NIL report("b", geometry.area * 2) NIL }
        Empty --> extrude(3) NIL comp(f) { top : T. }
        Bare --> extrude(3) NIL
        Slots --> extrude(2) split(x) { 1 : NIL report("slot", 1) | ~1 : NIL X. }
        Depends --> case scope.sx > 5 : NIL else : extrude(1)
    };
    let run = |start: &str| rules.generate_from(start, &lot()).expect("no limit");
    let model = run("Lot");
    assert_eq!(model.leaves().count(), 0);
    let sums = |key: &str| model.reports().get(key).map(|values| values.summary().sum);
    assert_eq!((sums("a"), sums("b")), (Some(100.0), Some(200.0)));
    for (start, leaves) in [("Empty", &["T"][..]), ("Bare", &[]), ("Slots", &["X"]), ("Depends", &[])] {
        assert_eq!(names(&run(start)), leaves, "{start}");
    }
}

#[test]
fn a_prefix_without_an_import_makes_a_rule_of_its_own() {
    let rules = cga! {
        Lot --> Tile foo.Tile foo.Tile(2) foo.Tile. foo.
        Tile --> A.
        foo.Tile --> B.
        foo.Tile(n) with ( m := n + 1 ) --> s(m, 1, 1) C.
        Last --> foo.
        Other --> D.
        @Allow(rule_not_reached)
        bar.Other --> E.
    };
    let model = rules.generate(&lot()).expect("no limit");
    assert_eq!(names(&model), ["A", "B", "C", "foo.Tile", "foo"]);
    assert_eq!(names(&rules.generate_from("Last", &lot()).expect("no limit")), ["foo"]);
    assert_eq!(names(&rules.generate_from("Other", &lot()).expect("no limit")), ["D"]);
}
