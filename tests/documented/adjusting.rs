//! *split operation*, *splitArea operation*, adjustMode: scopes shrink to the geometry or fill their parent.

use cga::{Axis, LeafView, Model, Scope, Settings, Shape, cga};

use crate::outlines::{fits, turned};
use cga_tests::pages::split_area::{adjusted, not_adjusted, scope_of_shapes};

cga! {
    grammar Scopes = r#"
    @StartRule
    Lot     --> P.
    @StartRule
    X       --> split(x) { ~1 : P. }*
    @StartRule
    XAdjust --> split(x, adjust) { ~1 : P. }*
    @StartRule
    XFill   --> split(x, noAdjust) { ~1 : P. }*
    @StartRule
    ZAdjust --> split(z, adjust) { ~1 : P. }*
    @StartRule
    ZFill   --> split(z, noAdjust) { ~1 : P. }*
    @StartRule
    Grid    --> split(x, noAdjust) { ~1.5 : split(z, noAdjust) { ~1 : primitiveQuad() P. }* }*

    @StartRule
    AreaX       --> splitArea(x) { '0.25 : P. }*
    @StartRule
    AreaXAdjust --> splitArea(x, adjust) { '0.25 : P. }*
    @StartRule
    AreaXFill   --> splitArea(x, noAdjust) { '0.25 : P. }*
    @StartRule
    AreaZAdjust --> splitArea(z, adjust) { '0.25 : P. }*
    @StartRule
    AreaZFill   --> splitArea(z, noAdjust) { '0.25 : P. }*
    "#;
}

/// A U of 6 × 4 with walls of 1 that opens to the front: its middle is lower than its arms.
fn u() -> Shape {
    let u = [[0.0, 4.0], [1.0, 4.0], [1.0, 1.0], [5.0, 1.0], [5.0, 4.0], [6.0, 4.0], [6.0, 0.0], [0.0, 0.0]];
    Shape::footprint(&u, &[]).expect("an outline")
}

/// As it is, turned, and tilted.
fn lots() -> [Shape; 3] {
    [u(), turned(&u(), [0.0, 1.0, 0.0], 33.0), turned(&u(), [1.0, 0.3, -0.2], 50.0)]
}

fn run(rule: &str, lot: &Shape) -> Model {
    Scopes::default().generate_from(rule, lot).expect("a model")
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

/// Where a leaf begins and ends in the coordinates of another scope, along an axis.
fn along(leaf: &LeafView<'_>, parent: &Scope, axis: Axis) -> (f64, f64) {
    let start = parent.frame().to_local(leaf.scope().origin)[axis.index()];
    (start, start + leaf.size()[axis.index()])
}

/// Scopes follow each other from one end of the parent to the other and are as large as it across the axis.
#[track_caller]
fn tiles<'a>(leaves: impl Iterator<Item = LeafView<'a>>, parent: &Scope, axis: Axis) {
    let mut end = 0.0;
    for leaf in leaves {
        let mut place = parent.frame().to_local(leaf.scope().origin);
        assert!(near(place[axis.index()], end), "a gap at {end}");
        place[axis.index()] = 0.0;
        assert!(place.abs().max_element() < 1e-9, "moved across the axis");
        let mut size = leaf.size();
        end += size[axis.index()];
        size[axis.index()] = parent.extent(axis);
        assert!((size - parent.size).abs().max_element() < 1e-9, "{} in {}", leaf.size(), parent.size);
    }
    assert!(near(end, parent.extent(axis)), "the last one ends at {end}");
}

#[track_caller]
fn fitted(leaf: &LeafView<'_>) {
    let (low, high) = fits(leaf);
    let same = low.abs().max_element() < 1e-9 && (high - leaf.size()).abs().max_element() < 1e-9;
    assert!(same, "{low} to {high} in {}", leaf.size());
}

#[test]
fn scopes_of_split_shrink_to_the_geometry_or_fill_the_parent() {
    for (rule, depth) in [("X", 1.0), ("XAdjust", 1.0), ("XFill", 4.0)] {
        let model = run(rule, &u());
        assert_eq!(model.counts(), [("P", 6)], "{rule}");
        for (at, leaf) in model.leaves().enumerate() {
            let arm = at == 0 || at == 5;
            assert!(near(leaf.scope().origin.x, at as f64) && near(leaf.scope().origin.z, 0.0));
            assert!(near(leaf.size().x, 1.0) && near(leaf.size().z, if arm { 4.0 } else { depth }));
            assert!(near(leaf.area(), if arm { 4.0 } else { 1.0 }));
        }
    }
}

#[test]
fn adjusted_scopes_are_boxes_around_the_pieces() {
    for lot in lots() {
        for rule in ["X", "XAdjust", "ZAdjust", "AreaX", "AreaXAdjust", "AreaZAdjust"] {
            let model = run(rule, &lot);
            assert!(3 < model.len() && near(model.area(), 12.0), "{rule}");
            model.leaves().for_each(|leaf| fitted(&leaf));
        }
        // Three metres of area end in the arm; the part beside it is as deep as what is left of the arm.
        let sizes: Vec<_> = run("AreaX", &lot).leaves().map(|leaf| (leaf.size().x, leaf.size().z)).collect();
        let expected = [(0.75, 4.0), (2.25, 4.0), (2.25, 4.0), (0.75, 4.0)];
        assert!(sizes.iter().zip(expected).all(|(a, b)| near(a.0, b.0) && near(a.1, b.1)), "{sizes:?}");
        let sizes: Vec<_> = run("AreaZAdjust", &lot).leaves().map(|leaf| (leaf.size().x, leaf.size().z)).collect();
        let expected = [(6.0, 0.5), (6.0, 0.5), (6.0, 1.5), (6.0, 1.5)];
        assert!(sizes.iter().zip(expected).all(|(a, b)| near(a.0, b.0) && near(a.1, b.1)), "{sizes:?}");
    }
}

#[test]
fn unadjusted_scopes_tile_the_parent() {
    for lot in lots() {
        for (rule, axis) in [("XFill", Axis::X), ("ZFill", Axis::Z), ("AreaXFill", Axis::X), ("AreaZFill", Axis::Z)] {
            let model = run(rule, &lot);
            assert!(3 < model.len() && near(model.area(), 12.0), "{rule}");
            tiles(model.leaves(), lot.scope(), axis);
        }
        // Parts without geometry are there as well, and can be filled: four columns of four.
        let model = run("Grid", &lot);
        assert_eq!(model.len(), 16);
        for column in model.leaves().collect::<Vec<_>>().chunks(4) {
            let mut parent = column[0].scope();
            parent.size.z = lot.scope().size.z;
            tiles(column.iter().copied(), &parent, Axis::Z);
        }
    }
}

/// Columns on the page's picture and the borders within each, in metres of a scope of 150 × 68, read to half a metre.
const BORDERS: [(f64, [f64; 4]); 5] = [
    (30.0, [15.2, 22.6, 35.7, 43.7]),
    (60.0, [24.2, 30.3, 36.3, 45.4]),
    (77.9, [21.5, 31.7, 42.0, 56.4]),
    (111.8, [22.5, 30.5, 41.4, 56.6]),
    (150.0, [17.4, 25.4, 43.0, 55.5]),
];

/// The page's disconnected outlines in 5 × 5 parts of equal area, with and without adjusting.
#[test]
fn twenty_five_parts_of_disconnected_outlines() {
    let settings = Settings::default();
    let whole = scope_of_shapes::EXAMPLE.model(&settings);
    let parent = whole.leaves_of("Pink").next().expect("the scope").scope();
    let area = whole.leaves_of("Geometry").map(|leaf| leaf.area()).sum::<f64>();
    for example in [adjusted::EXAMPLE, not_adjusted::EXAMPLE] {
        let model = example.model(&settings);
        assert_eq!(model.counts(), [("Geometry", 25), ("Pink", 25)], "{}", example.title);
        assert!(model.leaves_of("Geometry").all(|leaf| near(leaf.area(), area / 25.0)));
        let scopes: Vec<_> = model.leaves_of("Geometry").collect();
        for (column, (end, borders)) in scopes.chunks(5).zip(BORDERS) {
            let high = column.iter().map(|part| along(part, &parent, Axis::X).1).fold(0.0, f64::max);
            assert!((high - end).abs() < 0.5, "{}: {high}, not {end}", example.title);
            for (part, border) in column.iter().zip(borders) {
                let high = along(part, &parent, Axis::Z).1;
                assert!((high - border).abs() < 0.5, "{}: {high}, not {border}", example.title);
            }
        }
    }
    adjusted::EXAMPLE.model(&settings).leaves_of("Geometry").for_each(|leaf| fitted(&leaf));
}

/// Without adjusting the scopes of the parts make up the scope of the whole (*splitArea operation*): columns do, and the
/// parts of each column, the last of which goes on to the scope's border beyond the geometry.
#[test]
fn columns_of_parts_without_adjusting() {
    let settings = Settings::default();
    let model = not_adjusted::EXAMPLE.model(&settings);
    let whole = scope_of_shapes::EXAMPLE.model(&settings);
    let parent = whole.leaves_of("Pink").next().expect("the scope").scope();
    let leaves: Vec<_> = model.leaves_of("Geometry").collect();
    for column in leaves.chunks(5) {
        let mut frame = column[0].scope();
        frame.size.z = parent.size.z;
        tiles(column.iter().copied(), &frame, Axis::Z);
    }
    let ends: Vec<_> = leaves.chunks(5).map(|column| along(&column[0], &parent, Axis::X)).collect();
    assert!(ends.windows(2).all(|pair| near(pair[0].1, pair[1].0)));
    assert!(near(ends[0].0, 0.0) && near(ends[4].1, parent.size.x));
}
