//! The picture and its errors, on machines with a graphics card or a software renderer.

use cga::sink::meshes::Granularity;
use cga::{Assets, MeshBuilder, Settings, Shape, cga};
use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device, Instance};

use crate::draw::{HEIGHT, WIDTH, draw, instances};
use crate::gallery;
use crate::gpu::read;

#[test]
fn the_picture_shows_a_house_with_light_and_shadow() {
    let model = gallery::model().expect("no limit is reached");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    if device().is_none() {
        return;
    }
    let pixels = pollster::block_on(draw(&model.meshes(Granularity::Material))).expect("a picture");
    assert_eq!(pixels.len(), (WIDTH * HEIGHT * 4) as usize);
    let share = |is_like: fn([i32; 3]) -> bool| {
        let like = pixels.chunks_exact(4).filter(|pixel| is_like([pixel[0], pixel[1], pixel[2]].map(i32::from)));
        like.count() as f64 / f64::from(WIDTH * HEIGHT)
    };
    let sky = share(|[r, g, b]| r < g && g < b && 200 < b);
    let sunny = share(|[r, g, b]| 190 < r && 160 < b && b < g && g < r);
    let shady = share(|[r, g, b]| 90 < r && r < 170 && (r - g).abs() < 12 && b < g);
    let street = share(|[r, g, b]| r < 130 && (r - b).abs() < 12 && (r - g).abs() < 12);
    let awnings = share(|[r, g, b]| 2 * g < r && 2 * b < r && 100 < r);
    assert!(0.3 < sky && 0.05 < sunny && 0.05 < shady, "{sky} {sunny} {shady}");
    assert!(0.1 < street && 0.002 < awnings, "{street} {awnings}");
}

#[test]
fn an_inserted_mesh_is_one_mesh_with_its_places() {
    cga! {
        @Allow(missing_asset)
        grammar Posts;
        Lot --> split(x) { { 4 : s(0.5, 2, 0.5) center(xz) i("post") color("#ff0000") Post. }* }
    }
    let mut builder = MeshBuilder::new();
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|point| builder.point(point));
    builder.polygon(&corners);
    let post = builder.build().expect("a mesh");
    let settings = Settings { assets: Assets::new().with("post", post).into(), ..Settings::default() };
    let model = Posts::default().generate_with(&Shape::rectangle(12.0, 1.0), &settings).expect("a model");
    let meshes = model.meshes(Granularity::Material);
    assert_eq!(meshes.list.len(), 1);
    let placed = instances(&meshes.list[0]);
    assert_eq!(placed.len(), 3);
    assert!(placed.iter().all(|[.., color]| *color == [1.0, 0.0, 0.0, 1.0]));
    assert_eq!(placed.iter().map(|place| place[3][0] - placed[0][3][0]).collect::<Vec<_>>(), [0.0, 4.0, 8.0]);
}

#[test]
fn the_drawing_has_at_most_260_lines() {
    let files = [include_str!("main.rs"), include_str!("draw.rs"), include_str!("gpu.rs")];
    assert!(files.map(|text| text.lines().count()).iter().sum::<usize>() <= 260);
}

#[test]
fn a_buffer_that_cannot_be_mapped_is_an_error() {
    let Some(device) = device() else { return };
    let buffer = readable(&device);
    assert_eq!(read(&device, &buffer).expect("zeros"), [0; 16]);
    // It is still mapped.
    let error = read(&device, &buffer).expect_err("a second mapping fails");
    assert!(error.to_string().starts_with("the picture cannot be read: "), "{error}");
}

#[test]
fn a_lost_device_is_an_error() {
    let Some(device) = device() else { return };
    let buffer = readable(&device);
    device.destroy();
    let error = read(&device, &buffer).expect_err("the device is lost");
    assert!(error.to_string().starts_with("the picture cannot be read: "), "{error}");
}

fn readable(device: &Device) -> Buffer {
    let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
    device.create_buffer(&BufferDescriptor { label: None, size: 16, usage, mapped_at_creation: false })
}

/// A device, or a message that the rest of the test is left out.
fn device() -> Option<Device> {
    let Ok(adapter) = pollster::block_on(Instance::default().request_adapter(&Default::default())) else {
        println!("left out: wgpu finds no graphics card and no software renderer");
        return None;
    };
    let (device, _queue) = pollster::block_on(adapter.request_device(&Default::default())).expect("a device");
    Some(device)
}
