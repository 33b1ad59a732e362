//! Events for observers: a model is there, a run failed, and leaves.

use std::fmt;
use std::sync::Arc;

use bevy_ecs::entity::Entity;
use bevy_ecs::event::EntityEvent;
use bevy_math::Vec3;
use bevy_transform::components::Transform;
use cga::{Error, LeafView, Model};

/// The new model of an entity with [`Cga`](crate::Cga) has replaced the old one. It comes after the events of leaves.
#[derive(EntityEvent, Clone, Debug)]
pub struct CgaGenerated {
    /// The entity with [`Cga`](crate::Cga).
    pub entity: Entity,
    /// The parent of all meshes.
    pub root: Entity,
    /// The model: leaves, reports, faults.
    pub model: Arc<Model>,
    /// False if the component, or a lot of the scene that its rules can ask about, has changed since the run began. Then
    /// the next run is under way.
    pub is_newest: bool,
}

/// A run ended without a model. The old model stays.
#[derive(EntityEvent, Clone, Debug)]
pub struct CgaFailed {
    /// The entity with [`Cga`](crate::Cga).
    pub entity: Entity,
    /// The reason.
    pub error: CgaError,
}

/// A leaf of a new model, on request ([`Cga::leaf_events`](crate::Cga::leaf_events)). Entities that an observer spawns
/// as children of `root` disappear with the model:
///
/// ```
/// # use bevy_cga::CgaLeaf;
/// # use bevy_ecs::prelude::*;
/// # #[derive(Component)] struct Lamp;
/// fn add_lamps(leaf: On<CgaLeaf>, mut commands: Commands) {
///     if leaf.rule() == "Lamp" {
///         commands.spawn((Lamp, leaf.transform, ChildOf(leaf.root)));
///     }
/// }
/// # World::new().add_observer(add_lamps);
/// ```
#[derive(EntityEvent, Clone, Debug)]
pub struct CgaLeaf {
    /// The entity with [`Cga`](crate::Cga).
    pub entity: Entity,
    /// The parent of all meshes.
    pub root: Entity,
    /// The model: all leaves and reports.
    pub model: Arc<Model>,
    /// The index of the leaf in [`Model::leaves`].
    pub leaf: usize,
    /// The place of its scope's low corner and the direction of the scope's axes, relative to `root`.
    pub transform: Transform,
    /// The size of its scope in metres, along the axes of `transform`. A negative size mirrors.
    pub size: Vec3,
}

impl CgaLeaf {
    /// The leaf in the model: rule, material, geometry.
    ///
    /// # Panics
    /// Only if `leaf` was changed to a number out of range.
    pub fn view(&self) -> LeafView<'_> {
        self.model.leaves().nth(self.leaf).expect("the index of a leaf")
    }

    /// The name of its rule or leaf symbol, without the dot.
    pub fn rule(&self) -> &str {
        self.view().rule()
    }

    /// The centre of its scope, relative to `root`.
    pub fn centre(&self) -> Vec3 {
        self.transform.transform_point(self.size * 0.5)
    }
}

/// The reason why a run ended without a model.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CgaError {
    /// The error of the run.
    Run(Error),
    /// The watch of the settings was stopped.
    Stopped,
    /// An operation written in Rust, a source of assets or a watch panicked, with this message.
    Panic(String),
}

impl fmt::Display for CgaError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CgaError::Run(error) => error.fmt(f),
            CgaError::Stopped => f.write_str("the watch of the settings was stopped"),
            CgaError::Panic(message) => write!(f, "the run panicked: {message}"),
        }
    }
}

impl std::error::Error for CgaError {}
