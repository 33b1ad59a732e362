//! Tests of the reader: files made of JSON text, with data in base64.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::dvec3;
use serde_json::{Value, json};

use super::*;
use crate::material::{Channel, Color, LayerPart, MaterialNumber, MaterialText};

/// A file under construction: lists of accessors, views and data.
struct File {
    json: Value,
    data: Vec<u8>,
}

impl File {
    fn new() -> Self {
        let json = json!({"asset": {"version": "2.0"}, "accessors": [], "bufferViews": [], "meshes": [], "nodes": []});
        File { json, data: Vec::new() }
    }

    fn push(&mut self, list: &str, item: Value) -> usize {
        let list = self.json[list].as_array_mut().expect("a list");
        list.push(item);
        list.len() - 1
    }

    fn view(&mut self, bytes: &[u8]) -> usize {
        let start = self.data.len();
        self.data.extend_from_slice(bytes);
        self.push("bufferViews", json!({"buffer": 0, "byteOffset": start, "byteLength": bytes.len()}))
    }

    fn accessor(&mut self, kind: &str, component: u32, count: usize, bytes: &[u8]) -> usize {
        let view = self.view(bytes);
        self.push("accessors", json!({"bufferView": view, "componentType": component, "count": count, "type": kind}))
    }

    fn floats(&mut self, kind: &str, width: usize, values: &[f32]) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.accessor(kind, 5126, values.len() / width, &bytes)
    }

    fn indices(&mut self, values: &[u16]) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.accessor("SCALAR", 5123, values.len(), &bytes)
    }

    fn mesh(&mut self, primitive: Value) -> usize {
        self.push("meshes", json!({"primitives": [primitive]}))
    }

    /// A mesh with one triangle, (0, 0, 0), (1, 0, 0), (0, 1, 0).
    fn triangle(&mut self) -> usize {
        let positions = self.floats("VEC3", 3, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        self.mesh(json!({"attributes": {"POSITION": positions}}))
    }

    /// The file as JSON text.
    fn text(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        let uri = format!("data:application/octet-stream;base64,{}", STANDARD.encode(&self.data));
        json["buffers"] = json!([{"uri": uri, "byteLength": self.data.len()}]);
        json.to_string().into_bytes()
    }

    fn read(&self) -> Result<GltfFile, GltfError> {
        read_gltf(&self.text(), &mut |_| None)
    }

    fn mesh_of(&self) -> Mesh {
        self.read().expect("it is valid").mesh
    }

    /// The file as GLB.
    fn glb(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        json["buffers"] = json!([{"byteLength": self.data.len()}]);
        glb(json.to_string().as_bytes(), &self.data)
    }
}

fn glb(json: &[u8], data: &[u8]) -> Vec<u8> {
    let chunk = |kind: &[u8; 4], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes()[..], kind, bytes].concat();
    let chunks = [chunk(b"JSON", json), chunk(b"BIN\0", data)].concat();
    [&b"glTF"[..], &2u32.to_le_bytes(), &(12 + chunks.len() as u32).to_le_bytes(), &chunks].concat()
}

/// The smallest PNG header that counts as complete; `alpha` decides the colour type.
fn png(alpha: bool) -> Vec<u8> {
    let chunk = |name: &[u8], data: &[u8]| [&(data.len() as u32).to_be_bytes()[..], name, data, &[0; 4]].concat();
    let head = [0, 0, 0, 1, 0, 0, 0, 1, 8, if alpha { 6 } else { 2 }, 0, 0, 0];
    [&b"\x89PNG\r\n\x1a\n"[..], &chunk(b"IHDR", &head), &chunk(b"IEND", &[])].concat()
}

#[test]
fn both_containers_give_the_same_mesh() {
    let mut file = File::new();
    let mesh = file.triangle();
    file.push("nodes", json!({"mesh": mesh, "name": "Sail"}));
    let text = file.mesh_of();
    let binary = read_gltf(&file.glb(), &mut |_| None).expect("it is valid").mesh;
    assert_eq!((text.points(), text.groups()), (binary.points(), binary.groups()));
    assert_eq!((text.face_count(), text.area(), text.groups()), (1, 0.5, &["Sail".to_owned()][..]));
}

#[test]
fn a_buffer_may_be_a_file_with_escapes_in_its_name() {
    let mut file = File::new();
    let mesh = file.triangle();
    file.push("nodes", json!({"mesh": mesh}));
    file.json["buffers"] = json!([{"uri": "my%20data.bin", "byteLength": file.data.len()}]);
    let text = file.json.to_string();
    let data = file.data.clone();
    let found = read_gltf(text.as_bytes(), &mut |name| (name == "my data.bin").then(|| data.clone()));
    assert_eq!(found.expect("it is valid").mesh.area(), 0.5);
    let missing = read_gltf(text.as_bytes(), &mut |_| None).expect_err("the buffer is missing");
    assert_eq!(missing.to_string(), "buffers[0]: its data cannot be found");
}

#[test]
fn nodes_are_placed_below_each_other_and_a_mirrored_node_turns_faces_over() {
    let mut file = File::new();
    let mesh = file.triangle();
    let half = (0.5f64).sqrt();
    // A quarter turn about y: x becomes −z.
    file.push("nodes", json!({"children": [1, 2], "translation": [10, 0, 0], "rotation": [0, half, 0, half]}));
    file.push("nodes", json!({"mesh": mesh, "scale": [2, 3, 4]}));
    file.push("nodes", json!({"mesh": mesh, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1]}));
    let mesh = file.mesh_of();
    assert_eq!(mesh.face_count(), 2);
    assert!((mesh.face(0).area() - 3.0).abs() < 1e-12 && (mesh.face(1).area() - 0.5).abs() < 1e-12);
    let near = |face: usize, point| {
        mesh.face(face).outer().iter().any(|&at| (mesh.points()[at as usize]).distance(point) < 1e-12)
    };
    assert!(near(0, dvec3(10.0, 0.0, -2.0)) && near(1, dvec3(15.0, 0.0, 1.0)));
    // Both triangles face +x after the turn: mirrored faces keep their outside.
    for face in mesh.faces() {
        assert!(face.normal().dot(DVec3::X) > 0.999);
    }
}

#[test]
fn a_node_used_twice_is_an_error() {
    let mut file = File::new();
    file.push("nodes", json!({"children": [1]}));
    file.push("nodes", json!({"children": [0]}));
    assert_eq!(file.read().expect("a cycle has no root").mesh.face_count(), 0);
    file.json["scenes"] = json!([{"nodes": [0]}]);
    assert_eq!(file.read().expect_err("a cycle").to_string(), "nodes[0]: it has two parents");
    file.json["scenes"] = json!([{"nodes": [7]}]);
    assert_eq!(file.read().expect_err("no such node").to_string(), "nodes[7]: it does not exist");
}

#[test]
fn deep_nodes_need_no_stack() {
    let mut file = File::new();
    let mesh = file.triangle();
    let nodes: Vec<Value> = (1..=100_000)
        .map(|next| if next == 100_000 { json!({"mesh": mesh}) } else { json!({"children": [next]}) })
        .collect();
    file.json["nodes"] = nodes.into();
    assert_eq!(file.mesh_of().face_count(), 1);
}

#[test]
fn strips_and_fans_are_triangles_and_lines_are_left_out() {
    let square = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
    for (mode, order, faces) in
        [(4, [0, 1, 2, 2, 1, 3].to_vec(), 2), (5, vec![0, 1, 2, 3], 2), (6, vec![0, 1, 3, 2], 2)]
    {
        let mut file = File::new();
        let positions = file.floats("VEC3", 3, &square);
        let indices = file.indices(&order);
        let mesh = file.mesh(json!({"mode": mode, "attributes": {"POSITION": positions}, "indices": indices}));
        file.push("nodes", json!({"mesh": mesh}));
        let mesh = file.mesh_of();
        assert_eq!((mesh.face_count(), mesh.area(), mesh.points().len()), (faces, 1.0, 4), "{mode}");
        assert!(mesh.faces().all(|face| face.normal() == DVec3::Z), "{mode}");
    }
    let mut file = File::new();
    let mesh = file.mesh(json!({"mode": 1, "attributes": {}}));
    file.push("nodes", json!({"mesh": mesh}));
    let read = file.read().expect("it is valid");
    assert_eq!(read.mesh.face_count(), 0);
    assert_eq!(read.warnings, ["1 primitives with points or lines were left out", "the scene has no triangles"]);
}

#[test]
fn a_cube_with_split_vertices_is_closed() {
    // Each side has four vertices of its own.
    let mut values = Vec::new();
    let mut order: Vec<u16> = Vec::new();
    for axis in 0..3 {
        for side in [0.0f32, 1.0] {
            let first = (values.len() / 3) as u16;
            let ring = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
            for [a, b] in ring {
                let mut point = [0.0; 3];
                (point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3]) = (side, a, b);
                values.extend(point);
            }
            let corners = if side == 1.0 { [0, 1, 2, 0, 2, 3] } else { [0, 2, 1, 0, 3, 2] };
            order.extend(corners.map(|corner| first + corner));
        }
    }
    let mut file = File::new();
    let positions = file.floats("VEC3", 3, &values);
    let indices = file.indices(&order);
    let mesh = file.mesh(json!({"attributes": {"POSITION": positions}, "indices": indices}));
    file.push("nodes", json!({"mesh": mesh}));
    let mesh = file.mesh_of();
    assert_eq!((mesh.points().len(), mesh.face_count(), mesh.is_closed(), mesh.volume()), (8, 12, true, 1.0));
}

#[test]
fn instances_and_sparse_and_normalised_numbers_are_read() {
    let mut file = File::new();
    // A triangle in bytes: 255 is 1.
    let view = file.view(&[0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0]);
    file.json["bufferViews"][view]["byteStride"] = json!(4);
    let positions = file.push(
        "accessors",
        json!({"bufferView": view, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC3"}),
    );
    let mesh = file.mesh(json!({"attributes": {"POSITION": positions}}));
    // Three places, of which the sparse list moves the second.
    let (indices, values) = (file.view(&[1]), file.view(&[0, 0, 64, 64, 0, 0, 0, 0, 0, 0, 0, 0]));
    let places = file.push(
        "accessors",
        json!({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {"count": 1,
            "indices": {"bufferView": indices, "componentType": 5121}, "values": {"bufferView": values}}}),
    );
    let instancing = json!({"attributes": {"TRANSLATION": places}});
    file.push("nodes", json!({"mesh": mesh, "extensions": {"EXT_mesh_gpu_instancing": instancing}}));
    file.json["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing", "KHR_mesh_quantization"]);
    let mesh = file.mesh_of();
    assert_eq!((mesh.face_count(), mesh.area(), mesh.bounds().high.x), (3, 1.5, 4.0));
}

#[test]
fn a_material_has_its_colours_images_and_coordinates() {
    let mut file = File::new();
    let positions = file.floats("VEC3", 3, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let first = file.floats("VEC2", 2, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let second = file.floats("VEC2", 2, &[0.5, 0.5, 1.0, 0.5, 0.5, 1.0]);
    let image = file.view(&png(true));
    file.json["images"] =
        json!([{"bufferView": image, "mimeType": "image/png"}, {"uri": "normal%20map.png"}, {"bufferView": 0}]);
    file.json["textures"] = json!([{"source": 0}, {"source": 1}, {"source": 2}, {}]);
    file.json["materials"] = json!([{
        "name": "Brick",
        "alphaMode": "MASK",
        "doubleSided": true,
        "emissiveFactor": [0, 0.214_041_140_5, 0],
        "pbrMetallicRoughness": {
            "baseColorFactor": [0.214_041_140_5, 1, 0, 0.5],
            "roughnessFactor": 0.25,
            "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 3]}}},
            "metallicRoughnessTexture": {"index": 2},
        },
        "normalTexture": {"index": 1, "texCoord": 1},
        "occlusionTexture": {"index": 3},
    }]);
    let mesh = file.mesh(json!({
        "material": 0, "attributes": {"POSITION": positions, "TEXCOORD_0": first, "TEXCOORD_1": second}
    }));
    file.push("nodes", json!({"mesh": mesh}));
    let GltfFile { mesh, images, warnings } = file.read().expect("it is valid");
    assert_eq!(images, [EmbeddedImage { name: "#0.png".into(), bytes: png(true) }]);
    assert_eq!(warnings, ["images[2] is not a complete PNG or JPEG file"]);
    let material = &mesh.materials::<Material>()[0];
    let text = |which| material.text(which).map(|text| text.as_str());
    assert_eq!(text(MaterialText::Name), Some("Brick"));
    assert_eq!(text(MaterialText::Map(Layer::Color)), Some("#0.png"));
    assert_eq!(text(MaterialText::Map(Layer::Opacity)), Some("#0.png"));
    assert_eq!(text(MaterialText::Map(Layer::Normal)), Some("normal map.png"));
    assert_eq!([Layer::Roughness, Layer::Occlusion].map(|layer| text(MaterialText::Map(layer))), [None; 2]);
    assert_eq!(text(MaterialText::OpacityMode), Some("mask"));
    assert_eq!((material.double_sided, material.metallic, material.roughness), (Some(true), Some(1.0), Some(0.25)));
    let Color { r, g, b } = material.color();
    assert!((r - 0.5).abs() < 1e-8 && g == 1.0 && b == 0.0 && material.opacity() == 0.5);
    assert!((material.number(MaterialNumber::Emissive(Channel::G)).expect("light") - 0.5).abs() < 1e-8);
    // v points up here, so a scale moves the image as well.
    let number = |part| material.number(MaterialNumber::Map(Layer::Color, part));
    assert_eq!(number(LayerPart::Su), Some(2.0));
    assert_eq!((number(LayerPart::Sv), number(LayerPart::Tv)), (Some(3.0), Some(-2.0)));
    let uvs = |set: usize| mesh.uv_set(set).to_vec();
    assert_eq!(uvs(0), [DVec2::new(0.0, 1.0), DVec2::new(1.0, 1.0), DVec2::new(0.0, 0.0)]);
    assert_eq!(uvs(Layer::Normal.uv_set()), [DVec2::new(0.5, 0.5), DVec2::new(1.0, 0.5), DVec2::new(0.5, 0.0)]);
}

#[test]
fn a_primitive_without_coordinates_or_normals_does_not_drop_those_of_others() {
    let mut file = File::new();
    let positions = file.floats("VEC3", 3, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let pairs = file.floats("VEC2", 2, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let normals = file.floats("VEC3", 3, &[0.0, 0.6, 0.8, 0.0, 0.6, 0.8, 0.0, 0.6, 0.8]);
    let plain = file.mesh(json!({"attributes": {"POSITION": positions}}));
    let full = file.mesh(json!({"attributes": {"POSITION": positions, "TEXCOORD_0": pairs, "NORMAL": normals}}));
    file.push("nodes", json!({"mesh": plain}));
    file.push("nodes", json!({"mesh": full, "scale": [1, 1, -1], "translation": [0, 0, 5]}));
    let mesh = file.mesh_of();
    assert_eq!(mesh.uv_set(0).len(), 6);
    assert_eq!(mesh.uv_set(0)[..3], [DVec2::ZERO; 3]);
    assert_eq!(mesh.normals()[0], DVec3::Z);
    assert!(mesh.normals()[3].distance(dvec3(0.0, 0.6, -0.8)) < 1e-7);
    assert_eq!(mesh.face(1).normal(), -DVec3::Z);
}

#[test]
fn a_broken_file_is_named_by_its_item() {
    let valid = || {
        let mut file = File::new();
        let mesh = file.triangle();
        file.push("nodes", json!({"mesh": mesh}));
        file
    };
    let broken = |change: &dyn Fn(&mut File)| {
        let mut file = valid();
        change(&mut file);
        file.read().expect_err("it is broken").to_string()
    };
    assert_eq!(broken(&|file| file.json["accessors"][0]["count"] = json!(4)), "accessors[0]: its view ends early");
    assert_eq!(
        broken(&|file| file.json["accessors"][0]["count"] = json!(-1)),
        "accessors[0]: `count` must be a number without fraction"
    );
    assert_eq!(
        broken(&|file| file.json["accessors"][0]["type"] = json!("VEC2")),
        "accessors[0]: its `type` must be `VEC3` here"
    );
    assert_eq!(
        broken(&|file| file.json["accessors"][0]["byteOffset"] = json!(u64::MAX)),
        "accessors[0]: its view ends early"
    );
    assert_eq!(
        broken(&|file| file.json["bufferViews"][0]["byteLength"] = json!(1_000_000)),
        "bufferViews[0]: its buffer ends early"
    );
    assert_eq!(
        broken(&|file| file.json["bufferViews"][0]["byteStride"] = json!(8)),
        "accessors[0]: the elements of its view overlap"
    );
    assert_eq!(broken(&|file| file.data[0..4].fill(0xff)), "accessors[0]: a number is not finite");
    assert_eq!(broken(&|file| file.json["nodes"][0]["mesh"] = json!(9)), "meshes[9]: it does not exist");
    assert_eq!(
        broken(&|file| file.json["nodes"][0]["scale"] = json!([1, 2])),
        "nodes[0]: `scale` must be a list of 3 numbers"
    );
    let huge = json!([1e200, 1e200, 1e200]);
    let nested = |file: &mut File| {
        file.json["nodes"] = json!([{"scale": huge, "children": [1]}, {"mesh": 0, "scale": huge}]);
    };
    assert_eq!(broken(&nested), "nodes[1]: its place is not finite");
    assert_eq!(broken(&|file| file.json["asset"] = json!({"version": "1.0"})), "only version 2 of glTF can be read");
    assert_eq!(
        broken(&|file| file.json["extensionsRequired"] = json!(["KHR_draco_mesh_compression"])),
        "it requires the extension `KHR_draco_mesh_compression`, which cannot be read"
    );
}

#[test]
fn counts_beyond_the_data_need_no_memory() {
    let mut file = File::new();
    let absent = file.push("accessors", json!({"componentType": 5126, "count": 4_000_000_000u64, "type": "VEC3"}));
    let mesh = file.mesh(json!({"attributes": {"POSITION": absent}}));
    file.push("nodes", json!({"mesh": mesh}));
    assert_eq!(file.read().expect_err("too many").to_string(), "accessors[0]: it has too many elements");
    // Many places of one mesh.
    let mut file = File::new();
    let positions = file.push("accessors", json!({"componentType": 5126, "count": 1 << 20, "type": "VEC3"}));
    let mesh = file.mesh(json!({"attributes": {"POSITION": positions}}));
    for _ in 0..100 {
        file.push("nodes", json!({"mesh": mesh}));
    }
    assert_eq!(file.read().expect_err("too many"), GltfError::TooLarge);
}

#[test]
fn a_container_that_ends_early_is_refused() {
    let mut file = File::new();
    let mesh = file.triangle();
    file.push("nodes", json!({"mesh": mesh}));
    let whole = file.glb();
    for end in 0..whole.len() {
        assert!(read_gltf(&whole[..end], &mut |_| None).is_err(), "{end}");
    }
    assert!(matches!(read_gltf(b"", &mut |_| None), Err(GltfError::Json(_))));
    assert!(matches!(read_gltf(b"[]", &mut |_| None), Err(GltfError::Container(_))));
    // Deep JSON is refused before the stack ends.
    assert!(matches!(read_gltf(&vec![b'['; 1_000_000], &mut |_| None), Err(GltfError::Json(_))));
}

mod hostile;
