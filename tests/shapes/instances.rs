//! Repeated parts as instances: other bytes, the same triangles.

use std::collections::HashMap;
use std::sync::Arc;

use cga::glam::{DAffine3, DMat3, DMat4, DQuat, DVec3};
use cga::sink::buffers::Buffers;
use cga::sink::gltf::Glb;
use cga::sink::{Filled, PartId, Replay};
use cga::{Color, Flow, Leaf, Mesh, Scope, Settings, Shape, Sink, cga};
use cga_gates::{GlbFile, number};
use serde_json::Value;

cga! {
    /// Façades in colours by chance, with frames that grow, and panes that are lit by chance between them.
    grammar Street;
    Lot    --> extrude(22) comp(f) { side : Facade | top : Roof. }
    Facade --> 50% : color("#d8c8a8") Front else : color(rand, 0.5, 0.5) Front
    Front  --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 0.1 : Frame | 1.2 : Pane | 0.1 : Frame | ~1 : color("#806040") Wall. }
    Pane   --> 30% : color("#ffe0a0") Lit. else : Dark.
    Frame  --> extrude(0.08) Frame.
}

cga! {
    /// One bay, or many.
    grammar Bays;
    Lot --> comp(f) { front : split(x) { { ~2 : split(y) { 1 : Wall. | ~1 : Glass. } }* } | all : NIL }
}

cga! {
    /// Blocks along the axes of the shape itself.
    grammar Rows;
    Lot --> split(x) { { ~2 : split(y) { 1 : Wall. | ~1 : Glass. } }* }
}

/// A triangle in the world, with its rule, its colour and its normal.
#[derive(Clone, Debug)]
struct Triangle {
    look: String,
    corners: [DVec3; 3],
    normals: [DVec3; 3],
}

fn points(file: &GlbFile, accessor: &Value) -> Vec<DVec3> {
    file.rows(accessor).into_iter().map(DVec3::from_array).collect()
}

/// All triangles; instances are shown at all of their places.
fn triangles_of_file(file: &GlbFile) -> Vec<Triangle> {
    let nodes = file.json["nodes"].as_array().expect("nodes");
    let root = places(file, &nodes[0])[0];
    let mut triangles = Vec::new();
    for (at, node) in nodes.iter().enumerate().filter(|(_, node)| !node["mesh"].is_null()) {
        for place in places(file, node) {
            let placement = if at == 0 { root } else { root * place };
            let mesh = &file.json["meshes"][number(&node["mesh"])];
            for primitive in mesh["primitives"].as_array().expect("primitives") {
                add(file, primitive, placement, &mut triangles);
            }
        }
    }
    triangles
}

fn add(file: &GlbFile, primitive: &Value, placement: DMat4, to: &mut Vec<Triangle>) {
    let attributes = &primitive["attributes"];
    let (positions, normals) = (points(file, &attributes["POSITION"]), points(file, &attributes["NORMAL"]));
    let rules = file.rows::<1>(&attributes["_FEATURE_ID_0"]);
    let color = &file.json["materials"][number(&primitive["material"])]["name"];
    for triangle in file.rows::<1>(&primitive["indices"]).chunks_exact(3) {
        let corners = [0, 1, 2].map(|i| triangle[i][0] as usize);
        to.push(Triangle {
            look: format!("{color} {}", rules[corners[0]][0]),
            corners: corners.map(|corner| placement.transform_point3(positions[corner])),
            normals: corners.map(|corner| placement.transform_vector3(normals[corner])),
        });
    }
}

fn places(file: &GlbFile, node: &Value) -> Vec<DMat4> {
    let list = |value: &Value| value.as_array().map(|list| list.iter().filter_map(Value::as_f64).collect::<Vec<_>>());
    let instances = &node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    if instances.is_null() {
        let moved = list(&node["translation"]).map(|list| DMat4::from_translation(DVec3::from_slice(&list)));
        let matrix = list(&node["matrix"]).map(|list| DMat4::from_cols_slice(&list));
        return vec![moved.or(matrix).unwrap_or(DMat4::IDENTITY)];
    }
    let (at, turned) = (points(file, &instances["TRANSLATION"]), file.rows::<4>(&instances["ROTATION"]));
    let each = at.iter().zip(&turned);
    each.map(|(&at, turned)| DMat4::from_rotation_translation(DQuat::from_array(*turned), at)).collect()
}

/// Each triangle has an equal one among the others, except for rounding.
fn assert_same(mut some: Vec<Triangle>, others: Vec<Triangle>) {
    assert_eq!(some.len(), others.len());
    let near = |a: [DVec3; 3], b: [DVec3; 3]| (0..3).all(|i| (a[i] - b[i]).length() < 2e-5);
    for other in others {
        let found = some.iter().position(|triangle| {
            near(triangle.corners, other.corners)
                && near(triangle.normals, other.normals)
                && triangle.look == other.look
        });
        some.swap_remove(found.unwrap_or_else(|| panic!("nothing like {other:?}")));
    }
}

/// Lots with sides in many directions.
fn lots(count: usize) -> Vec<Shape> {
    let lot = |at: usize| {
        let (x, y) = (20.0 * at as f64, 0.3 * (at % 3) as f64);
        let corners = [[x, y], [x + 13.5, 1.0], [x + 12.0, -9.0], [x - 1.0, -11.0]];
        Shape::footprint(&corners, &[]).expect("a polygon").seed(at as u64)
    };
    (0..count).map(lot).collect()
}

fn settings() -> Settings {
    Settings::default()
}

/// One file, by a run of its own for each shape.
fn fresh(shapes: &[Shape], mut glb: Glb) -> Vec<u8> {
    for shape in shapes {
        Street::default().run(shape, &settings(), &mut glb).expect("no limit");
    }
    glb.into_bytes().expect("a file")
}

#[test]
fn instances_show_the_same_triangles() {
    let shapes = lots(2);
    for glb in [Glb::new, || Glb::new().with_origin(DVec3::new(100.0, 0.0, -5.0))] {
        let (merged, instanced) = (fresh(&shapes, glb()), fresh(&shapes, glb().with_instances()));
        let (merged, instanced) = (GlbFile::new(&merged), GlbFile::new(&instanced));
        let extension = Value::from("EXT_mesh_gpu_instancing");
        assert!(instanced.json["extensionsRequired"].as_array().is_some_and(|list| list.contains(&extension)));
        assert!(merged.json["extensionsRequired"].is_null());
        assert_same(triangles_of_file(&merged), triangles_of_file(&instanced));
        let sizes = [&merged, &instanced].map(|file| file.bytes.len());
        assert!(2 * sizes[1] < sizes[0], "{sizes:?}");
    }
}

#[test]
fn kept_and_fresh_templates_give_the_same_bytes() {
    let shapes = lots(12);
    let expected = fresh(&shapes, Glb::new().with_instances());
    let settings = settings();
    let grammar = Street::default();
    let mut session = grammar.session(&settings).expect("a session");
    for _ in 0..2 {
        let mut glb = Glb::new().with_instances();
        for shape in &shapes {
            session.run(shape, &mut glb).expect("no limit");
        }
        assert!(glb.into_bytes().expect("a file") == expected);
    }
}

#[test]
fn a_part_whose_template_was_forgotten_is_the_same_part() {
    let meshes = |rounds: usize| {
        let (settings, grammar) = (settings(), Bays::default());
        let mut session = grammar.session(&settings).expect("a session");
        let mut glb = Glb::new().with_instances();
        for round in 0..rounds {
            for at in 0..40 {
                let shape = Shape::cuboid(4.0 + 0.01 * f64::from(at), 3.0, 1.0).at([0.0, 0.0, 5.0 * round as f64]);
                session.run(&shape, &mut glb).expect("no limit");
            }
        }
        GlbFile::new(&glb.into_bytes().expect("a file")).json["meshes"].as_array().map_or(0, Vec::len)
    };
    assert_eq!((meshes(1), meshes(3)), (40, 40));
}

#[test]
fn parts_in_the_material_of_their_shape_are_told_apart() {
    let mut glb = Glb::new().with_instances();
    let mut merged = Glb::new();
    for at in 0..6 {
        let mut lot = Shape::cuboid(8.0, 3.0, 1.0).at([0.0, 0.0, 5.0 * f64::from(at)]);
        lot.set_color(Color::new(f64::from(at % 3) / 2.0, 0.5, 0.5));
        Bays::default().run(&lot, &settings(), &mut glb).expect("no limit");
        Bays::default().run(&lot, &settings(), &mut merged).expect("no limit");
    }
    let [merged, instanced] = [merged, glb].map(|glb| GlbFile::new(&glb.into_bytes().expect("a file")));
    assert_same(triangles_of_file(&merged), triangles_of_file(&instanced));
    assert_eq!(instanced.json["meshes"].as_array().map_or(0, Vec::len), 3);
}

#[test]
fn a_part_at_one_place_is_no_instance() {
    for (width, has_instances) in [(2.0, false), (12.0, true)] {
        let mut glb = Glb::new().with_instances();
        Bays::default().run(&Shape::cuboid(width, 3.0, 1.0), &settings(), &mut glb).expect("no limit");
        let file = GlbFile::new(&glb.into_bytes().expect("a file"));
        assert_eq!(!file.json["extensionsRequired"].is_null(), has_instances);
        assert_eq!(triangles_of_file(&file).len(), 4 * (width / 2.0) as usize);
    }
}

#[test]
fn a_run_into_the_sink_and_a_model_give_the_same_bytes() {
    let shapes = lots(4);
    let mut model = cga::Model::new();
    for shape in &shapes {
        Street::default().run(shape, &settings(), &mut model).expect("no limit");
    }
    assert!(model.to_glb().expect("a file") == fresh(&shapes, Glb::new()));
}

#[test]
fn axes_that_are_no_rotation_make_no_instances() {
    for (depth, has_instances) in [(1.0, true), (-1.0, false)] {
        let mut lot = Shape::cuboid(8.0, 3.0, 1.0);
        lot.set_scope(Scope { axes: DMat3::from_diagonal(DVec3::new(1.0, 1.0, depth)), ..*lot.scope() });
        let [merged, instanced] = [Glb::new(), Glb::new().with_instances()].map(|mut glb| {
            Rows::default().run(&lot, &settings(), &mut glb).expect("no limit");
            GlbFile::new(&glb.into_bytes().expect("a file"))
        });
        assert_same(triangles_of_file(&merged), triangles_of_file(&instanced));
        assert_eq!(!instanced.json["extensionsRequired"].is_null(), has_instances);
    }
}

/// Meshes with their places, and everything that does not repeat: what a program that draws instances keeps.
#[derive(Default)]
struct Scene {
    parts: Vec<(Buffers, Vec<DAffine3>)>,
    by_id: HashMap<PartId, usize>,
    rest: Buffers,
}

impl Sink for Scene {
    fn begin(&mut self) {
        self.by_id.clear();
        self.rest.begin();
    }

    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        let parts = &mut self.parts;
        let index = *self.by_id.entry(replay.part()).or_insert_with(|| {
            let mut mesh = Buffers::new();
            let _ = replay.each_local(&mut mesh);
            parts.push((mesh, Vec::new()));
            parts.len() - 1
        });
        self.parts[index].1.push(replay.placement());
        Flow::Continue(())
    }

    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        self.rest.filled(leaf)
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.rest.mesh(leaf, mesh, placement)
    }
}

fn triangles(buffers: &Buffers, placement: &DAffine3) -> Vec<Triangle> {
    let mut triangles = Vec::new();
    for submesh in buffers.submeshes() {
        let color = buffers.materials()[submesh.material as usize].color();
        let look = format!("{} {color:?}", buffers.rules()[submesh.rule as usize]);
        for triangle in buffers.indices()[submesh.indices].chunks_exact(3) {
            let vertices = [0, 1, 2].map(|i| buffers.vertices()[triangle[i] as usize].map(f64::from));
            let look = look.clone();
            let corners = vertices.map(|[x, y, z, ..]| placement.transform_point3(DVec3::new(x, y, z)));
            let normals = vertices.map(|[.., x, y, z]| placement.transform_vector3(DVec3::new(x, y, z)));
            triangles.push(Triangle { look, corners, normals });
        }
    }
    triangles
}

#[test]
fn a_sink_of_ones_own_can_take_instances() {
    let (mut scene, mut buffers) = (Scene::default(), Buffers::new());
    for shape in lots(2) {
        Street::default().run(&shape, &settings(), &mut scene).expect("no limit");
        Street::default().run(&shape, &settings(), &mut buffers).expect("no limit");
    }
    let mut all = triangles(&scene.rest, &DAffine3::IDENTITY);
    for (mesh, places) in &scene.parts {
        places.iter().for_each(|place| all.extend(triangles(mesh, place)));
    }
    assert_same(all, triangles(&buffers, &DAffine3::IDENTITY));
    let places = scene.parts.iter().map(|(_, places)| places.len()).sum::<usize>();
    assert!(2 * scene.parts.len() < places, "{} parts at {places} places", scene.parts.len());
}
