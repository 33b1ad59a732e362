//! Grammars whose rules have errors.

use std::sync::LazyLock;

use crate::fault::Error;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::rules::{Checked, RuleTables, Rules};
use crate::run::sink::Flow;
use crate::shape::{Shape, ShapeRef};
use crate::value::Value;

/// Marks a grammar whose rules have errors. Its sessions and parallel runs compile, so rustc reports the errors in
/// the rules only. It never runs, as its program never builds.
pub trait Unrunnable {}

impl<T: Unrunnable> Checked for T {}

impl<T: Unrunnable> Rules for T {
    type Values = ();
    type Call = ();
    fn tables(&self) -> &RuleTables {
        static NONE: LazyLock<RuleTables> = LazyLock::new(RuleTables::default);
        &NONE
    }

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
