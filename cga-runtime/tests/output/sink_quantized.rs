//! GLB files with small numbers: the same triangles as in files with 32-bit numbers.

use cga_runtime::asset::gltf::read_gltf;
use cga_runtime::output::gltf::Glb;
use cga_runtime::output::model::Model;
use cga_runtime::run::building::Building;
use cga_runtime::run::sink::Sink;
use glam::{DVec3, dvec3};
use serde_json::Value;

use crate::sink_support::{Fill, color, front, mixed, steady, tower};

/// A file as JSON and bytes.
struct File {
    json: Value,
    binary: Vec<u8>,
    length: usize,
}

impl File {
    fn new(glb: Glb) -> Self {
        let bytes = glb.into_bytes().expect("a file");
        let length = u32::from_le_bytes([bytes[12], bytes[13], bytes[14], bytes[15]]) as usize;
        let json = serde_json::from_slice(&bytes[20..20 + length]).expect("JSON");
        File { json, binary: bytes[20 + length + 8..].to_vec(), length: bytes.len() }
    }

    /// The primitives of all meshes, each with the number of its mesh.
    fn primitives(&self) -> Vec<(usize, &Value)> {
        let meshes = self.json["meshes"].as_array().into_iter().flatten().enumerate();
        meshes
            .flat_map(|(at, mesh)| mesh["primitives"].as_array().into_iter().flatten().map(move |p| (at, p)))
            .collect()
    }

    fn accessor(&self, number: &Value) -> &Value {
        &self.json["accessors"][number.as_u64().expect("a number") as usize]
    }

    /// The items of an accessor. Items of vertices begin at whole words.
    fn items<const N: usize>(&self, number: &Value) -> Vec<[f64; N]> {
        let accessor = self.accessor(number);
        let view = &self.json["bufferViews"][accessor["bufferView"].as_u64().expect("a view") as usize];
        let natural = |value: &Value| value.as_u64().unwrap_or_default() as usize;
        let ty = accessor["componentType"].as_u64().expect("a type");
        let size = match ty {
            5120 => 1,
            5123 => 2,
            _ => 4,
        };
        let stride = view["byteStride"].as_u64().map_or(N * size, |stride| stride as usize);
        let (begin, own) = (natural(&view["byteOffset"]), natural(&accessor["byteOffset"]));
        assert!(own.is_multiple_of(4) && (stride.is_multiple_of(4) || view["target"] == 34963));
        let count = natural(&accessor["count"]);
        assert!(own + stride * (count - 1) + N * size <= natural(&view["byteLength"]));
        let number = |at: usize| match ty {
            5120 => (f64::from(self.binary[at] as i8) / 127.0).max(-1.0),
            5123 => f64::from(u16::from_le_bytes([self.binary[at], self.binary[at + 1]])),
            _ => {
                let bytes = [0, 1, 2, 3].map(|byte| self.binary[at + byte]);
                if ty == 5125 { f64::from(u32::from_le_bytes(bytes)) } else { f64::from(f32::from_le_bytes(bytes)) }
            }
        };
        (0..count).map(|item| std::array::from_fn(|part| number(begin + own + item * stride + part * size))).collect()
    }

    /// The positions of a primitive after the node of its mesh, if the mesh is at one place.
    fn positions(&self, mesh: usize, primitive: &Value) -> Vec<DVec3> {
        let nodes = self.json["nodes"].as_array().expect("nodes");
        let node = nodes.iter().find(|node| node["mesh"] == mesh).expect("a node");
        let vector = |name: &str, usual: f64| match node[name].as_array() {
            Some(list) => DVec3::from_array(std::array::from_fn(|axis| list[axis].as_f64().expect("a number"))),
            None => DVec3::splat(usual),
        };
        let (translation, scale) = (vector("translation", 0.0), vector("scale", 1.0));
        self.items::<3>(&primitive["attributes"]["POSITION"])
            .into_iter()
            .map(|p| translation + scale * DVec3::from_array(p))
            .collect()
    }
}

fn file(model: &Model, glb: Glb) -> File {
    let mut glb = glb;
    assert!(model.replay(&mut glb).is_continue());
    File::new(glb)
}

const MOST_ERROR: f64 = 0.001;

#[test]
fn triangles_move_by_at_most_the_error() {
    for model in [mixed(), steady(), tower(3)] {
        let (plain, small) = (file(&model, Glb::new()), file(&model, Glb::new().with_quantization(MOST_ERROR)));
        let required: Vec<&str> =
            small.json["extensionsRequired"].as_array().expect("a list").iter().filter_map(Value::as_str).collect();
        assert_eq!(required, ["KHR_mesh_quantization"]);
        assert_eq!(plain.primitives().len(), small.primitives().len());
        let mut on_grid = 0;
        for ((mesh, a), (_, b)) in plain.primitives().into_iter().zip(small.primitives()) {
            assert_eq!(plain.items::<1>(&a["indices"]), small.items::<1>(&b["indices"]));
            let rule = |file: &File, p: &Value| file.items::<1>(&p["attributes"]["_FEATURE_ID_0"]);
            assert_eq!(rule(&plain, a), rule(&small, b));
            for (a, b) in plain.positions(mesh, a).into_iter().zip(small.positions(mesh, b)) {
                assert!((a - b).abs().max_element() <= MOST_ERROR, "{a} {b}");
            }
            let normal = |file: &File, p: &Value| file.items::<3>(&p["attributes"]["NORMAL"]);
            for (a, b) in normal(&plain, a).into_iter().zip(normal(&small, b)) {
                let (a, b) = (DVec3::from_array(a), DVec3::from_array(b));
                assert!((a - b).abs().max_element() <= 0.5 / 127.0 + 1e-6 && (b.length() - 1.0).abs() < 0.00674);
            }
            // Readers compare the limits with the numbers.
            let accessor = small.accessor(&b["attributes"]["POSITION"]);
            let limit = |name: &str, of: fn(f64, f64) -> f64| {
                let items = small.items::<3>(&b["attributes"]["POSITION"]);
                let found: [f64; 3] =
                    std::array::from_fn(|axis| items.iter().map(|item| item[axis]).reduce(of).expect("a point"));
                let given = accessor[name].as_array().expect("a limit");
                assert!((0..3).all(|axis| given[axis].as_f64() == Some(found[axis])), "{accessor}");
            };
            limit("min", f64::min);
            limit("max", f64::max);
            on_grid += usize::from(accessor["componentType"] == 5123);
        }
        assert!(0 < on_grid && small.length < plain.length);
    }
}

#[test]
fn a_file_is_read_back_with_its_area() {
    for model in [mixed(), steady()] {
        for glb in [Glb::new(), Glb::new().by_rule(), Glb::new().with_origin(dvec3(100.0, -3.0, 7.0))] {
            let mut glb = glb.with_quantization(MOST_ERROR);
            assert!(model.replay(&mut glb).is_continue());
            let bytes = glb.into_bytes().expect("a file");
            let mesh = read_gltf(&bytes, &mut |_| None).expect("it was written by us").mesh;
            assert!((mesh.area() / model.area() - 1.0).abs() < 0.01, "{} {}", mesh.area(), model.area());
        }
    }
}

#[test]
fn a_file_that_is_too_large_for_the_error_keeps_its_positions() {
    let mut fill = Fill(Glb::new().with_quantization(0.01));
    let wall = color(1.0, 0.0, 0.0);
    fill.quad("Wall", &wall, front(DVec3::ZERO, 10_000.0, 5.0));
    let file = File::new(fill.0);
    let (_, primitive) = file.primitives()[0];
    let ty = |file: &File, number: &Value| file.accessor(number)["componentType"].as_u64();
    assert_eq!(ty(&file, &primitive["attributes"]["POSITION"]), Some(5126));
    assert_eq!(ty(&file, &primitive["attributes"]["NORMAL"]), Some(5120));
    assert_eq!(file.json["nodes"][0]["mesh"], 0);
}

#[test]
fn indices_have_the_bits_that_they_need() {
    let wall = color(1.0, 0.0, 0.0);
    for (quads, ty) in [(3, 5123), (16_383, 5123), (16_384, 5125)] {
        let mut fill = Fill(Glb::new().with_quantization(1.0));
        for number in 0..quads {
            fill.quad("Wall", &wall, front(dvec3(f64::from(number % 100), f64::from(number / 100), 0.0), 1.0, 1.0));
        }
        let size = fill.0.size();
        let file = File::new(fill.0);
        let (_, primitive) = file.primitives()[0];
        assert_eq!(file.accessor(&primitive["indices"])["componentType"], ty, "{quads}");
        assert_eq!(file.items::<1>(&primitive["indices"]).last(), Some(&[f64::from(4 * quads - 1)]));
        // The count of bytes is right while leaves come.
        let wide = if ty == 5125 { 2 * 6 * quads as u64 } else { 0 };
        assert!(size + wide <= file.binary.len() as u64 && (file.binary.len() as u64) < size + wide + 200);
    }
}

#[test]
fn buildings_keep_their_numbers_without_rules() {
    let mut fill = Fill(Glb::new().without_rules());
    for (number, name) in [(0, "a"), (1, "b")] {
        fill.0.begin_building(name, number);
        fill.quad("Wall", &color(1.0, 0.0, 0.0), front(dvec3(number as f64, 0.0, 0.0), 1.0, 1.0));
        fill.0.end_building(&|| Building::new(name, number));
    }
    let file = File::new(fill.0);
    let (_, primitive) = file.primitives()[0];
    let attributes = primitive["attributes"].as_object().expect("attributes");
    assert!(attributes.keys().eq(["NORMAL", "POSITION", "_FEATURE_ID_0"]), "{attributes:?}");
    let features = &primitive["extensions"]["EXT_mesh_features"]["featureIds"];
    assert_eq!(features.to_string(), r#"[{"attribute":0,"featureCount":2,"propertyTable":0}]"#);
    let ids: Vec<f64> = file.items::<1>(&primitive["attributes"]["_FEATURE_ID_0"]).into_iter().flatten().collect();
    assert_eq!(ids, [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0]);
    let tables = &file.json["extensions"]["EXT_structural_metadata"]["propertyTables"];
    assert_eq!((tables.as_array().map(Vec::len), &tables[0]["count"]), (Some(1), &2.into()));
    // Without buildings, no number is left.
    let mut fill = Fill(Glb::new().without_rules());
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(DVec3::ZERO, 1.0, 1.0));
    let file = File::new(fill.0);
    assert_eq!((file.json.get("extensionsUsed"), file.json.get("extensions")), (None, None));
}

#[test]
fn faces_without_normals_share_their_corners() {
    for model in [mixed(), steady(), tower(3)] {
        for exact in [true, false] {
            let form = || if exact { Glb::new() } else { Glb::new().with_quantization(MOST_ERROR) };
            let (lit, plain) = (file(&model, form()), file(&model, form().without_normals()));
            assert!(plain.length < lit.length);
            assert_eq!(lit.primitives().len(), plain.primitives().len());
            for ((mesh, a), (_, b)) in lit.primitives().into_iter().zip(plain.primitives()) {
                assert!(a["attributes"].get("NORMAL").is_some() && b["attributes"].get("NORMAL").is_none());
                assert!(b["attributes"].get("TANGENT").is_none());
                let corners = |file: &File, p: &Value| {
                    let (points, rules) = (file.positions(mesh, p), file.items::<1>(&p["attributes"]["_FEATURE_ID_0"]));
                    let indices = file.items::<1>(&p["indices"]).into_iter().map(|[index]| index as usize);
                    indices.map(|index| (points[index], rules[index])).collect::<Vec<_>>()
                };
                for ((a, rule), (b, other)) in corners(&lit, a).into_iter().zip(corners(&plain, b)) {
                    assert!((a - b).abs().max_element() <= MOST_ERROR && rule == other, "{a} {b}");
                }
            }
        }
    }
    let vertices = |glb: Glb| {
        let file = file(&tower(1), glb);
        let count = |(_, p): (usize, &Value)| file.accessor(&p["attributes"]["POSITION"])["count"].as_u64();
        file.primitives().into_iter().filter_map(count).sum::<u64>()
    };
    let (lit, plain) = (vertices(Glb::new()), vertices(Glb::new().without_normals()));
    assert!(2 * plain <= lit, "{plain} {lit}");
}

#[test]
fn buildings_without_normals_share_no_corners_with_each_other() {
    let made = |glb: Glb| {
        let mut glb = Fill(glb.without_rules());
        for (name, seed) in [("a", 1), ("b", 2)] {
            glb.0.begin_building(name, seed);
            // The same square twice, with two rules.
            for rule in ["Wall", "Roof"] {
                glb.quad(rule, &color(0.5, 0.5, 0.5), front(DVec3::ZERO, 1.0, 2.0));
            }
            glb.0.end_building(&|| Building::new(name, seed));
        }
        File::new(glb.0)
    };
    let plain = made(Glb::new().without_normals());
    let [(_, primitive)] = plain.primitives()[..] else { panic!("one material") };
    let ids = plain.items::<1>(&primitive["attributes"]["_FEATURE_ID_0"]);
    let of = |number: f64| ids.iter().filter(|id| id[0] == number).count();
    let lit = made(Glb::new());
    let count = lit.items::<3>(&lit.primitives()[0].1["attributes"]["POSITION"]).len();
    assert_eq!(([of(0.0), of(1.0)], ids.len(), count), ([4, 4], 8, 16));
    // Each building has its own indices.
    let indices: Vec<usize> = plain.items::<1>(&primitive["indices"]).iter().map(|index| index[0] as usize).collect();
    let (first, second) = indices.split_at(indices.len() / 2);
    assert!(first.iter().all(|index| *index < 4) && second.iter().all(|index| 4 <= *index));
}
