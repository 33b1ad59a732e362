//! What pictures show.

use cga_picture::glam::{DVec2, DVec3};
use cga_picture::{Alpha, Bitmap, Bounds, Camera, Face, Lines, Paint, Renderer, Scene, Viewpoint};

use crate::{HALVES, add, color, front, square};

/// The places of a square's corners in an image that fills it.
const WHOLE: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];

/// An image of two by two pixels: red, green, and below them blue and white.
fn four() -> Bitmap {
    let colors = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255; 4]];
    Bitmap { width: 2, height: 2, rgba: colors.concat() }
}

/// A floor whose normal map leans towards +u, the east: light from there makes it brighter, light from the west darker, and the map
/// turns with the coordinates.
#[test]
fn normal_maps_turn_the_light() {
    let brightness = |texel: [u8; 4], sun: f64, uvs: &[DVec2; 4]| {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, -1.0], [0.0, -1.0]].map(|[x, z]| DVec3::new(x, 0.0, z));
        let mut scene = Scene::new(Bounds::of(corners));
        let map = scene.add_normal_map(Bitmap::filled(4, 4, texel));
        let paint = scene.add_paint(Paint { normal_image: (texel[3] == 255).then_some(map), ..Paint::default() });
        scene.add_face(&Face { normal_uvs: Some(uvs), ..Face::new(&corners, &HALVES, DVec3::Y, paint) });
        let mut renderer = Renderer::new(32, 32);
        renderer.view = Viewpoint::Around { azimuth: 0.0, elevation: 90.0 };
        (renderer.ground, renderer.lines, renderer.sun_azimuth, renderer.sun_elevation) =
            (false, Lines::None, sun, 30.0);
        let picture = renderer.render(&scene);
        u32::from(picture.pixel(16, 16).expect("a pixel")[0])
    };
    const FLAT: [u8; 4] = [128, 128, 255, 255];
    const NONE: [u8; 4] = [0; 4];
    const EAST: [u8; 4] = [218, 128, 218, 255];
    let turned = [WHOLE[1], WHOLE[2], WHOLE[3], WHOLE[0]];
    let [east, west, south] = [90.0, -90.0, 0.0];
    let flat = brightness(FLAT, east, &WHOLE);
    for sun in [east, west, south] {
        assert_eq!(brightness(FLAT, sun, &WHOLE), brightness(NONE, sun, &WHOLE));
        assert_eq!(brightness([127, 127, 255, 255], sun, &WHOLE), brightness(NONE, sun, &WHOLE));
    }
    assert!(flat + 10 < brightness(EAST, east, &WHOLE));
    assert!(brightness(EAST, west, &WHOLE) + 10 < flat);
    // u runs to the south here.
    assert_eq!(brightness(EAST, south, &turned), brightness(EAST, east, &WHOLE));
    // Coordinates in one line give no direction.
    assert_eq!(brightness(EAST, east, &[DVec2::ZERO; 4]), flat);
}

#[test]
fn the_nearer_square_is_seen_and_has_its_leaf() {
    let mut scene = Scene::new(Bounds::of(square(-1.0).into_iter().chain(square(1.0))));
    let (red, blue) = (scene.add_paint(color(0.8, 0.0, 0.0)), scene.add_paint(color(0.0, 0.0, 0.8)));
    add(&mut scene, 1.0, red, 7);
    add(&mut scene, -1.0, blue, 3);
    let renderer = front(16);
    let picture = renderer.render(&scene);
    assert!(picture.pixel(8, 8).is_some_and(|[r, _, b, a]| b < r && a == 255));
    assert_eq!((picture.pixel(16, 0), picture.pixel(0, 16)), (None, None));
    assert_eq!(renderer.leaves(&scene), [Some(7); 256]);
    assert_eq!(picture, renderer.render(&scene));
}

#[test]
fn clear_glass_shows_the_surface_behind_it() {
    let leaves = |opacity: f32| {
        let mut scene = Scene::new(Bounds::of(square(-1.0).into_iter().chain(square(1.0))));
        let (red, glass) =
            (scene.add_paint(color(0.8, 0.0, 0.0)), scene.add_paint(Paint { opacity, ..color(0.0, 0.0, 0.8) }));
        add(&mut scene, 1.0, glass, 1);
        add(&mut scene, -1.0, red, 0);
        (front(16).render(&scene).pixel(8, 8).expect("inside"), front(16).leaves(&scene)[0])
    };
    let [clear, half, solid] = [0.0, 0.5, 1.0].map(leaves);
    assert_eq!([clear.1, half.1, solid.1], [Some(0), Some(1), Some(1)]);
    assert!(clear.0[2] < half.0[2] && half.0[2] < solid.0[2], "{clear:?} {half:?} {solid:?}");
}

#[test]
fn an_image_is_the_right_way_round() {
    let mut scene = Scene::new(Bounds::of(square(0.0)));
    let image = scene.add_image(four());
    let paint = scene.add_paint(Paint { color_image: Some(image), ..Paint::default() });
    scene.add_face(&Face { color_uvs: Some(&WHOLE), ..Face::new(&square(0.0), &HALVES, DVec3::Z, paint) });
    let picture = front(16).render(&scene);
    let channels = |x, y| picture.pixel(x, y).map(|[r, g, b, _]| [r, g, b].map(|channel| 100 < channel));
    let [upper, lower] = [4, 11].map(|y| [4, 11].map(|x| channels(x, y).expect("inside")));
    assert_eq!(upper, [[true, false, false], [false, true, false]]);
    assert_eq!(lower, [[false, false, true], [true; 3]]);
}

#[test]
fn a_mask_cuts_holes() {
    let mut scene = Scene::new(Bounds::of(square(0.0)));
    let mut image = Bitmap::filled(2, 1, [255; 4]);
    image.rgba[3] = 0;
    let image = scene.add_image(image);
    let paint = scene.add_paint(Paint { opacity_image: Some((image, Alpha::Mask(0.5))), ..Paint::default() });
    scene.add_face(&Face { opacity_uvs: Some(&WHOLE), ..Face::new(&square(0.0), &HALVES, DVec3::Z, paint) });
    let leaves = front(16).leaves(&scene);
    assert_eq!([leaves[8 * 16 + 4], leaves[8 * 16 + 12]], [None, Some(0)]);
}

#[test]
fn lines_divide_leaves_in_one_plane_if_wanted() {
    let dark = |leaf: u32, lines: Lines| {
        let mut scene = Scene::new(Bounds::of(square(0.0)));
        let paint = scene.add_paint(Paint::default());
        for (leaf, half) in [(0, [[0, 1, 2]]), (leaf, [[0, 2, 3]])] {
            scene.add_face(&Face { leaf, ..Face::new(&square(0.0), &half, DVec3::Z, paint) });
        }
        let picture = Renderer { lines, ..front(32) }.render(&scene);
        (0..32).filter_map(|x| picture.pixel(x, 16)).map(|[red, ..]| red).min().expect("a row")
    };
    let [none, same, edges, leaves] = [(1, Lines::None), (0, Lines::Leaves), (1, Lines::Edges), (1, Lines::Leaves)]
        .map(|(leaf, lines)| dark(leaf, lines));
    assert!(none == same && same == edges && leaves < edges, "{none} {same} {edges} {leaves}");
}

/// Two faces in one plane and in one leaf on the ground, seen from above.
#[test]
fn lines_divide_faces_of_one_leaf_and_surround_them_on_the_ground_if_wanted() {
    let flat = square(0.0).map(|point| DVec3::new(point.x, 0.0, -point.y));
    let dark = |lines: Lines, opacity: f32| {
        let mut scene = Scene::new(Bounds::of(flat));
        let paint = scene.add_paint(Paint { opacity, ..Paint::default() });
        for half in HALVES {
            scene.add_face(&Face::new(&flat, &[half], DVec3::Y, paint));
        }
        let camera = Camera { margin: 0.2, ..Camera::auto(Bounds::of(flat)) }.looking_from(0.0, 90.0).orthographic();
        let renderer = Renderer { view: Viewpoint::Camera(camera), ground: true, lines, ..front(64) };
        let picture = renderer.render(&scene);
        // In a row through the middle: the edge on the left, the diagonal, and the edge on the right.
        let row: Vec<u8> = (0..64).filter_map(|x| picture.pixel(x, 32)).map(|[red, ..]| red).collect();
        [&row[..24], &row[24..40], &row[40..]].map(|part| *part.iter().min().expect("a pixel"))
    };
    for opacity in [1.0, 0.3] {
        let [plain, faces] = [Lines::Edges, Lines::Faces].map(|lines| dark(lines, opacity));
        assert!((0..3).all(|part| faces[part] + 8 < plain[part]), "{plain:?} {faces:?} at the opacity {opacity}");
    }
}

/// A camera above a floor whose triangles go on behind it: their corners are at pixels far outside the picture.
#[test]
fn a_floor_below_the_camera_is_seen_up_to_the_horizon() {
    let half = [3.0, 300.0, 3e4, 3e6];
    for (half, aside) in half.into_iter().flat_map(|half| [0.0, 0.31, 0.97].map(|aside| (half, aside * half))) {
        let corners = [[-half, half], [half, half], [half, -half], [-half, -half]];
        let floor = corners.map(|[x, z]| DVec3::new(x + aside, 0.0, z - 0.5 * aside));
        let mut scene = Scene::new(Bounds::of(floor));
        let paint = scene.add_paint(Paint::default());
        scene.add_face(&Face::new(&floor, &HALVES, DVec3::Y, paint));
        let near = Bounds { low: DVec3::splat(-1.0), high: DVec3::ONE };
        let camera = Camera::auto(near).looking_from(30.0, 8.0).field_of_view(70.0);
        let renderer = Renderer { view: Viewpoint::Camera(camera), ..front(64) };
        let leaves = renderer.leaves(&scene);
        let seen = |rows: std::ops::Range<usize>| {
            rows.map(|row| leaves[row * 64..][..64].iter().flatten().count()).sum::<usize>()
        };
        // Small floors end inside the picture.
        assert!(half < 100.0 || seen(48..64) == 16 * 64, "{half} {aside}: {} of {}", seen(48..64), 16 * 64);
        assert!(0 < seen(0..64), "{half} {aside}");
    }
}

#[test]
fn normals_of_corners_shade_smoothly() {
    let shade = |normals: Option<&[DVec3]>| {
        let mut scene = Scene::new(Bounds::of(square(0.0)));
        let paint = scene.add_paint(Paint::default());
        scene.add_face(&Face { normals, round: true, ..Face::new(&square(0.0), &HALVES, DVec3::Z, paint) });
        let picture = front(16).render(&scene);
        [1, 14].map(|x| picture.pixel(x, 8).expect("inside")[0])
    };
    let [left, right] = shade(None);
    assert!(left.abs_diff(right) <= 2);
    let aside = [-1.0, 1.0, 1.0, -1.0].map(|x| DVec3::new(x, 0.0, 1.0).normalize());
    let [left, right] = shade(Some(&aside));
    // The sun is to the left.
    assert!(right + 20 < left, "{left} {right}");
}

/// The bytes are the same on every machine.
#[test]
fn pictures_stay_the_same() {
    let mut scene = Scene::new(Bounds::of(square(-1.0).into_iter().chain(square(1.0))));
    let image = scene.add_image(four());
    let paints = [
        Paint { color_image: Some(image), ..color(0.9, 0.8, 0.7) },
        Paint { opacity: 0.4, ..color(0.1, 0.4, 0.3) },
        Paint { metallic: 1.0, gloss: 0.7, ..color(0.7, 0.6, 0.2) },
    ];
    let paints = paints.map(|paint| scene.add_paint(paint));
    for (leaf, (paint, z)) in paints.into_iter().zip([-1.0, 1.0, 0.0]).enumerate() {
        let leaf = leaf as u32;
        let turned = square(z).map(|p| DVec3::new(p.x, p.y, p.z + 0.5 * p.x));
        let normal = DVec3::new(-0.5, 0.0, 1.0).normalize();
        scene.add_face(&Face { leaf, color_uvs: Some(&WHOLE), ..Face::new(&turned, &HALVES, normal, paint) });
    }
    let bytes = Renderer::new(96, 64).render(&scene).rgba;
    let hash = bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3));
    assert_eq!(hash, 0x552e_d654_913e_5f01, "{hash:#x}");
}
