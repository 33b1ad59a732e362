//! The scenes of the gallery: their page, and what their rules make.

use std::fs;
use std::ops::RangeInclusive;

use cga::{Attribute, ChoiceValues, Model, Value, ValueType};
use cga_gates::GlbFile;
use cga_tests::gallery::scenes as scene_page;
use cga_tests::scenes::{Scene, materials, scenes};
use cga_tests::tree::root;

use super::gallery;

/// The bounds of a scene, and the rules whose parts are closed solids.
struct Expected {
    name: &'static str,
    parts: RangeInclusive<usize>,
    triangles: RangeInclusive<usize>,
    closed: &'static [&'static str],
}

#[rustfmt::skip]
const EXPECTED: [Expected; 14] = [
    Expected { name: "tower", parts: 6_000..=9_000, triangles: 70_000..=110_000, closed: &["Slab", "Railing", "Fin", "Mullion", "Column", "Plant", "Mast", "Screen", "Paving"] },
    Expected { name: "town_house", parts: 1_800..=3_000, triangles: 15_000..=26_000, closed: &["Base", "Band", "Sill", "Lintel", "Keystone", "Frame", "Door", "Step", "Cornice", "Bracket", "Coping", "Kerb", "Bar", "Shrub"] },
    Expected { name: "corner", parts: 3_000..=6_000, triangles: 25_000..=45_000, closed: &["Ledge", "Bracket", "Band", "Slab", "Rail", "Bar", "Frame", "Timber", "Sign", "Cloth", "Kerb", "Pole", "Chimney", "Pot"] },
    Expected { name: "courtyard", parts: 9_000..=15_000, triangles: 60_000..=110_000, closed: &["Cornice", "Shutter", "Sill", "Frame", "Chimney", "Skylight", "Lawn", "Gravel", "Crown", "Trunk"] },
    Expected { name: "stadium", parts: 11_000..=14_000, triangles: 30_000..=40_000, closed: &["Band", "Pier", "Rim", "Column", "Plaza"] },
    Expected { name: "bridge", parts: 1_000..=2_000, triangles: 35_000..=60_000, closed: &["Voussoirs", "Cutwater", "Cap", "Pilaster", "Slab", "Baluster", "Water"] },
    Expected { name: "temple", parts: 450..=700, triangles: 13_000..=18_000, closed: &["Step", "Shaft", "Echinus", "Abacus", "Architrave", "Cornice", "Glyph", "Tiles", "Geison"] },
    Expected { name: "street", parts: 5_000..=9_000, triangles: 60_000..=100_000, closed: &["Pavement", "Body", "Cabin", "Wheels", "Pole", "Crown", "Band", "Sign", "Lawn"] },
    Expected { name: "skyline", parts: 3_500..=5_500, triangles: 60_000..=95_000, closed: &["Ground", "Pavement", "Glass", "Joint", "Windows", "Spandrel", "End", "Top", "Crown", "Needle"] },
    Expected { name: "interior", parts: 600..=950, triangles: 9_000..=16_000, closed: &["Slab", "Board", "Wall", "Frame", "Fold", "Cushion", "Leg", "Top", "Book", "Turned", "Leaf", "Paint"] },
    Expected { name: "fence", parts: 950..=1_400, triangles: 28_000..=42_000, closed: &["Post", "Bar", "Rail", "Slat", "Plank", "Coping", "Ball", "Point", "Hedge", "Leaves", "Trunk", "Stile"] },
    Expected { name: "pavilion", parts: 600..=1_300, triangles: 10_000..=25_000, closed: &["Podium", "Slab", "Plate", "Roof", "Glass", "Bar", "Marble", "Tread", "Basin", "Crown"] },
    Expected { name: "park", parts: 700..=1_400, triangles: 32_000..=48_000, closed: &["Lawn", "Kerb", "Trunk", "Needles", "Crown", "Water", "Rim", "Basin", "Jet", "Slat", "Shrub", "Flower"] },
    Expected { name: "dungeon", parts: 600..=1_300, triangles: 8_000..=20_000, closed: &["Post", "Lintel", "Pole", "Bowl", "Flame", "Dais", "Chest", "Coin", "Rim", "Water", "Tomb", "Slab", "Base", "Pillar", "Board", "Bench", "Leg"] },
];

/// The largest picture in bytes.
const LARGEST: u64 = 400_000;

fn model(scene: &Scene) -> Model {
    scene.model().unwrap_or_else(|error| panic!("{}: {error}", scene.name))
}

/// The page shows the rules of today. `CGA_BLESS=1` writes the text.
#[test]
fn the_page_shows_these_scenes() {
    let list: Vec<_> = scenes().into_iter().map(|scene| (model(&scene), scene)).map(|(m, s)| (s, m)).collect();
    let (path, text) = (gallery().join("scenes.md"), scene_page::markdown(&list));
    if std::env::var_os("CGA_BLESS").is_some() {
        fs::write(&path, &text).expect("the page");
    }
    let now = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        now == text,
        "`cargo run --release -p cga-tests --example gallery -- scenes` writes docs/gallery/scenes.md again"
    );
    for (scene, _) in &list {
        let picture = fs::read(gallery().join(scene_page::picture_path(scene))).expect("a picture");
        assert!((picture.len() as u64) <= LARGEST, "{}: {} bytes", scene.name, picture.len());
        // The width and the height follow the head of the first block.
        let side = |at: usize| u32::from_be_bytes([0, 1, 2, 3].map(|byte| picture[at + byte])) as usize;
        assert_eq!([side(16), side(20)], scene.view.size, "{}", scene.name);
    }
    let pictures = fs::read_dir(gallery().join("scenes")).expect("the pictures").count();
    assert_eq!(pictures, list.len(), "the folder has pictures of other scenes");
}

#[test]
fn each_file_is_a_scene_with_its_own_rules() {
    let folder = root().join("examples/scenes");
    let mut files: Vec<String> = fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("a file").file_name().to_string_lossy().replace(".rs", ""))
        .filter(|name| name != "mod" && name != "scene")
        .collect();
    files.sort_unstable();
    let mut names: Vec<&str> = scenes().iter().map(|scene| scene.name).collect();
    let expected: Vec<&str> = EXPECTED.iter().map(|expected| expected.name).collect();
    assert_eq!(names, expected);
    names.sort_unstable();
    assert_eq!(files, names);
    for scene in scenes() {
        let header = format!("pub grammar {};", scene.grammar.name());
        assert!(scene.rules.contains(&header) && scene.rules.contains("-->"), "{}", scene.name);
        assert!(!scene.rules.contains("\n    @"), "{}: the indentation is removed", scene.name);
    }
}

#[test]
fn scenes_have_the_expected_sizes_and_no_faults() {
    for (scene, expected) in scenes().iter().zip(EXPECTED) {
        let (name, model) = (scene.name, model(scene));
        assert!(model.faults().is_empty(), "{name}: {:?}", model.faults());
        let (parts, triangles) = (model.leaves().len(), model.triangle_count());
        assert!(expected.parts.contains(&parts), "{name}: {parts} parts");
        assert!(expected.triangles.contains(&triangles), "{name}: {triangles} triangles");
    }
}

/// A material continues at its borders: two places on both sides of a border, in two copies of the image, look alike.
#[test]
fn materials_continue_at_their_borders() {
    const NEAR: f64 = 1e-7;
    for (name, surface) in materials::surfaces() {
        for step in 0..200 {
            let along = (f64::from(step) + 0.37) / 200.0;
            for sides in [[[NEAR, along], [1.0 - NEAR, along]], [[along, NEAR], [along, 1.0 - NEAR]]] {
                let [a, b] = sides.map(|place| (surface.texel)(place, ""));
                let colors = a.color.into_iter().zip(b.color).map(|(a, b)| (a - b).abs());
                let differences = colors.chain([(a.height - b.height).abs(), (a.rough - b.rough).abs()]);
                assert!(differences.fold(0.0, f64::max) < 0.01, "{name} at {sides:?}");
            }
        }
    }
}

/// Joints, worn faces and single stones differ in roughness.
#[test]
fn the_roughness_of_masonry_and_roofs_varies() {
    let names = ["brick", "stone", "paving", "tile", "slate", "asphalt"];
    for (name, surface) in materials::surfaces().filter(|(name, _)| names.contains(name)) {
        let places = (0..400).map(|step| [f64::from(step % 20) / 20.0 + 0.013, f64::from(step / 20) / 20.0 + 0.017]);
        let rough = places.map(|place| (surface.texel)(place, "").rough);
        let (least, most) = rough.fold((1.0_f64, 0.0_f64), |(least, most), own| (least.min(own), most.max(own)));
        assert!(0.1 < most - least && 0.2 < least && most <= 1.0, "{name}: {least} to {most}");
    }
}

/// A viewer of the files sees colour, relief and roughness of one material.
#[test]
fn files_have_maps_of_relief_and_roughness() {
    let names = ["tower", "town_house", "corner", "courtyard", "bridge", "temple", "street", "dungeon"];
    for scene in scenes().iter().filter(|scene| names.contains(&scene.name)) {
        let file = GlbFile::new(&model(scene).to_glb().expect("a file"));
        let materials = file.json["materials"].as_array().expect("materials");
        let has_all = |material: &&serde_json::Value| {
            let pbr = &material["pbrMetallicRoughness"];
            let maps = [&pbr["baseColorTexture"], &pbr["metallicRoughnessTexture"], &material["normalTexture"]];
            maps.iter().all(|map| map.is_object())
        };
        assert!(0 < materials.iter().filter(has_all).count(), "{}", scene.name);
    }
}

#[test]
fn solids_are_closed() {
    for (scene, expected) in scenes().iter().zip(EXPECTED) {
        let model = model(scene);
        for rule in expected.closed {
            assert!(0 < model.count(rule), "{}: no {rule}", scene.name);
            let open = model.leaves_of(rule).filter(|leaf| !leaf.mesh().0.is_closed()).count();
            assert_eq!(open, 0, "{}: {rule} is open", scene.name);
        }
    }
}

/// The model with other values of attributes, which has parts and no faults.
fn made(scene: &mut Scene, values: &[(&str, Value)]) -> Model {
    let text = format!("{}: {values:?}", scene.name);
    for (name, value) in values {
        scene.grammar.set(name, value.clone()).unwrap_or_else(|error| panic!("{text}: {error}"));
    }
    let model = scene.model().unwrap_or_else(|error| panic!("{text}: {error}"));
    values.iter().for_each(|(name, _)| scene.grammar.reset(name).expect("an attribute"));
    assert!(!model.is_empty() && model.faults().is_empty(), "{text}: {:?}", model.faults());
    model
}

/// The values to try for an attribute: the ends of its range, all choices, or values unlike the default.
fn values(attribute: &Attribute) -> Vec<Value> {
    let texts = |texts: &[cga::Text]| texts.iter().map(|text| Value::Text(text.clone())).collect();
    match (attribute.range, attribute.choices.as_ref().map(|choices| &choices.values), attribute.ty) {
        (Some(range), ..) => vec![Value::Float(range.min), Value::Float(range.max)],
        (None, Some(ChoiceValues::Texts(choices)), _) => texts(choices),
        (None, None, ValueType::Bool) => vec![Value::Bool(true), Value::Bool(false)],
        (None, None, ValueType::Text) => texts(&["#123456".into()]),
        _ => panic!("{} has neither a range nor choices", attribute.name),
    }
}

/// Returns true if two models are the same, to the byte. Files are compared only if the numbers of parts are equal.
fn alike(a: &Model, b: &Model) -> bool {
    let file = |model: &Model| model.to_glb().expect("a file");
    a.leaves().len() == b.leaves().len() && a.triangle_count() == b.triangle_count() && file(a) == file(b)
}

/// Two tests, so that two cores share the work.
#[test]
fn attributes_have_a_group_change_the_scene_and_work_at_the_ends_of_their_ranges() {
    attributes_work(0);
}

#[test]
fn attributes_of_the_other_scenes_work_too() {
    attributes_work(1);
}

/// Checks one half of the scenes: every second one. Each attribute alone changes the scene, and the scene works with all of them
/// at one end.
fn attributes_work(half: usize) {
    for mut scene in scenes().into_iter().skip(half).step_by(2) {
        let before = model(&scene);
        let attributes = scene.grammar.attributes().to_vec();
        for attribute in &attributes {
            let name = attribute.name.as_str();
            assert!(!attribute.group.is_empty(), "{}: {name} has no group", scene.name);
            let differs = values(attribute).into_iter().any(|value| {
                let changed = made(&mut scene, &[(name, value)]);
                !alike(&changed, &before)
            });
            assert!(differs, "{}: {name} changes nothing", scene.name);
        }
        for end in [<[Value]>::first, <[Value]>::last] {
            let all: Vec<_> = attributes
                .iter()
                .filter_map(|attribute| Some((attribute.name.as_str(), end(&values(attribute))?.clone())))
                .collect();
            made(&mut scene, &all);
        }
    }
}
