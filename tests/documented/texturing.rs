//! *split operation* (UV split), *tileUV*, *setupProjection*, *projectUV*, *texture*, *rotateUV* and *primitive operations*: the
//! texture coordinates of the pages' examples.

use cga::glam::{DVec2, DVec3};
use cga::{Settings, Shape, cga};

use crate::collect::{Corner, Leaves};
use cga_tests::pages::example::Example;
use cga_tests::pages::{primitives, texturing};

fn on(example: &Example, shape: &Shape) -> Leaves {
    let model = (example.run)(shape, &Settings::default()).expect("a model");
    assert!(model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
    let mut leaves = Leaves::default();
    let _ = model.replay(&mut leaves);
    leaves
}

fn of(example: &Example) -> Leaves {
    on(example, &(example.start)())
}

fn uv(corner: &Corner, set: usize) -> DVec2 {
    corner.uvs[set].expect("coordinates")
}

#[track_caller]
fn all_are(corners: &[Corner], expected: impl Fn(DVec3) -> [f64; 2]) {
    assert!(!corners.is_empty());
    for corner in corners {
        let expected = DVec2::from_array(expected(corner.point));
        assert!(uv(corner, 0).abs_diff_eq(expected, 1e-9), "{corner:?}: {expected}");
    }
}

/// The smallest and the largest u of each leaf of a rule.
fn bands(leaves: &Leaves, rule: &str) -> Vec<[f64; 2]> {
    let of_rule = leaves.0.iter().filter(|(name, _)| name == rule);
    let range = |faces: &Vec<Vec<Corner>>| {
        let us = faces.iter().flatten().map(|corner| uv(corner, 0).x);
        us.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], u| [low.min(u), high.max(u)])
    };
    of_rule.map(|(_, faces)| range(faces)).collect()
}

fn area(faces: &[Vec<Corner>]) -> f64 {
    let of_face = |face: &Vec<Corner>| {
        let from = |at: usize| face[at].point - face[0].point;
        (2..face.len()).map(|at| from(at - 1).cross(from(at))).sum::<DVec3>().length() / 2.0
    };
    faces.iter().map(of_face).sum()
}

/// "Independent of facade size."
#[test]
fn halves_in_uv_space() {
    for width in [9.0, 20.0, 333.0] {
        let leaves = on(&texturing::uv_space::EXAMPLE, &Shape::rectangle(width, 5.0));
        assert_eq!(bands(&leaves, "X"), [[0.0, 0.5], [0.5, 1.0]]);
        all_are(&leaves.corners("X"), |p| [p.x / width, p.y / (width / 2.0)]);
    }
}

/// "Dependent of facade size."
#[test]
fn pieces_of_five_in_unit_space() {
    for (width, pieces) in [(9.0, 2), (20.0, 4), (23.0, 5)] {
        let leaves = on(&texturing::unit_space::EXAMPLE, &Shape::rectangle(width, 5.0));
        let bands = bands(&leaves, "X");
        assert_eq!(bands.len(), pieces);
        for (at, [low, high]) in bands.iter().enumerate() {
            let borders = [5.0 * at as f64, (5.0 * (at + 1) as f64).min(width)].map(|metres| metres / width);
            assert!((low - borders[0]).abs() < 1e-12 && (high - borders[1]).abs() < 1e-12, "{bands:?}");
        }
    }
}

/// "Both covered by a [0,1] uv space, the u axis following the street direction and the v axis, perpendicular to u, along the
/// width."
#[test]
fn both_segments_of_a_street_are_covered_from_0_to_1() {
    let segments = texturing::two_segments();
    assert_eq!(segments.len(), 2);
    for shape in &segments {
        let leaves = on(&texturing::street::EXAMPLE, shape);
        assert_eq!(leaves.range("Street", 0), [DVec2::ZERO, DVec2::ONE]);
        // Across the street at its start.
        let start: Vec<_> = leaves.corners("Street").into_iter().filter(|corner| uv(corner, 0).x == 0.0).collect();
        let at = |v: f64| start.iter().find(|corner| uv(corner, 0).y == v).expect("a corner").point;
        // It may be the mitre of a bend.
        let across = at(0.0).distance(at(1.0));
        assert!((8.0 - 1e-6..8.5).contains(&across), "{across}");
    }
}

/// The text says "every 20 meters a 3 meter wide band"; the rule and the picture have one in every 23.
#[test]
fn a_band_of_about_three_metres_in_every_period_of_a_street() {
    let mut counts = Vec::new();
    for shape in texturing::two_segments() {
        let street: f64 = on(&texturing::street::EXAMPLE, &shape).0.iter().map(|(_, faces)| area(faces)).sum();
        let leaves = on(&texturing::bands::EXAMPLE, &shape);
        let stretch = street / 8.0 / 23.0 / leaves.0.len() as f64;
        assert!((stretch - 1.0).abs() < 0.25, "{stretch}");
        for (_, faces) in &leaves.0 {
            // The metres are means of the surface: in the bend it is stretched more.
            assert!((area(faces) / 8.0 - 3.0 * stretch).abs() < 0.15, "{}", area(faces) / 8.0);
        }
        counts.push(leaves.0.len());
    }
    assert_eq!(counts, [4, 2]);
}

/// "The tile width (in u-direction) is exactly 20 meters and the tile height is exactly 10 meters"; "exactly two tiles fit in".
#[test]
fn a_street_is_tiled_badly_and_well() {
    let shape = texturing::tiled_street();
    let most = |example: &Example| {
        let [low, high] = on(example, &shape).range("Street", 0);
        assert_eq!(low, DVec2::ZERO);
        high
    };
    assert_eq!(most(&texturing::default_uv::EXAMPLE), DVec2::ONE);
    assert_eq!(of(&texturing::default_uv::EXAMPLE).0[0].1.len(), 7);
    let bad = most(&texturing::tiled_badly::EXAMPLE);
    assert!((bad.x - 83.0 / 20.0).abs() < 0.01 && (bad.y - 1.4).abs() < 1e-3, "{bad}");
    let well = most(&texturing::tiled_well::EXAMPLE);
    assert!(well.abs_diff_eq(DVec2::new(4.0, 2.0), 1e-12), "{well}");
}

/// "Please note that in the bottom picture, the brick texture does not span over the whole facade anymore."
#[test]
fn walls_have_seams_where_each_sets_up_its_projection() {
    let through = of(&texturing::on_the_facade::EXAMPLE);
    all_are(&through.corners("Wall"), |p| [p.x / 1.5, p.y]);
    let each = of(&texturing::on_each_wall::EXAMPLE);
    for (_, faces) in &each.0 {
        let low = faces.iter().flatten().map(|corner| uv(corner, 0)).reduce(DVec2::min);
        assert!(low.is_some_and(|low| low.abs_diff_eq(DVec2::ZERO, 1e-9)), "{low:?}");
    }
    // The dirt map spans the façade in both.
    for leaves in [&through, &each] {
        for corner in leaves.corners("Wall") {
            assert!(uv(&corner, 2).abs_diff_eq(DVec2::new(corner.point.x / 9.0, corner.point.y / 7.0), 1e-9));
        }
    }
}

/// setupuv_ztrick_1.png has rows of one colour in the reveal; in setupuv_ztrick_2.png the bricks go on around its left corner.
#[test]
fn textures_are_smeared_in_a_reveal_or_go_on_around_the_corner() {
    all_are(&of(&texturing::without_uw::EXAMPLE).corners("Wall"), |p| [p.x / 1.5, p.y]);
    let front = Shape::rectangle(20.0, 12.0).scope().origin.z;
    all_are(&of(&texturing::with_uw::EXAMPLE).corners("Wall"), |p| [(p.x - (p.z - front)) / 1.5, p.y]);
}

#[test]
fn one_image_lies_on_all_roofs() {
    let image = |p: DVec3| [p.x / 586.0, -p.z / 442.0];
    all_are(&of(&texturing::global::EXAMPLE).corners("Roof"), image);
    // "Offsets": they are multiples of the size of the image, so its place is the same, and both coordinates are small.
    let example = &texturing::global_offsets::EXAMPLE;
    for corner in of(example).corners("Roof") {
        let moved = uv(&corner, 0) - DVec2::from_array(image(corner.point));
        assert!(moved.abs_diff_eq(DVec2::new(-7.0, 5.0), 1e-9) && uv(&corner, 0).abs().max_element() < 2.0, "{moved}");
    }
}

/// "Note: The texture operation does not create texture coordinates."
#[test]
fn textures_of_five_metres() {
    let leaves = of(&texturing::textured::EXAMPLE);
    for (rule, faces) in &leaves.0 {
        match rule.as_str() {
            "Facade" => {
                let low = faces[0].iter().map(|corner| corner.point).reduce(DVec3::min).expect("corners");
                for corner in &faces[0] {
                    let (across, up) = ((corner.point - low).with_y(0.0).length(), corner.point.y - low.y);
                    let uv = uv(corner, 0);
                    // Seen from outside u runs to the right: from the low corner, or towards it.
                    assert!((uv.y - up / 5.0).abs() < 1e-9);
                    let width = faces[0].iter().map(|c| (c.point - low).with_y(0.0).length()).fold(0.0, f64::max);
                    assert!([across, width - across].iter().any(|metres| (uv.x - metres / 5.0).abs() < 1e-9));
                }
            }
            _ => assert!(faces.iter().flatten().all(|corner| corner.uvs == [None; 10])),
        }
    }
}

/// "The rotation center is at the texture position u=0 and v=0."
#[test]
fn coordinates_are_turned_about_the_corner() {
    let range = |example: &Example| of(example).range("Facade", 0);
    assert_eq!(range(&texturing::standard_uv::EXAMPLE), [DVec2::ZERO, DVec2::ONE]);
    let (sin, cos) = libm::sincos(10.0_f64.to_radians());
    let [low, high] = range(&texturing::rotated_uv::EXAMPLE);
    assert!(low.abs_diff_eq(DVec2::new(-sin, 0.0), 1e-12) && high.abs_diff_eq(DVec2::new(cos, cos + sin), 1e-12));
}

/// The corners of a disk are on the circle in the square of the texture, so its sides are inside. Without a radius the scope
/// fits the sides.
fn inset(sides: f64) -> f64 {
    libm::cos(std::f64::consts::PI / sides)
}

/// primitiveQuadExample1.png and primitiveDiskExample1.png: u to the right and v away from the front.
#[test]
fn quads_and_disks_show_the_texture_from_above() {
    for (example, size, inset) in [
        (&primitives::quad::EXAMPLE, [25.0, 20.0], 1.0),
        (&primitives::quad_sized::EXAMPLE, [10.0, 20.0], 1.0),
        (&primitives::disk::EXAMPLE, [25.0, 20.0], inset(16.0)),
        (&primitives::disk_sized::EXAMPLE, [20.0, 20.0], 1.0),
    ] {
        all_are(&of(example).corners("Lot"), |p| {
            [0.5 + (p.x - 12.5) / size[0] * inset, 0.5 - (p.z - 10.0) / size[1] * inset]
        });
    }
}

/// primitiveCubeExample1.png: each side shows the texture as seen from outside; on top v = 0 is at the front.
#[test]
fn cubes_show_the_texture_on_each_side() {
    for example in [&primitives::cube::EXAMPLE, &primitives::cube_sized::EXAMPLE] {
        let leaves = of(example);
        let [low, high] = leaves
            .corners("Lot")
            .iter()
            .fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], c| [low.min(c.point), high.max(c.point)]);
        // Bottom, top, front, right, back, left.
        let share = |p: DVec3| (p - low) / (high - low);
        let sides: [fn(DVec3) -> [f64; 2]; 5] =
            [|s| [s.x, 1.0 - s.z], |s| [s.x, s.y], |s| [1.0 - s.z, s.y], |s| [1.0 - s.x, s.y], |s| [s.z, s.y]];
        for (face, side) in leaves.0[0].1[1..].iter().zip(sides) {
            all_are(face, |p| side(share(p)));
        }
    }
}

/// The angle from the front, anticlockwise seen from above, in turns from the seam: the left end of the side in front.
fn turn(p: DVec3, middle: DVec3, radii: DVec2, sides: f64) -> f64 {
    let angle = libm::atan2((p.x - middle.x) / radii.x, (p.z - middle.z) / radii.y) / std::f64::consts::TAU;
    (angle + 0.5 / sides).rem_euclid(1.0)
}

/// primitiveCylinderExample1.png: purple and red meet at the left end of the side in front.
#[test]
fn cylinders_show_the_texture_once_around() {
    for (example, sides, height, radii, inset) in [
        (&primitives::cylinder::EXAMPLE, 16.0, 22.5, DVec2::new(12.5, 10.0), inset(16.0)),
        (&primitives::cylinder_sized::EXAMPLE, 8.0, 15.0, DVec2::splat(10.0), 1.0),
    ] {
        let faces = &of(example).0[0].1;
        for face in faces.iter().filter(|face| face.len() == 4) {
            for corner in face {
                let (u, expected) = (uv(corner, 0), turn(corner.point, DVec3::new(12.5, 0.0, 10.0), radii, sides));
                let gap = (u.x - expected).abs();
                assert!(gap.min(1.0 - gap) < 1e-9 && (u.y - corner.point.y / height).abs() < 1e-9, "{corner:?}");
            }
        }
        let top = faces.iter().find(|face| face.iter().all(|corner| corner.point.y == height)).expect("a top");
        all_are(top, |p| [0.5 + (p.x - 12.5) / (2.0 * radii.x) * inset, 0.5 - (p.z - 10.0) / (2.0 * radii.y) * inset]);
    }
}

/// primitiveSphereExample1.png: v from the south pole to the north pole, the seam as for cylinders.
#[test]
fn spheres_show_the_texture_from_pole_to_pole() {
    for (example, sides, divisions, size) in [
        (&primitives::sphere::EXAMPLE, 16.0, 16.0, DVec3::new(25.0, 22.5, 20.0)),
        (&primitives::sphere_sized::EXAMPLE, 8.0, 4.0, DVec3::splat(20.0)),
    ] {
        let radii = DVec2::new(size.x, size.z) / 2.0;
        for corner in of(example).corners("Lot") {
            let uv = uv(&corner, 0);
            let height =
                1.0 - libm::acos((2.0 * corner.point.y / size.y - 1.0).clamp(-1.0, 1.0)) / std::f64::consts::PI;
            assert!((uv.y - height).abs() < 1e-7 && ((uv.y * divisions).round() - uv.y * divisions).abs() < 1e-9);
            if 1e-9 < uv.y && uv.y < 1.0 - 1e-9 {
                let gap = (uv.x - turn(corner.point, DVec3::new(12.5, 0.0, 10.0), radii, sides)).abs();
                assert!(gap.min(1.0 - gap) < 1e-9, "{corner:?}");
            }
        }
    }
}

/// primitiveConeExample1.png: the middle bar of the texture goes once around at half the height, so the tip is at (0.5, 1).
#[test]
fn cones_show_the_texture_as_a_triangle() {
    for (example, sides, height, radii) in [
        (&primitives::cone::EXAMPLE, 16.0, 22.5, DVec2::new(12.5, 10.0)),
        (&primitives::cone_sized::EXAMPLE, 8.0, 15.0, DVec2::splat(10.0)),
    ] {
        for face in of(example).0[0].1.iter().filter(|face| face.len() == 3) {
            for corner in face {
                let uv = uv(corner, 0);
                if corner.point.y == height {
                    assert_eq!(uv, DVec2::new(0.5, 1.0));
                } else {
                    let gap = (uv.x - turn(corner.point, DVec3::new(12.5, 0.0, 10.0), radii, sides)).abs();
                    assert!(gap.min(1.0 - gap) < 1e-9 && uv.y == 0.0, "{corner:?}");
                }
            }
        }
    }
}

cga! {
    grammar Cut = r##"
    @StartRule
    Lot --> s(7, 10, 7) primitiveCylinder(72) split(y) { 3 : NIL | 4 : Ring | ~1 : NIL }
    Ring --> print(geometry.du(0, unitSpace)) print(geometry.uMin(0) + " " + geometry.uMax(0)) [ Pieces ] [ Moved ] Whole.
    Pieces --> split(u, uvSpace, 0) { '0.25 : Quarter. }*
    Moved --> translateUV(0, 0.6, 0.25) split(u, uvSpace, 0) { '0.5 : Half. }*
    "##;
}

/// The faces that close a cut have texture coordinates of (0, 0), as in files that CityEngine writes.
#[test]
fn caps_are_a_point_in_texture_space() {
    let model = Cut::default().generate(&Shape::rectangle(7.0, 7.0)).expect("a model");
    let prints: Vec<String> = model.report().prints().iter().map(|print| print.to_string()).collect();
    // The sides touch the scope.
    let girth = 72.0 * 7.0 * libm::tan(std::f64::consts::PI / 72.0);
    assert!((prints[0].parse::<f64>().expect("a number") - girth).abs() < 1e-3, "{prints:?}");
    assert_eq!(prints[1], "0 1");
    // Caps are whole, in the piece with u = 0, which is the first one; or moved.
    let caps = |rule: &str| {
        let level = |leaf: cga::LeafView<'_>| {
            let (mesh, _) = leaf.mesh();
            mesh.faces().filter(|face| 0.9 < face.normal().y.abs()).count()
        };
        model.leaves_of(rule).map(level).collect::<Vec<_>>()
    };
    assert_eq!([caps("Whole"), caps("Quarter"), caps("Half")], [vec![2], vec![2, 0, 0, 0], vec![2, 0]]);
    assert!(model.leaves_of("Whole").all(|leaf| leaf.mesh().0.is_closed()));
}
