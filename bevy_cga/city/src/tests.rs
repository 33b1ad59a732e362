//! The panel and the pin, without a window and without a renderer.

use std::time::{Duration, Instant};

use bevy::app::TaskPoolPlugin;
use bevy::mesh::MeshPlugin;
use bevy::prelude::*;
use bevy_cga::{Cga, CgaPlugin, CgaRun};
use cga::Shape;

use crate::panel::{PanelText, Values};
use crate::pick::{Picked, Pin};
use crate::rules::House;
use crate::scene::Building;

/// An app with the panel, and two buildings with their models.
fn panel() -> (App, [Entity; 2]) {
    let mut app = App::new();
    app.add_plugins((TaskPoolPlugin::default(), AssetPlugin::default(), MeshPlugin, CgaPlugin::default()));
    app.init_asset::<StandardMaterial>().init_asset::<Image>().init_resource::<ButtonInput<KeyCode>>();
    crate::add_panel(&mut app);
    app.finish();
    app.cleanup();
    let buildings = [0, 1].map(|number| {
        let shape = Shape::rectangle(14.0, 12.0).seed(number as u64);
        app.world_mut().spawn((Cga::new(House::default(), shape), Building(number))).id()
    });
    settle(&mut app);
    (app, buildings)
}

/// Updates until no run is under way and the panel has noticed it.
fn settle(app: &mut App) {
    let start = Instant::now();
    app.update();
    while !app.world_mut().query::<&CgaRun>().query(app.world()).is_empty() {
        assert!(start.elapsed() < Duration::from_secs(120), "a run does not end");
        std::thread::sleep(Duration::from_millis(1));
        app.update();
    }
    app.update();
}

fn pick(app: &mut App, building: Option<Entity>) {
    *app.world_mut().resource_mut() = Picked { building, rule: None };
    app.update();
}

fn text(app: &mut App) -> String {
    let world = app.world_mut();
    world.query_filtered::<&Text, With<PanelText>>().single(world).expect("a panel").0.clone()
}

fn pin(app: &mut App) -> (Transform, Visibility) {
    let world = app.world_mut();
    let (place, visibility) =
        world.query_filtered::<(&Transform, &Visibility), With<Pin>>().single(world).expect("a pin");
    (*place, *visibility)
}

/// The updates in which the values of the panel and the place of the pin were computed last.
fn computed(app: &mut App) -> [u32; 2] {
    let world = app.world_mut();
    let values = world.query::<Ref<Values>>().single(world).expect("a panel").last_changed().get();
    let place = world.query_filtered::<Ref<Transform>, With<Pin>>().single(world).expect("a pin").last_changed().get();
    [values, place]
}

#[test]
fn a_picked_building_is_computed_once() {
    let (mut app, [one, other]) = panel();
    pick(&mut app, Some(one));
    let first = computed(&mut app);
    (0..5).for_each(|_| app.update());
    assert_eq!(computed(&mut app), first);
    pick(&mut app, Some(other));
    let second = computed(&mut app);
    assert!(first[0] < second[0] && first[1] < second[1], "{first:?} {second:?}");
}

#[test]
fn panel_and_pin_follow_the_picked_building() {
    let (mut app, [one, other]) = panel();
    assert!(text(&mut app).starts_with("Click a building."));
    assert_eq!(pin(&mut app).1, Visibility::Hidden);
    pick(&mut app, Some(one));
    assert!(text(&mut app).starts_with("Building 0, seed 0\n"), "{}", text(&mut app));
    let (low, visibility) = pin(&mut app);
    assert_eq!(visibility, Visibility::Inherited);

    let mut cga = app.world_mut().get_mut::<Cga>(one).expect("a building");
    cga.grammar.set("storeys", 20.0.into()).expect("an attribute");
    app.update();
    assert!(text(&mut app).contains("storeys: 20 *\n"), "{}", text(&mut app));
    assert_eq!(pin(&mut app).0, low, "the old model is shown");
    settle(&mut app);
    assert!(!text(&mut app).contains("on its way"), "{}", text(&mut app));
    let (high, _) = pin(&mut app);
    assert!(low.translation.y + 20.0 < high.translation.y, "{low:?} {high:?}");

    pick(&mut app, Some(other));
    assert!(text(&mut app).starts_with("Building 1, seed 1\n"), "{}", text(&mut app));
    assert!(!text(&mut app).contains("storeys: 20"), "{}", text(&mut app));
    assert!(pin(&mut app).0.translation.y < high.translation.y);
    pick(&mut app, None);
    assert!(text(&mut app).starts_with("Click a building."));
    assert_eq!(pin(&mut app).1, Visibility::Hidden);
}

#[test]
fn keys_choose_an_attribute_and_change_the_building() {
    let (mut app, [one, _]) = panel();
    let press = |app: &mut App, key| {
        app.world_mut().resource_mut::<ButtonInput<KeyCode>>().press(key);
        app.update();
        app.world_mut().resource_mut::<ButtonInput<KeyCode>>().reset_all();
    };
    pick(&mut app, Some(one));
    let before = computed(&mut app);
    assert!(text(&mut app).contains("> storeys: "), "{}", text(&mut app));
    press(&mut app, KeyCode::ArrowDown);
    assert!(text(&mut app).contains("> wall: "), "{}", text(&mut app));
    assert_eq!(computed(&mut app), before);

    press(&mut app, KeyCode::KeyN);
    assert!(text(&mut app).starts_with("Building 0, seed 1\n"), "{}", text(&mut app));
    let after = computed(&mut app);
    assert!(before[0] < after[0] && before[1] == after[1], "{before:?} {after:?}");
    app.update();
    assert!(text(&mut app).contains("another model is on its way"), "{}", text(&mut app));
    settle(&mut app);
    assert!(!text(&mut app).contains("another model is on its way"), "{}", text(&mut app));
    assert!(before[1] < computed(&mut app)[1]);
}
