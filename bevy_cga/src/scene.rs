//! Lots whose rules ask about each other.

use std::collections::BTreeMap;
use std::sync::{Arc, Weak};

use bevy_ecs::component::Component;
use bevy_ecs::entity::{Entity, EntityHashMap, EntityIndexSet};
use bevy_ecs::resource::Resource;
use cga::{Error, Model, SceneLot, SharedScene, Watch};

/// A scene. The rules of its lots, the entities with [`CgaLotOf`], may ask about each other.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct CgaScene {
    /// The distance in metres up to which occlusion queries ask about another lot, as
    /// [`Scene::occlusion_distance`](cga::Scene::occlusion_distance): 1 by default.
    pub occlusion_distance: f64,
    /// The distance in metres up to which queries of labelled shapes ask about another lot, as
    /// [`Scene::context_distance`](cga::Scene::context_distance): infinite by default.
    pub context_distance: f64,
}

impl Default for CgaScene {
    fn default() -> Self {
        CgaScene { occlusion_distance: 1.0, context_distance: f64::INFINITY }
    }
}

/// The scene of a lot, beside its [`Cga`](crate::Cga). Without it, rules know no neighbours.
///
/// If a lot changes, comes, goes, or moves to another scene, the lots whose rules can ask about its old or its new state run again too, and no
/// other. The models equal the models of a [`cga::Scene`] with the same lots. A lot that fails leaves no shapes for its neighbours.
///
/// If the scene is despawned, its lots stay, without neighbours. Insert `ChildOf` as well to despawn them with the scene.
#[derive(Component, Clone, Copy, Debug, PartialEq, Eq)]
#[relationship(relationship_target = CgaLots)]
pub struct CgaLotOf(#[entities] pub Entity);

/// The lots of a scene. Bevy keeps the list as [`CgaLotOf`] changes.
#[derive(Component, Debug, Default)]
#[relationship_target(relationship = CgaLotOf)]
#[require(CgaScene)]
pub struct CgaLots(Vec<Entity>);

/// The scenes as the runs know them.
#[derive(Resource, Debug, Default)]
pub(crate) struct Scenes {
    scenes: EntityHashMap<SceneState>,
    /// The scene of each lot.
    of_lots: EntityHashMap<Entity>,
    /// The entities that have lost a component since the last look.
    removed: Vec<Entity>,
}

#[derive(Debug, Default)]
struct SceneState {
    distances: CgaScene,
    lots: BTreeMap<Entity, Arc<SceneLot>>,
    /// The scene that runs share, with the neighbours that they have derived. It is dropped with the last of them.
    pass: Weak<Pass>,
}

/// A state of a scene, for all runs from one change to the next.
#[derive(Debug)]
pub(crate) struct Pass {
    distances: CgaScene,
    /// The entities of the lots, in ascending order.
    entities: Vec<Entity>,
    scene: SharedScene,
}

/// A lot in a state of its scene.
#[derive(Debug)]
pub(crate) struct LotPlace {
    pass: Arc<Pass>,
    index: usize,
}

/// A change of an entity that is or was a lot of a scene.
#[derive(Debug)]
pub(crate) struct LotChange {
    pub(crate) lot: Entity,
    /// The scene that it comes from.
    pub(crate) from: Option<Entity>,
    /// The scene that it is part of now.
    pub(crate) to: Option<Entity>,
    /// The state in the new scene; `None` to keep the known one.
    pub(crate) state: Option<SceneLot>,
    /// True if the lot runs in any case.
    pub(crate) is_changed: bool,
}

/// The effects of changes.
#[derive(Debug, Default)]
pub(crate) struct Affected {
    /// The lots that run again.
    pub(crate) lots: EntityIndexSet,
    /// The new states of the scenes, for the runs to share.
    pub(crate) passes: BTreeMap<Entity, Arc<Pass>>,
}

impl Scenes {
    /// Notes an entity that has lost its grammar, its scene or its distances, if it is known as a lot or a scene.
    pub(crate) fn note_removed(&mut self, entity: Entity) {
        if self.of_lots.contains_key(&entity) || self.scenes.contains_key(&entity) {
            self.removed.push(entity);
        }
    }

    /// The noted entities, which are forgotten.
    pub(crate) fn take_removed(&mut self) -> Vec<Entity> {
        std::mem::take(&mut self.removed)
    }

    /// The scene of a lot.
    pub(crate) fn scene_of(&self, lot: Entity) -> Option<Entity> {
        self.of_lots.get(&lot).copied()
    }

    /// The place of a lot in the newest state of its scene. `None` for an entity outside of scenes.
    pub(crate) fn place_of(&mut self, lot: Entity) -> Option<LotPlace> {
        let pass = self.pass(self.scene_of(lot)?);
        let index = pass.index_of(lot)?;
        Some(LotPlace { pass, index })
    }

    /// Takes over changes of lots, and the distances of the scenes in `scenes`.
    pub(crate) fn update(
        &mut self,
        changes: Vec<LotChange>,
        scenes: &[Entity],
        distances: impl Fn(Entity) -> CgaScene,
    ) -> Affected {
        let mut different: EntityIndexSet =
            changes.iter().flat_map(|change| [change.from, change.to]).flatten().collect();
        different.extend(scenes.iter().filter(|scene| self.scenes.contains_key(*scene)));
        let old: BTreeMap<Entity, Arc<Pass>> = different.iter().map(|scene| (*scene, self.pass(*scene))).collect();
        let changes: Vec<TakenChange> = changes.into_iter().filter_map(|change| self.take(change)).collect();
        for scene in &different {
            let Some(state) = self.scenes.get_mut(scene) else { continue };
            (state.distances, state.pass) = (distances(*scene), Weak::new());
            if state.lots.is_empty() {
                self.scenes.remove(scene);
            }
        }
        let new: BTreeMap<Entity, Arc<Pass>> = different.iter().map(|scene| (*scene, self.pass(*scene))).collect();
        let runs_again = |change: &&TakenChange| change.is_changed || change.sees_others(&old, &new);
        let mut lots: EntityIndexSet = changes.iter().filter(runs_again).map(|change| change.lot).collect();
        let own: EntityIndexSet = changes.iter().map(|change| change.lot).collect();
        for (scene, new) in &new {
            if new.entities.iter().all(|lot| lots.contains(lot)) {
                continue;
            }
            let old = &old[scene];
            let states = |state: fn(&TakenChange) -> &Option<LotState>| {
                let own = changes.iter().filter_map(move |change| state(change).as_ref());
                own.filter(|(of, _)| of == scene).map(|(_, lot)| &**lot).collect::<Vec<&SceneLot>>()
            };
            let mut affected = old.affected_by(&states(|change| &change.old));
            affected.extend(new.affected_by(&states(|change| &change.new)));
            affected.retain(|lot| self.scene_of(*lot) == Some(*scene) && !own.contains(lot));
            lots.extend(affected);
            if old.distances != new.distances {
                let sees_others = |lot: &&Entity| old.neighbours(**lot) != new.neighbours(**lot);
                lots.extend(new.entities.iter().filter(sees_others));
            }
        }
        Affected { lots, passes: new }
    }

    /// Takes over a change. `None` for an entity without a state.
    fn take(&mut self, change: LotChange) -> Option<TakenChange> {
        let LotChange { lot, from, to, state, is_changed } = change;
        let old = from.and_then(|scene| Some((scene, self.scenes.get_mut(&scene)?.lots.remove(&lot)?)));
        self.of_lots.remove(&lot);
        let state = state.map(Arc::new).or_else(|| old.as_ref().map(|(_, lot)| lot.clone()))?;
        let new = to.map(|scene| (scene, state));
        if let Some((scene, state)) = &new {
            self.of_lots.insert(lot, *scene);
            self.scenes.entry(*scene).or_default().lots.insert(lot, state.clone());
        }
        Some(TakenChange { lot, old, new, is_changed })
    }

    /// The newest state of a scene.
    fn pass(&mut self, scene: Entity) -> Arc<Pass> {
        let Some(state) = self.scenes.get_mut(&scene) else { return Arc::new(Pass::of(&SceneState::default())) };
        state.pass.upgrade().unwrap_or_else(|| {
            let pass = Arc::new(Pass::of(state));
            state.pass = Arc::downgrade(&pass);
            pass
        })
    }
}

/// A scene and the state of a lot in it.
type LotState = (Entity, Arc<SceneLot>);

/// A change with the states of the lot in its scenes.
#[derive(Debug)]
struct TakenChange {
    lot: Entity,
    old: Option<LotState>,
    new: Option<LotState>,
    is_changed: bool,
}

impl TakenChange {
    /// Returns true if a move to another scene can change the model of the lot itself.
    fn sees_others(&self, old: &BTreeMap<Entity, Arc<Pass>>, new: &BTreeMap<Entity, Arc<Pass>>) -> bool {
        let asks = |(_, state): &LotState| state.asks_about_neighbours();
        if !self.new.as_ref().or(self.old.as_ref()).is_some_and(asks) {
            return false;
        }
        match (&self.old, &self.new) {
            (Some((from, _)), Some((to, _))) => {
                [&old[from], &new[to]].iter().any(|pass| !pass.neighbours(self.lot).iter().all(Vec::is_empty))
            }
            // Outside of scenes, queries of neighbours are faults.
            _ => true,
        }
    }
}

impl Pass {
    fn of(state: &SceneState) -> Self {
        let CgaScene { occlusion_distance, context_distance } = state.distances;
        let scene = SharedScene::new(state.lots.values().cloned().collect())
            .occlusion_distance(occlusion_distance)
            .context_distance(context_distance);
        Pass { distances: state.distances, entities: state.lots.keys().copied().collect(), scene }
    }

    fn index_of(&self, lot: Entity) -> Option<usize> {
        self.entities.binary_search(&lot).ok()
    }

    fn affected_by(&self, changed: &[&SceneLot]) -> Vec<Entity> {
        self.scene.affected_by(changed).into_iter().map(|index| self.entities[index]).collect()
    }

    /// The lots that the occlusion queries of one can ask about, and the ones that its queries of labelled shapes can.
    fn neighbours(&self, lot: Entity) -> [Vec<Entity>; 2] {
        let Some(index) = self.index_of(lot) else { return Default::default() };
        [self.scene.occlusion_neighbours(index), self.scene.context_neighbours(index)]
            .map(|list| list.into_iter().map(|index| self.entities[index]).collect())
    }
}

impl LotPlace {
    /// Runs the lot among its neighbours.
    pub(crate) fn generate(&self, watch: Option<&Watch>) -> Result<Model, Error> {
        self.pass.scene.generate_lot(self.index, watch)
    }
}
