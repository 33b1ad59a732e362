//! Assets on flat, bent and mirrored carriers.

use glam::{DAffine3, DVec2};

use super::*;
use crate::primitive;

const UP: AlongUv = AlongUv {
    set: 0,
    height: 3.0,
    direction: HeightDirection::ScopeY,
    alignment: HeightAlignment::AlignPosition,
    rounding: 0.0,
};

const MOST: usize = 1 << 20;

/// Faces on the ground by their corners, each with a position and its coordinates.
fn carrier(faces: &[Vec<([f64; 2], [f64; 2])>]) -> Mesh {
    let mut builder = MeshBuilder::new();
    for face in faces {
        let corners: Vec<u32> = face.iter().map(|(p, _)| builder.point([p[0], 0.0, -p[1]])).collect();
        let uvs: Vec<DVec2> = face.iter().map(|&(_, uv)| uv.into()).collect();
        builder.face(&corners, &[], FaceTag::PLAIN).uvs(&uvs);
    }
    builder.build().unwrap()
}

fn rectangle(width: f64, depth: f64, tiles: [f64; 2]) -> Mesh {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let corner = |[x, y]: [f64; 2]| ([x * width, y * depth], [x * tiles[0], y * tiles[1]]);
    carrier(&[corners.map(corner).to_vec()])
}

/// A grid of `count` quads, or twice as many triangles, on [0,10] x [0,10], with interior nodes moved at random.
/// Coordinates cover `tiles` tiles.
fn grid(count: usize, tiles: f64, triangles: bool, seed: u64) -> Mesh {
    let mut state = seed;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let step = 10.0 / count as f64;
    let nodes: Vec<([f64; 2], [f64; 2])> = (0..=count)
        .flat_map(|j| (0..=count).map(move |i| (i, j)))
        .map(|(i, j)| {
            let inner = |k: usize| !k.is_multiple_of(count);
            let mut moved = |k: usize| (k as f64 + if inner(i) && inner(j) { 0.5 * random() } else { 0.0 }) * step;
            let place = [moved(i), moved(j)];
            let uv = if triangles { [moved(i), moved(j)] } else { [i as f64 * step, j as f64 * step] };
            (place, uv.map(|x| x / 10.0 * tiles))
        })
        .collect();
    let at = |i: usize, j: usize| nodes[j * (count + 1) + i];
    let cells = (0..count).flat_map(|j| (0..count).map(move |i| (i, j)));
    let faces: Vec<Vec<_>> = cells
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if triangles { vec![vec![a, b, c], vec![a, c, d]] } else { vec![vec![a, b, c, d]] }
        })
        .collect();
    carrier(&faces)
}

fn insert(carrier: &Mesh, asset: &Mesh, options: &AlongUv) -> Mesh {
    let mesh = insert_along_uv(carrier, asset, options, MOST).unwrap();
    assert!(mesh.check().is_empty(), "{:?}", mesh.check());
    mesh
}

/// An asset of 1 by 1 by 1 around the origin that is not a box.
fn ball() -> Mesh {
    primitive::sphere(12, 8)
}

#[test]
fn a_box_fills_its_cell() {
    let scale = DAffine3::from_scale(DVec3::new(2.0, 2.0, 4.0));
    let asset = primitive::cube().map(&(DAffine3::from_translation(DVec3::new(5.0, -1.0, -7.0)) * scale));
    let made = insert(&rectangle(10.0, 6.0, [1.0, 1.0]), &asset, &UP);
    assert!(made.is_closed() && made.face_count() == 6);
    assert!((made.volume() - 180.0).abs() < 1e-9);
    assert_eq!((made.bounds().low, made.bounds().high), (DVec3::new(0.0, 0.0, -6.0), DVec3::new(10.0, 3.0, 0.0)));
    let kept = AlongUv { alignment: HeightAlignment::KeepPosition, ..UP };
    let made = insert(&rectangle(10.0, 6.0, [1.0, 1.0]), &asset, &kept);
    assert_eq!((made.bounds().low.y, made.bounds().high.y), (-1.5, 1.5));
}

#[test]
fn x_goes_along_u_and_z_against_v() {
    // A triangle at x = 0, z = 0, which is u = 0, v = 1. A distant point makes the box 1 by 1.
    let mut builder = MeshBuilder::new();
    for corners in [[[0.0, 0.0], [0.0, 0.1], [0.1, 0.0]], [[1.0, 1.0], [1.0, 0.9], [0.9, 1.0]]] {
        let corners = corners.map(|[x, z]| builder.point([x, 0.0, z]));
        builder.face(&corners, &[], FaceTag::PLAIN).uvs(&[DVec2::ZERO, DVec2::X, DVec2::Y]);
    }
    let asset = builder.build().unwrap();
    let made = insert(&rectangle(10.0, 10.0, [1.0, 1.0]), &asset, &UP);
    assert_eq!(made.points()[..3], [[0.0, 0.0, -10.0], [0.0, 0.0, -9.0], [1.0, 0.0, -10.0]].map(DVec3::from));
    assert_eq!(made.face(0).normal(), asset.face(0).normal());
    assert_eq!(made.uvs()[..3], [DVec2::ZERO, DVec2::X, DVec2::Y]);
}

#[test]
fn sixteen_copies_on_a_quad() {
    let made = insert(&rectangle(8.0, 8.0, [4.0, 4.0]), &ball(), &AlongUv { height: 2.0, ..UP });
    assert!(made.is_closed());
    assert_eq!(made.face_count(), 16 * ball().face_count());
    assert!((made.volume() - 16.0 * 8.0 * ball().volume() / bulk(&ball())).abs() < 1e-9);
    assert!(made.normals().is_empty());
}

fn bulk(mesh: &Mesh) -> f64 {
    mesh.bounds().size().element_product()
}

#[test]
fn what_is_cut_at_inner_edges_stays_closed() {
    for seed in 0..12 {
        for (count, tiles, triangles) in
            [(2, 1.0, true), (3, 1.0, true), (5, 2.0, true), (3, 2.0, false), (4, 3.0, false)]
        {
            let carrier = grid(count, tiles, triangles, seed);
            for (name, asset) in [("ball", ball()), ("cube", primitive::cube()), ("cylinder", primitive::cylinder(9))] {
                let made = insert(&carrier, &asset, &UP);
                assert!(made.is_closed(), "{name} on {count}, {tiles}, {triangles}, {seed}");
                // Vertically from a plane, areas of chart and surface differ, but a cube covers all of it.
                if name == "cube" {
                    assert!((made.volume() - 300.0).abs() < 1e-9, "{}", made.volume());
                }
            }
        }
    }
}

#[test]
fn mirrored_charts_and_negative_heights_turn_faces_over() {
    let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let mirrored = carrier(&[corners.map(|p: [f64; 2]| (p, [2.0 - p[0] / 2.0, p[1] / 4.0])).to_vec()]);
    for carrier in [rectangle(4.0, 4.0, [2.0, 1.0]), mirrored] {
        for carrier in [carrier.clone(), carrier.reversed()] {
            for height in [2.0, -2.0] {
                for direction in [HeightDirection::ScopeY, HeightDirection::VertexNormal] {
                    let made = insert(&carrier, &ball(), &AlongUv { height, direction, ..UP });
                    let expected = 32.0 * ball().volume() / bulk(&ball());
                    assert!(made.is_closed() && (made.volume() - expected).abs() < 1e-9, "{}", made.volume());
                }
            }
        }
    }
    let flat = insert(&rectangle(4.0, 4.0, [1.0, 1.0]), &ball(), &AlongUv { height: 0.0, ..UP });
    assert_eq!(flat.bounds().size().y, 0.0);
}

#[test]
fn the_border_of_the_carrier_cuts_off() {
    // One and a half cells: two cubes, one of them open at the cut.
    let made = insert(&rectangle(6.0, 4.0, [1.5, 1.0]), &primitive::cube(), &UP);
    assert!(!made.is_closed());
    assert_eq!(made.face_count(), 6 + 5);
    assert_eq!(made.bounds().high.x, 6.0);
}

#[test]
fn along_vertex_normals_a_roof_stays_together() {
    let mut builder = MeshBuilder::new();
    let points =
        [[0.0, 0.0, 0.0], [0.0, 0.0, -5.0], [4.0, 3.0, -5.0], [4.0, 3.0, 0.0], [8.0, 0.0, 0.0], [8.0, 0.0, -5.0]];
    let p = points.map(|point| builder.point(point));
    let uvs = |u: f64| [[u, 0.0], [u + 0.5, 0.0], [u + 0.5, 1.0], [u, 1.0]].map(DVec2::from);
    builder.face(&[p[0], p[3], p[2], p[1]], &[], FaceTag::PLAIN).uvs(&uvs(0.0));
    builder.face(&[p[3], p[4], p[5], p[2]], &[], FaceTag::PLAIN).uvs(&uvs(0.5));
    let roof = builder.build().unwrap();
    for asset in [ball(), primitive::cube()] {
        let options = AlongUv { direction: HeightDirection::VertexNormal, height: 0.5, ..UP };
        let made = insert(&roof, &asset, &options);
        assert!(made.is_closed() && 0.0 < made.volume());
    }
}

#[test]
fn faces_that_a_projection_sees_edge_on_get_nothing() {
    let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]];
    // The wall is along u, so v is constant except for its last bits. A strip as wide as a millionth of a tile gets the asset.
    for (width, is_seen) in [(0.0, false), (4e-15, false), (-1e-14, false), (1e-6, true), (-1e-6, true)] {
        let corner = |[x, y]: [f64; 2]| ([x, y], [x, 0.41834667 + 0.5 * y * width]);
        let made = insert(&carrier(&[corners.map(corner).to_vec()]), &primitive::cube(), &UP);
        assert_eq!(!made.is_empty(), is_seen, "{width}");
    }
}

#[test]
fn hostile_input_ends() {
    let cube = primitive::cube();
    let at_most = |carrier: &Mesh, most| insert_along_uv(carrier, &cube, &UP, most);
    let wide = rectangle(1.0, 1.0, [1e6, 1e6]);
    assert_eq!(at_most(&wide, 10_000).unwrap_err(), TooManyCorners { most: 10_000 });
    for size in [1e15, 1e17, 1e300] {
        let far = rectangle(1.0, 1.0, [size, size]);
        assert!(at_most(&far, 10_000).is_err());
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let far = carrier(&[corners.map(|p: [f64; 2]| (p, [size + p[0], size * (1.0 + p[1] * 1e-15)])).to_vec()]);
        let _ = at_most(&far, 10_000);
    }
    let flat = carrier(&[vec![([0.0, 0.0], [0.5, 0.5]), ([1.0, 0.0], [0.5, 0.5]), ([1.0, 1.0], [0.5, 0.5])]]);
    assert!(insert(&flat, &cube, &UP).is_empty());
    let pentagon: Vec<_> = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 3.0], [0.0, 2.0]].map(|p| (p, p)).to_vec();
    assert!(insert(&carrier(&[pentagon]), &cube, &UP).is_empty());
    assert!(insert(&rectangle(1.0, 1.0, [1.0, 1.0]), &Mesh::default(), &UP).is_empty());
    assert!(insert(&rectangle(1.0, 1.0, [1.0, 1.0]), &cube, &AlongUv { set: 3, ..UP }).is_empty());
    let line = cube.map(&DAffine3::from_scale(DVec3::new(0.0, 1.0, 0.0)));
    let made = insert_along_uv(&rectangle(1.0, 1.0, [1.0, 1.0]), &line, &UP, MOST).unwrap();
    assert!(made.points().iter().all(|point| point.is_finite()));
}

/// A range that ends at a whole number except for rounding has whole copies, whichever way it is off.
#[test]
fn copies_are_whole_where_coordinates_are_off_by_rounding() {
    for asset in [ball(), primitive::cube(), primitive::cylinder(9)] {
        for tiles in [1.0, 2.0, 3.0, 7.0, 25.0] {
            for off in [0.0, 1e-16, -1e-16, 4e-16, -4e-16, 3e-12, -3e-12] {
                for from in [0.0, off, -off, -3.0 + off] {
                    let carrier = rectangle(10.0, 6.0, [1.0, 1.0]);
                    let uvs: Vec<DVec2> =
                        carrier.uvs().iter().map(|uv| DVec2::new(from + uv.x * (tiles + off), uv.y + off)).collect();
                    let mut carrier = carrier;
                    carrier.put_uv_set(0, uvs);
                    let made = insert(&carrier, &asset, &UP);
                    let copies = tiles as usize;
                    assert!(made.is_closed(), "{tiles} {off} {from}");
                    assert_eq!(made.face_count(), copies * asset.face_count(), "{tiles} {off} {from}");
                    let whole = 180.0 * asset.volume() / bulk(&asset);
                    assert!((made.volume() - whole).abs() < 1e-6 * whole, "{tiles} {off} {from}");
                }
            }
        }
    }
}
