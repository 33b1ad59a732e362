//! Attributes through `dyn Grammar`: defaults, copies, and the values that a run uses.

use cga::{AttributeError, Error, Grammar, Settings, Shape, Value, cga};

cga! {
    #[derive(PartialEq)]
    grammar House;
    @Range(min = 3, max = 60)
    attr height = 12
    attr wall = "brick"
    attr heights = [4, 3; 3, 3]
    attr storeys = rint(rand(2, 500))
    attr width = scope.sx
    attr mixed = storeys * 2 + width
    style Low
    attr height = 4
    style Default
    @StartRule
    Lot --> print(storeys) print(width) print(mixed) print(height) extrude(height) set(material.name, wall) House(size(heights))
    House(n) --> print(n) House.
}

fn house() -> Box<dyn Grammar + Send + Sync> {
    Box::new(House::default())
}

#[test]
fn reset_gives_defaults_again_also_computed_ones() {
    let mut house = House::default();
    let grammar: &mut dyn Grammar = &mut house;
    for (name, text) in [("height", "20"), ("wall", "stone"), ("heights", "[1]"), ("storeys", "7")] {
        grammar.set_text(name, text).unwrap();
    }
    assert_eq!(grammar.get("storeys"), Ok(Value::Float(7.0)));
    for attribute in grammar.attributes().to_vec() {
        grammar.reset(&attribute.name).unwrap();
        assert_eq!(grammar.get(&attribute.name).ok(), attribute.default, "{}", attribute.name);
    }
    assert_eq!(grammar.get("storeys"), Err(AttributeError::Computed { name: "storeys".into() }));
    assert!(
        matches!(grammar.reset("hieght"), Err(AttributeError::Unknown { near: Some(near), .. }) if near == "height")
    );
    grammar.attribute_reset(99);
    assert!(house == House::default());
}

#[test]
fn a_copy_has_the_same_values_and_its_own() {
    let mut first = house();
    first.set_text("height", "20").unwrap();
    let mut copy = first.clone();
    copy.set_text("height", "30").unwrap();
    assert_eq!((first.get("height"), copy.get("height")), (Ok(20.0.into()), Ok(30.0.into())));
    let boxes: Vec<Box<dyn Grammar>> = vec![first.boxed(), copy.boxed()];
    let volumes =
        boxes.clone().iter().map(|house| house.generate(&Shape::rectangle(2.0, 1.0)).unwrap().volume()).sum::<f64>();
    assert_eq!(volumes, 2.0 * (20.0 + 30.0));
}

#[test]
fn used_values_are_those_of_the_run() {
    let mut house = house();
    let (settings, mut met) = (Settings::default(), Vec::new());
    for seed in 0..8_u32 {
        let lot = Shape::rectangle(5.0 + f64::from(seed), 4.0).seed(seed.into());
        let used = house.used_values(&lot, &settings).unwrap();
        let names: Vec<&str> = house.attributes().iter().map(|attribute| attribute.name.as_str()).collect();
        assert_eq!(used.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), names);
        let value = |name| used.iter().find(|(known, _)| *known == name).unwrap().1.to_string();
        let model = house.generate(&lot).unwrap();
        let prints: Vec<String> = model.prints().iter().map(ToString::to_string).collect();
        assert_eq!(prints[..4], ["storeys", "width", "mixed", "height"].map(value));
        assert_eq!(value("width"), lot.scope().size.x.to_string());
        met.push(value("storeys"));
    }
    met.dedup();
    assert!(1 < met.len(), "storeys are random: {met:?}");

    house.set_text("storeys", "7").unwrap();
    let used = house.used_values(&Shape::rectangle(5.0, 4.0), &settings).unwrap();
    assert_eq!(
        used[3..],
        [("storeys", 7.0), ("width", 5.0), ("mixed", 19.0)].map(|(name, value)| (name.into(), value.into()))
    );
}

#[test]
fn used_values_follow_the_style() {
    let low = Settings { start: Some("Low$Lot".into()), ..Settings::default() };
    let lot = Shape::rectangle(5.0, 4.0);
    let height = |settings| house().used_values(&lot, settings).unwrap()[0].clone();
    assert_eq!(height(&low), ("height".into(), 4.0.into()));
    assert_eq!(height(&Settings::default()), ("height".into(), 12.0.into()));
    assert_eq!(house().generate_with(&lot, &low).unwrap().volume(), 80.0);
}

#[test]
fn used_values_have_the_errors_of_a_run() {
    let settings = Settings { start: Some("Lost".into()), ..Settings::default() };
    let lot = Shape::rectangle(5.0, 4.0);
    assert!(matches!(house().used_values(&lot, &settings), Err(Error::StartRule { .. })));
    let nowhere = Shape::rectangle(f64::NAN, 4.0);
    assert!(matches!(house().used_values(&nowhere, &Settings::default()), Err(Error::Shape(_))));
    let tall = House { height: Some(99.0), ..House::default() };
    assert!(matches!(tall.used_values(&lot, &Settings::default()), Err(Error::Attribute { .. })));

    cga! {
        grammar Cycle;
        attr mode = 1
        attr a = case mode == 1 : 5 else : b * 2
        attr b = case mode == 1 : a / 2 else : a
        Lot --> print(a + b) Leaf.
    }
    let mut cycle = Cycle::default();
    let used = cycle.used_values(&lot, &Settings::default()).unwrap();
    assert_eq!(used, [("mode", 1.0), ("a", 5.0), ("b", 2.5)].map(|(name, value)| (name.into(), value.into())));
    cycle.mode = 2.0;
    assert!(matches!(cycle.used_values(&lot, &Settings::default()), Err(Error::Cycle { .. })));
}

#[test]
fn kinds_and_types_have_names_for_machines() {
    let names: Vec<String> =
        house().attributes().iter().map(|own| format!("{} {}", own.kind.name(), own.ty.name())).collect();
    assert_eq!(names, ["plain float", "plain string", "plain float[]", "plain float", "plain float", "plain float"]);
}
