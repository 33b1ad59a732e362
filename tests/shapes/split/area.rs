//! Parts of given areas, on random outlines.

use cga::glam::{DMat3, DVec3};
use cga::{Mesh, Model, Shape, cga};

cga! {
    grammar Areas = r#"
    attr first = 1
    attr second = 1
    @StartRule X --> splitArea(x) { first : A. | '0.25 : B. | second : A. | ~1 : C. }
    @StartRule Z --> splitArea(z, noAdjust) { first : A. | '0.25 : B. | second : A. | ~1 : C. }
    @StartRule Stretched --> s('3, '1, '0.5) splitArea(x) { { ~first : A. | ~2 : B. }* }
    @StartRule Many --> splitArea(z) { ~first : splitArea(x) { ~1 : A. | ~1 : A. } }*
    @StartRule Fifths --> splitArea(z) { '0.2 : A. }*
    @StartRule Halves --> splitArea(x, noAdjust) { '0.5 : A. | '0.5 : A. }
    @StartRule Slot --> split(x, noAdjust) { 5 : NIL | ~1 : splitArea(z, noAdjust) { ~1 : A. }* }
    @StartRule Tiny --> splitArea(x) { 0.00000000001 : A. | ~1 : B. }
    @StartRule Mirrored --> s('-1, '1, '1) splitArea(x) { '0.25 : A. | ~1 : B. }
    "#;
}

/// Random numbers, the same in every run.
struct Random(u64);

impl Random {
    /// From 0 to 1.
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as f64 / (1u64 << 31) as f64
    }
}

/// A star around the origin, with a star-shaped hole, in the plane of two directions at right angles.
fn star(random: &mut Random, axes: DMat3) -> Shape {
    let corners = 3 + (random.share() * 12.0) as usize;
    let mut ring = |low: f64, high: f64| -> Vec<DVec3> {
        let angles = (0..corners).map(|at| at as f64 / corners as f64 * std::f64::consts::TAU);
        let at =
            |angle: f64| DVec3::new(libm::cos(angle), 0.0, -libm::sin(angle)) * (low + (high - low) * random.share());
        angles.map(at).map(|point| axes * point).collect()
    };
    let (outer, mut hole) = (ring(5.0, 12.0), ring(0.5, 2.0));
    hole.reverse();
    Shape::mesh(Mesh::from_polygon(&outer, &[hole]).unwrap())
}

fn run(rule: &str, areas: [f64; 2], shape: &Shape) -> Model {
    let [first, second] = areas;
    let model = Areas { first, second }.generate_from(rule, shape).unwrap();
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

/// Tilted about x and then y, so that neither axis lies in the plane.
fn tilted(x: f64, y: f64) -> DMat3 {
    let turn = |angle: f64| (libm::cos(angle), libm::sin(angle));
    let ((c, s), (d, t)) = (turn(x), turn(y));
    let about_x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, c, s), DVec3::new(0.0, -s, c));
    DMat3::from_cols(DVec3::new(d, 0.0, -t), DVec3::Y, DVec3::new(t, 0.0, d)) * about_x
}

/// *splitArea operation*: shares of the area, on planar faces of any form: with holes, concave, tilted.
#[test]
fn parts_have_the_areas_that_were_asked_for() {
    let mut random = Random(1);
    for round in 0..300 {
        let axes = if round % 2 == 0 { DMat3::IDENTITY } else { tilted(random.share(), random.share()) };
        let shape = star(&mut random, axes);
        let whole = shape.to_mesh().area();
        let (first, second) = (whole * 0.4 * random.share() + 0.1, whole * 0.3 * random.share() + 0.1);
        for rule in ["X", "Z"] {
            let model = run(rule, [first, second], &shape);
            let areas: Vec<f64> = model.leaves().map(|leaf| leaf.area()).collect();
            let expected = [first, 0.25 * whole, second, whole - first - 0.25 * whole - second];
            assert_eq!(areas.len(), 4, "{rule} {round}");
            for (found, expected) in areas.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9 * whole, "{rule} {round}: {areas:?}, not {expected:?}");
            }
        }
    }
}

/// Sides that are across the axis except for rounding, as turned lots have: a steep edge must not hide the others.
#[test]
fn turning_a_lot_changes_no_area() {
    let lots: [&[[f64; 2]]; 3] = [
        &[[0.0, 0.0], [20.0, 0.0], [17.0, 12.0], [3.0, 12.0]],
        &[[0.0, 0.0], [20.0, 0.0], [20.0, 9.0], [17.0, 12.0], [0.0, 12.0]],
        &[[0.0, 0.0], [20.0, 0.0], [20.0, 12.0], [12.0, 14.0], [12.0, 6.0], [0.0, 6.0]],
    ];
    for lot in lots {
        for step in 0..720 {
            let angle = (f64::from(step) / 2.0).to_radians();
            let (c, s) = (libm::cos(angle), libm::sin(angle));
            let outline: Vec<[f64; 2]> = lot.iter().map(|[x, z]| [x * c - z * s, x * s + z * c]).collect();
            let shape = Shape::footprint(&outline, &[]).unwrap();
            let whole = shape.to_mesh().area();
            for (rule, share) in [("Fifths", 0.2), ("Halves", 0.5)] {
                let model = run(rule, [1.0; 2], &shape);
                let areas: Vec<f64> = model.leaves().map(|leaf| leaf.area()).collect();
                let off = areas.iter().map(|area| (area - share * whole).abs()).fold(0.0, f64::max);
                assert!(off < 1e-9 * whole && areas.len() as f64 * share == 1.0, "{rule} at {step}: {areas:?}");
            }
        }
    }
}

/// *splitArea operation*, noAdjust: without adjusting, the last part ends with the scope and not with the geometry.
#[test]
fn scopes_without_adjusting_fill_the_scope() {
    let triangle = Mesh::from_polygon(&[[0.0; 3], [0.0, 0.0, 10.0], [10.0, 0.0, 0.0]].map(DVec3::from), &[]).unwrap();
    let model = run("Slot", [1.0; 2], &Shape::mesh(triangle));
    let depths: Vec<f64> = model.leaves().map(|leaf| leaf.size().z).collect();
    assert!(1 < depths.len() && (depths.iter().sum::<f64>() - 10.0).abs() < 1e-12, "{depths:?}");
}

/// An area that is too small to be told from none makes no part.
#[test]
fn areas_without_a_width_are_not_made() {
    let shape = star(&mut Random(3), DMat3::IDENTITY);
    assert_eq!(run("Tiny", [1.0; 2], &shape).counts(), [("B", 1)]);
}

#[test]
fn stretched_nested_and_mirrored_areas_add_up() {
    let mut random = Random(2);
    for round in 0..100 {
        let shape = star(&mut random, DMat3::IDENTITY);
        let whole = shape.to_mesh().area();
        let model = run("Stretched", [3.0, 1.0], &shape);
        let areas: Vec<f64> = model.leaves().map(|leaf| leaf.area()).collect();
        assert!((areas.iter().sum::<f64>() - 1.5 * whole).abs() < 1e-9 * whole, "{round}: {areas:?}");
        assert!(areas.chunks(2).all(|pair| (pair[0] / pair[1] - 1.5).abs() < 1e-7), "{round}: {areas:?}");
        let model = run("Many", [10.0, 1.0], &shape);
        let areas: Vec<f64> = model.leaves().map(|leaf| leaf.area()).collect();
        assert!(areas.iter().all(|area| (area / areas[0] - 1.0).abs() < 1e-7), "{round}: {areas:?}");
        assert!((areas.iter().sum::<f64>() - whole).abs() < 1e-9 * whole, "{round}");
        let model = run("Mirrored", [1.0; 2], &shape);
        assert!((model.leaves().next().unwrap().area() - 0.25 * whole).abs() < 1e-9 * whole, "{round}");
    }
}

/// Counts follow the least stretch of the areas, and the splits of boxes, lines and faces across the axis have an answer.
#[test]
fn what_has_no_area_along_the_axis_stays_whole() {
    let upright =
        Mesh::from_polygon(&[[0.0; 3], [0.0, 0.0, 2.0], [0.0, 2.0, 2.0], [0.0, 2.0, 0.0]].map(DVec3::from), &[]);
    let line = Shape::line([0.0; 3], [4.0, 0.0, 0.0]).unwrap();
    assert_eq!(run("X", [1.0; 2], &Shape::mesh_axis_aligned(upright.unwrap())).count("X"), 1);
    let model = run("X", [1.0; 2], &line);
    assert_eq!((model.count("X"), model.area(), model.placements("X").next().unwrap().size.x), (1, 0.0, 4.0));
    // A box along x: of the sides along the axis, 2 · 8 · (1 + 1) = 32 square metres, a quarter each time.
    let model = run("X", [8.0; 2], &Shape::cuboid(8.0, 1.0, 1.0));
    assert_eq!(model.leaves().map(|leaf| leaf.size().x).collect::<Vec<_>>(), [2.0; 4]);
}
