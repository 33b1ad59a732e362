//! The interface between a run and generated code.

use crate::fault::Error;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::run::start_rule::StartRule;
use crate::shape::{Shape, ShapeRef};

/// What generated code provides. Not for writing by hand.
pub trait Rules {
    /// Attributes and constants, evaluated for one initial shape.
    type Values;
    /// Calls that may wait on the work list: rules in cycles with their arguments.
    type Call: Clone;
    /// Rule names by number, for trails.
    const NAMES: &'static [&'static str];
    /// The names of leaves by number.
    const LEAVES: &'static [&'static str];
    /// Rules a run can start with; the default first.
    const STARTS: &'static [StartRule];
    /// Their numbers.
    const START_RULES: &'static [u32];
    /// The styles they put in force, by number.
    const START_STYLES: &'static [u32];

    /// True if attributes and constants do not depend on the initial shape.
    const SETTLED: bool;

    /// Checks the attributes against their ranges.
    ///
    /// # Errors
    /// [`Error::Attribute`].
    fn check(&self) -> Result<(), Error>;
    /// Evaluates attributes and constants, as the style in force has them.
    fn values(&self, env: &mut Env, shape: &Shape, style: u32) -> Self::Values;
    /// Runs a start rule.
    fn start(values: &Self::Values, cx: &mut Cx<'_, Self::Call>, rule: u32, shape: &ShapeRef<'_>) -> Flow;
    /// Runs a call that waited.
    fn resume(values: &Self::Values, cx: &mut Cx<'_, Self::Call>, shape: &ShapeRef<'_>, call: Self::Call) -> Flow;
}
