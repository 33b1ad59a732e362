//! Buildings and scenes with rules of our own, each in a file of its own. `examples/gallery.rs` draws them. Nothing here
//! draws or reads files, so the scenes also run in a browser.

mod bridge;
mod courtyard;
mod fence;
mod interior;
mod park;
mod pavilion;
pub mod scene;
mod skyline;
mod stadium;
mod street;
mod temple;
mod tower;
mod town_house;

pub use scene::Scene;

/// All scenes, in the order of the page.
pub fn scenes() -> Vec<Scene> {
    vec![
        tower::scene(),
        town_house::scene(),
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
    ]
}
