//! The worked examples of the documents that this project started from, word for word, to the documented numbers.
//!
//! The pages: *split operation*, *split attribute*, *splitArea operation*, *Subdivision split*, *comp operation*, and those
//! of the operations they use. What a page shows only in a picture is taken from the picture. The program
//! `examples/documented.rs` draws the same examples.

#[path = "documented/adjusting.rs"]
mod adjusting;
#[path = "documented/aligning.rs"]
mod aligning;
#[path = "documented/areas.rs"]
mod areas;
#[path = "documented/attributes.rs"]
mod attributes;
#[path = "documented/cleanup.rs"]
mod cleanup;
#[path = "texture/collect.rs"]
#[allow(dead_code, unused_imports, unused_macros, reason = "the examples need the sink alone")]
mod collect;
#[path = "documented/components.rs"]
mod components;
#[path = "documented/cutting.rs"]
mod cutting;
#[path = "documented/faces.rs"]
mod faces;
#[path = "documented/mass.rs"]
mod mass;
#[path = "documented/mesh_operations.rs"]
mod mesh_operations;
#[path = "documented/normals.rs"]
mod normals;
#[path = "documented/offsets.rs"]
mod offsets;
#[path = "documented/outlines.rs"]
mod outlines;
#[path = "documented/pages/mod.rs"]
mod pages;
#[path = "documented/pieces.rs"]
mod pieces;
#[path = "documented/roofs.rs"]
mod roofs;
#[path = "documented/scattered.rs"]
mod scattered;
#[path = "documented/scopes.rs"]
mod scopes;
#[path = "documented/selectors.rs"]
mod selectors;
#[path = "documented/setbacks.rs"]
mod setbacks;
#[path = "documented/tags.rs"]
mod tags;
#[path = "documented/texturing.rs"]
mod texturing;
#[path = "documented/thirty.rs"]
mod thirty;
#[path = "documented/wings.rs"]
mod wings;

/// Every example runs, leaves something and has nothing to complain about, and they can be told apart.
#[test]
fn all_examples_run() {
    let pages = [
        pages::split_operation::ALL,
        pages::split_attribute::ALL,
        pages::split_area::ALL,
        pages::subdivision_once::ALL,
        pages::subdivision_repeat::ALL,
        pages::cutting::ALL,
        pages::boolean::ALL,
        pages::boolean_table::ALL,
        pages::comp::ALL,
        pages::components::ALL,
        pages::texturing::ALL,
        pages::primitives::ALL,
        pages::roofs::ALL,
        pages::mass::ALL,
        pages::recompose::ALL,
        pages::scattering::ALL,
        pages::setback::ALL,
        pages::mesh_operations::ALL,
        pages::normals::ALL,
        pages::cleanup::ALL,
        pages::tags::ALL,
    ];
    let mut titles: Vec<_> = pages.concat().iter().map(|example| example.title).collect();
    for example in pages.concat() {
        let model = example.model(&pages::cutting::settings());
        assert!(!model.is_empty() && model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
        assert!(example.rules.contains("-->"));
        for rule in example.marks.iter().filter_map(|mark| mark.rule()) {
            assert!(0 < model.count(rule), "{}: no piece of {rule} to mark", example.title);
        }
    }
    let count = titles.len();
    titles.sort_unstable();
    titles.dedup();
    assert_eq!(titles.len(), count);
}
