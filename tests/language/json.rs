//! The feature `serde`: attributes, values, settings and reports as JSON.

use cga::{Array, Grammar, Limits, Settings, Shape, Text, Value, cga};
use serde_json::json;

cga! {
    @Allow(missing_asset)
    grammar House;
    @Range(min = 3, max = 60) @Distance @Group("Size", 1)
    attr height = 12
    @Enum("brick", "stone")
    attr wall = "brick"
    @Enum(valuesAttr = uses)
    attr use = "flats"
    @Hidden
    attr uses = ["flats", "shops"]
    attr grid = [1, 2; 3, 4]
    attr open = [true]
    /// Storeys above ground.
    attr storeys = rint(rand(2, 5))
    @File("obj", "glb")
    attr tree = ""
    Lot --> report("area", scope.sx * scope.sz) report("use", use) print(grid) print(size(uses) + size(open) + len(tree) + storeys)
        extrude(height) set(material.name, wall) i("missing.obj") House.
}

cga! {
    grammar Values;
    attr number = 0
    attr truth = false
    attr word = ""
    attr numbers = [0]
    attr truths = [false]
    attr words = [""]
    Lot --> print(number) print(truth) print(word) print(size(numbers) + size(truths) + size(words))
}

fn house() -> Box<dyn Grammar + Send + Sync> {
    Box::new(House::default())
}

fn values(house: &dyn Grammar) -> serde_json::Value {
    serde_json::from_str(&house.values_json()).expect("JSON")
}

#[test]
fn values_go_out_and_in() {
    let mut house = house();
    let defaults = json!({
        "height": 12.0, "wall": "brick", "use": "flats", "uses": ["flats", "shops"], "grid": [[1.0, 2.0], [3.0, 4.0]],
        "open": [true], "storeys": null, "tree": "",
    });
    assert_eq!(values(&*house), defaults);
    assert!(house.values_json().starts_with(r#"{"height":12.0,"wall":"brick""#), "in the order of the attributes");

    house.set_values_json(r#"{ "height": 20, "grid": [5], "storeys": 3, "open": [] }"#).expect("it is allowed");
    assert_eq!(house.get("grid"), Ok(Value::from(Array::from([5.0]))));
    assert_eq!(house.get("storeys"), Ok(3.0.into()));
    let changed = house.values_json();
    house.set_values_json(&defaults.to_string()).expect("it is allowed");
    assert_eq!(values(&*house), defaults);
    house.set_values_json(&changed).expect("it is allowed");
    assert_eq!(house.values_json(), changed);
}

#[test]
fn values_are_read_as_they_were_written() {
    let back = |name: &str, value: &Value| {
        let [mut from, mut to] = [Values::default(), Values::default()];
        from.set(name, value.clone()).expect("the type of the attribute");
        to.set_values_json(&from.values_json()).unwrap_or_else(|error| panic!("{error}: {}", from.values_json()));
        to.get(name).expect("an attribute")
    };
    let rows = |rows: Vec<Vec<f64>>| Value::from(Array::from(rows));
    for (name, value) in [
        ("number", Value::from(0.1 + 0.2)),
        ("number", (-1e300).into()),
        ("number", f64::INFINITY.into()),
        ("number", f64::NEG_INFINITY.into()),
        ("truth", true.into()),
        ("word", "é\n\"".into()),
        ("numbers", rows(vec![vec![1.0, 2.0], vec![3.0, f64::INFINITY]])),
        ("numbers", rows(vec![vec![1.0], vec![2.0]])),
        ("numbers", rows(vec![vec![1.0, 2.0]])),
        ("numbers", rows(Vec::new())),
        ("truths", Array::from([true, false]).into()),
        ("truths", Array::<bool>::default().into()),
        ("words", Array::from([Text::from("a"), Text::from("")]).into()),
        ("words", Array::<Text>::default().into()),
    ] {
        assert_eq!(back(name, &value), value);
    }
    assert!(matches!(back("number", &f64::NAN.into()), Value::Float(number) if number.is_nan()));
}

#[test]
fn a_value_without_a_type_is_what_it_looks_like() {
    let read = |json| serde_json::from_str::<Value>(json).map_err(|error| error.to_string());
    assert_eq!(read("[[1, 2], [3, 4.5]]"), Ok(Array::from(vec![vec![1.0, 2.0], vec![3.0, 4.5]]).into()));
    assert_eq!((read("12"), read("true")), (Ok(12.0.into()), Ok(true.into())));
    assert_eq!(
        (read("[]"), read("[\"a\"]")),
        (Ok(Array::<f64>::default().into()), Ok(Array::from([Text::from("a")]).into()))
    );
    for wrong in ["[[1], [2, 3]]", "[1, \"a\"]", "{}", "null"] {
        assert!(read(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn refused_values_change_nothing() {
    let mut house = house();
    let before = house.values_json();
    for (json, reason) in [
        (r#"{ "height": 20, "wall": "straw" }"#, "attribute `wall`: `straw` is not one of brick, stone"),
        (r#"{ "wall": "stone", "height": 99 }"#, "attribute `height`: 99 is outside of 3 to 60"),
        (r#"{ "wall": "stone", "hieght": 9 }"#, "unknown attribute `hieght`; did you mean `height`?"),
        (r#"{ "storeys": 4, "height": "tall" }"#, "attribute `height` is a number, and `\"tall\"` is not"),
        (
            r#"{ "storeys": 4, "grid": [[1], [2, 3]] }"#,
            "attribute `grid` is an array of numbers, and `[[1],[2,3]]` is not",
        ),
        (r#"{ "storeys": 4, "use": "cinema" }"#, "attribute `use`: `cinema` is not one of flats, shops"),
        (r#"{ "storeys": 4, "#, "the values are not a JSON object: "),
        ("[]", "the values are not a JSON object: "),
        ("", "the values are not a JSON object: "),
    ] {
        let error = house.set_values_json(json).expect_err(json).to_string();
        assert!(error.starts_with(reason), "{json}: {error}");
        assert_eq!(house.values_json(), before, "{json}");
    }
    let deep = format!("{{ \"grid\": {}{} }}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(house.set_values_json(&deep).is_err());
    // Choices may come with the value that they allow, in any order.
    house.set_values_json(r#"{ "use": "cinema", "uses": ["cinema"] }"#).expect("it is allowed");
    house.set_values_json(r#"{ "uses": null, "use": null }"#).expect("it is allowed");
    assert_eq!(house.values_json(), before);
}

#[test]
fn attributes_are_described() {
    let list: serde_json::Value = serde_json::from_str(&house().attributes_json()).expect("JSON");
    assert_eq!(
        list[0],
        json!({
            "name": "height", "display_name": "", "type": "float", "default": 12.0, "kind": "distance", "endings": [],
            "range": { "min": 3.0, "max": 60.0, "step": 0.0, "restricted": true }, "choices": null, "group": ["Size"],
            "group_order": 1.0, "about": "", "order": null, "hidden": false, "value": 12.0, "allowed": null,
        })
    );
    assert_eq!(list[1]["choices"], json!({ "values": ["brick", "stone"], "labels": [], "restricted": true }));
    assert_eq!(
        (&list[2]["choices"]["values"], &list[2]["allowed"]),
        (&json!({ "attribute": "uses" }), &json!(["flats", "shops"]))
    );
    assert_eq!((&list[4]["type"], &list[4]["default"]), (&json!("float[]"), &json!([[1.0, 2.0], [3.0, 4.0]])));
    assert_eq!((&list[6]["about"], &list[6]["value"]), (&json!("Storeys above ground."), &json!(null)));
    assert_eq!((&list[7]["kind"], &list[7]["endings"]), (&json!("file"), &json!(["obj", "glb"])));
}

#[test]
fn settings_are_read_and_written() {
    let settings: Settings =
        serde_json::from_str(r#"{ "start": "Lot", "limits": { "shapes": 7 } }"#).expect("settings");
    assert_eq!((settings.start.as_deref(), settings.limits), (Some("Lot"), Limits { shapes: 7, ..Limits::default() }));
    assert!(!settings.echo);
    let back: Settings = serde_json::from_str(&serde_json::to_string(&settings).expect("JSON")).expect("settings");
    assert_eq!((back.start, back.limits), (settings.start, settings.limits));
    assert!(serde_json::from_str::<Settings>(r#"{ "strat": "Lot" }"#).is_err());
}

#[test]
fn reports_are_written() {
    let mut house = house();
    house.set_values_json(r#"{ "storeys": 3 }"#).expect("it is allowed");
    let derived = house.run(&Shape::rectangle(3.0, 4.0), &Settings::default(), &mut cga::Model::new());
    let report = serde_json::to_value(derived.expect("a report")).expect("JSON");
    assert_eq!((&report["leaves"], &report["stopped"]), (&json!(1), &json!(false)));
    assert_eq!(
        report["reports"][0]["summary"],
        json!({
            "count": 1, "nans": 0, "numbers": 1, "sum": 12.0, "min": 12.0, "max": 12.0, "average": 12.0,
        })
    );
    assert_eq!(
        report["reports"][1],
        json!({
            "key": "use", "type": "string", "texts": { "flats": 1 },
            "summary": { "count": 1, "nans": 0, "numbers": 0, "sum": 0.0, "min": null, "max": null, "average": null },
        })
    );
    assert_eq!(
        report["prints"],
        json!([
            { "rule": "Lot", "value": [[1.0, 2.0], [3.0, 4.0]] }, { "rule": "Lot", "value": 6.0 },
        ])
    );
    assert_eq!((&report["faults"][0]["kind"], &report["faults"][0]["trail"]), (&json!("asset"), &json!(["Lot"])));
}
