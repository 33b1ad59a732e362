//! The GLB files of everything that the repository draws, read back from their bytes: what a viewer reads passes the gates too.

use std::collections::BTreeMap;
use std::fmt::Write;

use cga::sink::buffers::Buffers;
use cga::sink::gltf::Glb;
use cga::{Assets, Model, Settings, Shape, cga};
use cga_gates::{Finding, GlbSurvey, Look, Survey, back_faces, fights, holes, inside_out, report};

use super::PIXELS;
use super::fights::MOST;
use super::holes::open;

/// The sides from which files are drawn: azimuth and elevation in degrees. They are three of the sides from which models are drawn.
const SIDES: [[f64; 2]; 3] = [[13.0, 9.0], [133.0, 27.0], [253.0, 52.0]];

/// The triangles of a model whose image may be stretched: slivers of sidewalks at the inner side of corners.
fn bent(name: &str) -> usize {
    if name == "street" { 6 } else { 0 }
}

/// A GLB file as the gates see it.
struct WrittenFile {
    name: String,
    glb: GlbSurvey,
    looks: Vec<Look>,
}

impl WrittenFile {
    fn new(name: &str, bytes: &[u8]) -> Self {
        let glb = GlbSurvey::of(bytes);
        let looks = SIDES.map(|[azimuth, elevation]| Look::of(&glb.survey, azimuth, elevation, PIXELS)).into();
        WrittenFile { name: name.to_owned(), glb, looks }
    }

    fn of(model: &Model) -> Self {
        Self::new("planted", &model.to_glb().expect("a file"))
    }

    /// The findings at triangles.
    fn at(&self, triangles: &[u32]) -> Vec<Finding> {
        let finding = |&number: &u32| {
            let triangle = &self.glb.survey.triangles[number as usize];
            Finding { parts: vec![triangle.part], place: triangle.corners[0], side: None }
        };
        triangles.iter().map(finding).collect()
    }

    /// The findings of each gate, with its name and with the number that is allowed.
    fn findings(&self) -> [(&'static str, usize, Vec<Finding>); 6] {
        let (survey, looks) = (&self.glb.survey, &self.looks);
        [
            ("inside out", 0, inside_out(survey)),
            ("back faces", 0, back_faces(survey, looks)),
            ("holes", 0, holes(survey, looks, open(&self.name))),
            ("fights", MOST, fights(survey, looks)),
            ("turned normals", 0, self.at(&self.glb.turned_normals)),
            ("stretched textures", bent(&self.name), self.at(&self.glb.stretched_textures)),
        ]
    }

    /// The findings beyond the allowed numbers, as text. Empty for a good file.
    fn report(&self) -> String {
        let mut text = String::new();
        for (gate, most, found) in self.findings() {
            if most < found.len() {
                let _ = write!(text, "{}: {gate}: {}\n{}", self.name, found.len(), report(&self.glb.survey, &found));
            }
        }
        text
    }
}

/// The number of triangles of each building, sorted. Buildings in each other are found in the models.
fn by_building(survey: &Survey) -> Vec<usize> {
    let mut counts = BTreeMap::new();
    for triangle in &survey.triangles {
        *counts.entry(survey.parts[triangle.part as usize].building).or_insert(0) += 1;
    }
    let mut counts: Vec<usize> = counts.into_values().collect();
    counts.sort_unstable();
    counts
}

#[test]
fn the_files_of_all_models_pass_the_gates() {
    let (mut text, mut textured, mut images) = (String::new(), 0, 0);
    for surveyed in super::all() {
        let file = WrittenFile::new(&surveyed.drawn.name, &surveyed.file);
        let [triangles, own] = [&file.glb.survey, &surveyed.survey].map(by_building);
        // Houses in the masses are buildings of their own for the gates alone.
        let is_same = match super::units(&file.name) {
            [] => triangles == own,
            _ => triangles.iter().sum::<usize>() == own.iter().sum::<usize>(),
        };
        if !is_same {
            let _ = writeln!(text, "{}: {triangles:?} triangles in the file, and {own:?} in the model", file.name);
        }
        textured += usize::from(0 < file.glb.textured_materials);
        images += usize::from(0 < file.glb.embedded_images);
        text += &file.report();
    }
    assert!(text.is_empty(), "{text}");
    // The scenes of the gallery and the textured example have images in their files.
    assert!(10 < textured && 10 < images, "{textured} files show images, and {images} have some");
}

cga! {
    /// A turned shed, a window without reveals, a wall with a slit, a sign in its wall, and a block with an image from above on its sides.
    grammar Faulty;
    TurnedShed --> extrude(2) reverseNormals Box.
    OpenWindow --> extrude(6) comp(f) { front : split(x) { ~1 : Wall. | 3 : t(0, 0, -0.8) Glass. | ~1 : Wall. } | all : Wall. }
    Slit       --> s(^1, 8, 0.01) primitiveCube split(x) { ~1 : Wall. | 0.1 : split(y) { 2 : Wall. | ~1 : NIL | 2 : Wall. } | ~1 : Wall. }
    SignedWall --> extrude(6) comp(f) { front : [ Wall. ] s(^0.5, ^0.5, 0) center(xy) color("#a04030") Sign. | all : Wall. }
    Streaked   --> setupProjection(0, world.xz, 2, 2) extrude(3) texture("builtin:uvtest.png") projectUV(0) Block.
}

cga! {
    /// A house with images on its walls, a ball of a smooth mesh, and parts that repeat.
    grammar Bricks;
    Lot    --> [ extrude(6) comp(f) { side : Facade | top : roofHip(30) color("#803020") Roof. | all : Base. } ]
               t(^1.2, 0, 0) s(3, 3, 3) primitiveSphere(8, 6) Ball.
    Facade --> setupProjection(0, scope.xy, 1, 1) split(y) { { ~3 : split(x) { { ~2 : Wall }* } }* }
    Wall   --> projectUV(0) texture("builtin:uvtest.png") Wall.
}

fn faulty(start: &str) -> WrittenFile {
    let lot = Shape::rectangle(10.0, 8.0).start(start);
    let model = Faulty::default().generate_with(&lot, &Settings::default()).expect("a model");
    WrittenFile::of(&model.with_assets(Assets::default().into()))
}

#[test]
fn planted_errors_in_files_are_found() {
    let planted = [
        ("TurnedShed", "inside out", "Box\n"),
        ("OpenWindow", "back faces", "Wall\n"),
        ("Slit", "holes", "Wall  beside  Wall\n"),
        ("SignedWall", "fights", "Sign\n"),
        ("Streaked", "stretched textures", "Block\n"),
    ];
    for (start, gate, rules) in planted {
        let text = faulty(start).report();
        assert!(text.contains(&format!("planted: {gate}: ")) && text.contains(rules), "{start}: {text}");
    }
}

fn bricks() -> Model {
    let model = Bricks::default().generate_with(&Shape::rectangle(10.0, 8.0), &Settings::default()).expect("a model");
    model.with_assets(Assets::default().into())
}

/// The file of a model with other numbers in the first accessor of an attribute.
fn changed(model: &Model, attribute: &str, change: impl Fn(f32) -> f32) -> WrittenFile {
    let mut bytes = model.to_glb().expect("a file");
    let word = |bytes: &[u8], at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("a word"));
    let length = word(&bytes, 12) as usize;
    let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + length]).expect("a description");
    let mut primitives = json["meshes"][0]["primitives"].as_array().expect("primitives").iter();
    let accessor = primitives.find_map(|own| own["attributes"][attribute].as_u64()).expect("the attribute");
    let view =
        &json["bufferViews"][json["accessors"][accessor as usize]["bufferView"].as_u64().expect("a view") as usize];
    let [start, size] = ["byteOffset", "byteLength"].map(|name| view[name].as_u64().unwrap_or(0) as usize);
    for at in (28 + length + start..28 + length + start + size).step_by(4) {
        let number = f32::from_bits(word(&bytes, at));
        bytes[at..at + 4].copy_from_slice(&change(number).to_le_bytes());
    }
    WrittenFile::new("planted", &bytes)
}

#[test]
fn planted_errors_in_bytes_are_found() {
    let model = bricks();
    assert_eq!(WrittenFile::of(&model).report(), "");
    for (attribute, gate, change) in [
        ("NORMAL", "turned normals", (|number| -number) as fn(f32) -> f32),
        ("TEXCOORD_0", "stretched textures", |_| 0.25),
    ] {
        let text = changed(&model, attribute, change).report();
        assert!(text.starts_with(&format!("planted: {gate}: ")) && text.contains("Wall\n"), "{text}");
    }
    // A mirrored file shows its inside.
    let text = changed(&model, "POSITION", |number| -number).report();
    assert!(text.contains("planted: back faces: ") && text.contains("Ball\n"), "{text}");
}

#[test]
fn files_of_every_kind_pass_the_gates() {
    let model = bricks();
    let replayed = |mut glb: Glb| {
        let _ = model.replay(&mut glb);
        glb.into_bytes().expect("a file")
    };
    let mut instances = Glb::new().with_instances();
    let lot = Shape::rectangle(10.0, 8.0);
    Bricks::default().run(&lot, &Settings::default(), &mut instances).expect("no limit");
    let mut buffers = Buffers::new();
    let _ = model.replay(&mut buffers);
    let files = [
        ("plain", model.to_glb().expect("a file")),
        ("by rule", replayed(Glb::new().by_rule())),
        ("by building", replayed(Glb::new().by_building())),
        ("single sided", replayed(Glb::new().with_single_sided_solids())),
        ("quantized", replayed(Glb::new().with_quantization(0.001))),
        ("instances", instances.into_bytes().expect("a file")),
        ("buffers", buffers.to_glb().expect("a file")),
        ("watertight", model.watertight().to_glb().expect("a file")),
    ];
    let triangles = model.triangle_count();
    for (name, bytes) in files {
        let file = WrittenFile::new(name, &bytes);
        assert_eq!(file.report(), "");
        let own = file.glb.survey.triangles.len();
        assert!(own == triangles || name == "watertight" && triangles < own, "{name}: {own} and {triangles}");
    }
}
