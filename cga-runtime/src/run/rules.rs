//! The interface between a run and its rules.

use std::sync::Arc;

use crate::fault::Error;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::run::start_rule::StartRule;
use crate::shape::{Shape, ShapeRef};
use crate::value::Value;
use crate::value::text::Text;

/// The data of a grammar that all its runs share.
#[derive(Clone, Debug, Default)]
pub struct RuleTables {
    /// The grammar's name; empty without a header.
    pub name: Text,
    /// The names of rules by number, for trails.
    pub rules: Arc<[Text]>,
    /// The names of leaves by number.
    pub leaves: Arc<[Text]>,
    /// True if the rules read or set tags. Otherwise operations do not tag the edges that they make.
    pub tags: bool,
    /// The rules that a run can start with; the default first.
    pub starts: Vec<StartRule>,
    /// The entries of the start rules, in their order.
    pub entries: Vec<StartEntry>,
    /// The names of the attributes, in source order.
    pub attributes: Vec<Text>,
}

/// The entry of a start rule.
#[derive(Clone, Copy, Debug)]
pub struct StartEntry {
    /// The number of the rule.
    pub rule: u32,
    /// The number of the style.
    pub style: u32,
    /// The queries of other shapes that a run can reach, as a set of bits.
    pub queries: u8,
}

/// Names that are literals.
pub fn names(list: &[&'static str]) -> Arc<[Text]> {
    list.iter().copied().map(Text::fixed).collect()
}

/// Entries of start rules: rule, style and queries of each.
pub fn entries(list: &[(u32, u32, u8)]) -> Vec<StartEntry> {
    list.iter().map(|&(rule, style, queries)| StartEntry { rule, style, queries }).collect()
}

/// A list of values.
pub fn list<T, const N: usize>(entries: [T; N]) -> Vec<T> {
    entries.into()
}

/// Texts that are literals.
pub fn texts(list: &[&'static str]) -> Vec<Text> {
    list.iter().copied().map(Text::fixed).collect()
}

/// Marks grammars that come from checked rules, so that no other type has [`Rules`].
#[doc(hidden)]
pub trait Checked {}

/// The interface of checked rules: compiled by `cga!`, or loaded at run time.
pub trait Rules: Checked {
    /// Attributes and constants, evaluated for one initial shape.
    #[doc(hidden)]
    type Values;
    /// The calls that may wait in the list: rules in cycles with their arguments.
    #[doc(hidden)]
    type Call: Clone + 'static;
    /// The data that all runs share.
    #[doc(hidden)]
    fn tables(&self) -> &RuleTables;
    /// Checks the attributes against their ranges.
    ///
    /// # Errors
    /// [`Error::Attribute`].
    #[doc(hidden)]
    fn check(&self) -> Result<(), Error>;
    /// Evaluates attributes and constants under a style.
    #[doc(hidden)]
    fn values(&self, env: &mut Env, shape: &Shape, style: u32) -> Self::Values;
    /// Hands out the values of the attributes, in their order; `None` for attributes that the style does not have.
    #[doc(hidden)]
    fn used(values: &Self::Values, style: u32, each: &mut dyn FnMut(Option<Value>));
    /// Runs a start rule.
    #[doc(hidden)]
    fn start(values: &Self::Values, cx: &mut Cx<'_, Self::Call>, rule: u32, shape: &ShapeRef<'_>) -> Flow;
    /// Runs a call that waited.
    #[doc(hidden)]
    fn resume(values: &Self::Values, cx: &mut Cx<'_, Self::Call>, shape: &ShapeRef<'_>, call: Self::Call) -> Flow;
}
