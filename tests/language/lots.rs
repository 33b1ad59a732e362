//! Lots with attributes, a grammar and a start rule of their own.

use cga::{Batches, Error, FaultKind, Grammar, Grammars, Limits, Model, Settings, Shape, Value, WrongLots, cga};

use crate::{leaves, lines, model, model_of};

cga! {
    grammar House;
    @Range(min = 1, max = 50, restricted = true)
    attr height = 6
    attr roof = height / 2
    attr material = "brick"
    attr floors = [3, 3]
    @Enum("flat", "hip", restricted = true)
    attr form = "flat"
    attr modern = false
    @StartRule
    Lot    --> print(height + " " + roof + " " + material + " " + sum(floors) + " " + form + " " + modern) extrude(height) House.
    @StartRule
    Garden --> print("garden " + height) Garden.
}

cga! { grammar Park;  attr height = 8  attr trees = rint(rand(1, 1000))  @StartRule Lot --> print(height + " " + trees) Lawn. }

fn lot() -> Shape {
    Shape::rectangle(10.0, 10.0)
}

#[test]
fn values_of_a_lot_win_over_fields_and_defaults() {
    // As object attributes win in CityEngine; a field cannot tell whether the program set it.
    let house = House { height: 20.0, ..House::default() };
    let own = lot().attribute("height", 12.5).attribute("material", "wood").attribute("modern", true);
    assert_eq!(lines(&house.generate(&own).unwrap()), ["12.5 6.25 wood 6 flat true"]);
    assert_eq!(lines(&house.generate(&lot()).unwrap()), ["20 10 brick 6 flat false"]);
    // What follows from the value is computed with it, unless the lot has that too.
    let own = own.attribute("roof", 1).attribute("floors", Value::Floats([4.0, 5.0].into())).attribute("form", "hip");
    assert_eq!(lines(&house.generate(&own).unwrap()), ["12.5 1 wood 9 hip true"]);
    // A second value replaces the first.
    assert_eq!(lines(&house.generate(&own.attribute("height", 3)).unwrap()), ["3 1 wood 9 hip true"]);
}

#[test]
fn every_way_to_run_knows_the_values() {
    let (house, own) = (House::default(), lot().attribute("height", 12.5));
    let dynamic: Box<dyn Grammar + Send + Sync> = house.boxed();
    let settings = Settings::default();
    let volume = |model: Model| model.volume();
    assert_eq!(volume(house.generate(&own).unwrap()), 1250.0);
    assert_eq!(volume(dynamic.generate(&own).unwrap()), 1250.0);
    assert_eq!(volume(house.session(&settings).unwrap().generate(&own).unwrap()), 1250.0);
    let mut sink = Model::new();
    dynamic.session(&settings).unwrap().run(&own, &mut sink).unwrap();
    house.run(&own, &settings, &mut sink).unwrap();
    let _ = house.generate_all(&[own.clone(), own.clone()], &settings).unwrap().replay(&mut sink);
    assert_eq!(volume(sink), 4.0 * 1250.0);
    let used = house.used_values(&own, &settings).unwrap();
    assert!(
        used.contains(&("height".into(), Value::Float(12.5))) && used.contains(&("roof".into(), Value::Float(6.25))),
        "{used:?}"
    );
}

#[test]
fn start_rules_of_lots() {
    let house = House::default();
    let garden = lot().start("Garden").attribute("height", 2);
    assert_eq!(leaves(&house.generate(&garden).unwrap()), ["Garden"]);
    // It wins over the settings, but not over the rule of a call.
    let settings = Settings { start: Some("Lot".into()), ..Settings::default() };
    assert_eq!(lines(&house.generate_with(&garden, &settings).unwrap()), ["garden 2"]);
    assert_eq!(leaves(&house.generate_from("Lot", &garden).unwrap()), ["House"]);
    assert_eq!(
        house.generate_from("Gardn", &garden).unwrap_err().to_string(),
        "`Gardn` is not a start rule; the start rules are Lot, Garden"
    );
}

/// The error of a lot.
fn error(lot: &Shape) -> String {
    House::default().generate(lot).unwrap_err().to_string()
}

#[test]
fn errors_name_the_lot_and_all_that_is_wrong() {
    let own = lot().named("Mill Street 4");
    assert_eq!(
        error(&own.clone().attribute("hight", 3)),
        "lot `Mill Street 4`: unknown attribute `hight`; did you mean `height`?"
    );
    assert_eq!(
        error(&own.clone().attribute("height", "tall").attribute("form", "dome").start("Lott")),
        "lot `Mill Street 4`: attribute `height` is a number, and the value is text; also, attribute `form`: `dome` is not one of flat, hip; also, `Lott` is not a start rule; the start rules are Lot, Garden"
    );
    assert_eq!(
        error(&lot().attribute("height", 99)),
        "a lot without a name: attribute `height`: 99 is outside of 1 to 50"
    );
    assert_eq!(
        error(&lot().attribute("height", f64::NAN)),
        "a lot without a name: attribute `height`: NaN is outside of 1 to 50"
    );
    // A batch has the index too, and the first lot in the list counts.
    let lots = [own.clone(), own.clone().attribute("hight", 3), own.attribute("x", 3)];
    let error = House::default().generate_all(&lots, &Settings::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "initial shape 1: lot `Mill Street 4`: unknown attribute `hight`; did you mean `height`?"
    );
    assert!(matches!(error.error, Error::Lot { .. }) && error.shape == Some(1));
}

#[test]
fn by_choice_wrong_lots_are_faults() {
    let settings = Settings { wrong_lots: WrongLots::Fault, ..Settings::default() };
    let own =
        lot().named("4").attribute("height", 99).attribute("material", "wood").attribute("color", "red").start("Lott");
    let house = House { height: 7.0, ..House::default() };
    let made = house.generate_with(&own, &settings).unwrap();
    assert_eq!(lines(&made), ["7 3.5 wood 6 flat false"]);
    let faults: Vec<String> = made.faults().iter().map(|fault| fault.to_string()).collect();
    assert_eq!(
        faults,
        [
            "lot `4`: unknown attribute `color`; the attributes are height, roof, material, floors, form, modern",
            "lot `4`: attribute `height`: 99 is outside of 1 to 50",
            "lot `4`: `Lott` is not a start rule; the start rules are Lot, Garden",
        ]
    );
    assert!(made.faults().iter().all(|fault| fault.kind == FaultKind::Value));
    // Sessions tell it for each lot.
    let mut session = house.session(&settings).unwrap();
    assert_eq!([0; 2].map(|_| session.generate(&own).unwrap().faults().len()), [3, 3]);
    // A computed default stays computed.
    let own = lot().attribute("roof", "high");
    assert_eq!(lines(&house.generate_with(&own, &settings).unwrap()), ["7 3.5 brick 6 flat false"]);
}

#[test]
fn choices_may_come_from_the_lot_itself() {
    cga! {
        grammar Chosen;
        attr list = ["a", "b"]
        @Enum(valuesAttr = list, restricted = true)
        attr one = "a"
        Lot --> print(one) X.
    }
    let list = || Value::Texts(["x", "y"].map(cga::Text::from).into());
    let made = |lot: Shape| Chosen::default().generate(&lot);
    assert_eq!(lines(&made(lot().attribute("one", "y").attribute("list", list())).unwrap()), ["y"]);
    // The default is always allowed, a value of the field that the list lacks is not.
    assert_eq!(lines(&made(lot().attribute("list", list())).unwrap()), ["a"]);
    let chosen = Chosen { one: "b".into(), ..Chosen::default() };
    let error = chosen.generate(&lot().attribute("list", list())).unwrap_err().to_string();
    assert_eq!(error, "a lot without a name: attribute `one`: `b` is not one of x, y");
    let settings = Settings { wrong_lots: WrongLots::Fault, ..Settings::default() };
    let made = chosen.generate_with(&lot().attribute("list", list()), &settings).unwrap();
    assert_eq!((lines(&made), made.faults().len()), (vec!["b".to_owned()], 1));
}

#[test]
fn attributes_of_imports_styles_and_cycles() {
    cga! { grammar Imports = r#"import imp : "rules/import/inner.cga"  Lot --> imp(h = 3).Say imp.Say"#; }
    let made = Imports::default().generate(&Shape::rectangle(2.0, 2.0).attribute("imp.h", 8)).unwrap();
    assert_eq!(lines(&made), ["inner3 (2)[3,30]", "inner8 (2)[8,80]"]);
    cga! { grammar Cycle;  attr a = case p(1) : b + 1 else : 0  attr b = case p(1) : a + 1 else : 0  Lot --> print(a + b) X. }
    assert!(matches!(Cycle::default().generate(&lot()).unwrap_err(), Error::Cycle { .. }));
    assert_eq!(lines(&Cycle::default().generate(&lot().attribute("b", 5)).unwrap()), ["11"]);
}

/// The grammars of a small city.
fn city() -> Grammars {
    Grammars::new().with(House::default()).with_named("green", Park::default())
}

/// Lots of both kinds.
fn lots(count: u32) -> Vec<Shape> {
    let lot = |number: u32| {
        let lot = lot().at([f64::from(number) * 12.0, 0.0, 0.0]).seed(number.into()).named(format!("lot {number}"));
        match number % 3 {
            0 => lot.grammar("green").attribute("height", number % 5),
            1 => lot.grammar("House").attribute("height", 1 + number % 40),
            _ => lot.start(if number.is_multiple_of(2) { "Garden" } else { "Lot" }),
        }
    };
    (0..count).map(lot).collect()
}

#[test]
fn lots_of_several_grammars() {
    let city = city();
    assert_eq!(city.names().collect::<Vec<_>>(), ["House", "green"]);
    assert!(city.get("green").is_some_and(|grammar| grammar.name() == "Park") && city.get("Park").is_none());
    let all = city.generate_all(&lots(12), &Settings::default()).unwrap();
    assert_eq!((all.count("House"), all.count("Lawn"), all.count("Garden")), (6, 4, 2));
    // Each model equals the model of a run on that lot alone.
    for (lot, batch) in lots(12).iter().zip(&all) {
        let alone = city.generate(lot).unwrap();
        assert_eq!(lines(&alone), lines(&batch.sink));
        let mut sink = Model::new();
        assert_eq!(city.run(lot, &Settings::default(), &mut sink).unwrap(), *batch.sink.report());
        assert_eq!(sink.bounds(), batch.sink.bounds());
    }
    let unknown = lot().named("9").grammar("Shop");
    assert_eq!(
        city.generate(&unknown).unwrap_err().to_string(),
        "lot `9`: `Shop` is not a grammar of the set; the grammars are House, green"
    );
    let settings = Settings { wrong_lots: WrongLots::Fault, ..Settings::default() };
    let made = city.generate_with(&unknown, &settings).unwrap();
    assert_eq!((leaves(&made), made.faults().len()), (vec!["House"], 1));
    assert_eq!(
        Grammars::new().generate(&lot()).unwrap_err().to_string(),
        "a lot without a name: the set has no grammars"
    );
    assert!(matches!(Grammars::new().generate_with(&unknown, &settings), Err(Error::Lot { .. })));
    // A grammar that is refused, is refused where its first lot is.
    let city = Grammars::new().with(Park::default()).with(House { height: 99.0, ..House::default() });
    let lots = [lot(), lot().grammar("House"), lot()];
    let error = city.generate_all(&lots, &Settings::default()).unwrap_err();
    assert_eq!(error.to_string(), "initial shape 1: attribute `height`: 99 is outside of 1 to 50");
    // Two grammars of one name are not confused.
    let city = Grammars::new().with(House::default()).with(House { height: 12.0, ..House::default() });
    for lot in [lot().named("9"), lot().named("9").grammar("House")] {
        assert_eq!(
            city.generate(&lot).unwrap_err().to_string(),
            "lot `9`: the set has several grammars of the name `House`; add one of them with `with_named`"
        );
    }
    // A boxed grammar has the same name as without its box.
    let boxed = Grammars::new().with(Park::default()).with_boxed(House::default().boxed());
    assert_eq!(boxed.names().collect::<Vec<_>>(), ["Park", "House"]);
    let house = lot().grammar("House").seed(4);
    let unboxed = Grammars::new().with(House::default()).generate(&house).unwrap();
    assert_eq!(boxed.generate(&house).unwrap().to_glb().unwrap(), unboxed.to_glb().unwrap());
    // A name that is given replaces the grammar of that name.
    assert_eq!(Grammars::new().with(Park::default()).with_named("Park", House::default()).names().len(), 1);
}

/// The bytes of all that a city has.
fn bytes(all: &Batches<Model>) -> (Vec<u8>, String) {
    (all.to_glb().unwrap(), format!("{:?}", all.report()))
}

#[cfg(feature = "rayon")]
#[test]
fn the_bytes_do_not_depend_on_threads() {
    let made = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| bytes(&city().generate_all(&lots(288), &Settings::default()).unwrap()))
    };
    let one = made(1);
    assert_eq!(one, made(2));
    assert_eq!(one, made(7));
}

#[test]
fn what_a_session_keeps_for_lots_does_not_show() {
    cga! {
        grammar Windows;
        attr width = 2
        attr tint = "#336699"
        @StartRule
        Lot --> extrude(9) comp(f) { side : split(y) { { ~3 : split(x) { { ~width : Tile }* } }* } | top : Roof. }
        Tile --> split(x) { ~1 : Wall. | 0.8 : color(tint) Glass. | ~1 : Wall. }
    }
    let windows = Windows::default();
    // More different values than a session keeps, and values that come again.
    let lots: Vec<Shape> = (0..200_u32)
        .map(|i| {
            let lot = Shape::rectangle(12.0, 9.0).at([f64::from(i) * 15.0, 0.0, 0.0]).seed(i.into());
            if i % 4 == 3 {
                lot
            } else {
                lot.attribute("width", 1 + i * i % 23).attribute("tint", ["red", "#00ff00"][i as usize % 2])
            }
        })
        .collect();
    let mut session = windows.session(&Settings::default()).unwrap();
    let (mut kept, mut alone) = (Model::new(), Model::new());
    for lot in &lots {
        session.run(lot, &mut kept).unwrap();
        windows.run(lot, &Settings::default(), &mut alone).unwrap();
    }
    assert!(kept.to_glb().unwrap() == alone.to_glb().unwrap());
    // The same values as fields give the same leaves.
    let field = Windows { width: 5.0, ..Windows::default() }.generate(&lot()).unwrap();
    let of_lot = windows.generate(&lot().attribute("width", 5)).unwrap();
    assert!(field.to_glb().unwrap() == of_lot.to_glb().unwrap());
}

#[test]
fn rules_never_see_data_that_only_runs_read() {
    // `set` and inheritance go on as without it.
    cga! { grammar Sets;  attr h = 2  Lot --> set(h, h + 1) extrude(h) comp(f) { top : print(h) Top. | all : NIL } }
    assert_eq!(lines(&model(&Sets::default())), ["3"]);
    assert_eq!(lines(&Sets::default().generate(&lot().attribute("h", 7)).unwrap()), ["8"]);
    assert_eq!(leaves(&model_of(&Sets::default(), "Lot")), ["Top"]);
}

#[test]
fn a_grammar_that_only_runs_knows_lots_too() {
    #[derive(Clone)]
    struct Host(House);

    impl Grammar for Host {
        fn name(&self) -> &'static str {
            "Host"
        }
        fn attributes(&self) -> &[cga::Attribute] {
            self.0.attributes()
        }
        fn start_rules(&self) -> &[cga::StartRule] {
            self.0.start_rules()
        }
        fn attribute_get(&self, index: usize) -> Option<Value> {
            self.0.attribute_get(index)
        }
        fn attribute_set(&mut self, index: usize, value: Value) {
            self.0.attribute_set(index, value);
        }
        fn attribute_reset(&mut self, index: usize) {
            self.0.attribute_reset(index);
        }
        fn boxed(&self) -> Box<dyn Grammar + Send + Sync> {
            Box::new(self.clone())
        }
        fn used_values(&self, shape: &Shape, settings: &Settings) -> Result<Vec<(cga::Text, Value)>, Error> {
            self.0.used_values(shape, settings)
        }
        fn run(&self, _: &Shape, settings: &Settings, sink: &mut dyn cga::Sink) -> Result<cga::Report, Error> {
            // The shape is not handed on, so only what the session sets counts.
            self.0.run(&lot(), settings, sink)
        }
    }

    let city = Grammars::new().with(Host(House::default()));
    let own = lot().named("5").attribute("height", 12);
    assert_eq!(city.generate(&own).unwrap().volume(), 1200.0);
    assert_eq!(leaves(&city.generate(&own.clone().start("Garden")).unwrap()), ["Garden"]);
    assert_eq!(
        city.generate(&own.clone().attribute("h", 1)).unwrap_err().to_string(),
        "lot `5`: unknown attribute `h`; the attributes are height, roof, material, floors, form, modern"
    );
    let settings = Settings { wrong_lots: WrongLots::Fault, limits: Limits::default(), ..Settings::default() };
    assert_eq!(city.generate_with(&own.attribute("h", 1).start("Lott"), &settings).unwrap().faults().len(), 2);
}

#[test]
fn kept_values_are_told_apart_by_their_bits() {
    cga! { grammar Signs;  attr x = 1  attr list = [1]  Lot --> print(1 / x + " " + 1 / list[0]) X. }
    let signs = Signs::default();
    let mut session = signs.session(&Settings::default()).unwrap();
    let zeros = [0.0, -0.0, f64::NAN];
    for x in zeros {
        for element in zeros {
            let own = lot().attribute("x", x).attribute("list", Value::Floats([element].into()));
            let [kept, again] = [0; 2].map(|_| lines(&session.generate(&own).unwrap()));
            assert_eq!((&kept, &again), (&lines(&signs.generate(&own).unwrap()), &kept));
        }
    }
}

#[test]
fn wrong_values_do_not_take_others_with_them() {
    cga! {
        grammar Chosen;
        attr height = 6
        @Enum("p", "q", restricted = true)
        attr list = "p"
        @Enum(valuesAttr = list, restricted = true)
        attr one = "p"
        Lot --> print(height + " " + list + " " + one) X.
    }
    let settings = Settings { wrong_lots: WrongLots::Fault, ..Settings::default() };
    let made = |chosen: &Chosen, lot: Shape| {
        let made = chosen.generate_with(&lot, &settings).unwrap();
        (lines(&made)[0].clone(), made.faults().iter().map(|fault| fault.message.clone()).collect::<Vec<_>>())
    };
    // The list is left out, as the program's own value is not in it.
    let other = Chosen { list: "q".into(), one: "q".into(), ..Chosen::default() };
    let (line, faults) = made(&other, lot().attribute("height", 12).attribute("list", "p"));
    assert_eq!(
        (line.as_str(), faults),
        ("12 q q", vec!["a lot without a name: attribute `one`: `q` is not one of p".to_owned()])
    );
    // The order of the values makes no difference.
    let own = |names: [&str; 3]| {
        names
            .into_iter()
            .fold(lot(), |lot, name| if name == "height" { lot.attribute(name, 12) } else { lot.attribute(name, "y") })
    };
    let orders = [["height", "one", "list"], ["one", "list", "height"], ["list", "one", "height"]];
    for order in orders {
        let (line, faults) = made(&Chosen::default(), own(order));
        assert_eq!((line.as_str(), faults.len()), ("12 p p", 2), "{order:?}");
    }
    // Faults have a limit.
    let many = (0..3000).fold(lot(), |lot, number| lot.attribute(format!("x{number}"), 1));
    let report = Chosen::default().generate_with(&many, &settings).unwrap();
    assert_eq!((report.faults().len(), report.report().faults_left_out()), (1000, 2000));
}

#[test]
fn start_rules_of_settings_need_not_be_in_all_grammars() {
    let settings = Settings { start: Some("Garden".into()), ..Settings::default() };
    let lots = [lot().grammar("House"), lot().grammar("green").start("Lot")];
    let all = city().generate_all(&lots, &settings).unwrap();
    assert_eq!((all.count("Garden"), all.count("Lawn")), (1, 1));
    let error = city().generate_with(&lot().named("7").grammar("green"), &settings).unwrap_err();
    assert_eq!(error.to_string(), "lot `7`: `Garden` is not a start rule; the start rules are Lot");
    // A stopped watch ends a run before its lot is looked at.
    let watch = cga::Watch::new();
    watch.stop();
    let settings = Settings { watch: Some(watch), ..Settings::default() };
    assert!(city().generate_with(&lot().grammar("Shop"), &settings).unwrap().report().stopped);
}
