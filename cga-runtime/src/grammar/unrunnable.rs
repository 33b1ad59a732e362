//! Grammars whose rules have errors.

use crate::fault::Error;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::rules::{Compiled, Rules};
use crate::run::sink::Flow;
use crate::run::start_rule::StartRule;
use crate::shape::{Shape, ShapeRef};
use crate::value::Value;

/// Marks a grammar whose rules have errors. Its sessions and parallel runs compile, so rustc reports the errors in
/// the rules only. It never runs, as its program never builds.
pub trait Unrunnable {}

impl<T: Unrunnable> Compiled for T {}

impl<T: Unrunnable> Rules for T {
    type Values = ();
    type Call = ();
    const NAMES: &'static [&'static str] = &[];
    const LEAVES: &'static [&'static str] = &[];
    const TAGS: bool = false;
    const STARTS: &'static [StartRule] = &[];
    const START_RULES: &'static [u32] = &[];
    const START_STYLES: &'static [u32] = &[];

    fn check(&self) -> Result<(), Error> {
        Ok(())
    }

    fn values(&self, _: &mut Env, _: &Shape, _: u32) -> Self::Values {}

    fn used((): &Self::Values, _: u32, _: &mut dyn FnMut(Option<Value>)) {}

    fn start(_: &Self::Values, _: &mut Cx<'_, Self::Call>, _: u32, _: &ShapeRef<'_>) -> Flow {
        Flow::Break(())
    }

    fn resume(_: &Self::Values, _: &mut Cx<'_, Self::Call>, _: &ShapeRef<'_>, (): Self::Call) -> Flow {
        Flow::Break(())
    }
}
