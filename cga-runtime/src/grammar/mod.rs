//! Grammars: attributes and rules that can be run on a shape.

pub mod attribute;
mod field;
pub mod grammars;
#[cfg(feature = "serde")]
mod json;
mod kept_lots;
pub(crate) mod lazy;
mod lots;
pub mod parallel;
mod rule_source;
pub mod scene;
pub mod session;
pub(crate) mod support;
mod unrunnable;

pub use field::{Evaluated, Field};
pub use rule_source::{RuleSource, RustCall, RustCode};
pub use unrunnable::Unrunnable;

use self::attribute::{Attribute, AttributeError};
use self::session::DynSession;
use crate::fault::Error;
use crate::output::model::Model;
use crate::run::report::Report;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::run::start_rule::StartRule;
use crate::shape::Shape;
use crate::value::Value;
use crate::value::text::Text;

/// A grammar, for programs that choose one of several at run time. `cga!` implements it for the struct it makes.
///
/// User interfaces build on [`attributes`](Grammar::attributes) (names, groups, ranges, choices, defaults), on
/// [`start_rules`](Grammar::start_rules), and on reading and setting values by name, also as text. Annotations for
/// user interfaces do not change the results of rules.
pub trait Grammar {
    /// The grammar's name; empty for a grammar without a header.
    fn name(&self) -> &str;

    /// The attributes, in source order.
    fn attributes(&self) -> &[Attribute];

    /// A description in Markdown (`@RuleFileDescription`); empty if there is none.
    fn about(&self) -> &str {
        ""
    }

    /// All rules that a run can start with. The first is the default.
    fn start_rules(&self) -> &[StartRule];

    /// The value of the attribute with an index in [`attributes`](Grammar::attributes). `None` while it is computed
    /// for each initial shape, and for an index out of range. [`get`](Grammar::get) reads by name.
    #[doc(hidden)]
    fn attribute_get(&self, index: usize) -> Option<Value>;

    /// Sets an attribute by its index, unchecked. A value of another type changes nothing. [`set`](Grammar::set) sets
    /// by name.
    #[doc(hidden)]
    fn attribute_set(&mut self, index: usize, value: Value);

    /// Sets the attribute with an index to its default. A default that is computed is computed for each initial shape
    /// again. An index out of range changes nothing. [`reset`](Grammar::reset) resets by name.
    #[doc(hidden)]
    fn attribute_reset(&mut self, index: usize);

    /// The rules that the grammar was compiled from, with the feature `live`.
    #[doc(hidden)]
    fn rule_source(&self) -> Option<RuleSource> {
        None
    }

    /// A copy with the same values.
    fn boxed(&self) -> Box<dyn Grammar + Send + Sync>;

    /// The names and values of the attributes that a run on a shape uses, in the order of
    /// [`attributes`](Grammar::attributes): those that were set, and defaults that are computed for this shape from its
    /// geometry and its seed. Attributes that the style of the start rule does not have are left out. No rule runs, so queries of other shapes
    /// in defaults give false, 0 or an infinite distance; [`Building::attributes`](crate::run::building::Building::attributes) has the
    /// values of a run.
    ///
    /// # Errors
    /// The errors of a run before its first rule: [`Error::Attribute`], [`Error::StartRule`], [`Error::Shape`],
    /// [`Error::Lot`], [`Error::Cycle`], and limits of functions.
    fn used_values(&self, shape: &Shape, settings: &Settings) -> Result<Vec<(Text, Value)>, Error>;

    /// Runs the grammar and hands the leaves to a sink. A grammar that is written by hand need not know of lots: sessions,
    /// [`generate`](Grammar::generate) and [`parallel`] set the attributes of a lot and find its start rule before they call this.
    ///
    /// # Errors
    /// See [`Error`].
    fn run(&self, shape: &Shape, settings: &Settings, sink: &mut dyn Sink) -> Result<Report, Error>;

    /// The old name of [`run`](Grammar::run).
    ///
    /// # Errors
    /// See [`Error`].
    #[deprecated(note = "call `run`")]
    fn derive(&self, shape: &Shape, settings: &Settings, sink: &mut dyn Sink) -> Result<Report, Error> {
        self.run(shape, settings, sink)
    }

    /// Opens a session: several runs with the same settings that share their preparations. Grammars made by `cga!`
    /// check attributes and start rule here, other grammars when a run begins.
    ///
    /// A concrete grammar has its own method `session`. Its [`Session`](crate::grammar::session::Session) calls sinks
    /// without a pointer.
    ///
    /// # Errors
    /// An attribute is refused, or the start rule is unknown.
    fn session<'g>(&'g self, settings: &Settings) -> Result<Box<dyn DynSession + 'g>, Error> {
        Ok(Box::new(session::SingleRuns { grammar: self, settings: settings.clone() }))
    }

    /// The value of an attribute by its name.
    ///
    /// # Errors
    /// The attribute does not exist, or its default is computed for each initial shape and it is not set.
    fn get(&self, name: &str) -> Result<Value, AttributeError> {
        attribute::value(self.attributes(), name, &|index| self.attribute_get(index))
    }

    /// Sets an attribute by its name.
    ///
    /// # Errors
    /// The attribute does not exist, or the value has another type, is outside of a restricted range or is not among
    /// restricted choices. A default is never refused.
    fn set(&mut self, name: &str, value: Value) -> Result<(), AttributeError> {
        let index = attribute::allowed(self.attributes(), name, &value, &|name| self.get(name).ok())?;
        self.attribute_set(index, value);
        Ok(())
    }

    /// Sets an attribute by its name to the value of a text, as [`Value::parse`] reads it.
    ///
    /// # Errors
    /// As [`set`](Grammar::set), and if the text cannot be read as a value of the attribute's type.
    fn set_text(&mut self, name: &str, text: &str) -> Result<(), AttributeError> {
        let value = attribute::parsed(self.attributes(), name, text)?;
        self.set(name, value)
    }

    /// Sets an attribute by its name to its default.
    ///
    /// # Errors
    /// The attribute does not exist.
    fn reset(&mut self, name: &str) -> Result<(), AttributeError> {
        let (index, _) = attribute::find(self.attributes(), name)?;
        self.attribute_reset(index);
        Ok(())
    }

    /// The values of all attributes as a JSON object, by name; null where the default is computed for each initial shape.
    /// [`Value`] describes how arrays and NaN are written.
    #[cfg(feature = "serde")]
    fn values_json(&self) -> String {
        json::values(self.attributes(), &|index| self.attribute_get(index))
    }

    /// Sets attributes from a JSON object with values by name; null sets the default. Other attributes stay as they are.
    /// After an error, all stay as they are.
    ///
    /// # Errors
    /// The text is not a JSON object, or one of the errors of [`set`](Grammar::set). A list of choices may be in the same
    /// object as the choice.
    #[cfg(feature = "serde")]
    fn set_values_json(&mut self, json: &str) -> Result<(), AttributeError> {
        json::set_values(&mut json::Of(self), json)
    }

    /// The attributes as a JSON list, for user interfaces in other languages: the fields of [`Attribute`] with `type`,
    /// `value`, and with `allowed`, the values to choose from.
    #[cfg(feature = "serde")]
    fn attributes_json(&self) -> String {
        json::attributes(self.attributes(), &|index| self.attribute_get(index), &|name| self.get(name).ok())
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
        session::model(self.session(settings), shape, settings)
    }
}

/// Sets an attribute by its index to a value, or to its default.
fn put<G: Grammar + ?Sized>(grammar: &mut G, index: usize, value: Option<Value>) {
    match value {
        Some(value) => grammar.attribute_set(index, value),
        None => grammar.attribute_reset(index),
    }
}

macro_rules! clones {
    ($($grammar:ty),*) => {$(
        impl Clone for Box<$grammar> {
            fn clone(&self) -> Self {
                (**self).boxed()
            }
        }
    )*};
}

clones! { dyn Grammar, dyn Grammar + Send, dyn Grammar + Sync, dyn Grammar + Send + Sync }

#[cfg(test)]
mod tests;
