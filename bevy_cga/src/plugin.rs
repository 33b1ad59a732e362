//! The plugin and its systems.

use bevy_app::{App, Plugin, PostUpdate};
#[cfg(feature = "eval")]
use bevy_asset::AssetApp;
use bevy_asset::{AssetEventSystems, Assets};
use bevy_ecs::change_detection::{DetectChanges, DetectChangesMut};
use bevy_ecs::entity::{Entity, EntityIndexSet};
use bevy_ecs::lifecycle::Remove;
use bevy_ecs::observer::On;
use bevy_ecs::query::Changed;
use bevy_ecs::schedule::common_conditions::resource_changed;
use bevy_ecs::schedule::{IntoScheduleConfigs, SystemSet};
use bevy_ecs::system::{Commands, Query, Res, ResMut};
use bevy_ecs::world::Ref;
use bevy_mesh::Mesh;
use bevy_transform::TransformSystems;
use bevy_transform::components::Transform;

use crate::parts::{CgaModel, CgaOrigin, CgaRoot};
use crate::run::CgaRun;
use crate::scene::{Affected, CgaLotOf, CgaScene, LotChange, Scenes};
use crate::show::{end, root_transform};
use crate::source::Cga;

/// Runs the grammars of entities with [`Cga`] and shows their models.
///
/// It needs `AssetPlugin` and `MeshPlugin`, which are part of Bevy's `DefaultPlugins`.
#[derive(Clone, Debug, Default)]
pub struct CgaPlugin {
    /// The folder of images below Bevy's asset folder, for the feature `pbr`: empty, or such as `"buildings"`.
    pub image_folder: String,
}

/// The systems of [`CgaPlugin`], in `PostUpdate`. Changes of [`Cga`] before them start runs in the same frame.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CgaSystems;

impl Plugin for CgaPlugin {
    fn build(&self, app: &mut App) {
        app.init_resource::<CgaOrigin>()
            .init_resource::<Scenes>()
            .add_observer(remove_model)
            .add_observer(note_removed)
            .add_systems(
                PostUpdate,
                (start_runs, end_runs, move_roots.run_if(resource_changed::<CgaOrigin>))
                    .chain()
                    .in_set(CgaSystems)
                    // The renderer takes new meshes in the frame in which it loses the old ones.
                    .before(AssetEventSystems)
                    .before(TransformSystems::Propagate),
            );
        #[cfg(feature = "eval")]
        app.init_asset::<crate::CgaRules>()
            .register_asset_loader(crate::CgaRuleLoader::default())
            .add_systems(PostUpdate, crate::rules::take_rules.in_set(CgaSystems).before(start_runs));
        #[cfg(feature = "pbr")]
        crate::pbr::build(app, &self.image_folder);
    }

    fn finish(&self, app: &mut App) {
        if !app.world().contains_resource::<Assets<Mesh>>() {
            tracing::error!("`CgaPlugin` shows no models without `MeshPlugin`: add it, or Bevy's `DefaultPlugins`");
        }
    }
}

/// Starts a run for each entity that has changed and for the lots that can ask about it, or marks the run under way.
fn start_runs(
    (grammars, lots): (Query<Entity, Changed<Cga>>, Query<Entity, Changed<CgaLotOf>>),
    entities: Query<(Ref<Cga>, Option<&CgaLotOf>)>,
    (scenes, changed_scenes): (Query<&CgaScene>, Query<Entity, Changed<CgaScene>>),
    mut known: ResMut<Scenes>,
    mut runs: Query<(&Cga, Option<&mut CgaRun>)>,
    mut commands: Commands,
) {
    let removed = known.take_removed();
    let touched: EntityIndexSet = grammars.iter().chain(&lots).chain(removed.iter().copied()).collect();
    let changed_scenes: Vec<Entity> = changed_scenes.iter().chain(removed).collect();
    let (mut alone, mut changes) = (Vec::new(), Vec::new());
    for entity in touched {
        let cga = entities.get(entity).ok();
        let is_changed = cga.as_ref().is_some_and(|(cga, _)| cga.is_changed());
        let from = known.scene_of(entity);
        let to = cga.as_ref().and_then(|(_, lot)| Some(lot.as_ref()?.0));
        if to.is_none() && is_changed {
            alone.push(entity);
        }
        if from != to || to.is_some() && is_changed {
            let is_new = to.is_some() && (from.is_none() || is_changed);
            let state = cga.filter(|_| is_new).map(|(cga, _)| cga.scene_lot());
            changes.push(LotChange { lot: entity, from, to, state, is_changed });
        }
    }
    let distances = |scene| scenes.get(scene).copied().unwrap_or_default();
    // The passes live until the runs share them.
    let Affected { mut lots, passes: _passes } = known.update(changes, &changed_scenes, distances);
    lots.extend(alone);
    for entity in lots {
        match runs.get_mut(entity) {
            Ok((_, Some(mut run))) => run.is_outdated = true,
            Ok((cga, None)) => {
                commands.entity(entity).try_insert(CgaRun::start(cga, known.place_of(entity)));
            }
            // It was despawned, or its grammar was removed.
            Err(_) => {}
        }
    }
}

/// Notes an entity that may leave a scene, or a scene that may lose its distances. Unlike messages, the list waits for systems that pause.
fn note_removed(removed: On<Remove, (Cga, CgaLotOf, CgaScene)>, mut known: ResMut<Scenes>) {
    known.note_removed(removed.entity);
}

/// Shows the results of runs that have ended.
fn end_runs(mut runs: Query<(Entity, &mut CgaRun)>, meshes: Option<Res<Assets<Mesh>>>, mut commands: Commands) {
    if meshes.is_none() {
        return;
    }
    for (entity, mut run) in &mut runs {
        if let Some(result) = run.bypass_change_detection().poll() {
            commands.queue(move |world: &mut bevy_ecs::world::World| end(world, entity, result));
        }
    }
}

/// Moves all models after a change of the origin.
fn move_roots(origin: Res<CgaOrigin>, mut roots: Query<(&CgaRoot, &mut Transform)>) {
    for (root, mut transform) in &mut roots {
        *transform = root_transform(root.origin, Some(&origin));
    }
}

/// Removes run and model of an entity that loses its grammar.
fn remove_model(removed: On<Remove, Cga>, models: Query<&CgaModel>, mut commands: Commands) {
    if let Ok(model) = models.get(removed.entity) {
        commands.entity(model.root).try_despawn();
    }
    commands.entity(removed.entity).try_remove::<(CgaRun, CgaModel)>();
}
