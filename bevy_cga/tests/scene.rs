//! Lots of scenes, whose rules ask about each other.

mod common;

use std::panic::panic_any;

use bevy_app::{App, PostUpdate};
use bevy_cga::*;
use bevy_ecs::prelude::*;
use cga::sink::meshes::Granularity;
use cga::{Error, Grammars, Model, Scene, Settings, Shape, Watch, cga};
use common::*;

cga! {
    /// Houses whose windows vanish where a neighbour touches.
    grammar Row;
    attr height = 9
    Lot    --> extrude(height) comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { { 3 : Tile }* }
    Tile   --> case touches(inter) : PartyWall. else : Window.
}

cga! {
    /// Rules that panic.
    grammar Broken;
    Lot --> extrude(crate::broken()) Mass.
}

cga! {
    /// Labels, and no queries.
    grammar Church;
    Lot --> label("church") Church.
}

cga! {
    /// A query of labels in any distance.
    grammar Parish;
    Lot --> print(minimumDistance(inter, "church")) Parish.
}

cga! {
    /// A mass that reaches beyond its lot, with a label and both kinds of queries.
    grammar Wide;
    Lot  --> label("lot") s(^3, ^1, ^1) extrude(9) Mass
    Mass --> case overlaps(inter) : print(contextCount(inter, "lot")) Hidden. else : print(contextCount(inter, "lot")) Free.
}

fn broken() -> f64 {
    panic!("a broken function")
}

/// The lot with a number in a row of houses without gaps.
fn place(at: u8) -> Shape {
    Shape::rectangle(8.0, 10.0).at([8.0 * f64::from(at), 0.0, 0.0])
}

fn scene(app: &mut App) -> Entity {
    app.world_mut().spawn(CgaScene::default()).id()
}

fn add(app: &mut App, scene: Entity, cga: Cga) -> Entity {
    app.world_mut().spawn((cga, CgaLotOf(scene))).id()
}

/// A row with models.
fn row(app: &mut App, scene: Entity, count: u8) -> Vec<Entity> {
    let lots = (0..count).map(|at| add(app, scene, Cga::new(Row::default(), place(at)))).collect();
    settle(app);
    assert_eq!(runs(app), lots, "each runs once");
    lots
}

/// The entities that have got models since the last call, in ascending order.
fn runs(app: &mut App) -> Vec<Entity> {
    settle(app);
    let log = &mut *app.world_mut().resource_mut::<Log>();
    assert!(log.failed.is_empty(), "{:?}", log.failed);
    let mut list: Vec<Entity> = log.generated.drain(..).map(|event| event.entity).collect();
    list.sort_unstable_by_key(|entity| entity.index());
    list
}

/// Entities in ascending order.
fn sorted(entities: &[Entity]) -> Vec<Entity> {
    let mut list = entities.to_vec();
    list.sort_unstable_by_key(|entity| entity.index());
    list
}

fn model(app: &App, entity: Entity) -> &Model {
    &app.world().get::<CgaModel>(entity).expect("a model").model
}

fn count(app: &App, entity: Entity, rule: &str) -> usize {
    model(app, entity).count(rule)
}

/// Compares all lots of a scene with a scene of the core.
fn assert_equal_to_scene(app: &App, scene: Entity) {
    let world = app.world();
    let grammars = Grammars::new()
        .with(Row::default())
        .with(Field::default())
        .with(Church::default())
        .with(Parish::default())
        .with(Wide::default());
    let mut entities: Vec<Entity> = world.get::<CgaLots>(scene).map(|lots| lots.iter().collect()).unwrap_or_default();
    entities.retain(|entity| world.get::<Cga>(*entity).is_some());
    let lot = |entity: &Entity| {
        let Cga { grammar, shape, .. } = world.get::<Cga>(*entity).expect("a grammar");
        let lot = shape.clone().grammar(grammar.name());
        match grammar.get("height") {
            Ok(height) => lot.attribute("height", height),
            Err(_) => lot,
        }
    };
    let lots: Vec<Shape> = entities.iter().map(lot).collect();
    let distances = world.get::<CgaScene>(scene).copied().unwrap_or_default();
    let expected = Scene::of_grammars(&grammars, &lots)
        .occlusion_distance(distances.occlusion_distance)
        .context_distance(distances.context_distance);
    let expected = expected.generate(&Settings::default()).expect("models");
    assert_eq!(expected.len(), entities.len());
    for (entity, batch) in entities.iter().zip(expected) {
        assert_eq!(*model(app, *entity), batch.sink, "{entity}");
    }
}

#[test]
fn the_models_are_the_models_of_a_scene_for_any_order_of_entities() {
    for order in [[0, 1, 2, 3, 4], [3, 0, 4, 1, 2]] {
        let mut app = app();
        let scene = scene(&mut app);
        let mut lots = [Entity::PLACEHOLDER; 5];
        for at in order {
            let row = Row { height: f64::from(3 + at % 3 * 3) };
            lots[usize::from(at)] = add(&mut app, scene, Cga::new(row, place(at)));
        }
        assert_eq!(runs(&mut app), sorted(&lots));
        assert_equal_to_scene(&app, scene);
        let counts = lots.map(|lot| count(&app, lot, "PartyWall"));
        assert_eq!(counts, [1, 3, 3, 2, 1]);
    }
}

#[test]
fn a_change_of_one_lot_runs_the_lots_that_it_can_touch_and_no_other() {
    let mut app = app();
    let scene = scene(&mut app);
    let lots = row(&mut app, scene, 9);
    change_only(&mut app, lots[4], |cga| cga.grammar.set("height", 3.0.into()).expect("a height"));
    assert_eq!(runs(&mut app), lots[3..6]);
    assert_eq!([3, 4, 5].map(|at| count(&app, lots[at], "PartyWall")), [4, 2, 4]);
    assert_equal_to_scene(&app, scene);
    // A seed, the grammar, and the settings.
    change_only(&mut app, lots[0], |cga| cga.shape = cga.shape.clone().seed(3));
    assert_eq!(runs(&mut app), lots[..2]);
    change_only(&mut app, lots[8], |cga| *cga = Cga::new(Field::default(), place(8)));
    assert_eq!(runs(&mut app), lots[7..]);
    assert_equal_to_scene(&app, scene);
    // The place: its old and its new neighbours. The field at the end asks about nothing.
    change_only(&mut app, lots[4], |cga| cga.shape = place(9));
    assert_eq!(runs(&mut app), lots[3..6]);
    change_only(&mut app, lots[4], |cga| cga.shape = Shape::rectangle(8.0, 10.0).at([0.0, 0.0, 10.0]));
    assert_eq!(runs(&mut app), [lots[0], lots[1], lots[4]]);
    assert_equal_to_scene(&app, scene);
    // Several changes in one frame.
    for at in [2, 3, 6] {
        change_only(&mut app, lots[at], |cga| cga.grammar.set("height", 6.0.into()).expect("a height"));
    }
    assert_eq!(runs(&mut app), [&lots[1..4], &lots[5..8]].concat());
    assert_equal_to_scene(&app, scene);
    (0..5).for_each(|_| assert!(runs(&mut app).is_empty()));
}

#[test]
fn lots_come_go_and_move_to_other_scenes() {
    let mut app = app();
    let scenes = [scene(&mut app), scene(&mut app)];
    let lots = row(&mut app, scenes[0], 7);
    app.world_mut().despawn(lots[3]);
    assert_eq!(runs(&mut app), [lots[2], lots[4]]);
    assert_equal_to_scene(&app, scenes[0]);
    let new = add(&mut app, scenes[0], Cga::new(Row::default(), place(3)));
    assert_eq!(runs(&mut app), sorted(&[lots[2], new, lots[4]]));
    assert_equal_to_scene(&app, scenes[0]);
    app.world_mut().entity_mut(lots[0]).remove::<Cga>();
    assert_eq!(runs(&mut app), lots[1..2]);

    let others: Vec<Entity> =
        (0..3).map(|at| add(&mut app, scenes[1], Cga::new(Row::default(), place(6 + at)))).collect();
    assert_eq!(runs(&mut app), others);
    // It moves away from the house at place 5, into the house at place 6.
    app.world_mut().entity_mut(lots[6]).insert(CgaLotOf(scenes[1]));
    assert_eq!(runs(&mut app), sorted(&[lots[5], lots[6], others[0], others[1]]));
    scenes.iter().for_each(|scene| assert_equal_to_scene(&app, *scene));
    // Alone before and after, so no model changes.
    let far = add(&mut app, scenes[0], Cga::new(Row::default(), place(40)));
    assert_eq!(runs(&mut app), [far]);
    app.world_mut().entity_mut(far).insert(CgaLotOf(scenes[1]));
    assert!(runs(&mut app).is_empty());
    app.world_mut().entity_mut(far).insert(CgaLotOf(scenes[1]));
    assert!(runs(&mut app).is_empty());
    // Outside of scenes, queries of neighbours are faults.
    app.world_mut().entity_mut(far).remove::<CgaLotOf>();
    assert_eq!((runs(&mut app), model(&app, far).faults().len()), (vec![far], 1));
    app.world_mut().entity_mut(far).insert(CgaLotOf(scenes[0]));
    assert_eq!((runs(&mut app), model(&app, far).faults().len()), (vec![far], 0));
    scenes.iter().for_each(|scene| assert_equal_to_scene(&app, *scene));
}

#[test]
fn lots_that_ask_nothing_run_for_their_own_changes_alone() {
    let mut app = app();
    let first = scene(&mut app);
    let fields: Vec<Entity> = (0..4).map(|at| add(&mut app, first, Cga::new(Field::default(), place(at)))).collect();
    assert_eq!(runs(&mut app), fields);
    change_only(&mut app, fields[1], |cga| cga.granularity = Granularity::Leaf);
    assert_eq!(runs(&mut app), fields[1..2]);
    app.world_mut().despawn(fields[2]);
    assert!(runs(&mut app).is_empty());
    let second = scene(&mut app);
    app.world_mut().entity_mut(fields[0]).insert(CgaLotOf(second));
    app.world_mut().entity_mut(fields[3]).remove::<CgaLotOf>();
    assert!(runs(&mut app).is_empty());
    app.world_mut().despawn(first);
    assert!(runs(&mut app).is_empty());
}

#[test]
fn labels_reach_as_far_as_the_scene_tells() {
    let mut app = app();
    let scene = scene(&mut app);
    let church = add(&mut app, scene, Cga::new(Church::default(), place(0)));
    let field = add(&mut app, scene, Cga::new(Field::default(), place(1)));
    let parishes: Vec<Entity> =
        [2, 20].into_iter().map(|at| add(&mut app, scene, Cga::new(Parish::default(), place(at)))).collect();
    assert_eq!(runs(&mut app), sorted(&[church, field, parishes[0], parishes[1]]));
    assert_equal_to_scene(&app, scene);
    change_only(&mut app, church, |cga| cga.shape = cga.shape.clone().at([4.0, 0.0, 0.0]));
    assert_eq!(runs(&mut app), sorted(&[church, parishes[0], parishes[1]]));
    assert_equal_to_scene(&app, scene);
    // The field has no labels.
    change_only(&mut app, field, |cga| cga.shape = cga.shape.clone().seed(2));
    assert_eq!(runs(&mut app), [field]);
    app.world_mut().get_mut::<CgaScene>(scene).expect("a scene").context_distance = 20.0;
    assert_eq!(runs(&mut app), parishes[1..]);
    assert_equal_to_scene(&app, scene);
    change_only(&mut app, church, |cga| cga.shape = cga.shape.clone().seed(9));
    assert_eq!(runs(&mut app), sorted(&[church, parishes[0]]));
    app.world_mut().entity_mut(scene).remove::<CgaScene>();
    assert_eq!(runs(&mut app), parishes[1..]);
    assert_equal_to_scene(&app, scene);
}

#[test]
fn each_distance_of_a_scene_reaches_its_own_queries() {
    let mut app = app();
    let scene = scene(&mut app);
    let lots: Vec<Entity> =
        [0, 2, 9].into_iter().map(|at| add(&mut app, scene, Cga::new(Wide::default(), place(at)))).collect();
    assert_eq!(runs(&mut app), lots);
    assert_eq!([0, 1].map(|at| count(&app, lots[at], "Hidden")), [0, 0]);
    // Queries of labels reach all lots before and after.
    app.world_mut().get_mut::<CgaScene>(scene).expect("a scene").occlusion_distance = 10.0;
    assert_eq!(runs(&mut app), lots[..2]);
    assert_eq!([0, 1].map(|at| count(&app, lots[at], "Hidden")), [1, 1]);
    assert_equal_to_scene(&app, scene);
    app.world_mut().get_mut::<CgaScene>(scene).expect("a scene").context_distance = 1.0;
    assert_eq!(runs(&mut app), lots);
    assert_equal_to_scene(&app, scene);
    // The distances change places.
    *app.world_mut().get_mut::<CgaScene>(scene).expect("a scene") =
        CgaScene { occlusion_distance: 1.0, context_distance: 10.0 };
    assert_eq!(runs(&mut app), lots[..2]);
    assert_equal_to_scene(&app, scene);
}

#[test]
fn a_change_during_a_run_makes_one_more_run_of_the_affected_lots() {
    let mut app = app();
    let scene = scene(&mut app);
    let lots = row(&mut app, scene, 6);
    let old = model(&app, lots[1]).clone();
    let gate = Gate::default();
    // The gate holds the run of lot 2.
    change_only(&mut app, lots[2], |cga| {
        cga.settings.watch = Some(gate.watch());
        cga.grammar.set("height", 6.0.into()).expect("a height");
    });
    for height in [3.0, 6.0, 3.0] {
        app.update();
        change_only(&mut app, lots[3], |cga| cga.grammar.set("height", height.into()).expect("a height"));
    }
    app.update();
    assert!(app.world().get::<CgaRun>(lots[2]).is_some());
    assert_eq!(count(&app, lots[2], "PartyWall"), 6, "the old model stays");
    gate.open();
    settle(&mut app);
    assert_equal_to_scene(&app, scene);
    let log = app.world().resource::<Log>();
    let newest = |lot: Entity| {
        let own = log.generated.iter().filter(move |event| event.entity == lot);
        own.map(|event| event.is_newest).collect::<Vec<bool>>()
    };
    assert_eq!(newest(lots[2]), [false, true]);
    assert_eq!((newest(lots[0]), newest(lots[5])), (vec![], vec![]));
    for lot in [lots[1], lots[3], lots[4]] {
        let newest = newest(lot);
        assert_eq!(newest.last(), Some(&true));
        // Runs end before or after the next change, and an outdated one is never the last.
        assert!((1..=4).contains(&newest.len()), "{newest:?}");
    }
    assert_ne!(*model(&app, lots[1]), old);
}

#[test]
fn a_lot_that_fails_loses_no_other() {
    let mut app = app();
    let scene = scene(&mut app);
    let lots: Vec<Entity> = (0..4)
        .map(|at| match at {
            1 => add(&mut app, scene, Cga::new(Broken::default(), place(at))),
            _ => add(&mut app, scene, Cga::new(Row::default(), place(at))),
        })
        .collect();
    settle(&mut app);
    let failed = std::mem::take(&mut app.world_mut().resource_mut::<Log>().failed);
    assert_eq!(failed.iter().map(|event| event.entity).collect::<Vec<_>>(), lots[1..2]);
    assert_eq!(failed[0].error, CgaError::Panic("a broken function".to_owned()));
    assert_eq!(runs(&mut app), [lots[0], lots[2], lots[3]]);
    assert_eq!([0, 2].map(|at| count(&app, lots[at], "PartyWall")), [0, 3]);

    change_only(&mut app, lots[1], |cga| *cga = Cga::new(Row::default(), place(1)));
    assert_eq!(runs(&mut app), lots[..3]);
    assert_equal_to_scene(&app, scene);
    let root = app.world().get::<CgaModel>(lots[1]).expect("a model").root;
    for break_settings in [
        |settings: &mut Settings| settings.limits.shapes = 3,
        |settings: &mut Settings| settings.start = Some("Unknown".to_owned()),
        |settings: &mut Settings| settings.watch = Some(Watch::every(1, |_| panic_any("a broken watch"))),
    ] {
        change_only(&mut app, lots[1], |cga| {
            cga.settings = Settings::default();
            break_settings(&mut cga.settings);
        });
        settle(&mut app);
        let failed = std::mem::take(&mut app.world_mut().resource_mut::<Log>().failed);
        assert!(matches!(&failed[..], [event] if event.entity == lots[1]), "{failed:?}");
        assert_eq!(runs(&mut app), [lots[0], lots[2]]);
        assert_eq!(app.world().get::<CgaModel>(lots[1]).expect("a model").root, root, "the old model stays");
    }
    // A watch that is broken breaks its own run alone.
    assert_eq!([0, 2].map(|at| count(&app, lots[at], "PartyWall")), [3, 6]);
    change_only(&mut app, lots[1], |cga| cga.shape = Shape::rectangle(f64::NAN, 3.0));
    settle(&mut app);
    let failed = std::mem::take(&mut app.world_mut().resource_mut::<Log>().failed);
    assert!(matches!(&failed[..], [CgaFailed { error: CgaError::Run(Error::Shape(_)), .. }]), "{failed:?}");
    assert_eq!(runs(&mut app), [lots[0], lots[2]]);
}

#[test]
fn lots_stay_without_neighbours_when_their_scene_is_despawned() {
    let mut app = app();
    let scene = scene(&mut app);
    let lots = row(&mut app, scene, 3);
    let field = add(&mut app, scene, Cga::new(Field::default(), place(3)));
    assert_eq!(runs(&mut app), sorted(&[lots[2], field]));
    app.world_mut().despawn(scene);
    assert_eq!(runs(&mut app), lots);
    for lot in &lots {
        assert!(app.world().get::<CgaLotOf>(*lot).is_none());
        assert_eq!(count(&app, *lot, "PartyWall"), 0);
    }
    change_only(&mut app, lots[1], |cga| cga.shape = cga.shape.clone().seed(3));
    assert_eq!(runs(&mut app), lots[1..2]);
    // The next scene.
    let scene = app.world_mut().spawn_empty().id();
    for lot in &lots {
        app.world_mut().entity_mut(*lot).insert(CgaLotOf(scene));
    }
    assert_eq!(runs(&mut app), lots);
    assert_equal_to_scene(&app, scene);
    assert_eq!(app.world().get::<CgaScene>(scene), Some(&CgaScene::default()));
}

#[test]
fn scenes_and_lots_may_be_despawned_during_runs() {
    let mut app = app();
    let scene = scene(&mut app);
    let lots = row(&mut app, scene, 6);
    let gate = Gate::default();
    change_only(&mut app, lots[2], |cga| cga.settings.watch = Some(gate.watch()));
    app.update();
    app.world_mut().despawn(lots[2]);
    app.update();
    app.world_mut().despawn(scene);
    app.world_mut().despawn(lots[5]);
    app.update();
    gate.open();
    settle(&mut app);
    let rest = [lots[0], lots[1], lots[3], lots[4]];
    assert!(rest.iter().all(|lot| count(&app, *lot, "PartyWall") == 0));
    let log = app.world().resource::<Log>();
    assert!(log.failed.is_empty() && log.generated.iter().all(|event| event.entity != lots[2]));
}

#[test]
fn a_scene_of_children_is_despawned_with_its_lots() {
    let mut app = app();
    app.update();
    let before = app.world().entities().count_spawned();
    let scene = scene(&mut app);
    let lots = row(&mut app, scene, 3);
    for lot in &lots {
        app.world_mut().entity_mut(*lot).insert(ChildOf(scene));
    }
    assert!(runs(&mut app).is_empty());
    app.world_mut().despawn(scene);
    assert!(runs(&mut app).is_empty());
    assert_eq!(app.world().entities().count_spawned(), before);
}

#[test]
fn a_clone_of_a_lot_is_a_lot_of_its_scene() {
    let mut app = app();
    let scene = scene(&mut app);
    let lots = row(&mut app, scene, 3);
    let copy = app.world_mut().entity_mut(lots[2]).clone_and_spawn();
    change_only(&mut app, copy, |cga| cga.shape = place(3));
    assert_eq!(runs(&mut app), sorted(&[lots[2], copy]));
    assert_equal_to_scene(&app, scene);
}

#[test]
fn changes_while_the_systems_pause_are_not_lost() {
    #[derive(Resource)]
    struct IsPaused(bool);

    let mut app = app();
    app.insert_resource(IsPaused(false));
    app.configure_sets(PostUpdate, CgaSystems.run_if(|paused: Res<IsPaused>| !paused.0));
    let scene = scene(&mut app);
    let lots = row(&mut app, scene, 7);
    app.world_mut().resource_mut::<IsPaused>().0 = true;
    app.world_mut().despawn(lots[1]);
    app.world_mut().entity_mut(lots[4]).remove::<CgaLotOf>();
    (0..5).for_each(|_| app.update());
    app.world_mut().resource_mut::<IsPaused>().0 = false;
    assert_eq!(runs(&mut app), [lots[0], lots[2], lots[3], lots[4], lots[5]]);
    assert_equal_to_scene(&app, scene);
}
