//! Bad input does no harm.

use cga_picture::glam::{DVec2, DVec3};
use cga_picture::{Alpha, Bitmap, Bounds, Camera, Face, Paint, Projection, Renderer, Scene, Viewpoint};

use crate::{HALVES, add, color, front, square};

#[test]
fn bounds_need_not_be_those_of_the_faces() {
    let point = |at: f64| Bounds { low: DVec3::splat(at), high: DVec3::splat(at) };
    let flipped = Bounds { low: DVec3::ONE, high: DVec3::NEG_ONE };
    let odd = [point(0.0), point(1e9), point(f64::NAN), point(f64::INFINITY), point(f64::MAX), Bounds::EMPTY, flipped];
    for bounds in odd {
        let mut scene = Scene::new(bounds);
        let paint = scene.add_paint(color(0.5, 0.5, 0.5));
        for scale in [1e-300, 1.0, 1e9, 1e38, 1e300] {
            let corners = square(0.5).map(|corner| (corner - DVec3::Y) * scale);
            scene.add_face(&Face::new(&corners, &HALVES, DVec3::Z, paint));
        }
        assert_eq!(Renderer::new(16, 12).render(&scene).rgba.len(), 4 * 16 * 12, "{bounds:?}");
        assert_eq!(front(8).render(&scene).rgba.len(), 4 * 8 * 8, "{bounds:?}");
    }
}

#[test]
fn missing_corners_places_and_normals_are_left_out() {
    let mut scene = Scene::new(Bounds::of(square(0.0)));
    let image = scene.add_image(Bitmap::filled(1, 1, [255; 4]));
    let paint = scene.add_paint(Paint {
        color_image: Some(image),
        opacity_image: Some((image, Alpha::Blend)),
        ..Paint::default()
    });
    let whole = Face::new(&[], &HALVES, DVec3::Z, paint);
    scene.add_face(&whole);
    assert!(front(8).leaves(&scene).iter().all(Option::is_none));
    let corners = square(0.0);
    scene.add_face(&Face {
        corners: &corners[..3],
        normals: Some(&[]),
        color_uvs: Some(&[DVec2::NAN]),
        opacity_uvs: Some(&[]),
        ..whole
    });
    // One of two triangles has all corners.
    let seen = front(8).leaves(&scene).iter().flatten().count();
    assert!((28..=36).contains(&seen), "{seen}");
    scene.add_face(&Face { corners: &corners, normals: Some(&[]), opacity_uvs: Some(&[]), ..whole });
    assert!(front(8).leaves(&scene).iter().all(Option::is_some));
    front(8).render(&scene);
}

#[test]
fn numbers_that_a_scene_does_not_know_are_ignored() {
    let mut other = Scene::new(Bounds::EMPTY);
    let image = other.add_image(Bitmap::filled(1, 1, [0; 4]));
    let paint = other.add_paint(Paint::default());
    let mut scene = Scene::new(Bounds::of(square(0.0)));
    add(&mut scene, 0.0, paint, 0);
    assert!(front(8).leaves(&scene).iter().all(Option::is_none));
    let images = Paint { color_image: Some(image), opacity_image: Some((image, Alpha::Blend)), ..Paint::default() };
    let own = scene.add_paint(images);
    scene.add_face(&Face {
        color_uvs: Some(&[DVec2::ZERO; 4]),
        opacity_uvs: Some(&[DVec2::ZERO; 4]),
        ..Face::new(&square(0.0), &HALVES, DVec3::Z, own)
    });
    assert!(front(8).leaves(&scene).iter().all(Option::is_some));
}

#[test]
fn images_of_any_size_do_no_harm() {
    let short = Bitmap { width: 3, height: 5, rgba: vec![9; 7] };
    for image in [Bitmap::filled(0, 0, [0; 4]), Bitmap::filled(0, 3, [0; 4]), Bitmap::filled(3, 0, [0; 4]), short] {
        let mut scene = Scene::new(Bounds::of(square(0.0)));
        let image = scene.add_image(image);
        let paint = scene.add_paint(Paint { color_image: Some(image), ..Paint::default() });
        let uvs = [DVec2::ZERO, DVec2::X * 1e300, DVec2::INFINITY, DVec2::NAN];
        scene.add_face(&Face { color_uvs: Some(&uvs), ..Face::new(&square(0.0), &HALVES, DVec3::Z, paint) });
        assert_eq!(front(8).render(&scene).rgba.len(), 256);
    }
}

#[test]
fn settings_of_any_size_do_no_harm() {
    let mut scene = Scene::new(Bounds::of(square(0.0)));
    let odd = [f64::NAN, f64::INFINITY, -1e300];
    for number in odd.map(|number| number as f32) {
        let paint = Paint { opacity: number, metallic: number, gloss: number, ..color(number, number, number) };
        let paint = scene.add_paint(paint);
        add(&mut scene, 0.0, paint, 0);
        scene.add_triangle([DVec3::ZERO; 3], paint);
    }
    for number in odd {
        let bounds = Bounds::of(square(0.0));
        let projection = Projection::Perspective(number);
        let camera = Camera { azimuth: number, elevation: number, projection, bounds, margin: number, centred: true };
        for (width, height) in [(0, 0), (0, 5), (1, 1), (9, 3)] {
            let renderer = Renderer {
                view: Viewpoint::Camera(camera),
                samples: usize::MAX,
                sun_azimuth: number,
                sun_elevation: number,
                ..Renderer::new(width, height)
            };
            assert_eq!(renderer.render(&scene).rgba.len(), 4 * width * height);
            assert_eq!(renderer.leaves(&scene).len(), width * height);
        }
    }
}
