//! Comparing a row of boxes along x with what a page says about it.

use cga::{Model, Settings};

use cga_tests::pages::example::{Example, Piece};

/// Returns true if two lengths are equal except for rounding.
pub(crate) fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

/// Runs an example on a shape one metre deep and compares names, lengths, heights, positions and colours.
#[track_caller]
pub(crate) fn check(example: &Example) {
    let pieces = &example.pieces.expect("an example with pieces")();
    let model = example.model(&Settings::default());
    assert!(model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
    check_row(&model, example.title, pieces);
}

#[track_caller]
pub(crate) fn check_row(model: &Model, title: &str, pieces: &[Piece]) {
    let found: Vec<_> = model.leaves().map(|leaf| (leaf.rule(), leaf.size().x, leaf.size().y)).collect();
    let wanted: Vec<_> = pieces.iter().filter(|piece| piece.0 != "NIL").collect();
    assert_eq!(found.len(), wanted.len(), "{title}: {found:?}");
    let starts = pieces.iter().scan(0.0, |at, piece| {
        let start = *at;
        *at += piece.1;
        Some((piece, start))
    });
    for (leaf, (piece, start)) in model.leaves().zip(starts.filter(|(piece, _)| piece.0 != "NIL")) {
        let (origin, size) = (leaf.scope().origin, leaf.size());
        assert_eq!(leaf.rule(), piece.0, "{title}: {found:?}");
        let same = near(size.x, piece.1) && near(size.y, piece.2) && near(size.z, 1.0);
        assert!(same, "{title}: {piece:?} in {found:?}");
        assert!(near(origin.x, start) && near(origin.y, 0.0), "{title}: {piece:?} at {origin}, not {start}");
        assert!(near(leaf.volume(), piece.1 * piece.2), "{title}: the piece is a box of its size");
        if let Some(color) = color(piece.0) {
            let material = leaf.material().color.expect(title);
            let channels = [material.r, material.g, material.b].map(|c| c * 255.0);
            let same = channels.iter().zip(color).all(|(found, wanted)| near(*found, f64::from(wanted)));
            assert!(same, "{title}: {} is {channels:?}", piece.0);
        }
    }
}

/// The colours that the pages give to their rules; their word or their picture where there is no rule.
fn color(rule: &str) -> Option<[u8; 3]> {
    match rule {
        "X" => Some([0, 0, 0xff]),
        "Y" => Some([0xff, 0xff, 0]),
        "Z" => Some([0, 0xff, 0]),
        "Blue" => Some([0x84, 0xc0, 0xfc]),
        "Green" => Some([0x9b, 0xd7, 0x70]),
        "Yellow" => Some([0xfc, 0xe0, 0x70]),
        _ => None,
    }
}
