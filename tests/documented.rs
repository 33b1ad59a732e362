//! The worked examples of the documents that this project started from, word for word, to the documented numbers.
//!
//! The pages: *split operation*, *split attribute*, *splitArea operation*, *Subdivision split*, *comp operation*, and those
//! of the operations they use. What a page shows only in a picture is taken from the picture. The program
//! `examples/gallery.rs` draws the same examples.

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
#[path = "../examples/gallery/mod.rs"]
mod gallery;
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
#[path = "documented/roof_forms.rs"]
mod roof_forms;
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

/// The pages of the gallery show the rules and measures of today, and have their pictures. `CGA_BLESS=1` writes the text.
#[test]
fn the_gallery_shows_these_examples() {
    use gallery::chapter::{chapters, contents};
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/gallery");
    let chapters = chapters();
    let mut pages: Vec<(std::path::PathBuf, String)> =
        chapters.iter().map(|chapter| (folder.join(chapter.name).with_extension("md"), chapter.markdown())).collect();
    pages.push((folder.join("README.md"), contents(&chapters)));
    for (path, text) in pages {
        if std::env::var_os("CGA_BLESS").is_some() {
            std::fs::write(&path, &text).expect("the page");
        }
        let now = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(now == text, "{}: `cargo run --release --example gallery` writes it again", path.display());
    }
    for chapter in &chapters {
        for cell in 0..chapter.cells.len() {
            assert!(folder.join(chapter.picture(cell)).is_file(), "{}", chapter.picture(cell));
        }
        let files = std::fs::read_dir(folder.join(chapter.name)).expect("the pictures").count();
        assert_eq!(files, chapter.cells.len(), "{} has pictures of other examples", chapter.name);
    }
    let shown: usize = chapters.iter().map(|chapter| chapter.cells.len()).sum();
    // The hollow cylinder is an example of ours.
    assert_eq!(shown, all().len() + 1, "the gallery shows every example");
}

/// All examples.
fn all() -> Vec<pages::example::Example> {
    [
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
        pages::wings::ALL,
    ]
    .concat()
}

/// Every example runs, leaves something and has nothing to complain about, and they can be told apart.
#[test]
fn all_examples_run() {
    let mut titles: Vec<_> = all().iter().map(|example| example.title).collect();
    for example in all() {
        let model = example.model(&pages::cutting::settings());
        assert!(!model.is_empty() && model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
        assert!(example.shown().contains("-->"), "{}: the gallery shows no rule", example.title);
        for rule in example.marks.iter().filter_map(|mark| mark.rule()) {
            assert!(0 < model.count(rule), "{}: no piece of {rule} to mark", example.title);
        }
    }
    let count = titles.len();
    titles.sort_unstable();
    titles.dedup();
    assert_eq!(titles.len(), count);
}
