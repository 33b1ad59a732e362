//! Rule files as assets: loaded, changed, with mistakes.
#![cfg(feature = "eval")]

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use bevy_app::{App, TaskPoolPlugin};
use bevy_asset::{AssetPlugin, AssetServer, LoadState};
use bevy_cga::*;
use bevy_ecs::prelude::*;
use bevy_mesh::MeshPlugin;
use bevy_transform::TransformPlugin;
use cga::{Shape, Value};

const TOWER: &str =
    "import walls : \"parts/wall.cga\"  attr height = 6  Lot --> extrude(height) split(y) { ~3 : walls.Wall }*";

/// A folder of assets that goes with its test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("bevy-cga-{name}-{}", std::process::id()));
        fs::create_dir_all(folder.join("rules/parts")).expect("a folder");
        let folder = Folder(folder);
        folder.write("tower.cga", TOWER);
        folder.write("parts/wall.cga", "Wall --> Brick.");
        folder
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join("rules").join(name), text).expect("a file");
    }

    fn app(&self) -> App {
        let mut app = App::new();
        let assets = AssetPlugin { file_path: self.0.to_string_lossy().into_owned(), ..AssetPlugin::default() };
        app.add_plugins((TaskPoolPlugin::default(), assets, MeshPlugin, TransformPlugin, CgaPlugin::default()));
        app.finish();
        app.cleanup();
        app
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Updates until something is so.
fn until(app: &mut App, what: &str, is_so: impl Fn(&App) -> bool) {
    let start = Instant::now();
    while !is_so(app) {
        app.update();
        assert!(start.elapsed() < Duration::from_secs(120), "{what}");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// The leaves of the model of an entity, and their names.
fn leaves(app: &App, entity: Entity) -> Option<(usize, Vec<String>)> {
    let model = &app.world().get::<CgaModel>(entity)?.model;
    Some((model.len(), model.rules().iter().map(ToString::to_string).collect()))
}

#[test]
fn a_changed_rule_file_makes_its_models_again() {
    let folder = Folder::new("changed");
    let mut app = folder.app();
    let server = app.world().resource::<AssetServer>().clone();
    let rules = server.load("rules/tower.cga");
    let spawn = |app: &mut App, file: CgaFile| app.world_mut().spawn(file).id();
    let lot = || Shape::rectangle(10.0, 8.0);
    let low = spawn(&mut app, CgaFile::new(rules.clone(), lot()));
    let high = spawn(&mut app, CgaFile::new(rules.clone(), lot()).set("height", 30.0));
    let has = |entity, count: usize, name: &str| {
        let wanted = Some((count, vec![name.to_owned()]));
        move |app: &App| leaves(app, entity) == wanted
    };
    until(&mut app, "the first models", |app| has(low, 2, "Brick")(app) && has(high, 10, "Brick")(app));
    assert_eq!(app.world().get::<Cga>(low).expect("a grammar").grammar.name(), "tower");

    // An imported file, and a value that was set.
    folder.write("parts/wall.cga", "Wall --> Stone.");
    server.reload("rules/tower.cga");
    until(&mut app, "other models", |app| has(low, 2, "Stone")(app) && has(high, 10, "Stone")(app));
    app.world_mut().get_mut::<Cga>(low).expect("a grammar").grammar.set("height", 12.0.into()).expect("a height");
    until(&mut app, "a higher model", has(low, 4, "Stone"));

    // A mistake keeps the models, and the error has the line.
    folder.write("tower.cga", &TOWER.replace("extrude(height)", "extrude(heigth)"));
    server.reload("rules/tower.cga");
    let failed = |app: &App| match app.world().resource::<AssetServer>().load_state(&rules) {
        LoadState::Failed(error) => Some(error.to_string()),
        _ => None,
    };
    until(&mut app, "the mistake", |app| failed(app).is_some());
    let error = failed(&app).unwrap_or_default();
    assert!(error.contains("--> rules/tower.cga:1:") && error.contains("did you mean `height`?"), "{error}");
    (0..3).for_each(|_| app.update());
    assert!(has(low, 4, "Stone")(&app) && has(high, 10, "Stone")(&app));

    // The mend, with another attribute.
    folder.write("tower.cga", &TOWER.replace("~3", "~storey").replace("Lot", "attr storey = 6  Lot"));
    server.reload("rules/tower.cga");
    until(&mut app, "the mend", |app| has(low, 2, "Stone")(app) && has(high, 5, "Stone")(app));
    let grammar = &app.world().get::<Cga>(high).expect("a grammar").grammar;
    assert_eq!((grammar.get("height"), grammar.get("storey")), (Ok(Value::Float(30.0)), Ok(Value::Float(6.0))));
}

#[test]
fn an_entity_that_comes_later_has_the_loaded_rules() {
    let folder = Folder::new("later");
    let mut app = folder.app();
    let server = app.world().resource::<AssetServer>().clone();
    let rules = server.load("rules/tower.cga");
    until(&mut app, "the rules", |app| app.world().resource::<bevy_asset::Assets<CgaRules>>().contains(&rules));
    (0..3).for_each(|_| app.update());
    let entity = app.world_mut().spawn(CgaFile::new(rules, Shape::rectangle(4.0, 4.0)).set("lost", 1.0)).id();
    until(&mut app, "a model", |app| leaves(app, entity).is_some());
}
