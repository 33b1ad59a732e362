//! Files that no program should write: an error or a mesh, soon and in bounded memory.

use serde_json::{Value, json};

use super::{File, glb, png};
use crate::asset::gltf::{GltfError, GltfFile, read_gltf};
use crate::shape::seed::Seed;

/// A file with all parts that the reader looks at: nodes, instances, sparse data, strips, materials, images.
fn rich() -> File {
    let mut file = File::new();
    let square = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
    let positions = file.floats("VEC3", 3, &square);
    let normals = file.floats("VEC3", 3, &[0.0, 0.0, 1.0].repeat(4));
    let pairs = file.floats("VEC2", 2, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
    let indices = file.indices(&[0, 1, 2, 3]);
    let (places, values) = (file.view(&[1]), file.view(&[0, 0, 64, 64, 0, 0, 0, 0, 0, 0, 0, 0]));
    let moved = file.push(
        "accessors",
        json!({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {"count": 1,
            "indices": {"bufferView": places, "componentType": 5121}, "values": {"bufferView": values}}}),
    );
    let image = file.view(&png(true));
    let attributes = json!({"POSITION": positions, "NORMAL": normals, "TEXCOORD_0": pairs});
    let strip = json!({"mode": 5, "attributes": attributes, "indices": indices, "material": 0});
    let mesh =
        file.push("meshes", json!({"name": "Square", "primitives": [strip, {"attributes": {"POSITION": moved}}]}));
    file.push("nodes", json!({"children": [1, 2], "translation": [1, 2, 3], "rotation": [0, 1, 0, 1]}));
    file.push("nodes", json!({"mesh": mesh, "scale": [2, 3, -4], "name": "One"}));
    let instancing = json!({"attributes": {"TRANSLATION": moved}});
    file.push("nodes", json!({"mesh": mesh, "extensions": {"EXT_mesh_gpu_instancing": instancing}}));
    file.json["scenes"] = json!([{"nodes": [0]}]);
    file.json["scene"] = json!(0);
    file.json["images"] = json!([{"bufferView": image}, {"uri": "data:image/png;base64,AAAA"}, {"uri": "a%20b.png"}]);
    file.json["textures"] = json!([{"source": 0}, {"source": 1}, {"source": 2}]);
    file.json["materials"] = json!([{
        "alphaMode": "MASK", "emissiveFactor": [1, 0, 0.5],
        "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1], "baseColorTexture": {"index": 0},
            "metallicRoughnessTexture": {"index": 1, "texCoord": 0}},
        "normalTexture": {"index": 2, "extensions": {"KHR_texture_transform": {"scale": [2, 3], "rotation": 1}}},
    }]);
    file
}

fn read(bytes: &[u8]) -> Result<GltfFile, GltfError> {
    let read = read_gltf(bytes, &mut |_| None);
    if let Ok(file) = &read {
        assert_eq!(file.mesh.check().iter().find(|flaw| !is_of_input(flaw)), None);
        assert!(file.warnings.len() <= 101);
    }
    read
}

/// Flaws that faces of a file may have.
fn is_of_input(flaw: &crate::geometry::mesh::Flaw) -> bool {
    matches!(flaw, crate::geometry::mesh::Flaw::NotPlanar { .. })
}

/// A number below `count`.
fn below(rng: &mut Seed, count: usize) -> usize {
    (rng.draw() * count as f64) as usize
}

/// A value that does not belong where it is put.
fn wrong_value(rng: &mut Seed) -> Value {
    let values = [
        json!(-1),
        json!(0),
        json!(7),
        json!(u32::MAX),
        json!(1u64 << 32),
        json!(u64::MAX),
        json!(i64::MIN),
        json!(1e300),
        json!(-1e-300),
        json!(3.5),
        json!(5126),
        json!(5121),
        json!(1 << 22),
        json!(null),
        json!(true),
        json!(""),
        json!("VEC3"),
        json!("data:;base64,////"),
        json!([]),
        json!([0, 0, 0, 0]),
        json!([1e200, -1e200, 1e200]),
        json!({}),
        json!({"bufferView": 0, "index": 0, "mesh": 0}),
    ];
    values[below(rng, values.len())].clone()
}

/// Changes a random part of a value.
fn change(value: &mut Value, rng: &mut Seed) {
    let count = match &*value {
        Value::Array(list) => list.len(),
        Value::Object(map) => map.len(),
        _ => 0,
    };
    if count == 0 || rng.draw() < 0.1 {
        *value = wrong_value(rng);
        return;
    }
    let at = below(rng, count);
    let fate = rng.draw();
    match value {
        Value::Array(list) if fate < 0.05 => _ = list.remove(at),
        Value::Array(list) if fate < 0.1 => list.push(list[at].clone()),
        Value::Array(list) => change(&mut list[at], rng),
        Value::Object(map) => {
            let key = map.keys().nth(at).cloned().unwrap_or_default();
            if fate < 0.05 {
                map.remove(&key);
            } else if let Some(part) = map.get_mut(&key) {
                change(part, rng);
            }
        }
        _ => {}
    }
}

#[test]
fn ten_thousand_changed_files_give_a_mesh_or_an_error() {
    let valid = rich();
    assert_eq!(read(&valid.text()).expect("it is valid").mesh.face_count(), 8);
    let whole = valid.glb();
    let (mut read_count, mut refused) = (0, 0);
    for seed in 0..10_000 {
        let rng = &mut Seed::new(seed);
        let bytes = if seed % 2 == 0 {
            let mut json = valid.json.clone();
            json["buffers"] = json!([{"byteLength": valid.data.len()}]);
            (0..1 + below(rng, 3)).for_each(|_| change(&mut json, rng));
            glb(json.to_string().as_bytes(), &valid.data)
        } else {
            let mut bytes = whole.clone();
            for _ in 0..1 + below(rng, 4) {
                let at = below(rng, bytes.len());
                match below(rng, 4) {
                    0 => bytes[at] = below(rng, 256) as u8,
                    1 => bytes[at] ^= 1 << below(rng, 8),
                    2 => drop(bytes.splice(at..at, [b'9'; 3])),
                    _ => _ = bytes.remove(at),
                }
            }
            bytes
        };
        match read(&bytes) {
            Ok(_) => read_count += 1,
            Err(_) => refused += 1,
        }
    }
    assert!(500 < read_count && 500 < refused, "{read_count} read, {refused} refused");
}

/// A file whose mesh has one primitive many times.
fn many_primitives(file: &mut File, primitive: &Value, count: usize) {
    file.json["meshes"] = json!([{"primitives": vec![primitive.clone(); count]}]);
    file.json["nodes"] = json!([{"mesh": 0}]);
}

/// An accessor whose elements are not in the file.
fn absent(file: &mut File, kind: &str, count: usize) -> usize {
    file.push("accessors", json!({"componentType": 5126, "count": count, "type": kind}))
}

#[test]
fn primitives_that_share_very_many_positions_need_no_time_or_memory_for_each() {
    let mut file = File::new();
    let positions = absent(&mut file, "VEC3", 1 << 20);
    let indices = file.indices(&[0, 1, 2]);
    let primitive = json!({"attributes": {"POSITION": positions}, "indices": indices});
    many_primitives(&mut file, &primitive, 10_000);
    // All triangles are without area.
    assert_eq!(file.read().expect("it is valid").mesh.face_count(), 0);
    // Without indices, each is a copy of all positions. One copy and the positions themselves are all that a small file may have.
    many_primitives(&mut file, &json!({"attributes": {"POSITION": positions}}), 1);
    assert_eq!(file.read().expect("2,097,152 elements").mesh.face_count(), 0);
    many_primitives(&mut file, &json!({"attributes": {"POSITION": positions}}), 2);
    assert_eq!(file.read().expect_err("too many elements"), GltfError::TooLarge);
    many_primitives(&mut file, &json!({"attributes": {"POSITION": positions}}), 10_000);
    assert_eq!(file.read().expect_err("too many vertices"), GltfError::TooLarge);
}

#[test]
fn instances_without_data_are_limited() {
    let mut file = File::new();
    let mesh = file.triangle();
    let places = absent(&mut file, "VEC3", 1 << 19);
    let instancing = json!({"attributes": {"SCALE": places}});
    for _ in 0..1000 {
        file.push("nodes", json!({"mesh": mesh, "extensions": {"EXT_mesh_gpu_instancing": instancing}}));
    }
    assert_eq!(file.read().expect_err("too many places"), GltfError::TooLarge);
}

#[test]
fn images_that_share_bytes_are_copied_once() {
    let mut file = File::new();
    let positions = file.floats("VEC3", 3, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    // A large image: the reader looks at the head and the end only.
    let mut large = png(false);
    let end = large.split_off(large.len() - 12);
    let start = large.len();
    large.extend([&[0, 1, 0, 0][..], b"tEXt", &[b' '; 1 << 16], &[0; 4]].concat());
    large.extend(&end);
    let view = file.view(&large);
    let count = 200;
    let list = |item: &dyn Fn(usize) -> Value| Value::from((0..count).map(item).collect::<Vec<_>>());
    file.json["images"] = list(&|_| json!({"bufferView": view}));
    file.json["textures"] = list(&|number| json!({"source": number}));
    file.json["materials"] = list(&|number| json!({"normalTexture": {"index": number}}));
    let primitive = |number: usize| json!({"attributes": {"POSITION": positions}, "material": number});
    file.json["meshes"] = json!([{"primitives": list(&primitive)}]);
    file.json["nodes"] = json!([{"mesh": 0}]);
    let read = file.read().expect("it is valid");
    assert_eq!((read.images.len(), read.mesh.material_list().len()), (1, count));
    assert!(start < read.images[0].bytes.len());
    // Views that overlap have more bytes than the file.
    let own = file.json["bufferViews"][view].clone();
    let views: Vec<usize> = (0..count).map(|_| file.push("bufferViews", own.clone())).collect();
    file.json["images"] = list(&|number| json!({"bufferView": views[number]}));
    assert_eq!(file.read().expect_err("a bomb").to_string(), "images[1]: the data of images overlap");
}

#[test]
fn deep_objects_are_refused_before_the_stack_ends() {
    let text = String::from_utf8(rich().text()).expect("it is text");
    let deep = |depth: usize| {
        let extras = format!("{{\"extras\":{}0{},", "{\"a\":".repeat(depth), "}".repeat(depth));
        text.replacen('{', &extras, 1).into_bytes()
    };
    assert_eq!(read(&deep(100)).expect("it is valid").mesh.face_count(), 8);
    assert!(matches!(read(&deep(100_000)), Err(GltfError::Json(_))));
}
