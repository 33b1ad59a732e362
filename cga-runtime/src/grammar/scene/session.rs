//! Runs of the initial shapes of a scene, one after another, into sinks of the caller.

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use super::Scene;
use super::ghosts::{Derivations, SceneRun};
use crate::fault::Error;
use crate::grammar::parallel::Worker;
use crate::run::derive::{NoResult, RunOutcome};
use crate::run::ghost::{Collect, Ghost};
use crate::run::report::Report;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::run::surroundings::Neighbours;
use crate::shape::Shape;

/// Runs of some initial shapes of a [`Scene`], one after another and each once. Made by [`Scene::session`].
///
/// Each neighbour is derived once for all runs. A neighbour that fails or panics leaves no shapes, and its own run reports the error: as in a
/// [`SharedScene`](super::shared::SharedScene), one wrong initial shape takes none of the others with it.
pub struct SceneSession<'s> {
    scene: Scene<'s>,
    settings: Settings,
    session: Worker<'s>,
    run: SceneRun,
}

impl fmt::Debug for SceneSession<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SceneSession").field("scene", &self.scene).finish_non_exhaustive()
    }
}

impl<'s> SceneSession<'s> {
    pub(super) fn open(scene: Scene<'s>, settings: &Settings) -> Result<Self, Error> {
        let mut session = scene.open(&Settings { echo: false, ..settings.clone() })?;
        let run = scene.scene_run(&mut session);
        run.count_users();
        Ok(SceneSession { scene, settings: settings.clone(), session, run })
    }

    /// Runs the initial shape with an index among its neighbours, and hands the leaves to a sink. The sink is not
    /// [finished](Sink::finish): more runs may follow.
    ///
    /// # Errors
    /// [`Error::Shape`] for an index out of range, and the errors of a run.
    pub fn run(&mut self, index: usize, sink: &mut dyn Sink) -> Result<Report, Error> {
        if self.scene.lots.len() <= index {
            return Err(Error::Shape(format!("the scene has no initial shape {index}")));
        }
        let mut runs = Lenient { scene: &self.scene, settings: &self.settings, session: &mut self.session };
        self.run.outcome(&mut runs, index, sink).result(self.settings.echo)
    }
}

/// Derivations in one session. A neighbour that fails leaves no shapes.
struct Lenient<'a, 's> {
    scene: &'a Scene<'s>,
    settings: &'a Settings,
    session: &'a mut Worker<'s>,
}

impl Derivations for Lenient<'_, '_> {
    fn outcome(&mut self, index: usize, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        self.session.outcome(&self.scene.lots[index], neighbours, sink)
    }

    fn ghost(&mut self, index: usize, collect: Collect) -> Result<Option<Ghost>, NoResult> {
        let lot: &Shape = &self.scene.lots[index];
        match catch_unwind(AssertUnwindSafe(|| self.session.ghost(lot, collect))) {
            Ok(Ok(ghost)) => Ok(Some(ghost)),
            Ok(Err(NoResult::Failed(_))) => Ok(Some(Ghost::default())),
            Ok(Err(NoResult::Stopped)) => Err(NoResult::Stopped),
            Err(_) => {
                // A session that panicked may be in any state.
                let quiet = Settings { echo: false, ..self.settings.clone() };
                *self.session = self.scene.open(&quiet).map_err(NoResult::Failed)?;
                Ok(Some(Ghost::default()))
            }
        }
    }
}
