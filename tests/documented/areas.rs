//! *splitArea operation*: the examples of the page, to the areas that it prints, and what its text says of other sums.

use cga::{Color, Model, Settings, Shape, cga};

use cga_tests::pages::example::Example;
use cga_tests::pages::split_area::{
    block_by_area, block_by_length, floating_and_absolute, frame, nested, relative, repeating, repeating_with_a_rest,
};

/// Rule, area, colour.
type Part = (&'static str, f64, [f64; 3]);

const RED: [f64; 3] = [1.0, 0.0, 0.0];
const YELLOW: [f64; 3] = [1.0, 1.0, 0.0];
const GREEN: [f64; 3] = [0.0, 1.0, 0.0];
const CYAN: [f64; 3] = [0.0, 1.0, 1.0];
const BLUE: [f64; 3] = [0.0, 0.0, 1.0];
const MAGENTA: [f64; 3] = [1.0, 0.0, 1.0];

fn near(found: f64, expected: f64) -> bool {
    (found - expected).abs() < 1e-9 * expected.abs().max(1.0)
}

/// Runs an example and compares its parts, and what it prints: the whole area, then the area of each part.
#[track_caller]
fn check(example: &Example, total: f64, parts: &[Part]) -> Model {
    let model = example.model(&Settings::default());
    assert!(model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
    let found: Vec<_> = model.leaves().map(|leaf| (leaf.rule(), leaf.area())).collect();
    assert_eq!(found.len(), parts.len(), "{found:?}");
    for (leaf, (rule, area, [r, g, b])) in model.leaves().zip(parts) {
        assert!(leaf.rule() == *rule && near(leaf.area(), *area), "{found:?}, not {parts:?}");
        assert_eq!(leaf.material().color, Some(Color::new(*r, *g, *b)), "{rule}");
    }
    let lines: Vec<String> = model.prints().iter().map(ToString::to_string).collect();
    let names = parts.iter().map(|(rule, area, _)| (format!("area({})", &rule[..1]), *area));
    let expected: Vec<_> = [("total area".to_owned(), total)].into_iter().chain(names).collect();
    assert_eq!(lines.len(), expected.len(), "{lines:?}");
    for (line, (name, area)) in lines.iter().zip(expected) {
        let (what, number) = line.split_once(" = ").expect("a name and a number");
        assert!(what == name && near(number.parse().expect("a number"), area), "{lines:?}");
    }
    model
}

/// Where parts begin and end along x, in the world.
fn extents(model: &Model) -> Vec<(f64, f64)> {
    model.leaves().map(|leaf| (leaf.bounds().low.x, leaf.bounds().high.x)).collect()
}

#[test]
fn seventy_and_thirty_per_cent() {
    let model = check(&relative::EXAMPLE, 1000.0, &[("Green", 700.0, GREEN), ("Yellow", 300.0, YELLOW)]);
    // The upright of the L is 600, a metre of its foot 10.
    assert!(
        extents(&model).into_iter().zip([(0.0, 30.0), (30.0, 60.0)]).all(|(a, b)| near(a.0, b.0) && near(a.1, b.1))
    );
}

#[test]
fn fifths_of_a_triangle() {
    let parts = [("Red", RED), ("Yellow", YELLOW), ("Green", GREEN), ("Cyan", CYAN), ("Blue", BLUE)];
    let model = check(&repeating::EXAMPLE, 900.0, &parts.map(|(rule, color)| (rule, 180.0, color)));
    // Left of x there is x² / 2, up to the tip in the middle.
    let borders = [0.0, 360f64.sqrt(), 720f64.sqrt(), 60.0 - 720f64.sqrt(), 60.0 - 360f64.sqrt(), 60.0];
    for (found, border) in extents(&model).into_iter().zip(borders.windows(2)) {
        assert!(near(found.0, border[0]) && near(found.1, border[1]), "{found:?}, not {border:?}");
    }
}

#[test]
fn three_parts_of_thirty_per_cent_and_the_rest() {
    let parts = [("Red", 270.0, RED), ("Yellow", 270.0, YELLOW), ("Green", 270.0, GREEN), ("Cyan", 90.0, CYAN)];
    check(&repeating_with_a_rest::EXAMPLE, 900.0, &parts);
}

/// The borders of the part in the middle run along the hole, so that it is two faces without holes.
#[test]
fn floating_and_absolute_areas_along_a_hole() {
    let parts = [("Green", 400.0, GREEN), ("Yellow", 600.0, YELLOW), ("Blue", 400.0, BLUE)];
    let model = check(&floating_and_absolute::EXAMPLE, 1400.0, &parts);
    assert_eq!(extents(&model), [(0.0, 10.0), (10.0, 40.0), (40.0, 50.0)]);
    let faces: Vec<_> = model.leaves().map(|leaf| leaf.mesh().0.face_count()).collect();
    assert_eq!(faces, [1, 2, 1]);
    let holes: usize =
        model.leaves().map(|leaf| leaf.mesh().0.faces().map(|face| face.holes().count()).sum::<usize>()).sum();
    assert_eq!(holes, 0);
}

#[test]
fn six_equal_parts_of_a_triangle() {
    let parts =
        [("Red", RED), ("Yellow", YELLOW), ("Green", GREEN), ("Cyan", CYAN), ("Blue", BLUE), ("Magenta", MAGENTA)];
    let model = check(&nested::EXAMPLE, 900.0, &parts.map(|(rule, color)| (rule, 150.0, color)));
    // The first of a pair has the lower z, which is up in the page's picture.
    let centres: Vec<f64> = model.leaves().map(|leaf| leaf.scope().centre().z).collect();
    assert!(centres.chunks(2).all(|pair| pair[0] < pair[1]), "{centres:?}");
}

/// The page prints these areas for its block, whose corners are known from them to a centimetre.
#[test]
fn a_block_divided_three_times() {
    let by_area = block_by_area::EXAMPLE.model(&Settings::default());
    let areas: Vec<f64> = by_area.leaves().map(|leaf| leaf.area()).collect();
    assert_eq!(by_area.counts(), [("A", 8)]);
    assert!(areas.iter().all(|area| near(*area, areas[0]) && (area - 808.79).abs() < 0.1), "{areas:?}");
    let color = by_area.leaves().next().and_then(|leaf| leaf.material().color);
    assert!(color.is_some() && by_area.leaves().all(|leaf| leaf.material().color == color), "equal areas, one colour");

    let by_length = block_by_length::EXAMPLE.model(&Settings::default());
    let areas: Vec<f64> = by_length.leaves().map(|leaf| leaf.area()).collect();
    let printed = [243.932, 486.110, 574.800, 874.623, 781.353, 1025.261, 1254.575, 1229.638];
    assert_eq!(by_length.counts(), [("B", 8)]);
    assert!(areas.iter().zip(printed).all(|(found, printed)| (found - printed).abs() < 0.2), "{areas:?}");
    let mut colors: Vec<_> =
        by_length.leaves().filter_map(|leaf| leaf.material().color).map(|color| format!("{color:?}")).collect();
    colors.sort_unstable();
    colors.dedup();
    assert_eq!(colors.len(), 7, "the last two are both red on the picture");
}

cga! {
    grammar Sums = r#"
    @StartRule
    Less --> splitArea(x) { '0.3 : P. | '0.3 : P. }
    @StartRule
    More --> splitArea(x) { '0.7 : P. | '0.5 : P. | '0.2 : P. }
    @StartRule
    Absolute --> splitArea(x) { 500 : P. | 300 : P. }*
    @StartRule
    TooMuch --> splitArea(x) { 2000 : P. | 1 : P. }
    @StartRule
    NoRoom --> splitArea(x) { 1400 : P. | ~1 : Q. }
    @StartRule
    NoSize --> splitArea(x) { 0 : Q. | -100 : Q. | '0.5 : P. | '0.5 : P. }
    @StartRule
    Ratios --> splitArea(x) { ~2 : P. | ~1 : P. | ~4 : P. }
    @StartRule
    Rhythm --> splitArea(x) { { 100 : P. | ~250 : Q. }* | 100 : P. }
    "#;
}

/// The page lets shares sum to less than 1, which discards the rest, and to more, which ignores what is beyond. Sizes
/// follow the rules of `split`.
#[test]
fn sums_of_areas_that_are_not_the_whole() {
    let lot = frame();
    let hollow: [(&str, &[f64]); 8] = [
        ("Less", &[420.0, 420.0]),
        ("More", &[980.0, 420.0]),
        ("Absolute", &[500.0, 300.0, 500.0, 100.0]),
        ("TooMuch", &[1400.0]),
        ("NoRoom", &[1400.0]),
        ("NoSize", &[700.0, 700.0]),
        ("Ratios", &[400.0, 200.0, 800.0]),
        // Four times: (1400 - 500) / 1000 is nearer to 1 than (1400 - 400) / 750.
        ("Rhythm", &[100.0, 225.0, 100.0, 225.0, 100.0, 225.0, 100.0, 225.0, 100.0]),
    ];
    for (rule, areas) in hollow {
        let model = Sums::default().generate_from(rule, &lot).expect("a model");
        let found: Vec<f64> = model.leaves().map(|leaf| leaf.area()).collect();
        assert_eq!(found.len(), areas.len(), "{rule}: {found:?}");
        assert!(found.iter().zip(areas).all(|(found, area)| near(*found, *area)), "{rule}: {found:?}");
    }
}

/// A shape without area along the axis stays as it is, like one without length in `split`.
#[test]
fn what_has_no_area_along_the_axis_is_not_divided() {
    cga! { grammar Upright = r#"Lot --> splitArea(y) { '0.5 : P. | '0.5 : P. }"#; }
    let model = Upright::default().generate(&Shape::rectangle(4.0, 3.0)).expect("a model");
    assert_eq!(model.counts(), [("Lot", 1)]);
    assert_eq!(model.area(), 12.0);
}
