//! Replaces the entities of the old model by the entities of the new one.

use bevy_asset::Assets;
use bevy_ecs::entity::Entity;
use bevy_ecs::hierarchy::ChildOf;
use bevy_ecs::name::Name;
use bevy_ecs::world::World;
use bevy_mesh::{Mesh, Mesh3d};
use bevy_transform::components::Transform;
use cga::glam::DVec3;

use crate::convert;
use crate::event::{CgaError, CgaFailed, CgaGenerated, CgaLeaf};
use crate::parts::{CgaModel, CgaOrigin, CgaRoot};
use crate::run::{CgaRun, Generated};
use crate::scene::Scenes;
use crate::source::Cga;

/// The faults of a model that are logged; its report has all.
const LOGGED: usize = 8;

/// Ends the run of an entity: shows the result or reports the error, and starts the next run if the component has
/// changed. An entity that has no run any more, or no grammar, is left alone.
pub(crate) fn end(world: &mut World, entity: Entity, result: Result<Generated, CgaError>) {
    let (Some(cga), Some(run)) = (world.get::<Cga>(entity), world.get::<CgaRun>(entity)) else { return };
    let is_newest = !run.is_outdated;
    if is_newest {
        world.entity_mut(entity).remove::<CgaRun>();
    } else {
        let cga = cga.clone();
        let place = world.resource_mut::<Scenes>().place_of(entity);
        world.entity_mut(entity).insert(CgaRun::start(&cga, place));
    }
    match result {
        Ok(generated) => show(world, entity, generated, is_newest),
        Err(error) => {
            tracing::error!("no model for {entity}: {error}");
            world.trigger(CgaFailed { entity, error });
        }
    }
}

fn show(world: &mut World, entity: Entity, generated: Generated, is_newest: bool) {
    let Generated { model, origin, meshes, leaves } = generated;
    let faults = model.faults();
    for fault in faults.iter().take(LOGGED) {
        tracing::warn!("{entity}: {fault}");
    }
    if LOGGED < faults.len() {
        tracing::warn!("{entity}: {} more faults", faults.len() - LOGGED);
    }
    if let Some(old) = world.get::<CgaModel>(entity).map(|old| old.root) {
        // Not there if the program has despawned it.
        let _ = world.try_despawn(old);
    }
    let moved = root_transform(origin, world.get_resource::<CgaOrigin>());
    let root = world.spawn((CgaRoot { origin }, Name::new("model"), moved, ChildOf(entity))).id();
    for generated in meshes {
        let mesh = Mesh3d(world.resource_mut::<Assets<Mesh>>().add(generated.mesh));
        #[cfg(feature = "pbr")]
        let material = generated.places.first().and_then(|place| crate::pbr::material(world, &place.part));
        for place in generated.places {
            let _child = world.spawn((Name::new(place.name), mesh.clone(), place.transform, place.part, ChildOf(root)));
            #[cfg(feature = "pbr")]
            if let Some(material) = &material {
                let mut child = _child;
                child.insert(material.clone());
            }
        }
    }
    // An observer of the meshes may have despawned the entity, and with it the root.
    let Ok(mut owner) = world.get_entity_mut(entity) else { return };
    owner.insert(CgaModel { model: model.clone(), root });
    for leaf in leaves {
        // An observer may have despawned the entity.
        if world.get_entity(root).is_err() {
            return;
        }
        let (transform, size) = (leaf.transform, leaf.size);
        world.trigger(CgaLeaf { entity, root, model: model.clone(), leaf: leaf.leaf, transform, size });
        // The commands of observers.
        world.flush();
    }
    if world.get_entity(root).is_ok() {
        world.trigger(CgaGenerated { entity, root, model, is_newest });
    }
}

/// The transform of the parent of all meshes.
pub(crate) fn root_transform(origin: DVec3, world_origin: Option<&CgaOrigin>) -> Transform {
    Transform::from_translation(convert::vector(origin - world_origin.copied().unwrap_or_default().0))
}
