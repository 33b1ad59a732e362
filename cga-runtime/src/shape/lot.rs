//! Lots: initial shapes with data of their own, as the rows of a map have it.

use std::sync::Arc;

use super::Shape;
use crate::value::Value;
use crate::value::text::Text;

/// The data of an initial shape. It is shared, as many shapes inherit it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Lot {
    /// The values of attributes, each name once.
    pub(crate) attributes: Vec<(Text, Value)>,
    /// The name of its grammar among several.
    pub(crate) grammar: Option<Text>,
    /// Its start rule.
    pub(crate) start: Option<Text>,
}

impl Lot {
    /// Returns true if no run can tell the two apart. Numbers are compared by their bits: −0 and 0 differ, and NaN equals itself.
    pub(crate) fn is_same(&self, other: &Lot) -> bool {
        let are_same = |(own, other): (&(Text, Value), &(Text, Value))| own.0 == other.0 && own.1.is_same(&other.1);
        self.attributes.len() == other.attributes.len()
            && self.start == other.start
            && self.attributes.iter().zip(&other.attributes).all(are_same)
    }
}

impl Shape {
    /// Gives the lot a value for an attribute of its grammar. In a run from this shape it wins over the value of the grammar's field, as
    /// an object attribute wins over the value of the rule file in CityEngine (*attribute*). A field cannot tell its default from
    /// a value that the program set, so it wins over both. A second value for one name replaces the first.
    ///
    /// The run checks name, type, range and choices as [`Grammar::set`](crate::grammar::Grammar::set) does;
    /// [`Settings::wrong_lots`](crate::run::settings::Settings::wrong_lots) decides what a wrong one leads to.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::Shape;
    ///
    /// let lot = Shape::rectangle(20.0, 15.0).named("Mill Street 4").attribute("height", 12.5).attribute("use", "shop");
    /// assert_eq!(lot.attributes().map(|(name, _)| name).collect::<Vec<_>>(), ["height", "use"]);
    /// ```
    pub fn attribute(mut self, name: impl Into<Text>, value: impl Into<Value>) -> Self {
        let (name, value) = (name.into(), value.into());
        let attributes = &mut self.change_lot().attributes;
        match attributes.iter_mut().find(|(known, _)| *known == name) {
            Some(own) => own.1 = value,
            None => attributes.push((name, value)),
        }
        self
    }

    /// Names the grammar of the lot in a set of [`Grammars`](crate::grammar::grammars::Grammars). A run of a single grammar does not
    /// ask for it.
    pub fn grammar(mut self, name: impl Into<Text>) -> Self {
        self.change_lot().grammar = Some(name.into());
        self
    }

    /// Names the start rule of the lot. It wins over [`Settings::start`](crate::run::settings::Settings::start), but not over the rule of
    /// a call such as `generate_from`.
    pub fn start(mut self, rule: impl Into<Text>) -> Self {
        self.change_lot().start = Some(rule.into());
        self
    }

    /// The name, which rules read as `initialShape.name`; empty if it has none.
    pub fn name(&self) -> &str {
        self.state.get().map_or("", |state| &state.name)
    }

    /// The names and values of the lot's own attributes, in the order in which they were given.
    pub fn attributes(&self) -> impl ExactSizeIterator<Item = (&str, &Value)> {
        let own = self.lot().map_or(&[][..], |lot| &lot.attributes);
        own.iter().map(|(name, value)| (name.as_str(), value))
    }

    /// The name of the lot's grammar, if it has one.
    pub fn grammar_name(&self) -> Option<&str> {
        self.lot()?.grammar.as_deref()
    }

    /// The name of the lot's start rule, if it has one.
    pub fn start_name(&self) -> Option<&str> {
        self.lot()?.start.as_deref()
    }

    /// The data of the lot, if it has any.
    pub(crate) fn lot(&self) -> Option<&Lot> {
        self.state.get()?.lot.as_deref()
    }

    /// The shape with another start rule, or without one of its own.
    pub(crate) fn with_start(&self, rule: Option<&str>) -> Shape {
        let mut own = self.clone();
        if self.start_name() != rule {
            own.change_lot().start = rule.map(Text::from);
        }
        own
    }

    /// The shape without the data of a lot.
    pub(crate) fn without_lot(&self) -> Shape {
        let mut own = self.clone();
        if self.lot().is_some() {
            own.state.change().lot = None;
        }
        own
    }

    fn change_lot(&mut self) -> &mut Lot {
        Arc::make_mut(self.state.change().lot.get_or_insert_default())
    }
}
