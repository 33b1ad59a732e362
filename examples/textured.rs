//! A textured tower in a textured street: `textured.glb` and `textured.png`.
//!
//! `cargo run --release --example textured`
//!
//! This program draws the images and writes them to `out/textured`. The bricks are projected once for each façade, so
//! their pattern continues around its windows. Each window has its own image.

#[path = "materials/mod.rs"]
mod materials;

use std::error::Error;
use std::path::Path;

use cga::sink::picture::{Image, Picture};
use cga::street::{Centerline, Network, NetworkOptions, StreetError};
use cga::{Assets, Model, Settings, Shape, cga};

use materials::opening::{shop, window};

cga! {
    /// A tower of brick at a corner. The images come from a folder that this program fills.
    @Allow(missing_asset)
    pub grammar Tower;

    attr height = 39.2
    attr storey = 3.4
    const stone = "#d8cfc0"

    @StartRule
    Lot      --> extrude(height) comp(f) { side : Facade | top : Roof }
    Facade   --> setupProjection(0, scope.xy, 1.8, 1.2)
                 split(y) { 4.4 : Shops | 0.3 : Ledge | { ~storey : Storey }* | 0.5 : Ledge }
    Storey   --> split(x) { ~0.8 : Wall | { ~3 : Bay }* | ~0.8 : Wall }
    Bay      --> split(x) { ~1 : Wall | 1.3 : Column | ~1 : Wall }
    Column   --> split(y) { ~0.9 : Wall | 1.9 : Opening | ~0.5 : Wall }
    Opening  --> t(0, 0, -0.18) [ s(^1, ^1, 0.18) Recess ] Window
    Recess   --> primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Reveal }
    Reveal   --> deleteUV(0) color(stone) Reveal.
    Window   --> setupProjection(0, scope.xy, ^1, ^1) texture("window.png") projectUV(0)
                 set(material.roughness, 0.3) Window.
    Wall     --> texture("bricks.png") projectUV(0) Wall.
    Ledge    --> extrude(0.25) color(stone) Ledge.
    Shops    --> split(x) { 0.7 : Pier | { ~4 : Shop | 0.7 : Pier }* }
    Pier     --> extrude(0.12) color(stone) Pier.
    Shop     --> t(0, 0, -0.3) [ s(^1, ^1, 0.3) Recess ] split(y) { ~1 : Front | 0.8 : Sign }
    Front    --> setupProjection(0, scope.xy, ~1.6, ^1) texture("shop.png") projectUV(0) Front.
    Sign     --> extrude(0.35) color("#5b3b2e") Sign.
    Roof     --> setupProjection(0, scope.xy, 2.4, 2.4) texture("tiles.png") projectUV(0) Roof.
}

cga! {
    /// Streets with CityEngine's start rules, with markings along texture coordinates.
    @Allow(missing_asset)
    pub grammar Streets;

    Street   --> split(u, unitSpace, 0) { 1 : Lane | 3 : Zebra | ~1 : Middle | 3 : Zebra | 1 : Lane }
    Zebra    --> split(v, unitSpace, 0) { { ~0.6 : Lane | ~0.6 : Dash }* | ~0.6 : Lane }
    Middle   --> split(v, unitSpace, 0) { ~1 : Lane | 0.15 : Line | ~1 : Lane }
    Lane     --> tileUV(0, 3, 3) color("#6a6b70") texture("asphalt.png") Roadway.
    Line     --> split(u, unitSpace, 0) { { ~2 : Dash | ~3 : Lane }* | ~2 : Dash }
    Dash     --> deleteUV(0) color("#f4f1e6") Marking.
    Joint    --> Lane
    Junction --> Lane
    Crossing --> Lane
    Sidewalk --> tileUV(0, 1.8, 1.6) color("#cfc8bb") texture("slabs.png") extrude(world.up, 0.15)
                 modify(f) { side : setupProjection(0, scope.xy, 1.8, 1.6) projectUV(0) } Pavement.
}

/// A lot with a cut corner.
pub(crate) fn lot() -> Result<Shape, cga::Error> {
    Shape::footprint(&[[9.0, 34.0], [33.0, 34.0], [36.0, 31.0], [36.0, 9.0], [9.0, 9.0]], &[])
}

/// Two streets that cross at the corner.
pub(crate) fn network() -> Result<Network, StreetError> {
    let lines = [
        Centerline::new(&[[-20.0, 42.0], [43.0, 42.0], [80.0, 50.0]]),
        Centerline::new(&[[43.0, -20.0], [43.0, 42.0], [43.0, 80.0]]),
    ];
    Network::new(&lines, &NetworkOptions::default())
}

/// The tower and the streets.
pub(crate) fn model(settings: &Settings) -> Result<Model, Box<dyn Error>> {
    let mut scene = Model::new().with_assets(settings.assets.clone());
    let mut add = |model: Model| {
        model.faults().iter().for_each(|fault| eprintln!("fault: {fault}"));
        scene.append(&model);
    };
    add(Tower::default().generate_with(&lot()?, settings)?);
    for part in network()?.parts() {
        add(Streets::default().generate_with(&part.shape().start(part.start_rule()), settings)?);
    }
    Ok(scene)
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new("out/textured");
    std::fs::create_dir_all(folder)?;
    for (name, image) in images() {
        image.write_png(folder.join(name))?;
    }
    let scene = model(&Settings { assets: Assets::below(folder).into(), ..Settings::default() })?;
    scene.write_glb("textured.glb")?;
    Picture::new(1600, 1200).looking_from(26.0, 22.0).render(&scene).write_png("textured.png")?;
    println!("{} triangles; wrote textured.glb and textured.png", scene.triangle_count());
    Ok(())
}

/// The images by name.
pub(crate) fn images() -> Vec<(&'static str, Image)> {
    let mut images = materials::images();
    let names = [
        ("bricks.png", "brick_red.png"),
        ("tiles.png", "tile_red.png"),
        ("asphalt.png", "asphalt.png"),
        ("slabs.png", "paving.png"),
    ];
    let drawn = names.into_iter().filter_map(|(name, material)| Some((name, images.remove(material)?)));
    drawn.chain([("window.png", window()), ("shop.png", shop())]).collect()
}
