//! Runs of many lots on threads.

use std::panic::{AssertUnwindSafe, catch_unwind};

use cga::{Model, RuleFile, Session, Shape as Initial};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::call::Call;
use crate::errors::{PANIC, late_message};
use crate::failure::reason;
use crate::rows::Row;
use crate::run::STACK;

/// The reason why a lot has no model, with its kind.
pub(crate) type Reason = (&'static str, String);

/// A lot, or the reason why it is missing.
pub(crate) struct Job {
    pub(crate) row: usize,
    pub(crate) lot: usize,
    pub(crate) name: String,
    initial: Result<Initial, Reason>,
}

/// A lot with its model.
pub(crate) struct Done {
    pub(crate) job: Job,
    pub(crate) model: Result<Model, Reason>,
}

/// The lots of rows. Their seeds are their own ones; otherwise they count on from `seed`; without it they follow from their names, and lots
/// without names have their numbers.
pub(crate) fn jobs(rows: Vec<Row>, seed: Option<u64>, rules: &RuleFile, call: &Call) -> Vec<Job> {
    let mut jobs = Vec::new();
    let mut next = 0;
    for (row, Row { name, lots }) in rows.into_iter().enumerate() {
        let lots = match lots {
            Ok(lots) if lots.is_empty() => Err("the geometry is empty".to_owned()),
            lots => lots,
        };
        match lots {
            Err(why) => jobs.push(Job { row, lot: next, name, initial: Err(("shape", why)) }),
            Ok(lots) => {
                for draft in lots {
                    let initial = draft.map_err(|why| ("shape", why)).map(|draft| {
                        let counted = seed.map(|seed| seed.wrapping_add(next as u64));
                        let own = draft.own_seed.or(counted).or(draft.name_seed);
                        call.lot(rules, draft.initial.seed(own.unwrap_or(next as u64)))
                    });
                    jobs.push(Job { row, lot: next, name: name.clone(), initial });
                    next += 1;
                }
            }
        }
    }
    jobs
}

/// The most threads of a call.
const MOST_THREADS: usize = 1024;

/// The number of threads of a call; 0 for one for each processor.
///
/// # Errors
/// A `ValueError` for a number that is too large.
pub(crate) fn threads_of(given: Option<usize>) -> PyResult<usize> {
    match given.unwrap_or_default() {
        threads if MOST_THREADS < threads => {
            Err(PyValueError::new_err(format!("the number of threads is at most {MOST_THREADS}")))
        }
        threads => Ok(threads),
    }
}

/// A pool with a number of threads; 0 for one for each processor.
///
/// # Errors
/// A sentence: threads cannot be started.
pub(crate) fn pool(threads: usize) -> Result<ThreadPool, String> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build();
    pool.map_err(|why| format!("cannot start threads: {why}"))
}

/// Does the work in a pool with a number of threads.
///
/// # Errors
/// A sentence: threads cannot be started.
pub(crate) fn in_pool<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> Result<T, String> {
    Ok(pool(threads)?.install(work))
}

/// Runs all jobs, in their order.
pub(crate) fn run_all(jobs: Vec<Job>, rules: &RuleFile, call: &Call) -> Vec<Done> {
    // Sessions stay on their threads.
    jobs.into_par_iter().map_init(|| None, |session, job| run(job, session, rules, call)).collect()
}

fn run<'r>(job: Job, session: &mut Option<Session<'r, RuleFile>>, rules: &'r RuleFile, call: &Call) -> Done {
    let late = || ("deadline", late_message(call.deadline.unwrap_or_default()));
    let model = match &job.initial {
        Err(why) => Err(why.clone()),
        Ok(_) if call.watch.is_stopped() => Err(late()),
        Ok(initial) => {
            let run = AssertUnwindSafe(|| {
                if session.is_none() {
                    *session = Some(rules.session(&call.settings)?);
                }
                session.as_mut().map(|session| session.generate(initial)).transpose()
            });
            match catch_unwind(run) {
                Ok(Ok(Some(model))) if model.report().stopped => Err(late()),
                Ok(Ok(Some(model))) => Ok(model),
                Ok(Err(why)) => Err(reason(&why)),
                Ok(Ok(None)) | Err(_) => {
                    *session = None;
                    Err(("run", PANIC.to_owned()))
                }
            }
        }
    };
    Done { job, model }
}
