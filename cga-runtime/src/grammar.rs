//! What every grammar is: a set of attributes and rules that can be run on a shape.

use crate::array::Array;
use crate::attribute::{self, Attribute, AttributeError, ChoiceValues};
use crate::derive::{Cx, Report};
use crate::env::Env;
use crate::fault::Error;
use crate::model::Model;
use crate::settings::Settings;
use crate::shape::{Shape, ShapeRef};
use crate::sink::{Flow, Sink};
use crate::text::Text;
use crate::value::Value;

/// A grammar, for programs that choose among several at run time. `cga!` implements it for the struct it makes.
pub trait Grammar {
    /// The grammar's name; empty for one without a header.
    fn name(&self) -> &'static str;

    /// Its attributes, in source order, for building a user interface.
    fn attributes(&self) -> &'static [Attribute];

    /// The rules a run can start with; the first is the default.
    fn start_rules(&self) -> &'static [&'static str];

    /// The value of an attribute by its number in [`attributes`](Grammar::attributes); `None` while it is to be computed for
    /// each initial shape, and for other numbers. [`get`](Grammar::get) is the same by name.
    fn attribute_get(&self, index: usize) -> Option<Value>;

    /// Sets an attribute by its number, unchecked; a value of another type changes nothing. [`set`](Grammar::set) is the same
    /// by name.
    fn attribute_set(&mut self, index: usize, value: Value);

    /// Runs the grammar and hands the leaves to a sink.
    ///
    /// # Errors
    /// See [`Error`].
    fn derive(&self, shape: &Shape, settings: &Settings, sink: &mut dyn Sink) -> Result<Report, Error>;

    /// The value of an attribute by its name.
    ///
    /// # Errors
    /// There is no such attribute, or its default is computed for each initial shape and it is not set.
    fn get(&self, name: &str) -> Result<Value, AttributeError> {
        let (index, attribute) = attribute::find(self.attributes(), name)?;
        self.attribute_get(index).ok_or(AttributeError::Computed { name: attribute.name })
    }

    /// Sets an attribute by its name.
    ///
    /// # Errors
    /// There is no such attribute, or the value is of another type, outside of a restricted range or none of restricted
    /// choices. A default is never refused.
    fn set(&mut self, name: &str, value: Value) -> Result<(), AttributeError> {
        let (index, attribute) = attribute::find(self.attributes(), name)?;
        let choices = attribute.choices.filter(|choices| choices.restricted);
        let choices = choices.and_then(|choices| match choices.values {
            // One that is computed is not known before the run.
            ChoiceValues::Attribute(other) => Some(vec![self.get(other).ok()?]),
            _ => choices.known(),
        });
        attribute.check(&value, choices)?;
        self.attribute_set(index, value);
        Ok(())
    }

    /// Sets an attribute by its name to what a text says: see [`Value::parse`].
    ///
    /// # Errors
    /// As for [`set`](Grammar::set); and the text is no value of the attribute's type.
    fn set_text(&mut self, name: &str, text: &str) -> Result<(), AttributeError> {
        let (_, attribute) = attribute::find(self.attributes(), name)?;
        let value = Value::parse(text, attribute.ty()).ok_or_else(|| attribute.no_value(text))?;
        self.set(name, value)
    }

    /// Runs the default start rule with default settings.
    ///
    /// # Errors
    /// See [`Error`].
    fn generate(&self, shape: &Shape) -> Result<Model, Error> {
        self.generate_with(shape, &Settings::default())
    }

    /// Runs the grammar with settings: start rule, limits, assets.
    ///
    /// # Errors
    /// See [`Error`].
    fn generate_with(&self, shape: &Shape, settings: &Settings) -> Result<Model, Error> {
        let mut model = Model::new();
        let report = self.derive(shape, settings, &mut model)?;
        Ok(model.with_report(report))
    }
}

/// A field that holds an attribute. Used by generated code.
pub trait Field {
    /// Its value; `None` while it is to be computed.
    fn get(&self) -> Option<Value>;
    /// Takes a value of its type; others change nothing.
    fn set(&mut self, value: Value);
}

impl Field for f64 {
    fn get(&self) -> Option<Value> {
        Some(Value::Float(*self))
    }

    fn set(&mut self, value: Value) {
        if let Value::Float(number) = value {
            *self = number;
        }
    }
}

impl Field for bool {
    fn get(&self) -> Option<Value> {
        Some(Value::Bool(*self))
    }

    fn set(&mut self, value: Value) {
        if let Value::Bool(truth) = value {
            *self = truth;
        }
    }
}

impl Field for String {
    fn get(&self) -> Option<Value> {
        Some(Value::from(self.as_str()))
    }

    fn set(&mut self, value: Value) {
        if let Value::Text(text) = value {
            text.as_str().clone_into(self);
        }
    }
}

macro_rules! arrays {
    ($($item:ty => $variant:ident,)*) => {$(
        impl Field for Array<$item> {
            fn get(&self) -> Option<Value> {
                Some(Value::$variant(self.clone()))
            }

            fn set(&mut self, value: Value) {
                if let Value::$variant(array) = value {
                    *self = array;
                }
            }
        }
    )*};
}

arrays! { f64 => Floats, bool => Bools, Text => Texts, }

impl<F: Field + std::default::Default> Field for Option<F> {
    fn get(&self) -> Option<Value> {
        self.as_ref()?.get()
    }

    fn set(&mut self, value: Value) {
        self.get_or_insert_default().set(value);
    }
}

/// What generated code provides. Not for writing by hand.
pub trait Rules {
    /// Attributes and constants, evaluated for one initial shape.
    type Values;
    /// Calls that may wait on the work list: rules in cycles with their arguments.
    type Call;
    /// Rule names by number, for trails.
    const NAMES: &'static [&'static str];
    /// Rules a run can start with; the default first.
    const STARTS: &'static [&'static str];
    /// Their numbers.
    const START_RULES: &'static [u32];
    /// The styles they put in force, by number.
    const START_STYLES: &'static [u32];

    /// Checks the attributes against their ranges.
    ///
    /// # Errors
    /// [`Error::Attribute`].
    fn check(&self) -> Result<(), Error>;
    /// Evaluates attributes and constants, as the style in force has them.
    fn values(&self, env: &mut Env, shape: &Shape, style: u32) -> Self::Values;
    /// Runs a start rule.
    fn start<S: Sink + ?Sized>(
        values: &Self::Values,
        cx: &mut Cx<'_, S, Self::Call>,
        rule: u32,
        shape: ShapeRef<'_>,
    ) -> Flow;
    /// Runs a call that waited.
    fn resume<S: Sink + ?Sized>(
        values: &Self::Values,
        cx: &mut Cx<'_, S, Self::Call>,
        shape: ShapeRef<'_>,
        call: Self::Call,
    ) -> Flow;
}

/// Runs a grammar and collects a model. Used by generated code.
///
/// # Errors
/// See [`Error`].
pub fn generate<R: Rules>(rules: &R, shape: &Shape, settings: &Settings) -> Result<Model, Error> {
    let mut model = Model::new();
    let report = crate::derive::run(rules, shape, settings, &mut model)?;
    Ok(model.with_report(report))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attribute::{Choices, Default, Range};

    /// What `cga!` writes for a grammar, by hand.
    struct Tower {
        height: f64,
        lit: bool,
        style: String,
        storeys: Option<f64>,
        name: Option<String>,
        odd: f64,
    }

    static ATTRIBUTES: [Attribute; 6] = [
        Attribute::new("height", Default::Float(Some(12.0))).range(Range::new(3.0, 60.0, 0.0, true)),
        Attribute::new("lit", Default::Bool(Some(false))),
        Attribute::new("style", Default::Text(Some("plain")))
            .choices(Choices::new(ChoiceValues::Texts(&["plain", "ornate"]), true)),
        Attribute::new("storeys", Default::Float(None)).choices(Choices::new(ChoiceValues::Attribute("height"), true)),
        Attribute::new("name", Default::Text(None)).choices(Choices::new(ChoiceValues::Texts(&["a"]), false)),
        Attribute::new("odd", Default::Float(Some(-1.0))).range(Range::new(0.0, 1.0, 0.0, true)),
    ];

    impl Grammar for Tower {
        fn name(&self) -> &'static str {
            "Tower"
        }

        fn attributes(&self) -> &'static [Attribute] {
            &ATTRIBUTES
        }

        fn start_rules(&self) -> &'static [&'static str] {
            &["Lot"]
        }

        fn attribute_get(&self, index: usize) -> Option<Value> {
            match index {
                0 => Field::get(&self.height),
                1 => Field::get(&self.lit),
                2 => Field::get(&self.style),
                3 => Field::get(&self.storeys),
                4 => Field::get(&self.name),
                5 => Field::get(&self.odd),
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
                _ => {}
            }
        }

        fn derive(&self, _: &Shape, _: &Settings, _: &mut dyn Sink) -> Result<Report, Error> {
            Ok(Report::default())
        }
    }

    fn tower() -> Box<dyn Grammar> {
        let style = "plain".to_owned();
        Box::new(Tower { height: 12.0, lit: false, style, storeys: None, name: None, odd: -1.0 })
    }

    #[test]
    fn attributes_are_read_and_set_by_name() {
        let mut tower = tower();
        assert_eq!(tower.get("height"), Ok(12.0.into()));
        assert_eq!(tower.get("storeys"), Err(AttributeError::Computed { name: "storeys" }));
        assert_eq!(tower.set("height", 60.0.into()), Ok(()));
        assert_eq!((tower.set_text("lit", "true"), tower.set_text("style", "ornate")), (Ok(()), Ok(())));
        assert_eq!((tower.set_text("name", "any"), tower.set("storeys", 60.0.into())), (Ok(()), Ok(())));
        let values: Vec<String> = ATTRIBUTES.iter().map(|it| tower.get(it.name).expect("set").to_string()).collect();
        assert_eq!(values, ["60", "true", "ornate", "60", "any", "-1"]);
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
        ]
        .map(|result| result.expect_err("refused").to_string())
        .to_vec();
        assert_eq!(
            said,
            [
                "there is no attribute `hight`; did you mean `height`?",
                "there is no attribute `colour`",
                "attribute `height` is a number, and the value is true or false",
                "attribute `height` is a number, and `12 m` is not",
                "attribute `lit` is true or false, and `yes` is not",
                "attribute `height`: NaN is outside of 3 to 60",
                "attribute `height`: 61 is outside of 3 to 60",
                "attribute `style`: `plian` is none of plain, ornate",
                "attribute `storeys`: `4` is none of 12",
                "attribute `odd`: -2 is outside of 0 to 1",
            ]
        );
        assert_eq!(tower.set_text("odd", "-1"), Ok(()), "a default is never refused");
        assert_eq!(tower.get("height"), Ok(12.0.into()), "what is refused changes nothing");
        let long = "é".repeat(10_000);
        assert!(tower.set_text("height", &long).expect_err("no number").to_string().len() < 300);
        assert!(tower.get(&long).expect_err("no name").to_string().len() < 300);
    }

    #[test]
    fn generated_code_checks_choices() {
        let choices = |restricted| Choices::new(ChoiceValues::Floats(&[1.0, 2.5]), restricted);
        assert!(choices(true).check("a", 2.5).is_ok() && choices(false).check("a", 3.0).is_ok());
        let error = choices(true).check("a", 3.0).expect_err("none of them");
        assert_eq!(error.to_string(), "attribute `a`: `3` is none of 1, 2.5");
    }
}
