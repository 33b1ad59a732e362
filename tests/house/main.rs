//! Promises of the repository about itself: its layers, packages, links and pages.

mod guide;
mod interface;
mod layers;
mod links;
mod packages;
mod phrases;
mod pictures;
mod tidy;
mod traits;
