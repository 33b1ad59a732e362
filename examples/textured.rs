//! A textured tower in a textured street: `textured.glb` and `textured.png`.
//!
//! `cargo run --release --example textured`
//!
//! This program draws the images and writes them to `out/textured`. The bricks are projected once for each façade, so
//! their pattern continues around its windows. Each window has its own image.

use std::error::Error;
use std::path::Path;

use cga::sink::picture::{Image, Picture};
use cga::street::{Centerline, Network, NetworkOptions};
use cga::{Assets, Model, Settings, Shape, Sink, cga};

cga! {
    /// A tower of brick at a corner. The images come from a folder that this program fills.
    @Allow(missing_asset)
    pub grammar Tower;

    attr height = 39.2
    attr storey = 3.4
    const stone = "#d8cfc0"

    @StartRule
    Lot      --> extrude(height) comp(f) { side : Facade | top : Roof }
    Facade   --> setupProjection(0, scope.xy, 2, 1.2)
                 split(y) { 4.4 : Shops | 0.3 : Ledge | { ~storey : Storey }* | 0.5 : Ledge }
    Storey   --> split(x) { ~0.8 : Wall | { ~3 : Bay }* | ~0.8 : Wall }
    Bay      --> split(x) { ~1 : Wall | 1.3 : Column | ~1 : Wall }
    Column   --> split(y) { ~0.9 : Wall | 1.9 : Opening | ~0.5 : Wall }
    Opening  --> t(0, 0, -0.18) Window
    Window   --> setupProjection(0, scope.xy, ^1, ^1) texture("window.png") projectUV(0)
                 set(material.roughness, 0.3) Window.
    Wall     --> texture("bricks.png") projectUV(0) Wall.
    Ledge    --> extrude(0.25) color(stone) Ledge.
    Shops    --> split(x) { 0.7 : Pier | { ~4 : Shop | 0.7 : Pier }* }
    Pier     --> extrude(0.12) color(stone) Pier.
    Shop     --> t(0, 0, -0.3) split(y) { ~1 : Front | 0.8 : Sign }
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
    Lane     --> tileUV(0, 4, 4) texture("asphalt.png") Roadway.
    Line     --> split(u, unitSpace, 0) { { ~2 : Dash | ~3 : Lane }* | ~2 : Dash }
    Dash     --> deleteUV(0) color("#f4f1e6") Marking.
    Joint    --> Lane
    Junction --> Lane
    Crossing --> Lane
    Sidewalk --> tileUV(0, 1.5, 1.5) texture("slabs.png") extrude(world.up, 0.15) Pavement.
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new("out/textured");
    std::fs::create_dir_all(folder)?;
    for (name, image) in images() {
        image.write_png(folder.join(name))?;
    }
    let mut settings = Settings { assets: Assets::below(folder).into(), ..Settings::default() };
    let mut scene = Model::new().with_assets(settings.assets.clone());
    let mut add = |model: Model| {
        model.faults().iter().for_each(|fault| eprintln!("fault: {fault}"));
        let _ = model.replay(&mut scene as &mut dyn Sink);
    };

    let lot = [[9.0, 34.0], [33.0, 34.0], [36.0, 31.0], [36.0, 9.0], [9.0, 9.0]];
    add(Tower::default().generate_with(&Shape::footprint(&lot, &[])?, &settings)?);
    let lines = [
        Centerline::new(&[[-20.0, 42.0], [43.0, 42.0], [80.0, 50.0]]),
        Centerline::new(&[[43.0, -20.0], [43.0, 42.0], [43.0, 80.0]]),
    ];
    for part in Network::new(&lines, &NetworkOptions::default())?.parts() {
        settings.start = Some(part.start_rule().to_owned());
        add(Streets::default().generate_with(&part.shape(), &settings)?);
    }

    scene.write_glb("textured.glb")?;
    Picture::new(1600, 1200).looking_from(26.0, 22.0).render(&scene).write_png("textured.png")?;
    println!("{} triangles; wrote textured.glb and textured.png", scene.triangle_count());
    Ok(())
}

/// The images by name.
fn images() -> Vec<(&'static str, Image)> {
    vec![
        ("bricks.png", bricks()),
        ("window.png", window()),
        ("shop.png", shop()),
        ("tiles.png", tiles()),
        ("asphalt.png", grain(256, [86, 87, 92], 18)),
        ("slabs.png", slabs()),
    ]
}

/// A repeatable random number in 0..1 for each place.
fn noise(x: i64, y: i64) -> f64 {
    let mut state = (x as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (y as u64).wrapping_mul(0xc2b2_ae3d_27d4_eb4f);
    state = (state ^ (state >> 31)).wrapping_mul(0xd6e8_feb8_6659_fd93);
    ((state ^ (state >> 32)) >> 40) as f64 / (1u64 << 24) as f64
}

/// A lighter or darker colour.
fn shade([r, g, b]: [u8; 3], by: f64) -> [u8; 4] {
    let channel = |value: u8| (f64::from(value) + by).clamp(0.0, 255.0) as u8;
    [channel(r), channel(g), channel(b), 255]
}

/// A surface of fine grains.
fn grain(size: usize, color: [u8; 3], depth: i64) -> Image {
    let mut image = Image::filled(size, size, [0; 4]);
    for (at, pixel) in image.rgba.as_chunks_mut::<4>().0.iter_mut().enumerate() {
        let (x, y) = ((at % size) as i64, (at / size) as i64);
        *pixel = shade(color, (noise(x, y) - 0.5) * depth as f64 * 2.0);
    }
    image
}

/// Courses of bricks, each moved by half a brick: 8 wide, 16 high.
fn bricks() -> Image {
    let mut image = grain(512, [196, 188, 176], 8);
    for course in 0..16 {
        for brick in -1..8_i64 {
            let tone = noise(brick.rem_euclid(8), course) * 36.0 - 18.0;
            let (x, y) = (brick * 64 + (course % 2) * 32, course * 32);
            image.rectangle(x + 2, y + 2, 60, 28, shade([156, 82, 62], tone));
            image.rectangle(x + 2, y + 2, 60, 2, shade([156, 82, 62], tone + 22.0));
        }
    }
    image
}

/// A window with a cross of bars.
fn window() -> Image {
    let mut image = Image::filled(256, 384, [238, 234, 224, 255]);
    for (column, row) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let (x, y, height) = (22 + column * 112, 22 + row * 130, if row == 0 { 112 } else { 210 });
        image.rectangle(x, y, 100, height, [52, 72, 86, 255]);
        for step in 0..40 {
            image.rectangle(x + step * 2, y + 40 - step, 4, 12, shade([72, 98, 114], 30.0 - step as f64));
        }
    }
    image
}

/// A shop window above a plinth.
fn shop() -> Image {
    let mut image = Image::filled(256, 512, [70, 52, 44, 255]);
    image.rectangle(16, 16, 224, 380, [96, 118, 122, 255]);
    image.rectangle(16, 16, 224, 60, [126, 146, 148, 255]);
    image.rectangle(16, 300, 224, 96, [150, 128, 92, 255]);
    image
}

/// Rows of roof tiles.
fn tiles() -> Image {
    let mut image = Image::filled(256, 256, [92, 46, 38, 255]);
    for row in 0..8 {
        for tile in -1..8_i64 {
            let tone = noise(tile.rem_euclid(8), 100 + row) * 30.0 - 15.0;
            image.rectangle(tile * 32 + (row % 2) * 16 + 1, row * 32 + 2, 30, 27, shade([150, 74, 58], tone));
        }
    }
    image
}

/// Square slabs.
fn slabs() -> Image {
    let mut image = grain(256, [146, 140, 130], 10);
    for (column, row) in (0..9).map(|slab| (slab % 3, slab / 3)) {
        let tone = noise(column, 50 + row) * 18.0 - 9.0;
        image.rectangle(column * 85 + 2, row * 85 + 2, 82, 82, shade([188, 182, 170], tone));
    }
    image
}
