use glam::{DAffine3, DQuat, DVec2, DVec3};

use super::*;
use crate::extrude::{Extrude, extrude};
use crate::mesh::{FaceTag, MeshBuilder, SubcomponentTagsBuilder, TagSet};
use crate::random::Rng;

const ALL: f64 = f64::INFINITY;

fn ring(corners: &[(f64, f64)]) -> Vec<DVec3> {
    corners.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect()
}

fn polygon(outline: &[(f64, f64)], holes: &[&[(f64, f64)]]) -> Mesh {
    Mesh::from_polygon(&ring(outline), &holes.iter().map(|hole| ring(hole)).collect::<Vec<_>>()).expect("a polygon")
}

/// The laws: convex parts of positive area with the same sum, nothing new is open, and no edge has no length.
fn cut(mesh: &Mesh) -> Mesh {
    let made = convexify(mesh, ALL);
    assert!(made.refused.is_empty(), "{:?}", made.refused);
    let made = made.made.map_or_else(|| mesh.clone(), |made| made.0);
    assert_eq!(made.check(), []);
    for face in made.faces() {
        assert!(
            !is_concave(&face) && 0.0 < face.area(),
            "face {}: {:?}",
            face.index(),
            face.outline().collect::<Vec<_>>()
        );
    }
    assert!((made.area() - mesh.area()).abs() <= 1e-12 * mesh.area(), "{} {}", made.area(), mesh.area());
    assert_eq!(made.is_closed(), mesh.is_closed());
    assert!((made.volume() - mesh.volume()).abs() <= 1e-12 * mesh.bounds().size().element_product().max(1.0));
    assert_eq!(&made.points()[..mesh.points().len()], mesh.points());
    assert!(convexify(&made, ALL).made.is_none(), "convex faces stay as they are");
    made
}

fn areas(mesh: &Mesh) -> Vec<f64> {
    mesh.faces().map(|face| face.area()).collect()
}

const L: [(f64, f64); 6] = [(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (5.0, 5.0), (5.0, 10.0), (0.0, 10.0)];

#[test]
fn an_l_becomes_two_parts_by_its_shorter_cut() {
    let made = cut(&polygon(&L, &[]));
    assert_eq!(areas(&made), [50.0, 25.0]);
    assert_eq!(made.points().len(), 7);
    // A narrow arm is cut off.
    let narrow = [(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (2.0, 5.0), (2.0, 10.0), (0.0, 10.0)];
    assert_eq!(areas(&cut(&polygon(&narrow, &[]))), [50.0, 10.0]);
    let low = [(0.0, 0.0), (10.0, 0.0), (10.0, 1.0), (5.0, 1.0), (5.0, 10.0), (0.0, 10.0)];
    assert_eq!(areas(&cut(&polygon(&low, &[]))), [50.0, 5.0]);
}

#[test]
fn only_cuts_shorter_than_the_limit_are_made() {
    let l = polygon(&L, &[]);
    assert!(convexify(&l, 4.0).made.is_none() && convexify(&l, 5.0).made.is_none());
    assert_eq!(areas(&convexify(&l, 6.0).made.unwrap().0), [50.0, 25.0]);
    // A comb: its narrow prong is cut off, and the wide one stays.
    let comb = [
        (0.0, 0.0),
        (9.0, 0.0),
        (9.0, 5.0),
        (5.0, 5.0),
        (5.0, 2.0),
        (2.0, 2.0),
        (2.0, 5.0),
        (1.0, 5.0),
        (1.0, 2.0),
        (0.0, 2.0),
    ];
    let made = convexify(&polygon(&comb, &[]), 1.5).made.unwrap().0;
    assert_eq!(areas(&made), [30.0, 3.0]);
    assert_eq!((made.check(), is_concave(&made.face(0))), (Vec::new(), true));
}

#[test]
fn both_prongs_of_a_fork_are_cut_off_at_the_notch() {
    let fork = [(0.0, 0.0), (5.0, 0.0), (5.0, 9.0), (3.0, 9.0), (3.0, 4.0), (2.0, 4.0), (2.0, 9.0), (0.0, 9.0)];
    assert_eq!(areas(&cut(&polygon(&fork, &[]))), [20.0, 10.0, 10.0]);
}

#[test]
fn two_concave_corners_are_joined_where_they_are_near() {
    let hourglass = [(0.0, 0.0), (8.0, 0.0), (4.5, 5.0), (8.0, 10.0), (0.0, 10.0), (3.5, 5.0)];
    let made = cut(&polygon(&hourglass, &[]));
    assert_eq!((areas(&made), made.points().len()), (vec![22.5, 22.5], 6));
}

#[test]
fn holes_are_cut_through() {
    let square = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)];
    let made = cut(&polygon(&square(0.0, 10.0), &[&square(3.0, 6.0)]));
    assert!(made.faces().all(|face| face.loops().len() == 1) && made.face_count() == 4, "{}", made.face_count());
    cut(&polygon(&square(0.0, 10.0), &[&[(2.0, 2.0), (3.0, 2.0), (2.0, 3.0)]]));
    cut(&polygon(&square(0.0, 10.0), &[&square(1.0, 4.0), &square(6.0, 9.0)]));
    // Holes stay where the cuts through them would be too long. A cut that is short but divides nothing is not made.
    let holes = polygon(&square(0.0, 10.0), &[&square(3.0, 6.0)]);
    let near_the_rim = polygon(&square(0.0, 10.0), &[&square(1.0, 6.0)]);
    assert!(convexify(&holes, 2.0).made.is_none());
    let made = convexify(&near_the_rim, 1.5).made.unwrap().0;
    assert_eq!((made.check(), made.area()), (Vec::new(), 75.0));
    assert!(1 < made.face_count() && made.faces().any(|face| is_concave(&face)));
}

#[test]
fn new_points_are_shared_with_the_neighbours() {
    let block = extrude(&polygon(&L, &[]), Extrude::FaceNormal, 3.0);
    let made = cut(&block);
    assert!(made.is_closed());
    assert_eq!((made.face_count(), made.points().len()), (10, 14));
    // One side has a straight corner more below and above; the others are untouched.
    let counts: Vec<usize> = made.faces().map(|face| face.corner_count()).collect();
    assert_eq!(counts.iter().filter(|&&count| count == 6).count(), 1, "{counts:?}");
}

#[test]
fn values_at_new_corners_are_between_those_of_their_edges() {
    let block = extrude(&polygon(&L, &[]), Extrude::FaceNormal, 3.0);
    let place = |mesh: &Mesh, corner: usize| {
        let p = mesh.points()[mesh.corners()[corner] as usize];
        DVec2::new(2.0 * p.x + p.z, p.y - 3.0)
    };
    let tagged: Vec<FaceTag> = block.faces().map(|face| face.tag()).collect();
    let uvs = (0..block.corners().len()).map(|corner| place(&block, corner)).collect();
    let mut block = block.with_uv_set(2, uvs);
    block.normals = block.faces().flat_map(|face| vec![face.normal(); face.corner_count()]).collect();
    let made = cut(&block);
    assert!((0..made.corners().len()).all(|corner| (made.uv_set(2)[corner] - place(&made, corner)).length() < 1e-12));
    for face in made.faces() {
        assert!(made.normals()[face.corner_range()].iter().all(|normal| (*normal - face.normal()).length() < 1e-12));
        assert!(tagged.contains(&face.tag()));
    }
}

#[test]
fn parts_of_edges_keep_the_tags_of_the_edge() {
    let tag = |name: &str| TagSet::new([name]);
    let mut block = extrude(&polygon(&L, &[]), Extrude::FaceNormal, 3.0);
    let mut tagger = SubcomponentTagsBuilder::default();
    block.face_edges().for_each(|[a, b]| tagger.edge([a, b], &tag(&format!("edge.{}.{}", a.min(b), a.max(b)))));
    (0..block.points().len() as u32).for_each(|point| tagger.vertex(point, &tag("vertex")));
    block.subcomponent_tags = tagger.finish();
    let made = cut(&block);
    let old = block.points().len() as u32;
    let on_line = |[a, b]: [u32; 2], p: u32| {
        let [a, b, p] = [a, b, p].map(|point| made.points()[point as usize]);
        (p - a).cross(b - a).length() < 1e-9 && 0.0 < (p - a).dot(b - p)
    };
    let mut parts = 0;
    for [a, b] in made.face_edges() {
        let whole = block
            .face_edges()
            .find(|&ends| [a, b].iter().all(|p| ends.contains(p) || (old <= *p && on_line(ends, *p))));
        assert_eq!(made.edge_tags([a, b]), whole.and_then(|whole| block.edge_tags(whole)));
        parts += usize::from(whole.is_some() && old <= a.max(b));
    }
    assert!(4 <= parts && (0..old).all(|point| made.vertex_tags(point).is_some()));
    assert!((old..made.points().len() as u32).all(|point| made.vertex_tags(point).is_none()));
}

#[test]
fn a_bent_face_keeps_its_bend() {
    let mut builder = MeshBuilder::new();
    let outline = L.map(|(x, y)| builder.point([x, y, 0.01 * x * y]));
    builder.face(&outline, &[], FaceTag::PLAIN);
    let bent = builder.build().unwrap();
    let made = convexify(&bent, ALL).made.unwrap().0;
    assert_eq!((made.face_count(), &made.points()[..6]), (2, bent.points()));
    // The new point is on its edge.
    let new = made.points()[6];
    assert_eq!(new.z, if new.x == 0.0 { 0.0 } else { 0.01 * new.x * new.y });
}

#[test]
fn parts_of_bent_faces_are_convex_in_their_own_planes() {
    let mut random = Rng(5);
    for round in 0..100 {
        let mut builder = MeshBuilder::new();
        let outline: Vec<u32> = (0..9)
            .map(|k| {
                let (sin, cos) = libm::sincos(f64::from(k) / 9.0 * std::f64::consts::TAU);
                let far = 2.0 + 8.0 * random.unit();
                builder.point([far * cos, far * sin, 5.0 * random.unit()])
            })
            .collect();
        builder.face(&outline, &[], FaceTag::PLAIN);
        let bent = builder.build().unwrap();
        let made = convexify(&bent, ALL);
        assert!(made.refused.is_empty(), "{round}");
        let made = made.made.map_or_else(|| bent.clone(), |made| made.0);
        assert!(made.faces().all(|face| !is_concave(&face)), "{round}");
        let sum: DVec3 = made.faces().map(|face| face.area_vector()).sum();
        assert!((sum - bent.face(0).area_vector()).length() < 1e-9, "{round}");
    }
}

#[test]
fn stars_combs_and_plates_of_any_place_are_cut() {
    let mut random = Rng(3);
    let mut noise = || random.unit();
    for round in 0..60 {
        let corners = 5 + (noise() * 40.0) as usize;
        let round_trip = |radius: f64, noise: &mut dyn FnMut() -> f64| -> Vec<(f64, f64)> {
            (0..corners)
                .map(|k| {
                    let (sin, cos) = libm::sincos(k as f64 / corners as f64 * std::f64::consts::TAU);
                    let far =
                        radius * (0.4 + 0.6 * if round % 3 == 0 { (noise() * 4.0).round() / 4.0 } else { noise() });
                    (far * cos, far * sin)
                })
                .collect()
        };
        let outline = round_trip(10.0, &mut noise);
        let hole: Vec<(f64, f64)> = round_trip(3.0, &mut noise);
        let face = if round % 2 == 0 { polygon(&outline, &[]) } else { polygon(&outline, &[&hole]) };
        let turn = DQuat::from_euler(glam::EulerRot::XYZ, noise() * 6.0, noise() * 6.0, noise() * 6.0);
        let far = if round % 5 == 0 { 1e5 } else { 10.0 };
        let turned = face.map(&DAffine3::from_rotation_translation(turn, DVec3::new(noise(), noise(), noise()) * far));
        let meshes = [face.clone(), extrude(&face, Extrude::FaceNormal, 2.0), turned];
        for mesh in &meshes[..if far == 1e5 { 2 } else { 3 }] {
            cut(mesh);
        }
    }
}

#[test]
fn loops_that_touch_are_divided() {
    let mut builder = MeshBuilder::new();
    let at = |builder: &mut MeshBuilder, list: &[(f64, f64)]| -> Vec<u32> {
        list.iter().map(|&(x, y)| builder.point([x, y, 0.0])).collect()
    };
    // A hole that touches the outline in a corner, and another hole that touches the first one.
    let outline = at(&mut builder, &[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
    let one = at(&mut builder, &[(0.0, 0.0), (1.0, 2.0), (2.0, 1.0)]);
    let two = at(&mut builder, &[(2.0, 1.0), (2.0, 2.0), (3.0, 1.5)]);
    builder.face(&outline, &[&one, &two], FaceTag::PLAIN);
    let face = builder.build().unwrap();
    let made = convexify(&face, ALL);
    assert!(made.refused.is_empty());
    let made = made.made.unwrap().0;
    assert!((made.area() - face.area()).abs() < 1e-12 && made.faces().all(|face| !is_concave(&face)));
}

#[test]
fn faces_that_cross_themselves_stay() {
    for outline in [
        vec![(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 3.0)],
        vec![(0.0, 0.0), (6.0, 0.0), (1.0, 4.0), (3.0, -2.0), (5.0, 4.0)],
    ] {
        let mut builder = MeshBuilder::new();
        let corners: Vec<u32> = outline.iter().map(|&(x, y)| builder.point([x, y, 0.0])).collect();
        builder.face(&corners, &[], FaceTag::PLAIN);
        let mesh = builder.build().unwrap();
        let made = convexify(&mesh, ALL);
        assert!(made.made.is_none() && made.refused == [0]);
        assert!(convexify(&mesh, 0.1).made.is_none());
    }
}

#[test]
fn sizes_may_be_huge_or_tiny() {
    for size in [1e-200, 1e-9, 1e9, 1e140] {
        let mut builder = MeshBuilder::new();
        let l = L.map(|(x, y)| builder.point([x * size, y * size, 0.0]));
        builder.face(&l, &[], FaceTag::PLAIN);
        let made = convexify(&builder.build().unwrap(), ALL).made.unwrap().0;
        assert_eq!((made.face_count(), made.check().len()), (2, 0), "{size}");
    }
}

#[test]
fn a_face_that_is_refused_leaves_no_corners_in_its_neighbours() {
    let mut builder = MeshBuilder::new();
    // An L whose lower arm ends in a bow.
    let outline =
        [(0.0, 0.0), (10.0, 0.0), (12.0, 5.0), (12.0, 0.0), (10.0, 5.0), (5.0, 5.0), (5.0, 10.0), (0.0, 10.0)];
    let corners: Vec<u32> = outline.iter().map(|&(x, y)| builder.point([x, y, 0.0])).collect();
    builder.face(&corners, &[], FaceTag::PLAIN);
    let apex = builder.point([4.0, 4.0, 9.0]);
    for k in 0..corners.len() {
        builder.face(&[corners[(k + 1) % corners.len()], corners[k], apex], &[], FaceTag::PLAIN);
    }
    let far = L.map(|(x, y)| builder.point([x + 50.0, y, 0.0]));
    builder.face(&far, &[], FaceTag::PLAIN);
    let mesh = builder.build().unwrap();
    let made = convexify(&mesh, ALL);
    assert_eq!(made.refused, [0]);
    let made = made.made.unwrap().0;
    assert_eq!((made.face_count(), made.points().len()), (mesh.face_count() + 1, mesh.points().len() + 1));
    for face in 0..9 {
        assert_eq!(made.face(face).outer(), mesh.face(face).outer());
    }
}

#[test]
fn diagonals_divide_what_cuts_do_not() {
    let square = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)];
    let comb = [
        (0.0, 0.0),
        (9.0, 0.0),
        (9.0, 5.0),
        (5.0, 5.0),
        (5.0, 2.0),
        (2.0, 2.0),
        (2.0, 5.0),
        (1.0, 5.0),
        (1.0, 2.0),
        (0.0, 2.0),
    ];
    for face in
        [polygon(&L, &[]), polygon(&comb, &[]), polygon(&square(0.0, 9.0), &[&square(1.0, 3.0), &square(5.0, 8.0)])]
    {
        let mut net = Net::of(&face);
        let heads: Vec<u32> = face.face(0).loop_ranges().map(|ring| ring.start as u32).collect();
        let plane = Plane::of(DVec3::Z, face.points().iter().copied());
        let parts = triangles::divide(&mut net, &heads, &plane).unwrap();
        let (made, _) = assembled(&net, &[0], &[parts]);
        assert_eq!((made.check(), made.points()), (Vec::new(), face.points()));
        assert!((made.area() - face.area()).abs() < 1e-12 && made.faces().all(|face| !is_concave(&face)));
        // Every diagonal is needed: an end of it would be concave.
        assert!(made.face_count() <= 1 + face.face(0).corner_count());
        assert!(has_border_of(&made, &face));
    }
}

/// Returns true if a mesh has the same border as another one: both together, one of them reversed, are closed.
fn has_border_of(mesh: &Mesh, other: &Mesh) -> bool {
    let reversed = other.reversed();
    let mut builder = MeshBuilder::new();
    for part in [mesh, &reversed] {
        let points: Vec<u32> = part.points().iter().map(|&point| builder.point(point)).collect();
        for face in part.faces() {
            let rings: Vec<Vec<u32>> =
                face.loops().map(|ring| ring.iter().map(|&point| points[point as usize]).collect()).collect();
            let holes: Vec<&[u32]> = rings[1..].iter().map(Vec::as_slice).collect();
            builder.face(&rings[0], &holes, FaceTag::PLAIN);
        }
    }
    builder.build().unwrap().is_closed()
}

/// "Tags stay", "not flattened", groups and materials of faces.
#[test]
fn parts_keep_tags_groups_materials_and_values() {
    // A bent L with a square beside it, whose common edge is divided.
    let height = |x: f64, y: f64| if x == 10.0 && y == 0.0 { 1.0 } else { 0.0 };
    let mut builder = MeshBuilder::new();
    let points: Vec<u32> = L.iter().map(|&(x, y)| builder.point([x, y, height(x, y)])).collect();
    let beside = [(-5.0, 10.0), (-5.0, 0.0)].map(|(x, y)| builder.point([x, y, 0.0]));
    builder.groups(["g".to_owned(), "h".to_owned()]).materials(["m", "n"]);
    let set = |name: &str| crate::mesh::TagSet::new([name]);
    builder.tag_sets([set("l"), set("square")]);
    let value = |x: f64, y: f64| DVec2::new(x / 10.0, y / 10.0);
    let tilt = |x: f64| DVec3::new(x / 40.0, 0.0, 1.0).normalize();
    builder.face(&points, &[], FaceTag { group: 0, material: 0, tags: 0, ..FaceTag::PLAIN });
    builder.uvs(&L.map(|(x, y)| value(x, y))).normals(&L.map(|(x, _)| tilt(x)));
    let square = [points[0], points[5], beside[0], beside[1]];
    builder.face(&square, &[], FaceTag { group: 1, material: 1, tags: 1, ..FaceTag::PLAIN });
    builder.uvs(&[DVec2::ZERO; 4]).normals(&[DVec3::Z; 4]);
    builder.edge_tags([points[0], points[5]], &set("e"));
    builder.vertex_tags(points[3], &set("v"));
    let mesh = builder.build().expect("a mesh");
    let made = convexify(&mesh, ALL).made.expect("the L is cut").0;
    assert_eq!(made.face_count(), 3);
    // The parts of a bent face have other areas.
    assert!((made.area() - mesh.area()).abs() < 1.0 && made.points()[..8] == *mesh.points());
    assert_eq!(made.bounds(), mesh.bounds());
    for face in made.faces() {
        let is_square = face.index() == 2;
        let tag = face.tag();
        assert_eq!([tag.group, tag.material, tag.tags], [u32::from(is_square); 3], "{}", face.index());
        for corner in face.corner_range().filter(|_| !is_square) {
            let place = made.points()[made.corners()[corner] as usize];
            assert!(made.uvs()[corner].distance(value(place.x, place.y)) < 1e-12);
            // Between normals of length 1, the tilt does not grow evenly.
            assert!(made.normals()[corner].distance(tilt(place.x)) < 1e-3);
        }
    }
    assert_eq!(made.groups(), mesh.groups());
    // The cut divides the tagged edge: both halves keep its tag, and the cut has none.
    let edges: Vec<_> = made.subcomponent_tags.edges().collect();
    assert!(edges.len() == 2 && edges.iter().all(|(_, tags)| **tags == set("e")), "{edges:?}");
    assert_eq!(made.subcomponent_tags.vertices().collect::<Vec<_>>(), [(3, &set("v"))]);
}
