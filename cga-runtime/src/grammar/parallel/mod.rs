//! Runs on many initial shapes.
//!
//! The shapes are divided into *stretches*: neighbours in the list that share a sink. With the feature `rayon`,
//! several threads derive stretches at the same time, each with its own session. Without it, and where threads are
//! not available, the same functions derive them one after the other. The ends of stretches depend on the number of
//! shapes alone. So the results do not depend on the number of threads: they are the bytes that a loop over the
//! shapes gives.
//!
//! The sinks stay apart, in order ([`Batches`]); none is copied into another. Reports are merged shape by shape. The
//! first error in the order of the shapes ends the whole, and all shapes after it are discarded. The same holds for a
//! sink that ends its run: batches up to it are kept, and later ones are dropped, even complete ones.
//!
//! Threads take stretches in order, so a program that streams its sinks gets them almost in order.

mod order;
mod stretch;

use std::borrow::Cow;
use std::ops::Range;

pub use crate::output::batches::{Batch, Batches, ShapeError};
pub use stretch::Stretch;

use self::order::in_order;
use self::stretch::{Done, EarlyEnd, derive_stretch};
use crate::grammar::Grammar;
use crate::grammar::session::{Session, Setup};
use crate::output::model::Model;
use crate::run::derive::{self, RunOutcome};
use crate::run::report::Report;
use crate::run::rules::Rules;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::shape::Shape;

/// Runs a grammar on all shapes, with a sink for each stretch. Each sink is [finished](Sink::finish) after its last
/// shape.
///
/// # Errors
/// An error that does not depend on a shape, otherwise the first one in the order of the shapes.
pub fn run_all<G: Rules + Sync, S: Sink + Send>(
    grammar: &G,
    shapes: &[Shape],
    settings: &Settings,
    sink: impl Fn(&Stretch) -> S + Sync,
) -> Result<Batches<S>, ShapeError> {
    let setup = Setup::new(grammar, Cow::Owned(quiet(settings)))?;
    let run = |session: &mut Session<'_, G>, shape: &Shape, sink: &mut S| session.outcome(shape, sink);
    Crew { shapes, settings, first: setup.session(), again: || Some(setup.session()) }.run_all(sink, run)
}

/// Does the same as [`run_all`] for a grammar that is chosen at run time.
///
/// # Errors
/// As [`run_all`].
pub fn derive_all<G: Grammar + Sync + ?Sized, S: Sink + Send>(
    grammar: &G,
    shapes: &[Shape],
    settings: &Settings,
    sink: impl Fn(&Stretch) -> S + Sync,
) -> Result<Batches<S>, ShapeError> {
    let quiet = quiet(settings);
    let first = grammar.session(&quiet)?;
    let again = || grammar.session(&quiet).ok();
    Crew { shapes, settings, first, again }.run_all(sink, |session, shape, sink| match session.run(shape, sink) {
        Ok(report) => RunOutcome { report, error: None },
        Err(error) => RunOutcome { report: Report::default(), error: Some(error) },
    })
}

/// Runs a grammar on all shapes and collects a model of each. Each model, with its report, equals the model of a run
/// on that shape alone.
///
/// # Errors
/// As [`run_all`].
pub fn generate_all<G: Rules + Sync>(
    grammar: &G,
    shapes: &[Shape],
    settings: &Settings,
) -> Result<Batches<Model>, ShapeError> {
    let setup = Setup::new(grammar, Cow::Owned(quiet(settings)))?;
    let job = |session: &mut Session<'_, G>, stretch: &Stretch, ended: &dyn Fn() -> bool| {
        derive_stretch(shapes, stretch, ended, Vec::new(), |models, shape| {
            let mut model = Model::new();
            let outcome = session.outcome(shape, &mut model);
            models.push(model.with_report(outcome.report.clone()).with_assets(settings.assets.clone()));
            outcome
        })
    };
    let put = |batches: &mut Vec<Batch<Model>>, shapes: Range<usize>, models: Vec<Model>| {
        batches.extend(shapes.zip(models).map(|(at, model)| Batch { shapes: at..at + 1, sink: model }));
    };
    Crew { shapes, settings, first: setup.session(), again: || Some(setup.session()) }.work(job, put)
}

/// The settings for workers: prints are echoed later, in the order of the shapes.
fn quiet(settings: &Settings) -> Settings {
    Settings { echo: false, ..settings.clone() }
}

/// The workers: sessions of one grammar.
struct Crew<'a, W, A> {
    shapes: &'a [Shape],
    settings: &'a Settings,
    first: W,
    again: A,
}

impl<W, A: Fn() -> Option<W> + Sync> Crew<'_, W, A> {
    /// Derives all stretches, with a sink for each.
    fn run_all<S: Sink + Send>(
        self,
        sink: impl Fn(&Stretch) -> S + Sync,
        run: impl Fn(&mut W, &Shape, &mut S) -> RunOutcome + Sync,
    ) -> Result<Batches<S>, ShapeError> {
        let shapes = self.shapes;
        let job = |worker: &mut W, stretch: &Stretch, ended: &dyn Fn() -> bool| {
            let run = |sink: &mut S, shape: &Shape| run(worker, shape, sink);
            let mut done = derive_stretch(shapes, stretch, ended, sink(stretch), run);
            let failed = matches!(done.end, Some(EarlyEnd::Failed(..)));
            if !failed && !ended() && done.output.finish().is_break() {
                done.end.get_or_insert(EarlyEnd::Stopped);
            }
            done
        };
        self.work(job, |batches, shapes, sink| batches.push(Batch { shapes, sink }))
    }

    /// Derives all stretches; `put` adds the output of each to the batches, in order.
    fn work<S, T: Send>(
        self,
        job: impl Fn(&mut W, &Stretch, &dyn Fn() -> bool) -> Done<T> + Sync,
        put: impl Fn(&mut Vec<Batch<S>>, Range<usize>, T) + Sync,
    ) -> Result<Batches<S>, ShapeError>
    where
        S: Send,
    {
        let Crew { shapes, settings, first, again } = self;
        let count = shapes.len();
        let mut batches = Batches { batches: Vec::new(), report: Report::default() };
        let mut failed = None;
        let job = |worker: &mut W, number: usize, ended: &dyn Fn() -> bool| {
            let done = job(worker, &Stretch::of(number, count), ended);
            let ends = done.end.is_some();
            (done, ends)
        };
        in_order(Stretch::count(count), first, again, job, |done: Done<T>| {
            let Done { output, shapes, reports, counts, end } = done;
            for report in reports {
                if settings.echo {
                    derive::echo(report.prints());
                }
                batches.report.merge(report, &settings.limits);
            }
            batches.report.merge(counts, &settings.limits);
            match end {
                Some(EarlyEnd::Failed(at, error)) => failed = Some(ShapeError { shape: Some(at), error }),
                Some(EarlyEnd::Stopped) => batches.report.stopped = true,
                None => {}
            }
            put(&mut batches.batches, shapes, output);
        });
        failed.map_or(Ok(batches), Err)
    }
}
