//! The picture, on machines with a graphics card or a software renderer.

use cga::sink::meshes::Granularity;

use super::{HEIGHT, WIDTH, draw, garden};

#[test]
fn the_picture_shows_the_garden() {
    let model = garden::model().expect("no limit is reached");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    let meshes = model.meshes(Granularity::Material);
    let trees = model.count("Tree");
    assert!(0 < trees);
    assert!(meshes.list.iter().any(|mesh| mesh.places.len() == trees), "the trees are one mesh");
    if pollster::block_on(wgpu::Instance::default().request_adapter(&Default::default())).is_err() {
        println!("left out: wgpu finds no graphics card and no software renderer");
        return;
    }
    let pixels = pollster::block_on(draw(&meshes)).expect("a picture");
    assert_eq!(pixels.len(), (WIDTH * HEIGHT * 4) as usize);
    let share = |is_like: fn([i32; 3]) -> bool| {
        let like = pixels.chunks_exact(4).filter(|pixel| is_like([pixel[0], pixel[1], pixel[2]].map(i32::from)));
        like.count() as f64 / f64::from(WIDTH * HEIGHT)
    };
    let sky = share(|[r, g, b]| r < g && g < b && 200 < b);
    let green = share(|[r, g, b]| r < g && b < g);
    let roof = share(|[r, g, b]| g + 30 < r && b < g);
    let wall = share(|[r, g, b]| 120 < b && b < g && g < r);
    assert!(0.2 < sky && 0.15 < green && 0.04 < roof && 0.02 < wall, "{sky} {green} {roof} {wall}");
}
