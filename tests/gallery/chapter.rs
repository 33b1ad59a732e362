//! The chapters of the gallery: the examples of some pages of the reference, and their text.

use std::fmt::Write;

use cga::{Model, Settings};

use super::captions::{heights, lengths, numbered};
use super::cell::{Cell, area_cell, camera, cell, comp_cell, row};
use super::same;
use super::textured;
use crate::pages::example::Example;
use crate::pages::{self, assets, cutting, meshes};

/// A page of the gallery.
pub struct Chapter {
    /// The name of its file and of the folder of its pictures.
    pub name: &'static str,
    pub title: &'static str,
    /// The pages of the reference, without `.html`.
    pub sources: &'static [&'static str],
    pub cells: Vec<Cell>,
}

/// Where the pages of the reference are.
const REFERENCE: &str = "https://esri.github.io/cityengine-sdk/html/cgaref/cgareference";

/// All chapters. The examples run.
pub fn chapters() -> Vec<Chapter> {
    let (plain, with_meshes) = (Settings::default(), assets::settings());
    let each = |examples: &[Example]| -> Vec<Cell> {
        examples.iter().map(|example| comp_cell(example, &with_meshes)).collect()
    };
    let rows = |examples: &[Example], view| -> Vec<Cell> {
        examples.iter().map(|example| cell(example, &plain, view, lengths)).collect()
    };
    let chapter = |name, title, sources, cells| Chapter { name, title, sources, cells };
    let split_attribute = pages::split_attribute::ALL.iter().zip([numbered as fn(&Model) -> String, heights]);
    vec![
        chapter("split", "Splits of a box", &["op_split"], rows(pages::split_operation::ALL, row(10.0, 3.0, 1.0))),
        chapter(
            "subdivision-once",
            "Sizes of parts",
            &["cga_subdivision_split"],
            rows(pages::subdivision_once::ALL, row(5.0, 2.0, 1.0)),
        ),
        chapter(
            "subdivision-repeat",
            "Patterns that repeat",
            &["cga_subdivision_split"],
            rows(pages::subdivision_repeat::ALL, row(10.0, 3.0, 1.0)),
        ),
        chapter(
            "split-attribute",
            "Index and number of parts",
            &["attr_split"],
            split_attribute
                .map(|(example, measured)| cell(example, &plain, camera(example.model(&plain).bounds()), measured))
                .collect(),
        ),
        chapter(
            "split-area",
            "Splits by area",
            &["op_splitarea"],
            pages::split_area::ALL.iter().map(|example| area_cell(example, &plain)).collect(),
        ),
        chapter(
            "scope",
            "Scopes and pivots",
            &[
                "op_t",
                "op_r",
                "op_s",
                "op_center",
                "op_pushpop",
                "op_translate",
                "op_rotate",
                "op_rotateScope",
                "op_mirrorScope",
                "op_alignScopeToAxes",
                "op_alignScopeToGeometry",
                "op_setPivot",
            ],
            each(pages::scope::ALL),
        ),
        chapter("cutting", "Cuts through geometry", &["op_split"], cut()),
        chapter("comp", "Components by direction", &["op_comp"], each(pages::comp::ALL)),
        chapter("components", "Components", &["op_comp"], each(pages::components::ALL)),
        chapter("tags", "Tags", &["cga_componentTags", "op_settagsfromedgeattrs"], each(pages::tags::ALL)),
        chapter(
            "roofs",
            "Roofs",
            &["op_roofHip", "op_roofGable", "op_roofPyramid", "op_roofShed", "op_roofRidge"],
            each(pages::roofs::ALL),
        ),
        chapter(
            "setback",
            "Setbacks",
            &["op_setback", "op_setbackPerEdge", "op_setbackToArea"],
            each(pages::setback::ALL),
        ),
        chapter(
            "mass",
            "Envelopes, footprints, inner rectangles, wings",
            &["op_envelope", "op_footprint", "op_innerRectangle", "op_shapeLUO", "op_taper"],
            each(&[pages::mass::ALL, pages::wings::ALL].concat()),
        ),
        chapter("scatter", "Points", &["op_scatter"], each(pages::scattering::ALL)),
        chapter("inserting", "Inserted assets", &["op_i", "op_insertAlongUV"], each(pages::inserting::ALL)),
        chapter(
            "recompose",
            "Recomposed shapes",
            &["cga_shapeRecomposition", "op_modify"],
            each(pages::recompose::ALL),
        ),
        chapter("boolean", "Boolean operations", &["cga_booleanOperations"], each(pages::boolean::ALL)),
        chapter(
            "boolean-table",
            "All cases of boolean operations",
            &["cga_booleanOperations"],
            each(pages::boolean_table::ALL),
        ),
        chapter(
            "mesh-operations",
            "Operations on meshes",
            &["op_convexify", "op_deleteHoles"],
            each(pages::mesh_operations::ALL),
        ),
        chapter("normals", "Normals", &["op_setNormals", "op_softenNormals"], each(pages::normals::ALL)),
        chapter("cleanup", "Clean geometry", &["op_cleanupGeometry"], each(pages::cleanup::ALL)),
        chapter("texturing", "Texture coordinates", &["op_tileUV", "op_setupProjection"], textured::texturing(&plain)),
        chapter("primitives", "Primitives", &["op_primitive"], textured::primitives(&plain)),
    ]
}

/// The cylinder, and the same rules on a hollow cylinder.
fn cut() -> Vec<Cell> {
    let tube = assets::settings_with(meshes::lying_tube(cutting::SIDES, [0.3, 0.5], 4.0));
    let view = camera(cutting::cylinder::EXAMPLE.model(&assets::settings()).bounds());
    let solid = cutting::ALL.iter().map(|example| cell(example, &assets::settings(), view, lengths));
    let hollow = cell(&cutting::cylinder_cut::EXAMPLE, &tube, view, lengths);
    solid.chain([Cell { title: "The same on a hollow cylinder", ..hollow }]).collect()
}

impl Chapter {
    /// The path of a picture, from the folder of the gallery.
    pub fn picture(&self, cell: usize) -> String {
        format!("{}/{:02}.png", self.name, cell + 1)
    }

    /// The numbers of the cells with a picture of their own.
    pub fn drawn(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.cells.len()).filter(|cell| same::original(self.cells[*cell].title).is_none())
    }

    /// The page: beside each picture its rules, and below them what they give.
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}\n\n", self.title);
        let links = self.sources.iter().map(|source| format!("[{source}]({REFERENCE}/{source}.html)"));
        let _ = writeln!(
            text,
            "Examples of {} in Esri's reference. `cargo run --release -p cga-tests --example gallery` writes this page and its pictures,\nand `tests/documented` checks the rules.",
            links.collect::<Vec<_>>().join(", "),
        );
        for (number, cell) in self.cells.iter().enumerate() {
            let shown = match same::original(cell.title) {
                Some(original) => format!("The result looks as in <em>{}</em>.", escaped(original)),
                None => format!("<img src=\"{}\" alt=\"{}\">", self.picture(number), escaped(cell.title)),
            };
            let further = match cell.further {
                "" => String::new(),
                rules => format!(
                    "<details><summary>Rules of all examples</summary><pre>\n{}\n</pre></details>",
                    escaped(rules)
                ),
            };
            let _ = write!(
                text,
                "\n### {}\n\n<table><tr><td width=\"50%\">{shown}</td><td><pre>\n{}\n</pre>{further}{}</td></tr></table>\n",
                cell.title,
                escaped(cell.rules),
                escaped(&cell.measured),
            );
        }
        text
    }
}

/// The list of all chapters.
pub fn contents(chapters: &[Chapter]) -> String {
    let mut text = String::from(
        "# Gallery\n\n[Buildings and scenes](scenes.md): fourteen grammars of our own with large pictures, from a tower to a dungeon.\n\n[![Corner house](scenes/corner.png)](scenes.md#corner-house)\n[![Town houses](scenes/town_house.png)](scenes.md#town-houses)\n[![Bridge](scenes/bridge.png)](scenes.md#bridge)\n[![Courtyard block](scenes/courtyard.png)](scenes.md#courtyard-block)\n[![Street with junctions](scenes/street.png)](scenes.md#street-with-junctions)\n[![Dungeon](scenes/dungeon.png)](scenes.md#dungeon)\n\n## The examples of the reference\n\nThe worked examples of Esri's CGA reference, as this library draws them. `cargo run --release -p cga-tests --example gallery` writes\nthese pages and pictures.\n\n",
    );
    for chapter in chapters {
        let _ = writeln!(text, "- [{}]({}.md): {} examples", chapter.title, chapter.name, chapter.cells.len());
    }
    text
}

/// The text for HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
