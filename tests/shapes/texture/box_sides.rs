//! Boxes whose sides have coordinates of their own: inserted cubes, their parts, and boxes with faces of cuts.

use cga::mesh::read_gltf;
use cga::sink::buffers::{Buffers, Chunks};
use cga::sink::meshes::Granularity;
use cga::texture::{FaceMaps, SetMap};
use cga::{Flow, Geometry, Model, Settings, Shape, cga};

cga! {
    /// Parts of a cube, or of a box with a projection.
    grammar Parts;
    attr cube = true

    Lot -->
        case cube : extrude(3) primitiveCube() Cut
        else : extrude(3) setupProjection(0, world.xy, 2, 3, 0.25, -1) projectUV(0) Cut

    Cut --> scaleUV(0, 2, -3) rotateUV(0, 30) copyUV(0, 2) translateUV(2, 0.5, 0)
        split(x) { 1 : Columns | ~1 : r(scopeCenter, 10, 30, 0) Columns | ~0.7 : scaleUV(0, 2, 2) Columns }

    Columns --> split(z) { { ~0.6 : case split.index == 1 : color("#ff0000") Column. else : [ Column. ] }* | ~1 : deleteUV(2) s(^0.5, ^1, ^1) Column. }
}

/// A vertex: its position, and its coordinates in the sets 0 and 2.
type Corner = ([f64; 3], [[f64; 2]; 2]);

fn lot() -> Shape {
    Shape::rectangle(5.0, 4.0).at([3.0, 0.0, -7.0])
}

/// The vertices of a model, as its leaves have them.
fn corners(model: &Model) -> Vec<Corner> {
    let of_leaf = |leaf: cga::LeafView<'_>| {
        let (mesh, place) = leaf.mesh();
        let corner = |at: usize| {
            let point = place.transform_point3(mesh.points()[mesh.corners()[at] as usize]);
            let uv = |set| mesh.uv_set(set).get(at).map_or([0.0; 2], |uv| uv.to_array());
            (point.to_array(), [uv(0), uv(2)])
        };
        (0..mesh.corners().len()).map(corner).collect::<Vec<_>>()
    };
    model.leaves().flat_map(of_leaf).collect()
}

fn compare(name: &str, found: &[Corner], expected: &[Corner], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{name}");
    let numbers = |(place, [a, b]): &Corner| place.iter().chain(a).chain(b).copied().collect::<Vec<f64>>();
    for (found, expected) in found.iter().map(numbers).zip(expected.iter().map(numbers)) {
        let near = found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= tolerance * (1.0 + b.abs()));
        assert!(near, "{name}: {found:?} and {expected:?}");
    }
}

fn wide<const N: usize>(numbers: [f32; N]) -> [f64; N] {
    numbers.map(f64::from)
}

/// The vertices of buffers; sets that they do not have are 0.
fn of_buffers(buffers: &Buffers) -> impl Iterator<Item = Corner> {
    let uv = |set, at: usize| wide(buffers.uv_set(set).get(at).copied().unwrap_or_default());
    buffers.vertices().iter().enumerate().map(move |(at, &[x, y, z, ..])| (wide([x, y, z]), [uv(0, at), uv(2, at)]))
}

#[test]
fn sides_of_boxes_have_the_coordinates_of_their_meshes_in_every_output() {
    for cube in [true, false] {
        let grammar = Parts { cube };
        let model = grammar.generate(&lot()).expect("no error");
        let expected = corners(&grammar.generate(&lot().held_as_meshes()).expect("no error"));
        let has_sides = |leaf: &cga::LeafView<'_>| {
            matches!(leaf.geometry(), Geometry::Cuboid(_))
                && matches!(leaf.uvs(), [SetMap { maps: FaceMaps::Each(_), .. }, ..])
        };
        assert!(10 < model.leaves().filter(has_sides).count());
        assert!(14 * 24 < expected.len());
        compare("model", &corners(&model), &expected, 1e-9);
        let mut buffers = Buffers::new();
        grammar.run(&lot(), &Settings::default(), &mut buffers).expect("no error");
        compare("buffers", &of_buffers(&buffers).collect::<Vec<_>>(), &expected, 1e-5);
        let mut list = Vec::new();
        let mut chunks = Chunks::new(48, |chunk: &Buffers| {
            list.extend(of_buffers(chunk));
            Flow::Continue(())
        });
        grammar.run(&lot(), &Settings::default(), &mut chunks).expect("no error");
        assert!(cga::Sink::finish(&mut chunks).is_continue());
        drop(chunks);
        compare("chunks", &list, &expected, 1e-5);
        // Other outputs have a list for each material and its sets.
        let sorted = |mut list: Vec<Corner>| {
            let key = |corner: &Corner| {
                let (place, [a, b]) = corner;
                place.iter().chain(a).chain(b).map(|number| (number * 1e4).round() as i64).collect::<Vec<_>>()
            };
            list.sort_by_cached_key(key);
            list
        };
        let expected = sorted(expected);
        let meshes = model.meshes(Granularity::Material);
        let of_mesh = |mesh: &cga::sink::meshes::TriangleMesh| {
            let uv = |set: usize, at: usize| wide(mesh.uvs[set].get(at).copied().unwrap_or_default());
            let corner = |(at, place): (usize, &[f32; 3])| (wide(*place), [uv(0, at), uv(2, at)]);
            mesh.positions.iter().enumerate().map(corner).collect::<Vec<_>>()
        };
        compare("meshes", &sorted(meshes.list.iter().flat_map(of_mesh).collect()), &expected, 1e-4);
        let file = read_gltf(&model.to_glb().expect("a file"), &mut |_| None).expect("a file that can be read").mesh;
        let triangles = |name: &str, found: usize| assert_eq!(found, expected.len() / 2, "triangles of {name}");
        triangles("GLB", file.face_count());
        let number = |numbers: [f64; 2]| numbers.map(|number| (number * 1e3).round() as i64);
        let pairs =
            |list: &mut dyn Iterator<Item = [f64; 2]>| list.map(number).collect::<std::collections::BTreeSet<_>>();
        let known = pairs(&mut expected.iter().map(|(_, [uv, _])| *uv));
        assert_eq!(pairs(&mut file.uv_set(0).iter().map(|uv| uv.to_array())), known, "GLB");
        let (obj, _) = model.to_obj("m");
        let pair = |line: &str| {
            let mut numbers = line.split(' ').map(|number| number.parse::<f64>().expect("a number"));
            [(); 2].map(|()| numbers.next().expect("two numbers"))
        };
        assert_eq!(pairs(&mut obj.lines().filter_map(|line| line.strip_prefix("vt ").map(pair))), known, "OBJ");
        assert_eq!(model.watertight().count("Column"), model.count("Column"));
    }
}

#[test]
fn parts_of_a_cube_show_parts_of_its_image_and_nothing_on_cuts() {
    cga! {
        grammar Halves;
        Lot --> extrude(2) primitiveCube() split(x) { ~1 : Half. | ~1 : NIL }
    }
    let model = Halves::default().generate(&Shape::rectangle(4.0, 2.0)).expect("no error");
    let leaf = model.leaves().next().expect("a leaf");
    let Geometry::Cuboid(cuboid) = leaf.geometry() else { panic!("a box") };
    let [own] = leaf.uvs() else { panic!("one set") };
    let mut cuts = 0;
    for (number, face) in cuboid.faces().iter().enumerate() {
        let uvs = face.corners().map(|corner| own.maps.of_face(number).at(corner));
        let normal = face.u.cross(face.v).normalize();
        // The left half of the front, and of the top; the whole left side.
        let most = match normal.round().to_array() {
            [1.0, ..] => [0.0, 0.0],
            [-1.0, ..] => [1.0, 1.0],
            [_, _, -1.0] => [1.0, 1.0],
            _ => [0.5, 1.0],
        };
        cuts += usize::from(most == [0.0; 2]);
        let high = uvs.iter().fold(cga::glam::DVec2::ZERO, |high, uv| high.max(*uv));
        assert!(high.abs_diff_eq(most.into(), 1e-12), "{normal}: {uvs:?}");
    }
    assert_eq!(cuts, 1);
}
