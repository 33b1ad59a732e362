//! An app without a window and without a renderer, and a grammar.

#![allow(dead_code, unreachable_pub, reason = "each test file uses a part")]

use std::sync::{Arc, Condvar, Mutex};
use std::time::{Duration, Instant};

use bevy_app::{App, TaskPoolPlugin};
use bevy_asset::AssetPlugin;
use bevy_cga::*;
use bevy_ecs::prelude::*;
use bevy_mesh::{Mesh3d, MeshPlugin};
use bevy_transform::TransformPlugin;
use bevy_transform::components::Transform;
use cga::mesh::FaceTag;
use cga::{Assets, Mesh, MeshBuilder, Settings, Shape, Watch, cga};

cga! {
    /// A house with a row of trees.
    pub grammar Yard;
    @Range(min = 1, max = 50, restricted = true)
    attr height = 6
    attr wall = "#c08040"
    attr roof = 50% : "#993322" else : "#555555"
    Lot   --> [ extrude(height) color(wall) House ] Trees
    House --> report("walls", geometry.area) comp(f) { top : color(roof) Roof. | side : Wall. }
    Trees --> split(x) { { 4 : Tree }* }
    Tree  --> s(2, 3, 2) center(xz) i("tree") color("#408040") Tree.
}

cga! {
    /// One face.
    pub grammar Field;
    Lot --> color("#80a040") Grass.
}

cga! {
    /// No leaf.
    pub grammar Nothing;
    Lot --> NIL
}

/// A pyramid, one metre wide and high.
pub fn tree() -> Mesh {
    let mut builder = MeshBuilder::new();
    let top = builder.point([0.5, 1.0, 0.5]);
    let ring = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(|[x, z]| builder.point([x, 0.0, z]));
    for (k, &a) in ring.iter().enumerate() {
        builder.face(&[a, ring[(k + 1) % 4], top], &[], FaceTag::PLAIN);
    }
    builder.build().expect("a mesh")
}

pub fn settings() -> Settings {
    Settings { assets: Assets::new().with("tree", tree()).into(), ..Settings::default() }
}

/// A lot of 20 by 10 metres, with five trees.
pub fn yard() -> Cga {
    Cga::new(Yard::default(), Shape::rectangle(20.0, 10.0)).settings(settings())
}

pub fn app() -> App {
    let mut app = App::new();
    app.add_plugins((
        TaskPoolPlugin::default(),
        AssetPlugin::default(),
        MeshPlugin,
        TransformPlugin,
        CgaPlugin::default(),
    ));
    app.init_resource::<Log>();
    app.add_observer(|event: On<CgaGenerated>, mut log: ResMut<Log>| log.generated.push(event.clone()));
    app.add_observer(|event: On<CgaFailed>, mut log: ResMut<Log>| log.failed.push(event.clone()));
    app.add_observer(|event: On<CgaLeaf>, mut log: ResMut<Log>| log.leaves.push(event.clone()));
    app.finish();
    app.cleanup();
    app
}

/// All events.
#[derive(Resource, Default)]
pub struct Log {
    pub generated: Vec<CgaGenerated>,
    pub failed: Vec<CgaFailed>,
    pub leaves: Vec<CgaLeaf>,
}

pub fn log(app: &App) -> &Log {
    app.world().resource::<Log>()
}

/// Updates until no run is under way.
pub fn settle(app: &mut App) {
    let start = Instant::now();
    loop {
        app.update();
        if app.world_mut().query::<&CgaRun>().iter(app.world()).next().is_none() {
            return;
        }
        assert!(start.elapsed() < Duration::from_secs(120), "a run does not end");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Spawns an entity and waits for its model.
pub fn shown(app: &mut App, cga: Cga) -> Entity {
    let entity = app.world_mut().spawn(cga).id();
    settle(app);
    entity
}

/// Changes the component of an entity and waits for the model.
pub fn change(app: &mut App, entity: Entity, change: impl FnOnce(&mut Cga)) {
    change_only(app, entity, change);
    settle(app);
}

pub fn change_only(app: &mut App, entity: Entity, change: impl FnOnce(&mut Cga)) {
    change(&mut app.world_mut().get_mut::<Cga>(entity).expect("a grammar"));
}

/// The meshes of an entity's model, in order.
pub fn parts(app: &App, entity: Entity) -> Vec<(Entity, CgaMesh, Mesh3d, Transform)> {
    let world = app.world();
    let Some(model) = world.get::<CgaModel>(entity) else { return Vec::new() };
    let children = world.get::<Children>(model.root).map_or(&[][..], |children| children);
    let part = |&child: &Entity| {
        let part = world.get::<CgaMesh>(child)?.clone();
        Some((child, part, world.get::<Mesh3d>(child)?.clone(), *world.get::<Transform>(child)?))
    };
    children.iter().filter_map(part).collect()
}

/// Holds runs back at their end.
#[derive(Clone, Default)]
pub struct Gate {
    state: Arc<(Mutex<bool>, Condvar)>,
}

impl Gate {
    /// A watch whose runs wait at the gate.
    pub fn watch(&self) -> Watch {
        let gate = self.clone();
        Watch::every(1, move |_| {
            let (is_open, opened) = &*gate.state;
            let limit = Duration::from_secs(120);
            let waited = opened.wait_timeout_while(is_open.lock().expect("a lock"), limit, |is_open| !*is_open);
            assert!(!waited.expect("a lock").1.timed_out(), "the gate stays closed");
            std::ops::ControlFlow::Continue(())
        })
    }

    pub fn open(&self) {
        *self.state.0.lock().expect("a lock") = true;
        self.state.1.notify_all();
    }
}
