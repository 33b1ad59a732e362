use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};

use super::*;
use crate::extrude::{Extrude, extrude};
use crate::mesh::{FaceTag, MeshBuilder, SubcomponentTagsBuilder, TagSet};
use crate::primitive;
use crate::random::Rng;
use crate::triangulate::Triangulator;

const ALL: Parts = Parts { vertices: true, edges: true, faces: true };
const VERTICES: Parts = Parts { vertices: true, edges: false, faces: false };
const EDGES: Parts = Parts { vertices: false, edges: true, faces: false };
const FACES: Parts = Parts { vertices: false, edges: false, faces: true };

fn build(points: &[[f64; 3]], faces: &[&[u32]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    points.iter().for_each(|point| {
        builder.point(*point);
    });
    faces.iter().for_each(|face| {
        builder.face(face, &[], FaceTag::PLAIN);
    });
    builder.build().unwrap()
}

/// Each face in triangles, whose points are not shared with other faces on request.
fn triangles(mesh: &Mesh, is_soup: bool) -> Mesh {
    let mut made = without_faces(mesh);
    let (mut triangulator, mut found) = (Triangulator::new(), Vec::new());
    for face in mesh.faces() {
        found.clear();
        triangulator.face(mesh, face.index(), &mut found);
        // The one with the first edge comes first.
        let first = face.corner_range().start as u32;
        found.sort_by_key(|triangle| (!triangle.contains(&first) || !triangle.contains(&(first + 1)), *triangle));
        for triangle in &mut found {
            let least = triangle.iter().position(|corner| corner == triangle.iter().min().unwrap()).unwrap();
            triangle.rotate_left(least);
            let corners = triangle.map(|corner| {
                let point = mesh.corners[corner as usize];
                (if is_soup { made.old_point(point) } else { point }, corner as usize)
            });
            made.keep_at([corners], FaceOrigin::piece(&face));
        }
    }
    made.finish_used()
}

/// The mesh after a cleanup, which keeps the laws.
fn clean(mesh: &Mesh, parts: Parts, tolerance: f64) -> Mesh {
    let made = cleanup(mesh, parts, tolerance).unwrap_or_else(|| mesh.clone());
    let flaws: Vec<_> =
        made.check().into_iter().filter(|flaw| !matches!(flaw, crate::mesh::Flaw::NotPlanar { .. })).collect();
    assert_eq!(flaws, []);
    if mesh.is_closed() && !made.is_empty() {
        assert!(made.is_closed());
        let most = (tolerance + 1e-6 * mesh.bounds().size().max_element()) * mesh.area();
        assert!((made.volume() - mesh.volume()).abs() <= most, "{} {}", made.volume(), mesh.volume());
    }
    made
}

fn counts(mesh: &Mesh) -> [usize; 2] {
    [mesh.face_count(), mesh.points().len()]
}

fn turned() -> DAffine3 {
    let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 0.5).normalize(), 0.7));
    DAffine3 { matrix3: turn, translation: DVec3::new(100.0, 20.0, -300.0) }
}

#[test]
fn triangles_of_a_block_become_its_faces_again() {
    let outline =
        [[0.0, 0.0], [9.0, 0.0], [9.0, 4.0], [5.0, 4.0], [5.0, 7.0], [0.0, 7.0]].map(|[x, z]| DVec3::new(x, 0.0, -z));
    let l = extrude(&Mesh::from_polygon(&outline, &[]).unwrap(), Extrude::FaceNormal, 3.0);
    for block in [primitive::cube(), l.clone(), l.map(&turned())] {
        for is_soup in [false, true] {
            let divided = triangles(&block, is_soup);
            let made = clean(&divided, EDGES, 0.0);
            assert_eq!((counts(&made), made.is_closed()), (counts(&block), true));
            assert!((made.volume() - block.volume()).abs() < 1e-6 * block.volume());
            // First edges stay.
            for (one, other) in made.faces().zip(block.faces()) {
                let edge = |face: crate::mesh::FaceRef<'_>| face.outline().take(2).collect::<Vec<_>>();
                assert_eq!(edge(one), edge(other));
            }
            // Vertices alone are merged, and the triangles stay.
            assert_eq!(counts(&clean(&divided, VERTICES, 0.0)), [divided.face_count(), block.points().len()]);
        }
    }
    assert!(cleanup(&l, ALL, 0.0).is_none());
}

#[test]
fn limits_grow_with_the_tolerance() {
    // Two squares with a gap, a fold, and a bend in an edge.
    let gap = |width: f64| {
        let [a, b] = [5.0, 5.0 + width];
        build(
            &[
                [0., 0., 0.],
                [a, 0., 0.],
                [a, 0., -9.],
                [0., 0., -9.],
                [b, 0., 0.],
                [b + 5., 0., 0.],
                [b + 5., 0., -9.],
                [b, 0., -9.],
            ],
            &[&[0, 1, 2, 3], &[4, 5, 6, 7]],
        )
    };
    let fold = |degrees: f64| {
        let (rise, run) = libm::sincos(degrees.to_radians());
        build(
            &[
                [0., 0., 0.],
                [3., 0., 0.],
                [3., 0., -2.],
                [0., 0., -2.],
                [3. + 2.0 * run, 2.0 * rise, 0.],
                [3. + 2.0 * run, 2.0 * rise, -2.],
            ],
            &[&[0, 1, 2, 3], &[1, 4, 5, 2]],
        )
    };
    let bend = |degrees: f64| {
        let (rise, run) = libm::sincos(degrees.to_radians());
        build(
            &[[0., 0., 0.], [2., 0., 0.], [2. + 2.0 * run, 2.0 * rise, 0.], [2., 5., 0.], [0., 5., 0.]],
            &[&[0, 1, 2, 3, 4]],
        )
    };
    for tolerance in [0.1, 0.5, 1.0] {
        let at = |share: f64| tolerance * share;
        for (share, points) in [(0.99, 6), (1.01, 8)] {
            assert_eq!(clean(&gap(at(share)), VERTICES, tolerance).points().len(), points, "{tolerance}");
        }
        for (share, faces) in [(0.99, 1), (1.01, 2)] {
            assert_eq!(clean(&fold(10.0 * at(share)), EDGES, tolerance).face_count(), faces, "{tolerance}");
        }
        for (share, points) in [(0.99, 4), (1.01, 5)] {
            assert_eq!(clean(&bend(10.0 * at(share)), VERTICES, tolerance).points().len(), points, "{tolerance}");
        }
        for (share, faces) in [(0.99, 1), (1.01, 2)] {
            let side = at(share).sqrt() * 2.0;
            let far = 9.0;
            let flags = build(
                &[[0., 0., 0.], [5., 0., 0.], [0., 5., 0.], [far, 0., 0.], [far + side, 0., 0.], [far, 0.5 * side, 0.]],
                &[&[0, 1, 2], &[3, 4, 5]],
            );
            let made = cleanup(&flags, Parts::default(), 0.0);
            assert!(made.is_none());
            assert_eq!(small(&flags, tolerance).face_count(), faces, "{tolerance}");
        }
    }
    assert_eq!(counts(&clean(&gap(0.0), EDGES, 0.0)), [1, 6]);
    assert_eq!(clean(&fold(0.1), EDGES, 0.0).face_count(), 2);
    assert_eq!(clean(&bend(0.1), VERTICES, 0.0).points().len(), 5);
}

/// The mesh without small faces.
fn small(mesh: &Mesh, tolerance: f64) -> Mesh {
    small_faces::without_small_faces(mesh, &Limits::of(tolerance, 1.0)).unwrap_or_else(|| mesh.clone())
}

#[test]
fn round_bodies_keep_their_form() {
    for tolerance in [0.1, 0.5, 1.0] {
        for (sides, radius) in [(36, 5.0), (72, 20.0), (360, 50.0)] {
            let round =
                primitive::cylinder(sides).map(&DAffine3::from_scale(DVec3::new(2.0 * radius, 10.0, 2.0 * radius)));
            let made = clean(&round, ALL, tolerance);
            // Each side is within the angle of its place.
            let least = 180.0 / (10.0 * tolerance);
            assert!(least.min(sides as f64) < made.face_count() as f64, "{sides} {tolerance}: {}", made.face_count());
            assert!((made.volume() / round.volume() - 1.0).abs() < 0.05);
        }
        let ball = primitive::sphere(48, 24).map(&DAffine3::from_scale(DVec3::splat(20.0)));
        let made = clean(&ball, ALL, tolerance);
        assert!((made.volume() / ball.volume() - 1.0).abs() < 0.02 && 100 < made.face_count(), "{}", made.face_count());
    }
    // An outline whose corners all bend by 5 degrees.
    let circle: Vec<DVec3> = (0..72)
        .map(|k| libm::sincos(f64::from(k * 5).to_radians()))
        .map(|(z, x)| DVec3::new(x, 0.0, -z) * 9.0)
        .collect();
    let disk = Mesh::from_polygon(&circle, &[]).unwrap();
    let made = clean(&disk, VERTICES, 0.51);
    assert!((18..=40).contains(&made.points().len()), "{}", made.points().len());
    assert!((made.area() / disk.area() - 1.0).abs() < 0.02, "{} {}", made.area(), disk.area());
    assert_eq!(made.points()[0], disk.points()[0]);
}

#[test]
fn one_of_doubled_faces_stays() {
    let points = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [2., 0., 0.]];
    let quads: &[&[u32]] = &[&[0, 1, 2, 3], &[2, 3, 0, 1], &[3, 2, 1, 0], &[1, 4, 2]];
    let made = clean(&build(&points, quads), FACES, 0.0);
    assert_eq!((made.face_count(), made.face(0).outer()), (2, &[0, 1, 2, 3][..]));
    // Also of a sheet with two sides, which is closed but encloses nothing.
    let made = clean_open(&build(&points[..4], &[&[0, 1, 2, 3], &[3, 2, 1, 0]]));
    assert_eq!(made.face_count(), 1);
    // The other order of holes and of corners does not matter.
    let square = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(|(x, y)| [x, y, 0.0]);
    let mut builder = MeshBuilder::new();
    let [a, b, c] = [square(0.0, 9.0), square(1.0, 2.0), square(3.0, 4.0)].map(|ring| ring.map(|p| builder.point(p)));
    let back = |ring: [u32; 4]| [ring[2], ring[1], ring[0], ring[3]];
    builder.face(&a, &[&back(b), &back(c)], FaceTag::PLAIN);
    builder.face(&back(a), &[&c, &b], FaceTag::PLAIN);
    builder.face(&a, &[&back(b)], FaceTag::PLAIN);
    let made = clean(&builder.build().unwrap(), FACES, 0.0);
    assert_eq!(made.faces().map(|face| face.loops().len()).collect::<Vec<_>>(), [3, 2]);
}

fn clean_open(mesh: &Mesh) -> Mesh {
    assert!(mesh.is_closed());
    let made = cleanup(mesh, FACES, 0.0).unwrap();
    assert_eq!(made.check(), []);
    made
}

#[test]
fn walls_between_solids_vanish_and_solids_stay_closed() {
    let cube = primitive::cube();
    let joined = |places: &[DVec3], size: DVec3| {
        let meshes: Vec<Mesh> = places
            .iter()
            .map(|place| cube.map(&(DAffine3::from_translation(*place) * DAffine3::from_scale(size))))
            .collect();
        crate::mesh::join::join(meshes.iter())
    };
    let row = joined(&[DVec3::ZERO, DVec3::X, DVec3::X * 2.0], DVec3::ONE);
    assert_eq!(counts(&clean(&row, FACES, 0.0)), [14, 16]);
    assert_eq!(counts(&clean(&row, ALL, 0.0)), [6, 8]);
    // The same body twice is one.
    assert_eq!(counts(&clean_twice(&joined(&[DVec3::ZERO, DVec3::ZERO], DVec3::ONE))), [6, 8]);
    // A floor that two bodies share is doubled, and both are needed.
    let mut shared = joined(&[DVec3::ZERO], DVec3::new(1.0, 2.0, 1.0));
    shared = crate::mesh::join::join([&shared, &cube].into_iter());
    assert_eq!(clean(&shared, FACES, 0.0).face_count(), 12);
    // A small body vanishes as a whole, and one with small faces stays.
    let sizes = [DVec3::splat(0.1), DVec3::splat(5.0)];
    let both = crate::mesh::join::join(
        sizes.map(|size| cube.map(&DAffine3::from_scale(size)).map(&DAffine3::from_translation(size * 20.0))).iter(),
    );
    assert_eq!(clean(&both, FACES, 0.09).face_count(), 6);
    assert_eq!(
        small(&primitive::sphere(64, 32).map(&DAffine3::from_scale(DVec3::splat(9.0))), 1.0).face_count(),
        64 * 32
    );
}

fn clean_twice(mesh: &Mesh) -> Mesh {
    let made = cleanup(mesh, ALL, 0.0).unwrap();
    assert!(made.is_closed() && made.check().is_empty());
    made
}

#[test]
fn corners_on_an_edge_of_a_neighbour_are_joined_and_slivers_vanish() {
    // A box whose top has a sliver along an edge, so that it is closed.
    let points = [
        [0., 0., 0.],
        [4., 0., 0.],
        [4., 0., -4.],
        [0., 0., -4.],
        [0., 2., 0.],
        [4., 2., 0.],
        [4., 2., -4.],
        [0., 2., -4.],
        [1.5, 2., 0.],
    ];
    let faces: &[&[u32]] =
        &[&[3, 2, 1, 0], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7], &[4, 8, 5, 6, 7], &[4, 5, 8]];
    let mesh = build(&points, faces);
    assert!(mesh.is_closed());
    let made = clean(&mesh, FACES, 0.0);
    assert_eq!((counts(&made), made.is_closed()), ([6, 9], true));
    assert_eq!(counts(&clean(&mesh, VERTICES, 0.0)), [6, 8]);
    assert_eq!(counts(&clean(&mesh, ALL, 0.0)), [6, 8]);
    // In an open mesh too.
    let open = build(&points, &faces[1..]);
    assert_eq!(counts(&clean(&open, ALL, 0.0)), [5, 8]);
}

#[test]
fn holes_are_merged_and_bridges_to_them_removed() {
    let square = |x: f64, low: f64, high: f64| {
        [(x, low), (x, high), (x + high - low, high), (x + high - low, low)]
            .map(|(x, y)| DVec3::new(x, y, 0.0))
            .to_vec()
    };
    let outline: Vec<DVec3> = square(0.0, 0.0, 10.0).into_iter().rev().collect();
    // Neighbours at a distance of 0.05 become one hole, and a small one vanishes.
    let holes = [square(2.0, 2.0, 4.0), square(4.05, 2.0, 4.0), square(8.0, 8.0, 8.05)];
    let plate = Mesh::from_polygon(&outline, &holes).unwrap();
    let made = clean(&plate, VERTICES, 0.1);
    assert_eq!((made.face(0).loops().len(), made.face(0).corner_count()), (2, 8));
    assert!((made.area() - (100.0 - 8.0)).abs() < 0.2);
    // A hole with a bridge to the outline.
    let keyhole = build(
        &[
            [0., 0., 0.],
            [9., 0., 0.],
            [9., 9., 0.],
            [0., 9., 0.],
            [3., 3., 0.],
            [3., 6., 0.],
            [6., 6., 0.],
            [6., 3., 0.],
        ],
        &[&[0, 1, 2, 3, 0, 4, 5, 6, 7, 4]],
    );
    let made = clean(&keyhole, VERTICES, 0.0);
    assert_eq!(
        (made.face(0).outer(), made.face(0).holes().collect::<Vec<_>>()),
        (&[0, 1, 2, 3][..], vec![&[4, 5, 6, 7][..]])
    );
    // A plug in a hole.
    let mut builder = MeshBuilder::new();
    let ring = outline.iter().map(|p| builder.point(*p)).collect::<Vec<_>>();
    let hole = holes[0].iter().map(|p| builder.point(*p)).collect::<Vec<_>>();
    builder.face(&ring, &[&hole], FaceTag::PLAIN);
    builder.face(&hole.iter().rev().copied().collect::<Vec<_>>(), &[], FaceTag::PLAIN);
    assert_eq!(counts(&clean(&builder.build().unwrap(), EDGES, 0.0)), [1, 4]);
}

#[test]
fn edges_with_another_texture_material_or_tag_stay() {
    // Four squares in a row: the texture jumps after the first, its size changes after the second, the third has a material.
    let build = |tag: [u32; 4], texture: [fn(f64) -> f64; 4]| {
        let mut builder = MeshBuilder::new();
        let points: Vec<[u32; 2]> =
            (0..5).map(|k| [0.0, -1.0].map(|z| builder.point([f64::from(k), 0.0, z]))).collect();
        builder.materials(["m"]);
        builder.groups(["a", "b"].map(String::from).to_vec());
        for k in 0..4 {
            let (x, map) = (k as f64, texture[k]);
            builder.face(
                &[points[k][0], points[k + 1][0], points[k + 1][1], points[k][1]],
                &[],
                FaceTag { group: tag[k], ..FaceTag::PLAIN },
            );
            let uv = |x: f64, v: f64| DVec2::new(map(x), v);
            builder.uvs(&[uv(x, 0.0), uv(x + 1.0, 0.0), uv(x + 1.0, 1.0), uv(x, 1.0)]);
        }
        builder.build().unwrap()
    };
    let same: fn(f64) -> f64 = |x| x * 0.5;
    let jump: fn(f64) -> f64 = |x| x * 0.5 + 0.25;
    let wide: fn(f64) -> f64 = |x| x * 2.0 - 3.0;
    for (groups, maps, faces) in [
        ([FaceTag::NONE; 4], [same; 4], 1),
        ([FaceTag::NONE; 4], [same, jump, jump, jump], 2),
        // At x = 2 the coordinates are equal, but the texture is denser after it.
        ([FaceTag::NONE; 4], [same, same, wide, wide], 2),
        ([0, 0, 1, 1], [same; 4], 2),
        ([0, 1, 0, 1], [same; 4], 4),
    ] {
        for part in [EDGES, ALL] {
            let made = clean(&build(groups, maps), part, 0.0);
            assert_eq!(made.face_count(), faces);
            assert_eq!(made.uvs().len(), made.corners().len());
        }
    }
    // Straight points stay where the texture bends.
    let bent = build([0, 1, 0, 1], [same, same, wide, wide]);
    assert!(cleanup(&bent, VERTICES, 0.0).is_none());
}

/// "Tagged edges and edges between coplanar faces with different tags are kept." "Tagged vertices and collinear vertices between
/// edges with different tags are kept."
#[test]
fn tags_stay() {
    let tag = |name: &str| TagSet::new([name]);
    // Three squares in a row, with a point in the middle of each outer edge.
    let mut builder = MeshBuilder::new();
    let low: Vec<u32> = (0..7).map(|k| builder.point([f64::from(k) * 0.5, 0.0, 0.0])).collect();
    let high: Vec<u32> = (0..4).map(|k| builder.point([f64::from(k), 0.0, -1.0])).collect();
    for k in 0..3 {
        builder.face(&[low[2 * k], low[2 * k + 1], low[2 * k + 2], high[k + 1], high[k]], &[], FaceTag::PLAIN);
    }
    let plain = builder.clone().build().unwrap();
    assert_eq!(counts(&clean(&plain, ALL, 0.0)), [1, 4]);
    builder.edge_tags([low[2], high[1]], &tag("edge")).vertex_tags(low[1], &tag("vertex"));
    builder.edge_tags([low[2], low[3]], &tag("half"));
    builder.edge_tags([low[4], low[5]], &tag("whole")).edge_tags([low[5], low[6]], &tag("whole"));
    let tagged = builder.build().unwrap();
    let made = clean(&tagged, ALL, 0.0);
    // The second and the third square are one. Its lower edge keeps its points where tags differ.
    assert_eq!(counts(&made), [2, 9]);
    let names = |set: Option<&TagSet>| set.map(|set| set.names()[0].to_string());
    let edges: Vec<_> = made.face_edges().filter_map(|ends| names(made.edge_tags(ends))).collect();
    assert_eq!(edges, ["edge", "half", "whole", "edge"]);
    assert_eq!((0..9).filter(|&point| made.vertex_tags(point).is_some()).count(), 1);
    // Vertices that merge unite their tags.
    let mut near = build(
        &[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1.01, 0., 0.], [2., 0., 0.], [1.5, 1., 0.]],
        &[&[0, 1, 2], &[3, 4, 5]],
    );
    let mut tagger = SubcomponentTagsBuilder::default();
    [(1, "a"), (3, "b")].iter().for_each(|&(point, name)| tagger.vertex(point, &tag(name)));
    tagger.edge([3, 5], &tag("e"));
    near.subcomponent_tags = tagger.finish();
    let made = clean(&near, VERTICES, 0.1);
    assert_eq!(made.vertex_tags(1).unwrap().names().len(), 2);
    assert_eq!(made.subcomponent_tags.edges().map(|edge| edge.0).collect::<Vec<_>>(), [[1, 4]]);
}

#[test]
fn hostile_meshes_have_a_result() {
    let mut random = Rng(5);
    let coordinate = |random: &mut Rng| (random.unit() * 5.0).floor();
    for round in 0..400 {
        let mut builder = MeshBuilder::new();
        let points: Vec<u32> = (0..12)
            .map(|_| {
                let mut near =
                    [coordinate(&mut random), coordinate(&mut random), coordinate(&mut random) * f64::from(round % 2)];
                near[0] += random.unit() * 1e-3;
                builder.point(near)
            })
            .collect();
        for _ in 0..14 {
            let count = 3 + (random.unit() * 4.0) as usize;
            let ring: Vec<u32> = (0..count).map(|_| points[(random.unit() * 12.0) as usize]).collect();
            builder.face(&ring, &[], FaceTag::PLAIN);
        }
        let Ok(mesh) = builder.build() else { continue };
        for parts in [ALL, VERTICES, EDGES, FACES] {
            for tolerance in [0.0, 0.01, 1.0] {
                if let Some(made) = cleanup(&mesh, parts, tolerance) {
                    assert!(made.check().iter().all(|flaw| {
                        use crate::mesh::Flaw::*;
                        matches!(flaw, NotPlanar { .. } | Hole { .. })
                    }));
                }
            }
        }
    }
    // A Möbius strip, and faces that share one edge.
    let strip: Vec<[f64; 3]> = (0..20)
        .map(|k| {
            let (turn, side) = (f64::from(k / 2) * 0.2 * std::f64::consts::PI, if k % 2 == 0 { 0.3 } else { -0.3 });
            let ((s, c), (hs, hc)) = (libm::sincos(turn), libm::sincos(turn * 0.5));
            [c * (3.0 + side * hc), side * hs, s * (3.0 + side * hc)]
        })
        .collect();
    let faces: Vec<[u32; 4]> =
        (0..10).map(|k| if k < 9 { [2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2] } else { [18, 19, 0, 1] }).collect();
    let faces: Vec<&[u32]> = faces.iter().map(|face| &face[..]).collect();
    let moebius = build(&strip, &faces);
    for tolerance in [0.0, 0.1, 1.0] {
        clean(&moebius, ALL, tolerance);
    }
    let fan = build(
        &[[0., 0., 0.], [0., 1., 0.], [1., 0., 0.], [2., 1., 0.], [-1., 0., 0.], [0., 0., 1.]],
        &[&[0, 2, 1], &[0, 3, 1], &[0, 1, 4], &[0, 1, 5]],
    );
    assert_eq!(clean(&fan, EDGES, 0.0).face_count(), 4);
    // Sizes far from 1.
    for size in [1e-150, 1e-9, 1e9, 1e150] {
        let cube = triangles(&primitive::cube(), true).map(&DAffine3::from_scale(DVec3::splat(size)));
        assert_eq!(clean_twice(&cube).face_count(), 6, "{size}");
    }
    assert!(cleanup(&primitive::cube().map(&DAffine3::from_scale(DVec3::splat(0.1))), ALL, 1.0).unwrap().is_empty());
    assert!(cleanup(&Mesh::default(), ALL, 1.0).is_none());
}

#[test]
fn large_meshes_take_seconds() {
    // 40,000 triangles in one plane, and a long line of points.
    let count = 142;
    let mut builder = MeshBuilder::new();
    let at: Vec<u32> = (0..=count)
        .flat_map(|x| (0..=count).map(move |z| [f64::from(x), 0.0, -f64::from(z)]))
        .map(|p| builder.point(p))
        .collect();
    for x in 0..count as usize {
        for z in 0..count as usize {
            let corner = |dx: usize, dz: usize| at[(x + dx) * (count as usize + 1) + z + dz];
            builder.face(&[corner(0, 0), corner(1, 0), corner(1, 1)], &[], FaceTag::PLAIN);
            builder.face(&[corner(0, 0), corner(1, 1), corner(0, 1)], &[], FaceTag::PLAIN);
        }
    }
    let grid = builder.build().unwrap();
    assert_eq!(counts(&clean(&grid, ALL, 0.0)), [1, 4]);
    assert_eq!(counts(&clean(&grid, ALL, 0.3)), [1, 4]);
}
