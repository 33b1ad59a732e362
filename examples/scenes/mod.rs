//! Buildings and scenes with rules of our own, each in a file of its own. `examples/gallery.rs` draws them. Nothing here
//! draws or reads files, so the scenes also run in a browser.

mod bridge;
mod corner;
mod courtyard;
mod dungeon;
mod fence;
mod interior;
#[path = "../materials/mod.rs"]
pub mod materials;
mod park;
mod pavilion;
pub mod scene;
mod skyline;
mod stadium;
mod street;
mod temple;
mod tower;
mod town_house;

use cga::Grammar;

pub use scene::Scene;

/// All scenes, in the order of the page.
pub fn scenes() -> Vec<Scene> {
    let grammars: [Box<dyn Grammar + Send + Sync>; 14] = [
        Box::new(tower::Tower::default()),
        Box::new(town_house::TownHouse::default()),
        Box::new(corner::Corner::default()),
        Box::new(courtyard::Courtyard::default()),
        Box::new(stadium::Stadium::default()),
        Box::new(bridge::Bridge::default()),
        Box::new(temple::Temple::default()),
        Box::new(street::Streets::default()),
        Box::new(skyline::Skyline::default()),
        Box::new(interior::Interior::default()),
        Box::new(fence::Fence::default()),
        Box::new(pavilion::Pavilion::default()),
        Box::new(park::Park::default()),
        Box::new(dungeon::Dungeon::default()),
    ];
    layouts().into_iter().zip(grammars).map(|(layout, grammar)| layout.with(grammar)).collect()
}

/// All scenes without compiled rules, for programs that load the text of the rules.
pub fn layouts() -> [Scene<()>; 14] {
    [
        tower::scene(),
        town_house::scene(),
        corner::scene(),
        courtyard::scene(),
        stadium::scene(),
        bridge::scene(),
        temple::scene(),
        street::scene(),
        skyline::scene(),
        interior::scene(),
        fence::scene(),
        pavilion::scene(),
        park::scene(),
        dungeon::scene(),
    ]
}
