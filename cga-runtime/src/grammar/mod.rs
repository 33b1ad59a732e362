//! What every grammar is: a set of attributes and rules that can be run on a shape.

pub mod attribute;
mod field;
pub(crate) mod lazy;
pub mod parallel;
pub mod session;
pub(crate) mod support;
mod unrunnable;

pub use field::Field;
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

/// A grammar, for programs that choose among several at run time. `cga!` implements it for the struct it makes.
///
/// What user interfaces need is here: [`attributes`](Grammar::attributes) with names, groups, ranges, values to choose
/// from and defaults; [`start_rules`](Grammar::start_rules); values by name, from text where a person typed them. None of
/// it changes what rules make.
pub trait Grammar {
    /// The grammar's name; empty for one without a header.
    fn name(&self) -> &'static str;

    /// Its attributes, in source order, for building a user interface.
    fn attributes(&self) -> &'static [Attribute];

    /// What it makes, in Markdown (`@RuleFileDescription`); empty when nothing is said.
    fn about(&self) -> &'static str {
        ""
    }

    /// The rules a run can start with, all of them; the first is the default.
    fn start_rules(&self) -> &'static [StartRule];

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

    /// Opens a session: several runs with the same settings, which share what is made once. The grammars that `cga!` makes check
    /// attributes and start rule here; others when a run begins.
    ///
    /// A concrete grammar has a method `session` of its own, whose [`Session`](crate::grammar::session::Session) calls no sink through a
    /// pointer.
    ///
    /// # Errors
    /// An attribute that is refused, an unknown start rule.
    fn session<'g>(&'g self, settings: &Settings) -> Result<Box<dyn DynSession + 'g>, Error> {
        Ok(Box::new(session::Plain { grammar: self, settings: settings.clone() }))
    }

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
        attribute.allows(&value, self)?;
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
        Ok(model.with_report(report).with_assets(settings.assets.clone()))
    }
}

#[cfg(test)]
mod tests;
