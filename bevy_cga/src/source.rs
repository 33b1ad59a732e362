//! The component that describes a model: a grammar, an initial shape and settings.

use bevy_asset::RenderAssetUsages;
use bevy_ecs::component::Component;
use bevy_transform::components::Transform;
use cga::sink::meshes::Granularity;
use cga::{Grammar, SceneLot, Settings, Shape};

/// A grammar on an initial shape. Its model becomes a child of this entity.
///
/// A change of the component starts a run in the background. The old model stays until the new one replaces it. While a
/// run is under way, further changes wait for its end; then one run uses the newest state. So the last change always
/// becomes visible, and a slider that moves every frame shows models on the way.
///
/// Change detection of Bevy decides: a mutable access counts as a change, also if it sets an equal value.
///
/// Its rules know no neighbours, unless the entity is a lot of a scene: [`CgaLotOf`](crate::CgaLotOf).
///
/// The entity's own [`Transform`] moves the model; `bevy_cga` does not change it. Coordinates of the shape are relative
/// to [`CgaOrigin`](crate::CgaOrigin).
#[derive(Component, Clone)]
#[require(Transform)]
pub struct Cga {
    /// The grammar with its attributes. [`Grammar::set`] changes an attribute by its name.
    pub grammar: Box<dyn Grammar + Send + Sync>,
    /// The initial shape: footprint, place, seed.
    pub shape: Shape,
    /// Start rule, limits and assets. With a watch, a run ends when the watch is stopped, and the old model stays.
    pub settings: Settings,
    /// The division into meshes.
    pub granularity: Granularity,
    /// The leaves with an event of their own, [`CgaLeaf`](crate::CgaLeaf).
    pub leaf_events: LeafEvents,
    /// True for meshes whose triangles meet edge to edge, so that the camera sees no pixel through a wall
    /// ([`cga::Model::watertight`]). They have up to 1.8 times as many triangles. False by default.
    pub watertight: bool,
    /// The memory that holds the meshes. Colliders and ray casts need `MAIN_WORLD`, the renderer `RENDER_WORLD`.
    pub usages: RenderAssetUsages,
}

/// The leaves with an event of their own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum LeafEvents {
    /// No leaf.
    #[default]
    None,
    /// All leaves.
    All,
    /// The leaves of some rules, by the name without the dot.
    Rules(Vec<String>),
}

impl Cga {
    /// A grammar on a shape, with default settings: one mesh for each material, no events for leaves, meshes in the main
    /// world and in the render world.
    pub fn new(grammar: impl Grammar, shape: Shape) -> Self {
        Cga {
            grammar: grammar.boxed(),
            shape,
            settings: Settings::default(),
            granularity: Granularity::default(),
            leaf_events: LeafEvents::default(),
            watertight: false,
            usages: RenderAssetUsages::default(),
        }
    }

    /// Sets the settings of runs.
    #[must_use]
    pub fn settings(self, settings: Settings) -> Self {
        Cga { settings, ..self }
    }

    /// Sets the division into meshes.
    #[must_use]
    pub fn granularity(self, granularity: Granularity) -> Self {
        Cga { granularity, ..self }
    }

    /// Sets the leaves with an event of their own.
    #[must_use]
    pub fn leaf_events(self, leaf_events: LeafEvents) -> Self {
        Cga { leaf_events, ..self }
    }

    /// Makes the meshes watertight: for models near the camera.
    #[must_use]
    pub fn watertight(self) -> Self {
        Cga { watertight: true, ..self }
    }

    /// Sets the memory that holds the meshes.
    #[must_use]
    pub fn usages(self, usages: RenderAssetUsages) -> Self {
        Cga { usages, ..self }
    }

    /// The lot of a scene.
    pub(crate) fn scene_lot(&self) -> SceneLot {
        SceneLot::new(self.grammar.clone(), self.shape.clone(), self.settings.clone())
    }
}

impl LeafEvents {
    /// Returns true if leaves of a rule have events.
    pub fn includes(&self, rule: &str) -> bool {
        match self {
            LeafEvents::None => false,
            LeafEvents::All => true,
            LeafEvents::Rules(names) => names.iter().any(|name| name == rule),
        }
    }
}
