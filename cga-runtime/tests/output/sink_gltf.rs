//! GLB files, read back.

use std::sync::Arc;

use crate::sink_support::{Fill, color, front, hash, mixed, plate, steady, textured, tower, upright};
use cga_runtime::asset::gltf::read_gltf;
use cga_runtime::material::{Channel, Color, Material, MaterialNumber, MaterialText};
use cga_runtime::output::error::WriteError;
use cga_runtime::output::gltf::Glb;
use cga_runtime::output::model::Model;
use cga_runtime::run::sink::{Leaf, Sink};
use cga_runtime::shape::scope::Scope;
use cga_runtime::value::array::Array;
use cga_runtime::value::text::Text;
use glam::{DAffine3, DVec3, dvec3};

/// The description and the binary part, after checks of the container.
fn parts(file: &[u8]) -> (String, &[u8]) {
    let word = |at: usize| u32::from_le_bytes([file[at], file[at + 1], file[at + 2], file[at + 3]]) as usize;
    assert_eq!((&file[..4], word(4), word(8)), (&b"glTF"[..], 2, file.len()));
    let length = word(12);
    assert_eq!((&file[16..20], length % 4), (&b"JSON"[..], 0));
    let json = String::from_utf8(file[20..20 + length].to_vec()).expect("text");
    let rest = &file[20 + length..];
    if rest.is_empty() {
        return (json, rest);
    }
    assert_eq!((word(20 + length), &rest[4..8], rest.len() % 8), (rest.len() - 8, &b"BIN\0"[..], 0));
    assert_eq!((20 + length + 8) % 8, 0);
    (json, &rest[8..])
}

/// The first text between two marks.
fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let start = text.find(before).unwrap_or_else(|| panic!("no {before} in {text}")) + before.len();
    &text[start..start + text[start..].find(after).expect("an end")]
}

fn glb(model: &Model) -> Vec<u8> {
    model.to_glb().expect("a file")
}

#[test]
fn an_empty_model_is_a_scene_without_nodes() {
    let file = glb(&Model::new());
    let (json, binary) = parts(&file);
    assert_eq!(json.trim_end(), r#"{"asset":{"generator":"cga","version":"2.0"},"scene":0,"scenes":[{}]}"#);
    assert!(binary.is_empty());
}

#[test]
fn a_quad_has_positions_normals_rules_and_indices() {
    let mut fill = Fill(Model::new());
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(dvec3(1.0, 2.0, 3.0), 4.0, 5.0));
    let file = glb(&fill.0);
    let (json, binary) = parts(&file);
    assert_eq!(between(&json, "\"min\":[", "]"), "1,2,3");
    assert_eq!(between(&json, "\"max\":[", "]"), "5,7,3");
    assert_eq!(between(&json, "\"baseColorFactor\":[", "]"), "1,0,0,1");
    let words: Vec<u32> = binary[..24].chunks_exact(4).map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]])).collect();
    assert_eq!(words, [0, 1, 2, 0, 2, 3]);
    let float = |at: usize| f32::from_le_bytes([binary[at], binary[at + 1], binary[at + 2], binary[at + 3]]);
    assert_eq!([float(24), float(28), float(32)], [1.0, 2.0, 3.0]);
    assert!(binary.windows(4).any(|name| name == b"Wall"));
}

#[test]
fn looks_are_shared_and_rules_are_not_lost() {
    let mut fill = Fill(Model::new());
    fill.quad("A", &color(0.5, 0.5, 0.5), front(DVec3::ZERO, 1.0, 1.0));
    fill.quad("B", &color(0.5, 0.5, 0.5), front(DVec3::X, 1.0, 1.0));
    let clear = Material::with(|look| (look.color, look.opacity) = (Some(Color::new(0.5, 0.5, 0.5)), Some(0.5)));
    fill.cuboid("C", &Arc::new(clear), upright(DVec3::ZERO, DVec3::ONE));
    let file = glb(&fill.0);
    let (json, _) = parts(&file);
    assert_eq!(json.matches("\"POSITION\"").count(), 2);
    assert_eq!(json.matches("\"alphaMode\":\"BLEND\"").count(), 1);
    assert_eq!(json.matches("\"doubleSided\":true").count(), 2);
    assert_eq!(between(&json, "\"featureCount\":", ","), "3");
    assert!(between(&json, "\"baseColorFactor\":[", "]").starts_with("0.21404"));
}

#[test]
fn light_sides_and_alpha_modes_are_told_apart() {
    let mut fill = Fill(Model::new());
    let material = |change: &dyn Fn(&mut Material)| Arc::new(Material::with(|look| change(look)));
    let list = [
        material(&|_| {}),
        material(&|look| look.set_number(MaterialNumber::Emissive(Channel::B), 1.0)),
        material(&|look| look.double_sided = Some(false)),
        material(&|look| look.set_text(MaterialText::OpacityMode, "mask")),
        material(&|look| {
            look.set_text(MaterialText::OpacityMode, "mask");
            look.set_number(MaterialNumber::Cutoff, 0.25);
        }),
        material(&|look| {
            look.set_text(MaterialText::OpacityMode, "opaque");
            look.opacity = Some(0.5);
        }),
        // Attributes unknown to glTF do not make another look.
        material(&|look| look.set_number(MaterialNumber::Shininess, 3.0)),
    ];
    for material in &list {
        fill.quad("A", material, front(DVec3::ZERO, 1.0, 1.0));
    }
    let (json, _) = parts(&glb(&fill.0));
    assert_eq!(json.matches("\"pbrMetallicRoughness\"").count(), 6);
    assert_eq!(json.matches("\"emissiveFactor\":[0,0,1]").count(), 1);
    assert_eq!(json.matches("\"doubleSided\":false").count(), 1);
    assert_eq!(json.matches("\"alphaMode\":\"MASK\",\"alphaCutoff\":0.5").count(), 1);
    assert_eq!(json.matches("\"alphaCutoff\":0.25").count(), 1);
    assert_eq!(json.matches("BLEND").count(), 0);
}

#[test]
fn only_what_has_texture_coordinates_shows_a_texture() {
    let mut fill = Fill(Model::new());
    let brick = Arc::new(Material::with(|look| look.texture = Some("maps/brick wall.png".into())));
    fill.quad("Wall", &brick, front(DVec3::ZERO, 1.0, 1.0));
    fill.mesh("Sign", &brick, &textured(), DAffine3::IDENTITY);
    let file = glb(&fill.0);
    let (json, _) = parts(&file);
    assert_eq!(json.matches("\"baseColorTexture\"").count(), 1);
    assert_eq!(json.matches("\"TEXCOORD_0\"").count(), 1);
    assert_eq!(between(&json, "\"uri\":\"", "\""), "maps/brick%20wall.png");
}

#[test]
fn assets_inserted_often_are_stored_once() {
    let asset = plate();
    let sizes: Vec<usize> = [1, 2, 50]
        .into_iter()
        .map(|count| {
            let mut fill = Fill(Model::new());
            for i in 0..count {
                fill.instance("Tree", &Arc::default(), &asset, DAffine3::from_translation(DVec3::X * f64::from(i)));
            }
            glb(&fill.0).len()
        })
        .collect();
    assert!(sizes[2] - sizes[1] < 48 * 100, "{sizes:?}");
    // A mirrored instance would show its faces from the other side, so it is written out.
    let mut fill = Fill(Model::new());
    for scale in [1.0, 1.0, -1.0] {
        fill.instance("Tree", &Arc::default(), &asset, DAffine3::from_scale(dvec3(scale, 1.0, 1.0)));
    }
    assert_eq!(parts(&glb(&fill.0)).0.matches("\"matrix\"").count(), 2);
}

#[test]
fn a_model_far_away_is_stored_about_itself() {
    let mut fill = Fill(Model::new());
    let far = dvec3(512_345.0, 0.0, 5_400_000.0);
    fill.cuboid("Box", &color(1.0, 0.0, 0.0), upright(far, DVec3::splat(0.125)));
    let file = glb(&fill.0);
    let (json, _) = parts(&file);
    assert_eq!(between(&json, "\"translation\":[", "]"), "512345,0,5400000");
    assert_eq!(between(&json, "\"max\":[", "]"), "0.125,0.125,0.125");
}

#[test]
fn coordinates_that_are_no_floats_are_an_error() {
    let mut fill = Fill(Model::new());
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(dvec3(f64::NAN, 0.0, 0.0), 1.0, 1.0));
    assert!(matches!(fill.0.to_glb(), Err(WriteError::NotFinite)));
}

#[test]
fn the_same_model_gives_the_same_bytes() {
    assert_eq!(glb(&mixed()), glb(&mixed()));
    let file = glb(&steady());
    assert_eq!((file.len(), hash(&file)), (43496, 0xc99b_9766_fc3c_363e));
}

/// Writes files for other programs if a folder is given.
#[test]
fn samples_are_written_when_asked_for() {
    let Ok(folder) = std::env::var("CGA_WRITE_SAMPLES") else { return };
    let mut quad = Fill(Model::new());
    quad.quad("Wall", &color(1.0, 0.0, 0.0), front(DVec3::ZERO, 4.0, 5.0));
    let mut flat = Fill(Model::new());
    flat.cuboid("Flat", &color(1.0, 0.0, 0.0), upright(DVec3::ZERO, dvec3(1.0, 0.0, 1.0)));
    flat.quad("Line", &color(1.0, 0.0, 0.0), front(DVec3::ZERO, 0.0, 1.0));
    let samples =
        [("empty", Model::new()), ("quad", quad.0), ("flat", flat.0), ("mixed", mixed()), ("tower", tower(100))];
    for (name, model) in samples {
        model.write_glb(format!("{folder}/{name}.glb")).expect("a writable folder");
    }
}

/// The description as JSON.
fn description(file: &[u8]) -> serde_json::Value {
    serde_json::from_str(&parts(file).0).expect("JSON")
}

/// A file of a model, by rule.
fn by_rule(model: &Model) -> Vec<u8> {
    let mut glb = Glb::new().named("Tower \"A\"").by_rule();
    assert!(model.replay(&mut glb).is_continue());
    let glb = glb
        .with_extra("height", 24.0)
        .with_extra("walls", Array::from(vec![Text::from("brick"), Text::from("st\"one")]))
        .with_extra("slope", f64::NAN);
    glb.into_bytes().expect("a file")
}

#[test]
fn rules_can_be_nodes_with_the_same_triangles() {
    for model in [mixed(), steady(), tower(3)] {
        let (plain, file) = (glb(&model), by_rule(&model));
        let json = description(&file);
        let root = &json["nodes"][0];
        assert_eq!(root["name"], "Tower \"A\"");
        assert_eq!(root["extras"]["height"], 24);
        assert_eq!(root["extras"]["walls"][1], "st\"one");
        assert!(root["extras"]["slope"].is_null() && root["mesh"].is_null());
        let nodes: Vec<&str> = json["nodes"].as_array().expect("nodes")[1..]
            .iter()
            .map(|node| node["name"].as_str().expect("a name"))
            .collect();
        assert!(model.rules().iter().all(|rule| nodes.contains(&rule.as_str())), "{nodes:?}");
        assert!(!json.to_string().contains("EXT_mesh_features") && file.len() < plain.len() + 4000);
        let read = |bytes: &[u8]| read_gltf(bytes, &mut |_| None).expect("it was written by us").mesh;
        let (plain, own) = (read(&plain), read(&file));
        assert_eq!(own.face_count(), plain.face_count());
        assert!((own.area() - plain.area()).abs() < 1e-9 * own.area());
        assert!((own.area() - model.area()).abs() < 1e-4 * own.area());
        // The groups of the file are the rules.
        assert!(own.groups().iter().all(|group| model.rules().iter().any(|rule| rule.is(group))));
    }
}

#[test]
fn meshes_and_nodes_have_names() {
    let json = description(&glb(&mixed()));
    assert_eq!((&json["nodes"][0]["name"], &json["meshes"][0]["name"]), (&"model".into(), &"model".into()));
    // The asset is stored once, at three places.
    assert_eq!((&json["nodes"][1]["name"], &json["meshes"][1]["name"]), (&"Bench".into(), &"Bench".into()));
}

#[test]
fn a_placement_beyond_the_range_of_readers_is_an_error() {
    let material = color(1.0, 0.0, 0.0);
    for (origin, size) in [(1e39, 0.0), (0.0, 1e39)] {
        let scope = Scope { origin: DVec3::splat(origin), ..Scope::new(DVec3::splat(size)) };
        let mut glb = Glb::new().with_placements();
        assert!(glb.placement(&Leaf::new(&Text::fixed("Lamp"), &material, &scope)).is_continue());
        assert!(matches!(glb.into_bytes(), Err(WriteError::NotFinite)), "{origin} {size}");
    }
}
