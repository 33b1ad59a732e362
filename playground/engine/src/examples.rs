//! The grammars of the example programs, with the shapes that the programs run them on.

use std::sync::Arc;

use cga::sink::picture::Image;
use cga::street::{Network, NetworkOptions};
use cga::{Assets, Shape};

use crate::entry::CatalogEntry;
use crate::inline::rules_of;
use crate::programs::{district, massing, streets, textured, tower};
use crate::scenes::scene::{Scene, Start, View};

/// The grammars, in the order of the menu.
pub(crate) fn entries() -> Vec<CatalogEntry> {
    vec![house(), office_tower(), district(), massing(), street_network(), brick_tower(), marked_streets()]
}

fn house() -> CatalogEntry {
    let scene = Scene {
        name: "house",
        title: "Your own rules",
        sentence: "A small house to begin with. Type rules, choose a lot, or drop a GeoJSON or OBJ file on the page.",
        rules: include_str!("../house.cga").to_owned(),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::rectangle(20.0, 15.0))],
        view: View::default(),
    };
    CatalogEntry::new(scene, "House")
}

fn office_tower() -> CatalogEntry {
    let scene = Scene {
        name: "office_tower",
        title: "Office tower",
        sentence: "From `examples/tower.rs`: the outline decides how many bays a storey has, and every window has frames and glass.",
        rules: rules(include_str!("../../../examples/tower.rs"), "Tower"),
        grammar: (),
        shapes: vec![Start::new("Lot", tower::lot().expect("the outline is simple"))],
        view: View { azimuth: 34.0, elevation: 12.0, ..View::default() },
    };
    CatalogEntry::new(scene, "Tower")
}

fn district() -> CatalogEntry {
    let (footprints, _) = district::read(district::SAMPLE).expect("the sample is GeoJSON");
    // The last outline of the sample has no area.
    let lots = footprints
        .iter()
        .enumerate()
        .filter_map(|(number, footprint)| Some(Start::new(footprint.start, footprint.lot(number).ok()?)));
    let scene = Scene {
        name: "district",
        title: "District",
        sentence: "From `examples/district.rs`: one grammar for any outline; its area and its holes decide the form of the roof. Party walls have no windows, and shops face the street.",
        rules: rules(include_str!("../../../examples/district.rs"), "House"),
        grammar: (),
        shapes: lots.collect(),
        view: View { azimuth: 28.0, elevation: 32.0, ..View::default() },
    };
    CatalogEntry::new(scene, "House").with_values(r#"{ "neighbours": true }"#)
}

fn massing() -> CatalogEntry {
    let scene = Scene {
        name: "massing",
        title: "Ten masses",
        sentence: "From `examples/massing.rs`: ten lots of one size, each with a start rule of its own.",
        rules: rules(include_str!("../../../examples/massing.rs"), "Massing"),
        grammar: (),
        shapes: massing::lots().map(|(rule, lot)| Start::new(rule, lot)).collect(),
        view: View { azimuth: -28.0, elevation: 32.0, ..View::default() },
    };
    CatalogEntry::new(scene, "Massing")
}

fn street_network() -> CatalogEntry {
    let (lines, _) = streets::read(streets::SAMPLE).expect("the sample is GeoJSON");
    let network = Network::new(&lines, &NetworkOptions::default()).expect("the sample is a network");
    let scene = Scene {
        name: "street_network",
        title: "Street network",
        sentence: "From `examples/streets.rs`: the library lays out a network of centre lines, and five rules colour its parts.",
        rules: rules(include_str!("../../../examples/streets.rs"), "Streets"),
        grammar: (),
        shapes: starts(&network),
        view: View { azimuth: 20.0, elevation: 60.0, ..View::default() },
    };
    CatalogEntry::new(scene, "Streets")
}

fn brick_tower() -> CatalogEntry {
    let lot = textured::lot().expect("the outline is simple");
    let scene = Scene {
        name: "brick_tower",
        title: "Brick tower",
        sentence: "From `examples/textured.rs`: the bricks of a facade continue around its windows, and each window has an image of its own.",
        rules: rules(include_str!("../../../examples/textured.rs"), "Tower"),
        grammar: (),
        shapes: vec![Start::new("Lot", lot)],
        view: View { azimuth: 26.0, elevation: 14.0, ..View::default() },
    };
    CatalogEntry::new(scene, "Tower").with_assets(images)
}

fn marked_streets() -> CatalogEntry {
    let scene = Scene {
        name: "marked_streets",
        title: "Marked streets",
        sentence: "From `examples/textured.rs`: lines and zebra crossings are splits along the texture coordinates of a street.",
        rules: rules(include_str!("../../../examples/textured.rs"), "Streets"),
        grammar: (),
        shapes: starts(&textured::network().expect("the lines are a network")),
        view: View { azimuth: 26.0, elevation: 40.0, ..View::default() },
    };
    CatalogEntry::new(scene, "Streets").with_assets(images)
}

/// The rules of a grammar in the source file of a program.
fn rules(source: &str, grammar: &str) -> String {
    rules_of(source, grammar).expect("the program has the grammar")
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
