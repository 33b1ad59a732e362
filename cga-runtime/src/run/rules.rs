//! The interface between a run and generated code.

use crate::fault::Error;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::run::start_rule::StartRule;
use crate::shape::{Shape, ShapeRef};
use crate::value::Value;

/// Marks grammars that `cga!` makes, so that no other type has [`Rules`].
#[doc(hidden)]
pub trait Compiled {}

/// The interface of generated code, which `cga!` alone implements.
pub trait Rules: Compiled {
    /// Attributes and constants, evaluated for one initial shape.
    #[doc(hidden)]
    type Values;
    /// The calls that may wait in the list: rules in cycles with their arguments.
    #[doc(hidden)]
    type Call: Clone;
    /// The names of rules by number, for trails.
    #[doc(hidden)]
    const NAMES: &'static [&'static str];
    /// The names of leaves by number.
    #[doc(hidden)]
    const LEAVES: &'static [&'static str];
    /// The rules that a run can start with; the default first.
    #[doc(hidden)]
    const STARTS: &'static [StartRule];
    /// The numbers of the start rules.
    #[doc(hidden)]
    const START_RULES: &'static [u32];
    /// The numbers of their styles.
    #[doc(hidden)]
    const START_STYLES: &'static [u32];

    /// The queries of other shapes that a run from each start rule can reach, as a set of bits; empty if there are none.
    #[doc(hidden)]
    const START_QUERIES: &'static [u8] = &[];

    /// True if the rules read or set tags. Otherwise operations do not tag the edges that they make.
    #[doc(hidden)]
    const TAGS: bool;

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
