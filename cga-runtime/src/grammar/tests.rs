//! Attributes by name.

use std::sync::LazyLock;

use super::*;
use crate::grammar::attribute::{ChoiceValues, Choices, Range};
use crate::run::rules::texts;
use crate::value::ValueType;
use crate::value::array::Array;
use crate::value::text::Text;

/// A hand-written equivalent of the code that `cga!` generates.
#[derive(Clone)]
struct Tower {
    height: f64,
    lit: bool,
    style: String,
    storeys: Option<f64>,
    name: Option<String>,
    odd: f64,
    storeys_each: Array<f64>,
    uses: Array<Text>,
    its_use: String,
}

impl Tower {
    fn new() -> Self {
        Tower {
            height: 12.0,
            lit: false,
            style: "plain".into(),
            storeys: None,
            name: None,
            odd: -1.0,
            storeys_each: [99.0].into(),
            uses: ["shop", "flat"].map(Text::fixed).into(),
            its_use: "shop".into(),
        }
    }
}

static ATTRIBUTES: LazyLock<[Attribute; 9]> = LazyLock::new(|| {
    [
        Attribute::new("height", 12.0).range(Range::new(3.0, 60.0, 0.0, true)),
        Attribute::new("lit", false),
        Attribute::new("style", "plain").choices(Choices::new(ChoiceValues::Texts(texts(&["plain", "ornate"])), true)),
        Attribute::computed("storeys", ValueType::Float)
            .choices(Choices::new(ChoiceValues::Attribute("height".into()), true)),
        Attribute::computed("name", ValueType::Text).choices(Choices::new(ChoiceValues::Texts(texts(&["a"])), false)),
        Attribute::new("odd", -1.0).range(Range::new(0.0, 1.0, 0.0, true)),
        Attribute::new("storeys_each", Array::from([99.0])).range(Range::new(3.0, 6.0, 0.0, true)),
        Attribute::computed("uses", ValueType::Texts)
            .choices(Choices::new(ChoiceValues::Texts(texts(&["shop", "flat"])), true)),
        Attribute::computed("use", ValueType::Text).choices(Choices::new(ChoiceValues::Attribute("uses".into()), true)),
    ]
});

impl Grammar for Tower {
    fn name(&self) -> &str {
        "Tower"
    }

    fn attributes(&self) -> &[Attribute] {
        &*ATTRIBUTES
    }

    fn start_rules(&self) -> &[StartRule] {
        static STARTS: LazyLock<[StartRule; 1]> = LazyLock::new(|| [StartRule::new("Lot")]);
        &*STARTS
    }

    fn attribute_get(&self, index: usize) -> Option<Value> {
        match index {
            0 => Field::get(&self.height),
            1 => Field::get(&self.lit),
            2 => Field::get(&self.style),
            3 => Field::get(&self.storeys),
            4 => Field::get(&self.name),
            5 => Field::get(&self.odd),
            6 => Field::get(&self.storeys_each),
            7 => Field::get(&self.uses),
            8 => Field::get(&self.its_use),
            _ => None,
        }
    }

    fn attribute_set(&mut self, index: usize, value: Value) {
        match index {
            0 => Field::set(&mut self.height, value),
            1 => Field::set(&mut self.lit, value),
            2 => Field::set(&mut self.style, value),
            3 => Field::set(&mut self.storeys, value),
            4 => Field::set(&mut self.name, value),
            5 => Field::set(&mut self.odd, value),
            6 => Field::set(&mut self.storeys_each, value),
            7 => Field::set(&mut self.uses, value),
            8 => Field::set(&mut self.its_use, value),
            _ => {}
        }
    }

    fn attribute_reset(&mut self, index: usize) {
        if let Some(value) = Tower::new().attribute_get(index) {
            self.attribute_set(index, value);
        }
    }

    fn boxed(&self) -> Box<dyn Grammar + Send + Sync> {
        Box::new(self.clone())
    }

    fn used_values(&self, _: &Shape, _: &Settings) -> Result<Vec<(Text, Value)>, Error> {
        let values = self.attributes().iter().enumerate();
        Ok(values.filter_map(|(index, attribute)| Some((attribute.name.clone(), self.attribute_get(index)?))).collect())
    }

    fn run(&self, _: &Shape, _: &Settings, _: &mut dyn Sink) -> Result<Report, Error> {
        Ok(Report::default())
    }
}

fn tower() -> Box<dyn Grammar> {
    Box::new(Tower::new())
}

#[test]
fn attributes_are_read_and_set_by_name() {
    let mut tower = tower();
    assert_eq!(tower.get("height"), Ok(12.0.into()));
    assert_eq!(tower.get("storeys"), Err(AttributeError::Computed { name: "storeys".into() }));
    assert_eq!(tower.set("height", 60.0.into()), Ok(()));
    assert_eq!((tower.set_text("lit", "true"), tower.set_text("style", "ornate")), (Ok(()), Ok(())));
    assert_eq!((tower.set_text("name", "any"), tower.set("storeys", 60.0.into())), (Ok(()), Ok(())));
    let values: Vec<String> = ATTRIBUTES.iter().map(|it| tower.get(&it.name).expect("set").to_string()).collect();
    assert_eq!(values, ["60", "true", "ornate", "60", "any", "-1", "(1)[99]", "(2)[shop,flat]", "shop"]);
}

#[test]
fn what_is_refused_is_taught() {
    let mut tower = tower();
    let said: Vec<String> = [
        tower.set("hight", 3.0.into()),
        tower.set("colour", 3.0.into()),
        tower.set("height", true.into()),
        tower.set_text("height", "12 m"),
        tower.set_text("lit", "yes"),
        tower.set("height", f64::NAN.into()),
        tower.set_text("height", "61"),
        tower.set_text("style", "plian"),
        tower.set_text("storeys", "4"),
        tower.set_text("odd", "-2"),
        tower.set_text("height\n", "-2"),
        tower.set_text("lit", "yes\u{1b}[2J"),
        tower.set_text("style", "a\nb"),
        tower.set_text("odd", "1e999"),
    ]
    .map(|result| result.expect_err("refused").to_string())
    .to_vec();
    assert_eq!(
        said,
        [
            "unknown attribute `hight`; did you mean `height`?",
            "unknown attribute `colour`; the attributes are height, lit, style, storeys, name, odd, storeys_each, uses, use",
            "attribute `height` is a number, and the value is true or false",
            "attribute `height` is a number, and `12 m` is not",
            "attribute `lit` is true or false, and `yes` is not",
            "attribute `height`: NaN is outside of 3 to 60",
            "attribute `height`: 61 is outside of 3 to 60",
            "attribute `style`: `plian` is not one of plain, ornate",
            "attribute `storeys`: `4` is not one of 12",
            "attribute `odd`: -2 is outside of 0 to 1",
            r"unknown attribute `height\n`; did you mean `height`?",
            r"attribute `lit` is true or false, and `yes\u{1b}[2J` is not",
            r"attribute `style`: `a\nb` is not one of plain, ornate",
            "attribute `odd` is a number, and `1e999` is not",
        ]
    );
    assert_eq!(tower.set_text("odd", "-1"), Ok(()), "a default is never refused");
    assert_eq!(tower.get("height"), Ok(12.0.into()), "what is refused changes nothing");
    let long = "é".repeat(10_000);
    assert!(tower.set_text("height", &long).expect_err("no number").to_string().len() < 300);
    assert!(tower.get(&long).expect_err("no name").to_string().len() < 300);
}

#[test]
fn elements_of_arrays_are_checked_one_by_one() {
    let mut tower = tower();
    let said = |result: Result<(), AttributeError>| result.map_err(|error| error.to_string());
    assert_eq!(said(tower.set_text("storeys_each", "[3, 4; 5, 6]")), Ok(()));
    assert_eq!(said(tower.set_text("storeys_each", "[]")), Ok(()));
    let refused = Err("attribute `storeys_each`: 7 is outside of 3 to 6".to_owned());
    assert_eq!(said(tower.set_text("storeys_each", "[3, 7, 8]")), refused);
    assert_eq!(said(tower.set_text("storeys_each", "[99]")), Ok(()), "a default is never refused");
    assert!(said(tower.set_text("storeys_each", "[99; 99]")).is_err());
    assert_eq!(said(tower.set_text("uses", r#"["shop", "flat"]"#)), Ok(()));
    let refused = Err("attribute `uses`: `barn` is not one of shop, flat".to_owned());
    assert_eq!(said(tower.set_text("uses", r#"["shop"; "barn"]"#)), refused);
    assert_eq!(said(tower.set_text("use", "flat")), Ok(()), "the elements of another attribute");
    assert_eq!(said(tower.set_text("uses", r#"["shop"]"#)), Ok(()));
    let refused = Err("attribute `use`: `flat` is not one of shop".to_owned());
    assert_eq!(said(tower.set_text("use", "flat")), refused);
    assert_eq!(said(tower.set_text("uses", "[]")), Ok(()));
    let refused = Err("attribute `use`: `shop` is not allowed: the list of choices is empty".to_owned());
    assert_eq!(said(tower.set_text("use", "shop")), refused);
}

#[test]
fn a_run_checks_what_fields_hold() {
    let mut rules = Tower::new();
    assert_eq!(attribute::check(&rules), Ok(()));
    rules.odd = 2.0;
    let error = attribute::check(&rules).expect_err("out of range");
    assert_eq!(error.to_string(), "attribute `odd`: 2 is outside of 0 to 1");
    rules.odd = 0.5;
    rules.style = "gothic".into();
    let error = attribute::check(&rules).expect_err("none of them");
    assert_eq!(error.to_string(), "attribute `style`: `gothic` is not one of plain, ornate");
    rules.style = "ornate".into();
    rules.name = Some("anything".into());
    rules.storeys = Some(3.0);
    let error = attribute::check(&rules).expect_err("not the height");
    assert_eq!(error.to_string(), "attribute `storeys`: `3` is not one of 12");
}

#[test]
fn a_grammar_that_only_derives_has_sessions_too() {
    let tower = Tower::new();
    let mut session = tower.session(&Settings::default()).expect("a session");
    let (mut left, mut right) = (Model::new(), Model::new());
    let shape = Shape::rectangle(1.0, 1.0);
    let runs = (session.run(&shape, &mut left), tower.run(&shape, &Settings::default(), &mut right));
    assert_eq!(runs.0.map(|report| report.leaves).ok(), runs.1.map(|report| report.leaves).ok());
    assert_eq!(left.len(), right.len());
}
