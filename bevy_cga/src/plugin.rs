//! The plugin and its systems.

use bevy_app::{App, Plugin, PostUpdate};
#[cfg(feature = "eval")]
use bevy_asset::AssetApp;
use bevy_asset::{AssetEventSystems, Assets};
use bevy_ecs::change_detection::DetectChangesMut;
use bevy_ecs::entity::Entity;
use bevy_ecs::lifecycle::Remove;
use bevy_ecs::observer::On;
use bevy_ecs::query::Changed;
use bevy_ecs::schedule::common_conditions::resource_changed;
use bevy_ecs::schedule::{IntoScheduleConfigs, SystemSet};
use bevy_ecs::system::{Commands, Query, Res};
use bevy_mesh::Mesh;
use bevy_transform::TransformSystems;
use bevy_transform::components::Transform;

use crate::parts::{CgaModel, CgaOrigin, CgaRoot};
use crate::run::CgaRun;
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
        app.init_resource::<CgaOrigin>().add_observer(remove_model).add_systems(
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

/// Starts a run for each change, or marks the run under way.
fn start_runs(mut changed: Query<(Entity, &Cga, Option<&mut CgaRun>), Changed<Cga>>, mut commands: Commands) {
    for (entity, cga, run) in &mut changed {
        match run {
            Some(mut run) => run.is_outdated = true,
            None => {
                commands.entity(entity).try_insert(CgaRun::start(cga));
            }
        }
    }
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
