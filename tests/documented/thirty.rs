//! The split cases that everybody compares with, from rules to boxes: lengths along x, each given with the case.

use cga::{Shape, cga};

use crate::pieces::near;

/// A start rule for each case with the length of its box and the lengths that come out.
macro_rules! cases {
    ($rules:tt $($case:ident in $extent:literal => $lengths:expr;)*) => {
        // The checks report mistakes that the pages show on purpose: see `cga-lang/tests/data/lower/seed_*.cga`.
        cga! { @Allow(size_not_positive, slot_never_made) grammar Cases = $rules; }

        #[test]
        fn every_case_gives_its_lengths() {
            $(check(stringify!($case), $extent, &$lengths);)*
        }
    };
}

/// Runs one case and compares lengths and positions; the pieces touch and end where they should.
#[track_caller]
fn check(case: &str, extent: f64, lengths: &[f64]) {
    let model = Cases::default().generate_from(case, &Shape::cuboid(extent, 1.0, 1.0)).unwrap();
    let found: Vec<f64> = model.leaves().map(|leaf| leaf.size().x).collect();
    assert_eq!(found.len(), lengths.len(), "{case}: {found:?}");
    let mut at = 0.0;
    for (leaf, length) in model.leaves().zip(lengths) {
        assert!(near(leaf.size().x, *length), "{case}: {found:?}, not {lengths:?}");
        assert!(near(leaf.scope().origin.x, at), "{case}: {} at {at}", leaf.scope().origin.x);
        at += leaf.size().x;
    }
    assert!(at <= extent + 1e-9, "{case} fits");
}

fn times(count: usize, pattern: &[f64]) -> Vec<f64> {
    pattern.repeat(count)
}

fn framed(low: &[f64], middle: &[f64], high: &[f64]) -> Vec<f64> {
    [low, middle, high].concat()
}

cases! {
    r#"
    @StartRule C01 --> split(x) { '.5 : P. | '.1 : P. | '.2 : P. }
    @StartRule C02 --> split(x) { ~.5 : P. | ~.1 : P. | ~.2 : P. }
    @StartRule C03 --> split(x) { 3.3 : P. | ~3 : P. | 5 : P. }
    @StartRule C04 --> split(x) { '.5 : P. | '.6 : P. | 3 : P. }
    @StartRule C05 --> split(x) { 3 : P. }
    @StartRule C06 --> split(x) { 2 : P. | 1 : P. | 1 : P. | 2 : P. | 1 : P. }
    @StartRule C07 --> split(x) { '.382 : P. | '.618 : P. }
    @StartRule C08 --> split(x) { 1 : P. | ~2 : P. | 1 : P. }
    @StartRule C09 --> split(x) { 3 : P. | ~2 : P. | ~2 : P. | ~2 : P. }
    @StartRule C10 --> split(x) { 2 : P. }*
    @StartRule C11 --> split(x) { 1 : P. | { ~2.5 : P. }* | 1 : P. }
    @StartRule C12 --> split(x) { ~1 : P. | { 2 : P. }* }
    @StartRule C13 --> split(x) { { 1 : P. | ~2.7 : P. }* | 1 : P. }
    @StartRule C14 --> split(x) { ~2.7 : P. | .3 : P. }*
    @StartRule C15 --> split(x) { ~5 : P. | ~.5 : P. }*
    @StartRule C16 --> split(x) { 2 : P. | 1 : P. }*
    @StartRule C17 --> split(x) { ~2 : P. | ~1 : P. }*
    @StartRule C18 --> split(x) { 1 : P. | { ~1 : P. | .2 : P. | ~1 : P. }* | 1 : P. }
    @StartRule C19 --> split(x) { { 1 : P. | ~3 : P. }* | 1 : P. }
    @StartRule C20 --> split(x) { 3 : P. | 1 : P. }
    @StartRule C21 --> split(x) { 1.5 : P. | -2 : P. | 1.5 : P. | 1.5 : P. | 0 : P. | 1.5 : P. }
    @StartRule C22 --> split(x) { 3 : P. | ~1 : P. }
    @StartRule C23 --> split(x) { 3 : P. | ~1.5 : P. | ~1.5 : P. }
    @StartRule C24 --> split(x) { 5 : P. | ~1 : P. }
    @StartRule C25 --> split(x) { ~2.1 : P. }*
    @StartRule C26 --> split(x) { { 2 : P. }* | ~1 : P. }
    @StartRule C27 --> split(x) { ~2 : P. | { 1 : P. | ~2 : P. }* }
    @StartRule C28 --> split(x) { 4.4 : P. | .3 : P. | { ~3 : P. | .3 : P. }* }
    @StartRule C29 --> split(x) { ~2.7 : P. | .3 : P. }*
    @StartRule C30 --> split(x) { { ~.75 : P. | ~1 : P. }* | ~.5 : P. }

    # A width that the rules know: windows and the bars between them.
    @StartRule Bars --> Bars(2.15)
    Bars(W) --> split(x) { { ~W/3 : P. | 0.25 : P. }* | ~W/3 : P. }
    @StartRule NoBar --> NoBar(2.15)
    NoBar(W) --> split(x) { { ~W : P. | 0.25 : P. }* | ~W : P. }
    "#
    C01 in 10.0 => [5.0, 1.0, 2.0];
    C02 in 10.0 => [6.25, 1.25, 2.5];
    C03 in 10.0 => [3.3, 1.7, 5.0];
    C04 in 10.0 => [5.0, 5.0];
    C05 in 5.0 => [3.0];
    C06 in 5.0 => [2.0, 1.0, 1.0, 1.0];
    C07 in 5.0 => [1.91, 3.09];
    C08 in 5.0 => [1.0, 3.0, 1.0];
    C09 in 5.0 => [3.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0];
    C10 in 10.0 => [2.0; 5];
    C11 in 10.0 => framed(&[1.0], &[8.0 / 3.0; 3], &[1.0]);
    C12 in 10.0 => [2.0; 5];
    C13 in 10.0 => [1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 1.0];
    C14 in 40.0 => times(13, &[36.1 / 13.0, 0.3]);
    C15 in 30.0 => times(5, &[60.0 / 11.0, 6.0 / 11.0]);
    C16 in 10.0 => [2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 1.0];
    C17 in 10.0 => times(3, &[20.0 / 9.0, 10.0 / 9.0]);
    C18 in 10.0 => framed(&[1.0], &times(4, &[0.9, 0.2, 0.9]), &[1.0]);
    C19 in 10.0 => [1.0, 3.5, 1.0, 3.5, 1.0];
    C20 in 5.0 => [3.0, 1.0];
    C21 in 5.0 => [1.5, 1.5, 1.5, 0.5];
    C22 in 5.0 => [3.0, 2.0];
    C23 in 5.0 => [3.0, 1.0, 1.0];
    C24 in 5.0 => [5.0];
    C25 in 10.0 => [2.0; 5];
    C26 in 10.0 => [2.0; 5];
    C27 in 10.0 => [1.75, 1.0, 1.75, 1.0, 1.75, 1.0, 1.75];
    C28 in 12.2 => [4.4, 0.3, 3.45, 0.3, 3.45, 0.3];
    C29 in 20.0 => times(7, &[17.9 / 7.0, 0.3]);
    C30 in 10.0 => framed(&times(5, &[30.0 / 37.0, 40.0 / 37.0]), &[20.0 / 37.0], &[]);
    Bars in 2.15 => [0.55, 0.25, 0.55, 0.25, 0.55];
    NoBar in 2.15 => [2.15];
}
