//! The picture and its errors, on machines with a graphics card or a software renderer.

use cga::sink::meshes::Granularity;
use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device, Instance};

use super::{HEIGHT, WIDTH, draw, garden, read};

#[test]
fn the_picture_shows_the_garden() {
    let model = garden::model().expect("no limit is reached");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    let meshes = model.meshes(Granularity::Material);
    let trees = model.count("Tree");
    assert!(0 < trees);
    assert!(meshes.list.iter().any(|mesh| mesh.places.len() == trees), "the trees are one mesh");
    if device().is_none() {
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

#[test]
fn the_drawing_has_at_most_150_lines() {
    assert!(include_str!("main.rs").lines().count() <= 150);
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
