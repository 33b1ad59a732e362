//! Pictures: equal on every machine, with the expected contents.

use std::sync::Arc;

use crate::sink_support::{Fill, color, hash, mixed, plate, steady, tower, upright};
use cga_runtime::output::model::Model;
use cga_runtime::output::picture::{Camera, Image, Lines, Picture};
use cga_runtime::output::svg::Svg;
use glam::{DAffine3, DVec3, dvec3};

fn red_box() -> Model {
    let mut fill = Fill(Model::new());
    fill.cuboid("Box", &color(0.9, 0.1, 0.1), upright(DVec3::ZERO, dvec3(1.0, 2.0, 1.0)));
    fill.0
}

fn is_red(pixel: [u8; 4]) -> bool {
    2 * u32::from(pixel[1]) < u32::from(pixel[0]) && 2 * u32::from(pixel[2]) < u32::from(pixel[0])
}

/// The share of red pixels, and the columns that they span.
fn red(image: &Image) -> (f64, usize, usize) {
    let columns: Vec<usize> = (0..image.width * image.height)
        .filter(|at| is_red(image.pixel(at % image.width, at / image.width).expect("inside")))
        .map(|at| at % image.width)
        .collect();
    let ends = (columns.iter().min().copied().unwrap_or(0), columns.iter().max().copied().unwrap_or(0));
    (columns.len() as f64 / (image.width * image.height) as f64, ends.0, ends.1)
}

#[test]
fn the_same_model_gives_the_same_pixels() {
    let picture = Picture::new(160, 120);
    let image = picture.render(&mixed());
    assert_eq!((image.width, image.height, image.rgba.len()), (160, 120, 4 * 160 * 120));
    assert_eq!(image, picture.render(&mixed()));
    assert_eq!(hash(&picture.render(&steady()).rgba), 0xdfc4_af87_b3b3_0f08);
}

#[test]
fn everything_is_in_the_picture() {
    for (azimuth, elevation) in [(0.0, 0.0), (30.0, 20.0), (120.0, -40.0), (210.0, 90.0)] {
        for model in [red_box(), tower(1)] {
            let camera = Camera::auto(model.bounds()).looking_from(azimuth, elevation);
            for camera in [camera, camera.orthographic(), camera.field_of_view(70.0)] {
                let mut picture = Picture::new(64, 48).camera(camera);
                picture.ground = false;
                picture.lines = Lines::None;
                let with = picture.render(&model);
                let without = picture.render(&Model::new());
                let border = (0..64).flat_map(|x| [(x, 0), (x, 47)]).chain((0..48).flat_map(|y| [(0, y), (63, y)]));
                for (x, y) in border {
                    assert_eq!(with.pixel(x, y), without.pixel(x, y), "{azimuth} {elevation} {x} {y}");
                }
                assert_ne!(with, without);
            }
        }
    }
}

#[test]
fn a_box_seen_from_the_front_is_a_rectangle_in_the_middle() {
    let model = red_box();
    let camera = Camera { margin: 0.0, ..Camera::auto(model.bounds()).looking_from(0.0, 0.0).orthographic() };
    let mut picture = Picture::new(200, 100).camera(camera);
    picture.ground = false;
    let (share, left, right) = red(&picture.render(&model));
    assert_eq!((left, right), (75, 124));
    assert!((share - 0.25).abs() < 0.02, "{share}");
}

#[test]
fn the_ground_is_darker_where_the_sun_does_not_reach() {
    let image = Picture::new(160, 120).render(&red_box());
    let bright = |x: usize, y: usize| image.pixel(x, y).map_or(0, |p| p.iter().map(|&c| u32::from(c)).sum::<u32>());
    // The sun is to the left, so the box casts a shadow to the right of its foot.
    assert!(bright(112, 86) + 60 < bright(20, 86), "{} {}", bright(112, 86), bright(20, 86));
}

#[test]
fn a_centred_camera_has_equal_space_above_and_below() {
    // A wide plate seen from above its front edge: the near side is larger in the picture.
    let mut fill = Fill(Model::new());
    fill.cuboid("Box", &color(0.9, 0.1, 0.1), upright(DVec3::ZERO, dvec3(40.0, 1.0, 12.0)));
    let rows = |centred: bool| {
        let camera = Camera { centred, ..Camera::auto(fill.0.bounds()) }.looking_from(10.0, 25.0).field_of_view(50.0);
        let mut picture = Picture::new(240, 200).camera(camera);
        picture.ground = false;
        picture.lines = Lines::None;
        let image = picture.render(&fill.0);
        let red = |y: usize| (0..240).any(|x| is_red(image.pixel(x, y).expect("inside")));
        let first = (0..200).find(|&y| red(y)).expect("a red row");
        let last = (0..200).rfind(|&y| red(y)).expect("a red row");
        (first, 199 - last)
    };
    let (above, below) = rows(true);
    assert!(above.abs_diff(below) <= 1 && 20 < above, "{above} {below}");
    let (above, below) = rows(false);
    assert!(above + 8 < below, "the default is as it was: {above} {below}");
}

#[test]
fn the_ground_has_no_horizon() {
    // From this low, the horizon is in the picture.
    let camera = Camera::auto(red_box().bounds()).looking_from(0.0, 2.0).field_of_view(60.0);
    let with = |lines| {
        let mut picture = Picture::new(120, 90).camera(camera);
        picture.lines = lines;
        picture.render(&red_box())
    };
    let (plain, lined) = (with(Lines::None), with(Lines::Edges));
    // The box is in the middle; the columns at the sides show ground and backdrop alone.
    for x in [2, 8, 111, 117] {
        for y in 0..90 {
            assert_eq!(plain.pixel(x, y), lined.pixel(x, y), "{x} {y}");
        }
    }
    assert_ne!(plain, lined, "the box has lines");
}

#[cfg(feature = "png")]
#[test]
fn indexed_files_are_smaller_and_almost_the_same() {
    let image = Picture::new(320, 240).render(&tower(2));
    let (full, indexed) = (image.to_png().expect("a file"), image.to_indexed_png().expect("a file"));
    assert!(indexed.len() * 3 < full.len() * 2, "{} {}", indexed.len(), full.len());
    let mut reader = png::Decoder::new(std::io::Cursor::new(indexed)).read_info().expect("a PNG file");
    let palette = reader.info().palette.clone().expect("a palette");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut pixels).expect("the pixels");
    assert_eq!(pixels.len(), 320 * 240);
    for (index, pixel) in pixels.iter().zip(image.rgba.chunks_exact(4)) {
        let color = &palette[3 * usize::from(*index)..][..3];
        let off = color.iter().zip(pixel).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(off <= Some(40), "{color:?} {pixel:?}");
    }
    assert!(Image::filled(0, 0, [0; 4]).to_indexed_png().is_ok() == Image::filled(0, 0, [0; 4]).to_png().is_ok());
}

#[test]
fn holes_can_be_seen_through() {
    let mut fill = Fill(Model::new());
    fill.mesh("Plate", &color(0.9, 0.1, 0.1), &plate(), DAffine3::IDENTITY);
    let camera = Camera { margin: 0.0, ..Camera::auto(fill.0.bounds()).looking_from(0.0, 0.0).orthographic() };
    let mut picture = Picture::new(80, 60).camera(camera);
    picture.ground = false;
    let image = picture.render(&fill.0);
    assert!(!is_red(image.pixel(40, 30).expect("inside")) && is_red(image.pixel(8, 30).expect("inside")));
}

#[test]
fn glass_lets_what_is_behind_it_through() {
    let mut fill = Fill(Model::new());
    fill.cuboid("Box", &color(0.9, 0.1, 0.1), upright(DVec3::ZERO, DVec3::ONE));
    let mut clear = (*color(0.2, 0.5, 0.9)).clone();
    clear.opacity = Some(0.2);
    fill.quad("Glass", &Arc::new(clear), crate::sink_support::front(dvec3(-1.0, -1.0, 2.0), 3.0, 3.0));
    let camera = Camera::auto(fill.0.bounds()).looking_from(0.0, 0.0);
    let image = Picture::new(80, 60).camera(camera).render(&fill.0);
    let [r, _, b, _] = image.pixel(40, 30).expect("inside");
    let [r2, _, b2, _] = image.pixel(24, 30).expect("inside");
    assert!(b < r && r2 < b2, "{r} {b} {r2} {b2}");
}

#[test]
fn odd_models_and_sizes_do_no_harm() {
    let mut fill = Fill(Model::new());
    fill.quad("A", &color(1.0, 0.0, 0.0), crate::sink_support::front(dvec3(f64::NAN, 0.0, 0.0), 1.0, 1.0));
    fill.quad("B", &color(1.0, 0.0, 0.0), crate::sink_support::front(dvec3(1e300, 0.0, 0.0), 1.0, 1.0));
    fill.quad("C", &color(1.0, 0.0, 0.0), crate::sink_support::front(DVec3::ZERO, 0.0, 0.0));
    let mut point = Fill(Model::new());
    point.quad("C", &color(1.0, 0.0, 0.0), crate::sink_support::front(DVec3::ONE, 0.0, 0.0));
    for model in [fill.0, point.0, Model::new()] {
        for (width, height) in [(0, 0), (1, 1), (3, 2), (40, 30)] {
            let image = Picture::new(width, height).render(&model);
            assert_eq!(image.rgba.len(), 4 * width * height);
            assert!(model.to_svg(width, height).ends_with("</svg>\n"));
        }
    }
    // A camera inside a box.
    let model = red_box();
    let camera = Camera::auto(cga_runtime::geometry::mesh::Bounds { low: DVec3::splat(0.4), high: DVec3::splat(0.5) });
    Picture::new(40, 30).camera(camera).render(&model);
}

#[test]
fn images_can_be_put_together_and_labelled() {
    let white = [255; 4];
    let mut sheet = Image::filled(40, 20, white);
    sheet.blit(&Image::filled(10, 10, [9, 8, 7, 255]), -5, 15);
    assert_eq!(
        (sheet.pixel(4, 15), sheet.pixel(5, 15), sheet.pixel(4, 14)),
        (Some([9, 8, 7, 255]), Some(white), Some(white))
    );
    assert_eq!((sheet.pixel(40, 0), sheet.pixel(0, 20)), (None, None));
    sheet.rectangle(0, 0, 1, 1, [0, 0, 0, 0]);
    assert_eq!(sheet.pixel(0, 0), Some(white));
    sheet.text(10, 2, 1, "I\n.", [0, 0, 0, 255]);
    let ink: Vec<(usize, usize)> =
        (0..800).map(|at| (at % 40, at / 40)).filter(|&(x, y)| sheet.pixel(x, y) == Some([0, 0, 0, 255])).collect();
    // Both ends of the letter, its stem, and the dot on the next line.
    assert_eq!(ink.len(), 3 + 5 + 3 + 4);
    assert_eq!((ink[0], ink[ink.len() - 1]), ((11, 2), (12, 19)));
    assert_eq!(Image::text_size(2, "ab\nc"), (22, 40));
}

#[cfg(feature = "png")]
#[test]
fn png_files_hold_the_pixels() {
    let opaque = Picture::new(20, 10).render(&red_box());
    let glass = Image::filled(20, 10, [9, 8, 7, 100]);
    for (image, kind) in [(&opaque, png::ColorType::Rgb), (&glass, png::ColorType::Rgba)] {
        let bytes = image.to_png().expect("a file");
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        let info = reader.next_frame(&mut pixels).expect("a picture");
        assert_eq!((info.width, info.height, info.color_type), (20, 10, kind));
        let colors = image.rgba.as_chunks::<4>().0.iter();
        let wanted: Vec<u8> = colors.flat_map(|color| &color[..kind.samples()]).copied().collect();
        assert_eq!(pixels, wanted);
    }
}

#[test]
fn svg_paints_what_is_nearer_later() {
    let mut fill = Fill(Model::new());
    let far = upright(dvec3(0.0, 0.0, -9.0), dvec3(9.0, 9.0, 0.1));
    // The near box comes first. Its middle is behind the middle of the far box's nearest face.
    fill.cuboid("Near", &color(0.0, 0.0, 1.0), upright(dvec3(0.0, 0.0, -8.9), dvec3(0.5, 0.5, 0.1)));
    fill.cuboid("Far", &color(1.0, 0.0, 0.0), far);
    let svg = fill.0.to_svg(400, 300);
    let paths: Vec<&str> = svg.lines().filter(|line| line.starts_with("<path")).collect();
    let blue = |line: &&str| line.contains("fill=\"#0000");
    let first = paths.iter().position(blue);
    // The large face behind it is painted first. Its sides overlap nothing, so their order is free.
    assert!(Some(0) < first, "{svg}");
    assert_eq!(paths.len(), 6);
}

#[test]
fn svg_is_short_and_stays_the_same() {
    let svg = Svg::new(300, 200).render(&mixed());
    assert_eq!(svg, Svg::new(300, 200).render(&mixed()));
    let svg = Svg::new(300, 200).render(&steady());
    assert!(svg.contains('Z') && svg.contains("fill-rule=\"evenodd\""));
    assert_eq!((svg.len(), hash(svg.as_bytes())), (13777, 0x67e3_ab42_8bf4_c377));
}
