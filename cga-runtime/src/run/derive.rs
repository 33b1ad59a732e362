//! Runs: rules call each other directly, and leaves go to the sink as they appear.

use std::any::Any;
use std::cell::OnceCell;
use std::io::Write as _;
use std::sync::Arc;

use crate::fault::Error;
use crate::geometry::work;
use crate::run::building::Building;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::queries::Queries;
use crate::run::report::{Print, Report};
use crate::run::rules::{RuleTables, Rules, StartEntry};
use crate::run::settings::Settings;
use crate::run::sink::{Flow, LeafTables, Sink};
use crate::run::start_rule::StartRule;
use crate::run::surroundings::{Neighbours, Surroundings};
use crate::run::template::Templates;
use crate::shape::look_table::LookTable;
use crate::shape::{Shape, ShapeRef};
use crate::value::Value;
use crate::value::text::Text;

/// The start rule of a run: its number, its style and its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    pub(super) rule: u32,
    pub(super) style: u32,
    /// Its index among the start rules.
    pub(super) index: usize,
    /// The queries of other shapes that the run can reach.
    pub(crate) queries: Queries,
}

/// The state of a run that the next run of the session can reuse. No result depends on it.
#[derive(Default)]
pub(crate) struct Kept {
    templates: KeptTemplates,
    looks: KeptLooks,
}

/// The templates of a grammar whose type of calls is not known here.
#[derive(Default)]
pub(crate) struct KeptTemplates(Option<Box<dyn Any>>);

/// The part of [`Kept`] about looks.
#[derive(Default)]
struct KeptLooks {
    /// `None` before the first run, during a run, and after a run that ended by a panic.
    looks: Option<LookTable>,
    /// The number of runs so far.
    runs: u64,
}

impl KeptTemplates {
    /// The templates of the last run, if it had the same type of calls.
    fn take<C: 'static>(&mut self) -> Box<Templates<C>> {
        self.0.take().and_then(|kept| kept.downcast().ok()).unwrap_or_default()
    }

    fn keep<C: 'static>(&mut self, templates: Box<Templates<C>>) {
        self.0 = Some(templates);
    }
}

impl KeptLooks {
    /// Takes the looks for the next run. Their numbers start again if there are many: then `templates` have wrong numbers.
    fn begin(&mut self, templates: &mut KeptTemplates) -> LookTable {
        self.runs += 1;
        let mut looks = self.looks.take().filter(|looks| !looks.is_full()).unwrap_or_else(|| {
            *templates = KeptTemplates::default();
            LookTable::default()
        });
        looks.begin();
        looks
    }
}

/// The result of a run, with or without an error.
#[derive(Debug, Default)]
pub struct RunOutcome {
    pub(crate) report: Report,
    pub(crate) error: Option<Error>,
    /// The initial shape of a scene whose derivation failed, if the run failed because of a neighbour.
    pub(crate) failed_neighbour: Option<usize>,
}

impl RunOutcome {
    /// The result of a run that never begins because the watch is stopped.
    pub(crate) fn stopped(settings: &Settings) -> Option<Self> {
        let is_stopped = settings.watch.as_ref().is_some_and(|watch| watch.is_stopped());
        is_stopped.then(|| Report { stopped: true, ..Report::default() }.into())
    }

    /// The report, after its prints were written to standard output with `echo`.
    ///
    /// # Errors
    /// The run failed.
    pub(crate) fn result(self, echoes: bool) -> Result<Report, Error> {
        if echoes {
            echo(&self.report.prints);
        }
        self.error.map_or(Ok(self.report), Err)
    }

    /// A run that never began.
    pub(crate) fn failed(error: Error) -> Self {
        RunOutcome { error: Some(error), ..RunOutcome::default() }
    }
}

impl From<Report> for RunOutcome {
    fn from(report: Report) -> Self {
        RunOutcome { report, ..RunOutcome::default() }
    }
}

/// The reason why a derivation has no result.
#[derive(Debug)]
pub enum NoResult {
    /// An error ended it.
    Failed(Error),
    /// The watch ended it.
    Stopped,
}

impl From<NoResult> for RunOutcome {
    fn from(reason: NoResult) -> Self {
        match reason {
            NoResult::Failed(error) => RunOutcome::failed(error),
            NoResult::Stopped => Report { stopped: true, ..Report::default() }.into(),
        }
    }
}

/// A run that can be derived several times. It does not have the type of its rules, so the code around the rules is compiled once and not
/// for each grammar.
pub(crate) struct Derivation<'a> {
    pub(crate) rules: &'a dyn Derivable,
    pub(crate) tables: &'a RuleTables,
    pub(crate) start: Start,
    /// The initial shape, which was checked.
    pub(crate) shape: &'a Shape,
    pub(crate) settings: &'a Settings,
}

/// Rules of any type. The functions of a session know no other, so they are compiled once and not for each grammar.
pub(crate) trait Derivable {
    /// [`Rules::tables`].
    fn rule_tables(&self) -> &RuleTables;

    /// [`Rules::check`].
    ///
    /// # Errors
    /// [`Error::Attribute`].
    fn check_values(&self) -> Result<(), Error>;

    /// Derives a run into a sink, with templates that are kept. Hands its end and the values of its attributes to `end`.
    fn derive(
        &self,
        run: (Start, &Shape),
        env: &mut Env,
        kept: &mut KeptTemplates,
        sink: &mut dyn Sink,
        end: &mut dyn FnMut(&mut Env, &mut dyn Sink, Flow, UsedValues<'_>),
    );

    /// Hands out the values of the attributes for a shape, unless their evaluation ends with an error.
    fn evaluate(&self, run: (Start, &Shape), env: &mut Env, each: &mut dyn FnMut(Option<Value>));
}

impl<R: Rules> Derivable for R {
    fn rule_tables(&self) -> &RuleTables {
        self.tables()
    }

    fn check_values(&self) -> Result<(), Error> {
        self.check()
    }

    fn derive(
        &self,
        (Start { rule, style, .. }, shape): (Start, &Shape),
        env: &mut Env,
        kept: &mut KeptTemplates,
        sink: &mut dyn Sink,
        end: &mut dyn FnMut(&mut Env, &mut dyn Sink, Flow, UsedValues<'_>),
    ) {
        let values = self.values(env, shape, style);
        let start = &mut |cx: &mut Cx<'_, R::Call>, shape: &ShapeRef<'_>| R::start(&values, cx, rule, shape);
        let resume = &mut |cx: &mut Cx<'_, R::Call>, shape: &ShapeRef<'_>, call| R::resume(&values, cx, shape, call);
        let flow = derive(env, shape, kept, sink, start, resume);
        end(env, sink, flow, &|each| R::used(&values, style, each));
    }

    fn evaluate(
        &self,
        (Start { style, .. }, shape): (Start, &Shape),
        env: &mut Env,
        each: &mut dyn FnMut(Option<Value>),
    ) {
        let values = self.values(env, shape, style);
        if env.error.is_none() {
            R::used(&values, style, each);
        }
    }
}

/// Hands out the values of the attributes of a run; see [`Rules::used`].
pub(crate) type UsedValues<'a> = &'a dyn Fn(&mut dyn FnMut(Option<Value>));

impl Derivation<'_> {
    /// Runs the rules on the shape, among shapes of other initial shapes.
    pub(crate) fn run(&self, neighbours: Option<&Arc<Neighbours>>, kept: &mut Kept, sink: &mut dyn Sink) -> RunOutcome {
        let around = match self.surroundings(neighbours.cloned()) {
            Ok(around) => around,
            Err(reason) => return reason.into(),
        };
        let Kept { templates, looks } = kept;
        let mut env = self.env(around.clone(), looks.begin(templates));
        env.run = looks.runs;
        sink.begin();
        sink.begin_building(self.shape.name(), self.shape.seed_value());
        let mut outcome = None;
        self.rules.derive((self.start, self.shape), &mut env, templates, sink, &mut |env, sink, flow, used| {
            outcome = Some(self.end(env, &around, flow, sink, used));
        });
        looks.looks = Some(env.leaf_tables.looks);
        outcome.unwrap_or_default()
    }

    /// Derives the run once more into a sink, with templates of its own.
    pub(crate) fn derive_again(&self, env: &mut Env, sink: &mut dyn Sink) -> Flow {
        let mut outcome = Flow::Continue(());
        let run = (self.start, self.shape);
        self.rules.derive(run, env, &mut KeptTemplates::default(), sink, &mut |_, _, flow, _| outcome = flow);
        outcome
    }

    /// Ends a run and tells the sink about its building.
    fn end(
        &self,
        env: &mut Env,
        around: &Surroundings,
        flow: Flow,
        sink: &mut dyn Sink,
        used: UsedValues<'_>,
    ) -> RunOutcome {
        let mut outcome = outcome(env, flow);
        let keeps_tree = self.settings.tree && sink.keeps_tree();
        let make = || {
            let mut building = Building::of(self.shape, self.tables.name.clone());
            let mut attributes = self.tables.attributes.iter();
            // After an error some values may be placeholders.
            if outcome.error.is_none() {
                used(&mut |value| {
                    let name = attributes.next().cloned().unwrap_or_default();
                    building.attributes.extend(value.map(|value| (name, value)));
                });
            }
            building.reports = outcome.report.reports.clone();
            let is_complete = outcome.error.is_none() && !outcome.report.stopped;
            if keeps_tree && is_complete {
                building.tree = self.shape_tree(&outcome.report, around.clone()).map(Arc::new);
            }
            building
        };
        // Sinks that pass leaves on to several others may ask more than once.
        let building = OnceCell::new();
        sink.end_building(&|| building.get_or_init(make).clone());
        // A sink that works on whole buildings may have been stopped.
        outcome.report.stopped |= outcome.error.is_none() && !work::spend(0);
        outcome
    }
}

/// Calls the start rule, and then the calls that wait. A break without an error comes from the sink or the watch.
fn derive<C: 'static>(
    env: &mut Env,
    shape: &Shape,
    kept: &mut KeptTemplates,
    sink: &mut dyn Sink,
    start: &mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>) -> Flow,
    resume: &mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>, C) -> Flow,
) -> Flow {
    // They are taken, as the looks are: templates contain numbers of looks. If a sink panics, neither stays in the session.
    let mut templates = kept.take();
    let mut cx = Cx::new(env, sink, &mut templates);
    let flow = derive_all(&mut cx, shape, start, resume);
    kept.keep(templates);
    flow
}

fn derive_all<C>(
    cx: &mut Cx<'_, C>,
    shape: &Shape,
    start: &mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>) -> Flow,
    resume: &mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>, C) -> Flow,
) -> Flow {
    if cx.env.ended() {
        return Flow::Break(());
    }
    let base = cx.env.base(shape.without_trim_planes());
    start(cx, &base.shape())?;
    while let Some(next) = cx.waiting.pop_front() {
        (cx.depth, cx.stack) = (next.depth, 0);
        cx.env.resume_trail(next.trail);
        let base = cx.env.base(next.shape);
        resume(cx, &base.shape(), next.call)?;
    }
    Flow::Continue(())
}

/// The result of a run that has ended: `Break` if the sink, the watch or an error ended it.
fn outcome(env: &mut Env, flow: Flow) -> RunOutcome {
    // An operation that the watch has ended may be the last step.
    let flow = if flow.is_continue() { env.spend(0) } else { flow };
    env.tell_watch(flow.is_continue());
    let (faults, faults_left_out) = env.take_faults();
    let prints = std::mem::take(&mut env.prints);
    let report = Report {
        shapes: env.shapes_made(),
        leaves: env.leaf_count(),
        faults,
        faults_left_out,
        stopped: flow.is_break() && env.error.is_none(),
        reports: std::mem::take(&mut env.reports),
        prints_quota: prints.quota,
        prints: prints.in_order(),
    };
    RunOutcome { report, error: env.error.take(), failed_neighbour: None }
}

/// The values of the attributes of a run on a shape that was checked, without running rules.
pub(crate) fn used_values(
    rules: &dyn Derivable,
    start: Start,
    shape: &Shape,
    settings: &Settings,
) -> Result<Vec<Option<Value>>, Error> {
    let mut env = start.env(rules.rule_tables(), shape, settings, LookTable::default());
    let mut list = Vec::new();
    rules.evaluate((start, shape), &mut env, &mut |value| list.push(value));
    env.error.take().map_or(Ok(list), Err)
}

/// Writes lines to standard output. A closed output does not end the run.
pub(crate) fn echo(prints: &[Print]) {
    let mut out = std::io::stdout().lock();
    let _ = prints.iter().try_for_each(|print| writeln!(out, "{print}"));
}

impl Start {
    /// The start rule with a name, or the default one. `Default$Lot` means `Lot`.
    pub(crate) fn find(tables: &RuleTables, name: Option<&str>) -> Result<Self, Error> {
        let index = name.map_or(Ok(0), |name| start_index(name, &tables.starts))?;
        let entry = tables.entries.get(index).filter(|_| index < tables.starts.len());
        let StartEntry { rule, style, queries } = *entry.ok_or_else(|| unknown_start("", &tables.starts))?;
        Ok(Start { rule, style, index, queries: Queries::from_bits(queries) })
    }

    /// The state of a run of the rules from it.
    pub(super) fn env(self, tables: &RuleTables, shape: &Shape, settings: &Settings, looks: LookTable) -> Env {
        let name = tables.starts.get(self.index).map_or_else(Text::default, |start| start.name.clone());
        let leaves = LeafTables { names: tables.leaves.clone(), looks };
        Env::new(settings, tables.rules.clone(), leaves, (shape, name))
    }
}

/// The start rule with a name among `starts`.
pub(crate) fn known_start<'a>(name: &str, starts: &'a [StartRule]) -> Result<&'a StartRule, Error> {
    start_index(name, starts).map(|at| &starts[at])
}

fn start_index(name: &str, starts: &[StartRule]) -> Result<usize, Error> {
    let plain = name.strip_prefix("Default$").unwrap_or(name);
    let at = starts.iter().position(|start| start.name.is(name) || start.name.is(plain));
    at.ok_or_else(|| unknown_start(name, starts))
}

fn unknown_start(name: &str, starts: &[StartRule]) -> Error {
    let known = starts.iter().filter(|start| !start.hidden).map(|start| start.name.clone()).collect();
    Error::StartRule { name: name.to_owned(), known }
}
