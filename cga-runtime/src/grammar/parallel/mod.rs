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

#[cfg(feature = "rayon")]
mod crew;
pub(crate) mod order;
mod stretch;

use std::ops::Range;

#[expect(deprecated, reason = "the old name")]
pub use crate::output::batches::ShapeError;
pub use crate::output::batches::{Batch, Batches, RunError};
pub use stretch::Stretch;

use self::order::in_order;
use self::stretch::{Done, EarlyEnd, derive_stretch};
use crate::fault::Error;
use crate::grammar::Grammar;
use crate::grammar::session::DynSession;
use crate::output::model::Model;
use crate::run::derive::{self, RunOutcome};
use crate::run::report::Report;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::shape::Shape;

/// Runs a grammar on all shapes, with a sink for each stretch. Each sink is [finished](Sink::finish) after its last
/// shape. The grammar may be one that is chosen at run time.
///
/// # Errors
/// An error that does not depend on a shape, otherwise the first one in the order of the shapes.
pub fn run_all<G: Grammar + Sync + ?Sized, S: Sink + Send>(
    grammar: &G,
    shapes: &[Shape],
    settings: &Settings,
    sink: impl Fn(&Stretch) -> S + Sync,
) -> Result<Batches<S>, RunError> {
    let open = |settings: &Settings| grammar.session(settings);
    run_by(&Runs { open: &open, count: shapes.len(), run: &alone(shapes) }, settings, sink)
}

/// Opens a session on a thread.
pub(crate) type Open<'a, 'g> = &'a (dyn Fn(&Settings) -> Result<Worker<'g>, Error> + Sync);

/// Runs the shape with an index in a session.
pub(crate) type RunAt<'a> = &'a (dyn Fn(&mut Worker<'_>, usize, &mut dyn Sink) -> RunOutcome + Sync);

/// Runs on many shapes.
pub(crate) struct Runs<'a, 'g> {
    pub(crate) open: Open<'a, 'g>,
    /// The number of shapes.
    pub(crate) count: usize,
    pub(crate) run: RunAt<'a>,
}

/// Runs the shapes of a list, each without its neighbours.
pub(crate) fn alone(shapes: &[Shape]) -> impl Fn(&mut Worker<'_>, usize, &mut dyn Sink) -> RunOutcome + Sync {
    |session, at, sink| session.outcome(&shapes[at], None, sink)
}

/// [`run_all`] for any runs.
pub(crate) fn run_by<S: Sink + Send>(
    runs: &Runs<'_, '_>,
    settings: &Settings,
    sink: impl Fn(&Stretch) -> S + Sync,
) -> Result<Batches<S>, RunError> {
    let job = |session: &mut Worker<'_>, stretch: &Stretch, ended: &dyn Fn() -> bool| {
        let run = |sink: &mut S, at: usize| (runs.run)(session, at, sink);
        let mut done = derive_stretch(stretch, ended, sink(stretch), run);
        let failed = matches!(done.end, Some(EarlyEnd::Failed(..)));
        if !failed && !ended() && done.output.finish().is_break() {
            done.end.get_or_insert(EarlyEnd::Stopped);
        }
        done
    };
    work(runs, settings, job, |batches, shapes, sink| batches.push(Batch { shapes, sink }))
}

/// The old name of [`run_all`].
///
/// # Errors
/// As [`run_all`].
#[deprecated(note = "call `run_all`, which takes every grammar")]
pub fn derive_all<G: Grammar + Sync + ?Sized, S: Sink + Send>(
    grammar: &G,
    shapes: &[Shape],
    settings: &Settings,
    sink: impl Fn(&Stretch) -> S + Sync,
) -> Result<Batches<S>, RunError> {
    run_all(grammar, shapes, settings, sink)
}

/// Runs a grammar on all shapes and collects a model of each. Each model, with its report, equals the model of a run
/// on that shape alone.
///
/// # Errors
/// As [`run_all`].
pub fn generate_all<G: Grammar + Sync + ?Sized>(
    grammar: &G,
    shapes: &[Shape],
    settings: &Settings,
) -> Result<Batches<Model>, RunError> {
    let open = |settings: &Settings| grammar.session(settings);
    generate_by(&Runs { open: &open, count: shapes.len(), run: &alone(shapes) }, settings)
}

/// [`generate_all`] for any runs.
pub(crate) fn generate_by(runs: &Runs<'_, '_>, settings: &Settings) -> Result<Batches<Model>, RunError> {
    let job = |session: &mut Worker<'_>, stretch: &Stretch, ended: &dyn Fn() -> bool| {
        derive_stretch(stretch, ended, Vec::new(), |models, at| {
            let mut model = Model::new();
            let outcome = (runs.run)(session, at, &mut model);
            models.push(model.with_report(outcome.report.clone()).with_assets(settings.assets.clone()));
            outcome
        })
    };
    let put = |batches: &mut Vec<Batch<Model>>, shapes: Range<usize>, models: Vec<Model>| {
        batches.extend(shapes.zip(models).map(|(at, model)| Batch { shapes: at..at + 1, sink: model }));
    };
    work(runs, settings, job, put)
}

/// A session that derives stretches on one thread.
pub(crate) type Worker<'g> = Box<dyn DynSession + 'g>;

/// Derives all stretches; `put` adds the output of each to the batches, in order.
fn work<S: Send, T: Send>(
    runs: &Runs<'_, '_>,
    settings: &Settings,
    job: impl Fn(&mut Worker<'_>, &Stretch, &dyn Fn() -> bool) -> Done<T> + Sync,
    put: impl Fn(&mut Vec<Batch<S>>, Range<usize>, T) + Sync,
) -> Result<Batches<S>, RunError> {
    // Prints are echoed later, in the order of the shapes.
    let quiet = Settings { echo: false, ..settings.clone() };
    let first = (runs.open)(&quiet)?;
    let again = || (runs.open)(&quiet).ok();
    let count = runs.count;
    let mut batches = Batches { batches: Vec::new(), report: Report::default() };
    let mut failed = None;
    let job = |worker: &mut Worker<'_>, number: usize, ended: &dyn Fn() -> bool| {
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
            Some(EarlyEnd::Failed(at, error)) => failed = Some(RunError { shape: Some(at), error }),
            Some(EarlyEnd::Stopped) => batches.report.stopped = true,
            None => {}
        }
        put(&mut batches.batches, shapes, output);
    });
    failed.map_or(Ok(batches), Err)
}
