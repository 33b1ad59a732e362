//! The grammars of the example programs, with the shapes that the programs run them on.

use std::sync::Arc;

use cga::Assets;
use cga::sink::picture::Image;
use cga::street::{Network, NetworkOptions};

use crate::entry::CatalogEntry;
use crate::programs::{district, massing, streets, textured, tower};
use crate::scenes::scene::{Scene, Start, View, grammar_text};

/// The grammars, in the order of the menu.
pub(crate) fn entries() -> Vec<CatalogEntry> {
    vec![office_tower(), district(), massing(), street_network(), brick_tower(), marked_streets()]
}

fn office_tower() -> CatalogEntry {
    CatalogEntry::new(Scene {
        name: "office_tower",
        title: "Office tower",
        sentence: "From `examples/tower.rs`: the outline decides how many bays a storey has, and every window has frames and glass.",
        rules: grammar_text(include_str!("../../../examples/tower.rs")),
        grammar: Box::new(tower::Tower::default()),
        shapes: vec![Start::new("Lot", tower::lot().expect("the outline is simple"))],
        view: View { azimuth: 34.0, elevation: 12.0, ..View::default() },
    })
}

fn district() -> CatalogEntry {
    let (footprints, _) = district::read(district::SAMPLE).expect("the sample is GeoJSON");
    // The last outline of the sample has no area.
    let lots = footprints
        .iter()
        .enumerate()
        .filter_map(|(number, footprint)| Some(Start::new(footprint.start, footprint.lot(number).ok()?)));
    CatalogEntry::new(Scene {
        name: "district",
        title: "District",
        sentence: "From `examples/district.rs`: one grammar for any outline; its area and its holes decide the form of the roof. Party walls have no windows, and shops face the street.",
        rules: grammar_text(include_str!("../../../examples/district.rs")),
        grammar: Box::new(district::House { neighbours: true, ..district::House::default() }),
        shapes: lots.collect(),
        view: View { azimuth: 28.0, elevation: 32.0, ..View::default() },
    })
}

fn massing() -> CatalogEntry {
    CatalogEntry::new(Scene {
        name: "massing",
        title: "Ten masses",
        sentence: "From `examples/massing.rs`: ten lots of one size, each with a start rule of its own.",
        rules: grammar_text(include_str!("../../../examples/massing.rs")),
        grammar: Box::new(massing::Massing::default()),
        shapes: massing::lots().map(|(rule, lot)| Start::new(rule, lot)).collect(),
        view: View { azimuth: -28.0, elevation: 32.0, ..View::default() },
    })
}

fn street_network() -> CatalogEntry {
    let (lines, _) = streets::read(streets::SAMPLE).expect("the sample is GeoJSON");
    let network = Network::new(&lines, &NetworkOptions::default()).expect("the sample is a network");
    CatalogEntry::new(Scene {
        name: "street_network",
        title: "Street network",
        sentence: "From `examples/streets.rs`: the library lays out a network of centre lines, and five rules colour its parts.",
        rules: grammar_text(include_str!("../../../examples/streets.rs")),
        grammar: Box::new(streets::Streets::default()),
        shapes: starts(&network),
        view: View { azimuth: 20.0, elevation: 60.0, ..View::default() },
    })
}

fn brick_tower() -> CatalogEntry {
    let lot = textured::lot().expect("the outline is simple");
    let scene = Scene {
        name: "brick_tower",
        title: "Brick tower",
        sentence: "From `examples/textured.rs`: the bricks of a facade continue around its windows, and each window has an image of its own.",
        rules: grammar_text(include_str!("../../../examples/textured.rs")),
        grammar: Box::new(textured::Tower::default()),
        shapes: vec![Start::new("Lot", lot)],
        view: View { azimuth: 26.0, elevation: 14.0, ..View::default() },
    };
    CatalogEntry::with_assets(scene, images)
}

fn marked_streets() -> CatalogEntry {
    // The second grammar of the program.
    let (_, rules) = include_str!("../../../examples/textured.rs").rsplit_once("cga! {\n").unwrap_or_default();
    let scene = Scene {
        name: "marked_streets",
        title: "Marked streets",
        sentence: "From `examples/textured.rs`: lines and zebra crossings are splits along the texture coordinates of a street.",
        rules: grammar_text(rules),
        grammar: Box::new(textured::Streets::default()),
        shapes: starts(&textured::network().expect("the lines are a network")),
        view: View { azimuth: 26.0, elevation: 40.0, ..View::default() },
    };
    CatalogEntry::with_assets(scene, images)
}

/// The parts of a network with their start rules.
fn starts(network: &Network) -> Vec<Start> {
    network.parts().iter().map(|part| Start::new(part.start_rule(), part.shape())).collect()
}

/// The images of `examples/textured.rs`, as its folder would have them.
fn images() -> Arc<Assets> {
    let file = |(name, image): (&'static str, Image)| (name, image.to_png().expect("a small image"));
    let files: Vec<_> = textured::images().into_iter().map(file).collect();
    Arc::new(Assets::from_source(files))
}
