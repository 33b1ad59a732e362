//! The checkpoint of a run: the counts at which counting leaves the fast path, for a limit or for the watch.

use std::ops::ControlFlow;

use super::{ENDED, Env, MOST_SHAPES};
use crate::fault::LimitKind;
use crate::geometry::work;
use crate::run::settings::Settings;
use crate::run::sink::Flow;
use crate::run::watch::{Progress, STRIDE, Watch};

/// The counts at which counting leaves the fast path, and the last progress that the watch got.
#[derive(Debug, Default)]
pub(crate) struct Checkpoint {
    pub(crate) shapes: u64,
    pub(crate) calls: u64,
    /// The number of shapes at which the watch ended the run.
    pub(crate) stopped_at: Option<u64>,
    /// The highest count of shapes requested during the recording of a template. The checkpoint is then no higher, so
    /// that every higher request comes here.
    recorded: Option<u64>,
    /// In a run that stops at each shape, the number of shapes up to which no limit is reached and the watch need not be asked.
    quiet: u64,
    /// True in a derivation whose shapes are not progress.
    is_silent: bool,
    told: Progress,
}

impl Checkpoint {
    /// The first checkpoint of a run.
    pub(crate) fn first(settings: &Settings) -> Self {
        let stride = if settings.watch.is_some() { STRIDE } else { u64::MAX };
        // Larger numbers mark a run that has ended.
        let most = settings.limits.shapes_in(settings.limits.bytes).min(MOST_SHAPES);
        Checkpoint {
            shapes: most.min(stride),
            quiet: most.min(STRIDE - 1),
            calls: settings.limits.calls.min(stride),
            ..Checkpoint::default()
        }
    }

    /// Makes no checkpoint later than a number of shapes.
    pub(super) fn lower(&mut self, most: u64) {
        self.shapes = self.shapes.min(most);
        self.quiet = self.quiet.min(most);
    }

    /// Returns true while room is measured: a template is recorded.
    pub(crate) fn measures_room(&self) -> bool {
        self.recorded.is_some()
    }
}

impl Env {
    /// Handles a request for `more` shapes that passes the checkpoint.
    #[cold]
    #[inline(never)]
    pub(crate) fn make_room(&mut self, more: u64) -> Flow {
        if self.has_quiet_room(more) { ControlFlow::Continue(()) } else { self.make_room_beyond(more) }
    }

    /// Handles a request for `more` shapes at a limit, for the watch or while room is measured.
    #[cold]
    #[inline(never)]
    fn make_room_beyond(&mut self, more: u64) -> Flow {
        let wanted = self.shape_count().saturating_add(more);
        let limit = self.most_shapes();
        if limit < wanted {
            return self.too_many_shapes();
        }
        if let Some(most) = &mut self.checkpoint.recorded {
            *most = wanted.max(*most);
            if self.checkpoint.shapes != 0 {
                self.checkpoint.shapes = *most;
            }
            return ControlFlow::Continue(());
        }
        if self.stops_at_each_shape() {
            self.checkpoint.quiet = limit.min(wanted.saturating_add(STRIDE - 1));
            return if self.checkpoint.is_silent { self.ask() } else { self.ask_watch() };
        }
        self.checkpoint.shapes = limit.min(wanted.saturating_add(STRIDE));
        self.ask_watch()
    }

    /// Returns true if `more` shapes pass the checkpoint only because it stays 0, as in a run that records its tree or keys.
    #[inline]
    pub(crate) fn has_quiet_room(&self, more: u64) -> bool {
        let wanted = self.shape_count().saturating_add(more);
        self.stops_at_each_shape() && !self.measures_room() && wanted <= self.checkpoint.quiet
    }

    /// Returns true if `more` shapes do not pass the limit.
    pub(crate) fn is_within_limit(&self, more: u64) -> bool {
        self.shape_count().saturating_add(more) <= self.most_shapes()
    }

    /// Begins to measure the room that a derivation requests. Returns the checkpoint to restore.
    pub(crate) fn measure_room(&mut self) -> u64 {
        let (count, before) = (self.shape_count(), self.checkpoint.shapes);
        self.checkpoint.recorded = Some(count);
        // In a run that stops at each shape, it stays 0.
        self.checkpoint.shapes = before.min(count);
        before
    }

    /// Returns true while room is measured.
    pub(crate) fn measures_room(&self) -> bool {
        self.checkpoint.measures_room()
    }

    /// Returns true while the checkpoint is 0, so that each shape passes it: in a run that records the tree of shapes or their keys.
    fn stops_at_each_shape(&self) -> bool {
        self.checkpoint.shapes == 0
    }

    /// Tells the watch nothing of this derivation: its shapes are not progress.
    pub(crate) fn tell_no_progress(&mut self) {
        self.checkpoint.is_silent = true;
    }

    /// Ends the measurement. Returns the highest count of shapes requested.
    pub(crate) fn measured_room(&mut self, checkpoint: u64) -> u64 {
        self.checkpoint.shapes = checkpoint;
        self.checkpoint.recorded.take().unwrap_or_default()
    }

    /// Handles the counter of calls at its checkpoint.
    #[cold]
    pub(crate) fn at_calls(&mut self) -> Flow {
        let limit = self.settings.limits.calls;
        if limit < self.calls.made {
            return self.limit(LimitKind::Calls, limit);
        }
        self.checkpoint.calls = limit.min(self.calls.made.saturating_add(STRIDE));
        self.ask_watch()
    }

    /// Asks the watch before a step that is not slim. `Break` if the run has ended. Progress is not told: the counters of a watch
    /// are shared by threads.
    #[inline]
    pub fn ask(&mut self) -> Flow {
        let is_stopped = self.settings.watch.as_ref().is_some_and(Watch::is_stopped);
        if is_stopped || self.ended() { self.ask_watch() } else { ControlFlow::Continue(()) }
    }

    /// Counts units of work of a step that is not slim, and asks the watch after many. `Break` if the run has ended.
    pub(crate) fn spend(&mut self, units: usize) -> Flow {
        if work::spend(units) { ControlFlow::Continue(()) } else { self.ask_watch() }
    }

    /// Reports the progress to the watch, and ends the run if the watch is stopped.
    #[cold]
    fn ask_watch(&mut self) -> Flow {
        if !self.ended() && !self.measures_room() && !self.checkpoint.is_silent {
            self.tell_watch(false);
        }
        if work::ask() {
            return if self.ended() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
        }
        if !self.ended() {
            self.checkpoint.stopped_at = Some(self.shape_count());
            // As in `limit`: the next count ends the run.
            self.shapes = ENDED;
        }
        ControlFlow::Break(())
    }

    /// Reports the progress since the last report to the watch. `complete` marks the end of a run that was not cut
    /// short.
    pub(crate) fn tell_watch(&mut self, complete: bool) {
        let Some(watch) = &self.settings.watch else { return };
        let now = Progress {
            initial_shapes: u64::from(complete),
            shapes: self.shapes_made(),
            leaves: self.leaf_count(),
            // Counted by the thread: see `work`.
            work: 0,
        };
        let told = std::mem::replace(&mut self.checkpoint.told, now);
        watch.advance(Progress {
            shapes: now.shapes.saturating_sub(told.shapes),
            leaves: now.leaves.saturating_sub(told.leaves),
            ..now
        });
    }

    /// The number of shapes derived so far. Once the run has ended, the counter itself is only a mark.
    pub(crate) fn shapes_made(&self) -> u64 {
        match self.checkpoint.stopped_at {
            Some(shapes) => shapes,
            // A limit was reached; the run has no report.
            None if self.ended() => self.checkpoint.told.shapes,
            None => self.shape_count(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::settings::Limits;
    use crate::shape::Shape;

    fn env(limits: Limits, watch: Option<Watch>) -> Env {
        let settings = Settings { limits, watch, ..Settings::default() };
        Env::with_names(&settings, &["Lot"], &Shape::cuboid(1.0, 1.0, 1.0), "Lot")
    }

    fn count(env: &mut Env, shapes: u64) -> Flow {
        env.shapes += shapes;
        if env.has_room(0) { ControlFlow::Continue(()) } else { env.make_room(0) }
    }

    #[test]
    fn what_ended_goes_on_counting_nothing() {
        let limits = Limits { shapes: u64::MAX, calls: u64::MAX, ..Limits::default() };
        for watch in [None, Some(Watch::new())] {
            let mut env = env(limits, watch);
            assert!(env.limit::<()>(LimitKind::Vertices, 1).is_break());
            assert!(count(&mut env, 1).is_break() && env.error.is_some() && !env.call(1));
        }
    }

    #[test]
    fn a_stopped_run_keeps_its_count_and_gets_no_error() {
        let watch = Watch::new();
        let mut env = env(Limits::default(), Some(watch.clone()));
        assert!(count(&mut env, STRIDE).is_continue());
        watch.stop();
        assert!(count(&mut env, 1).is_break() && count(&mut env, 1).is_break());
        assert!(env.limit::<()>(LimitKind::Shapes, 1).is_break() && env.error.is_none() && !env.call(1));
        env.tell_watch(false);
        assert_eq!((env.shapes_made(), watch.progress().shapes), (STRIDE + 1, STRIDE + 1));
    }

    #[test]
    fn the_callback_comes_in_its_steps() {
        let (steps, seen) = std::sync::mpsc::channel();
        let watch = Watch::every(100_000, move |progress| {
            let _ = steps.send(progress.shapes);
            ControlFlow::Continue(())
        });
        let mut env = env(Limits::default(), Some(watch.clone()));
        for _ in 0..400_000 {
            assert!(count(&mut env, 1).is_continue());
        }
        env.tell_watch(true);
        let steps: Vec<u64> = seen.try_iter().collect();
        assert_eq!(steps.iter().map(|shapes| shapes / 100_000).collect::<Vec<_>>(), [1, 2, 3, 4]);
        assert_eq!((watch.progress().initial_shapes, watch.progress().shapes), (1, 400_000));
    }
}
