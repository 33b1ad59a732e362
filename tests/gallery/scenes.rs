//! The page of the scenes, and their pictures.

use std::fmt::Write;

use cga::mesh::Bounds;
use cga::sink::picture::{Camera, Image, Picture};
use cga::{Attribute, ChoiceValues, Model};

use crate::scenes::Scene;

/// The page: for each scene a picture, a sentence, the attributes and the rules.
pub fn markdown(scenes: &[(Scene, Model)]) -> String {
    let mut text = String::from(
        "# Buildings and scenes\n\nFourteen grammars of our own, each complete: copy one into `cga! { … }`, change a number and look at the result. `cargo run\n--release -p cga-tests --example gallery` writes this page and its pictures from the files in `examples/scenes`, and\n`tests/documented/scenes.rs` checks them.\n\nThe images of bricks, stone, roofs and plants are drawn by a program too, with relief: `cargo run --release --example materials`\nwrites them to `out/materials`, and their picture. Give them to a run with `Settings { assets: Assets::below(\"out/materials\").into(), ..Settings::default() }`.\n\n![The materials](materials.png)\n\n",
    );
    for (scene, _) in scenes {
        let _ = writeln!(text, "- [{}](#{})", scene.title, scene.title.to_lowercase().replace(' ', "-"));
    }
    for (scene, model) in scenes {
        let (title, picture) = (scene.title, picture_path(scene));
        let _ = write!(text, "\n## {title}\n\n![{title}]({picture})\n\n{} ", scene.sentence);
        let (parts, triangles) = (thousands(model.leaves().len()), thousands(model.triangle_count()));
        let _ = writeln!(text, "{parts} parts, {triangles} triangles.\n");
        text.push_str("| attribute | default | range | meaning |\n|---|---|---|---|\n");
        for attribute in ordered(scene.grammar.attributes()) {
            let default = scene.grammar.get(&attribute.name).map_or("random".to_owned(), |value| format!("`{value}`"));
            let (name, about) = (&attribute.name, attribute.about.replace('\n', " "));
            let _ = writeln!(text, "| `{name}` | {default} | {} | {about} |", limits(attribute));
        }
        let _ = write!(text, "\n```text\n{}\n```\n", scene.rules);
    }
    text
}

/// The path of a picture, from the folder of the gallery.
pub fn picture_path(scene: &Scene) -> String {
    format!("scenes/{}.png", scene.name)
}

/// The picture of a scene.
#[allow(dead_code, reason = "the test of the text draws nothing")]
pub fn picture(scene: &Scene, model: &Model) -> Image {
    let view = &scene.view;
    let region = view.region.map(|[low, high]| Bounds { low: low.into(), high: high.into() });
    let whole = Camera { margin: 0.04, centred: true, ..Camera::auto(region.unwrap_or_else(|| model.bounds())) };
    let camera = whole.looking_from(view.azimuth, view.elevation).field_of_view(view.field_of_view);
    let [width, height] = view.size;
    let mut picture = Picture::new(width, height).camera(camera);
    picture.samples = 3;
    picture.style.line_opacity = 0.3;
    (picture.sun_azimuth, picture.sun_elevation) = (view.sun_azimuth, view.sun_elevation);
    picture.render(model)
}

/// The attributes as panels show them: by groups and by their numbers in them.
fn ordered(attributes: &[Attribute]) -> Vec<&Attribute> {
    let mut list: Vec<_> = attributes.iter().filter(|attribute| !attribute.hidden).collect();
    let number = |order: Option<f64>| order.unwrap_or(f64::INFINITY);
    list.sort_by(|a, b| {
        let groups = number(a.group_order).total_cmp(&number(b.group_order));
        groups.then(number(a.order).total_cmp(&number(b.order)))
    });
    list
}

/// The values that an attribute may have.
fn limits(attribute: &Attribute) -> String {
    match (attribute.range, attribute.choices.as_ref().map(|choices| &choices.values)) {
        (Some(range), _) => format!("{} to {}", range.min, range.max),
        (None, Some(ChoiceValues::Texts(texts))) => texts.join(", "),
        _ => String::new(),
    }
}

/// A number with a comma before each third digit from the right.
fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let groups = digits.as_bytes().rchunks(3).rev().map(|group| String::from_utf8_lossy(group));
    groups.collect::<Vec<_>>().join(",")
}
