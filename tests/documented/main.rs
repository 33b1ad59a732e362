//! The worked examples of the documents that this project started from, word for word, to the documented numbers.
//!
//! The pages: *split operation*, *split attribute*, *splitArea operation*, *Subdivision split*, *comp operation*, and the pages
//! of the operations they use. What a page shows only in a picture is taken from the picture. The program
//! `examples/gallery.rs` draws the same examples.

mod adjusting;
mod aligning;
mod areas;
mod attributes;
mod choices;
mod cleanup;
#[path = "../shapes/collect.rs"]
#[allow(dead_code, unused_imports, unused_macros, reason = "the examples need the sink alone")]
mod collect;
mod components;
mod cutting;
mod faces;
mod gates;
mod guide;
mod inserting;
mod mass;
mod mesh_operations;
mod normals;
mod offsets;
mod outlines;
mod pieces;
mod roof_forms;
mod roofs;
mod scattered;
mod scenes;
mod scope_chapter;
mod scopes;
mod selectors;
mod setbacks;
mod tags;
mod texturing;
mod thirty;
mod wings;

use std::fs;
use std::path::PathBuf;

use cga_tests::pages::{self, example::Example};
use cga_tests::tree::root;

/// The pages of the gallery show the rules and measures of today, and have their pictures. `CGA_BLESS=1` writes the text.
#[test]
fn the_gallery_shows_these_examples() {
    use cga_tests::gallery::chapter::{chapters, contents};
    let folder = gallery();
    let chapters = chapters();
    let mut pages: Vec<(PathBuf, String)> =
        chapters.iter().map(|chapter| (folder.join(chapter.name).with_extension("md"), chapter.markdown())).collect();
    pages.push((folder.join("README.md"), contents(&chapters)));
    for (path, text) in pages {
        if std::env::var_os("CGA_BLESS").is_some() {
            fs::write(&path, &text).expect("the page");
        }
        let now = fs::read_to_string(&path).unwrap_or_default();
        assert!(
            now == text,
            "{}: `cargo run --release -p cga-tests --example gallery` writes it again",
            path.display()
        );
    }
    for chapter in &chapters {
        for cell in chapter.drawn() {
            assert!(folder.join(chapter.picture(cell)).is_file(), "{}", chapter.picture(cell));
        }
        let files = fs::read_dir(folder.join(chapter.name)).expect("the pictures").count();
        assert_eq!(files, chapter.drawn().count(), "{} has pictures of other examples", chapter.name);
    }
    let shown: usize = chapters.iter().map(|chapter| chapter.cells.len()).sum();
    // The hollow cylinder is an example of ours.
    assert_eq!(shown, pages::all().len() + 1, "the gallery shows every example");
}

/// The folder of the pages.
fn gallery() -> PathBuf {
    root().join("docs/gallery")
}

/// A test for each example whose page describes a row of pieces, and the list of them.
macro_rules! rows {
    ($($page:ident { $($example:ident),* })*) => {
        $(mod $page {
            $(mod $example {
                #[test]
                fn pieces() {
                    crate::pieces::check(&cga_tests::pages::$page::$example::EXAMPLE);
                }
            })*
        })*

        const ROWS: &[Example] = &[$($(pages::$page::$example::EXAMPLE),*),*];
    };
}

rows! {
    split_operation { setup, relative_sizes, floating_sizes_only, absolute_and_floating_sizes, oversized, repeat_with_absolute_sizes, repeat_with_floating_sizes, interleaved_repeat, rhythm, rhythm_as_first_printed }
    subdivision_once { introduction, absolute, two_absolute, limited_scope, no_size, golden_ratio, floating, floating_between, two_floating, three_floating, floating_without_space }
    subdivision_repeat { absolute, floating, bordered, absolute_then_float, float_then_absolute, between_floats, same_size, pattern, pattern_inside, parallel_floating, parallel_absolute }
}

#[test]
fn each_row_of_pieces_is_compared() {
    let titles = |list: &[Example]| -> Vec<&str> { list.iter().map(|example| example.title).collect() };
    let all: Vec<Example> = pages::all().into_iter().filter(|example| example.pieces.is_some()).collect();
    assert_eq!(titles(&all), titles(ROWS));
}

/// Every piece follows from the ratio, until nothing is left that could be split.
#[test]
fn the_recursion_of_the_golden_ratio() {
    let model = pages::subdivision_once::golden_ratio_recursive::EXAMPLE.model(&cga::Settings::default());
    let pieces: Vec<_> = model.leaves().map(|leaf| (leaf.rule(), leaf.scope().origin.x, leaf.size().x)).collect();
    // `A` fills the low part and `B` the rest; both end at their low end.
    for (low, high, rule) in [(0.0, 5.0 * 0.382, "A"), (5.0 * 0.382, 5.0, "B")] {
        let mut mine: Vec<_> = pieces.iter().filter(|piece| low <= piece.1 && piece.1 < high).collect();
        mine.sort_by(|a, b| b.1.total_cmp(&a.1));
        let (mut extent, mut rest) = (high - low, mine.as_slice());
        while let [yellow, green, smaller @ ..] = rest
            && 1e-3 < extent
        {
            assert_eq!((yellow.0, green.0), ("Yellow", "Green"));
            assert!((yellow.2 - extent * 0.618 * 0.618).abs() < 1e-9);
            assert!((green.2 - extent * 0.618 * 0.382).abs() < 1e-9);
            extent *= 0.382;
            assert!((green.1 - low - extent).abs() < 1e-9);
            rest = smaller;
        }
        // The shape that is too small to be split is a leaf.
        assert_eq!(rest.last().map(|piece| (piece.0, piece.1)), Some((rule, low)));
        assert!((rest.iter().map(|piece| piece.2).sum::<f64>() - extent).abs() < 1e-9);
    }
    assert!((pieces.iter().map(|piece| piece.2).sum::<f64>() - 5.0).abs() < 1e-9);
}

/// Every example runs, leaves something and has nothing to complain about, and they can be told apart.
#[test]
fn all_examples_run() {
    let mut titles: Vec<_> = pages::all().iter().map(|example| example.title).collect();
    for example in pages::all() {
        let model = example.model(&pages::assets::settings());
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
