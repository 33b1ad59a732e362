//! What every grammar is: a set of attributes and rules that can be run on a shape.

use crate::derive::{Cx, Report};
use crate::env::Env;
use crate::fault::Error;
use crate::model::Model;
use crate::settings::Settings;
use crate::shape::{Shape, ShapeRef};
use crate::sink::{Flow, Sink};

/// A grammar, for programs that choose among several at run time. `cga!` implements it for the struct it makes.
pub trait Grammar {
    /// The grammar's name; empty for one without a header.
    fn name(&self) -> &'static str;

    /// Its attributes, in source order, for building a user interface.
    fn attributes(&self) -> &'static [Attribute];

    /// The rules a run can start with; the first is the default.
    fn start_rules(&self) -> &'static [&'static str];

    /// Runs the grammar and hands the leaves to a sink.
    ///
    /// # Errors
    /// See [`Error`].
    fn derive(&self, shape: &Shape, settings: &Settings, sink: &mut dyn Sink) -> Result<Report, Error>;

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

/// An attribute of a grammar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attribute {
    /// As written, and the name of the field.
    pub name: &'static str,
    /// Type and default.
    pub default: Default,
    /// `@Range`.
    pub range: Option<Range>,
    /// `@Group`, from the outermost to the innermost.
    pub group: &'static [&'static str],
    /// `@Description` or doc comment.
    pub about: &'static str,
    /// `@Order`: user interfaces show attributes with smaller numbers first, and those without one last.
    pub order: Option<f64>,
    /// `@Hidden`: user interfaces leave it out.
    pub hidden: bool,
}

/// The type of an attribute, and its default when that is a constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Default {
    /// A number; `None` when it is computed for each initial shape.
    Float(Option<f64>),
    /// A truth value.
    Bool(Option<bool>),
    /// Text.
    Text(Option<&'static str>),
}

/// `@Range(min, max)`: what a slider may offer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Step of a slider, 0 when free.
    pub step: f64,
    /// Whether a run refuses values outside. What the host program sets is checked; what rules compute or `set` is not.
    pub restricted: bool,
}

impl Range {
    /// Checks the value of an attribute. Used by generated code.
    ///
    /// # Errors
    /// [`Error::Attribute`] when the range is restricted and the value outside or not a number.
    pub fn check(&self, name: &'static str, value: f64) -> Result<(), Error> {
        if !self.restricted || (self.min <= value && value <= self.max) {
            return Ok(());
        }
        let message = format!("{value} is outside of {} to {}", self.min, self.max);
        Err(Error::Attribute { name, message })
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

    /// Checks the attributes against their ranges.
    ///
    /// # Errors
    /// [`Error::Attribute`].
    fn check(&self) -> Result<(), Error>;
    /// Evaluates attributes and constants.
    fn values(&self, env: &mut Env, shape: &Shape) -> Self::Values;
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
