//! *footprint*, *envelope* and *innerRectangle operations*.

use cga::{Model, Settings, Shape, cga};

use cga_tests::pages::example::Example;
use cga_tests::pages::{assets, mass};

cga! {
    grammar Mass = r##"
    # envelope operation, per edge control
    @StartRule
    Sides --> envelope(normal, 20, 6, 40, 8, 50) X.
    @StartRule
    Arrays -->
        envelope(normal, 20,
          comp(fe) { street.front = 6 | street.back = 8 },
          comp(fe) { street.front = 40      | street.back = 50      | all = 90 }) X.
    @StartRule
    Three --> envelope(normal, 20, 6, 40) X.
    @StartRule
    Seven --> envelope(normal, 20, 6, 40, 8, 50, 5, 60) X.
    @StartRule
    Nine  --> envelope(normal, 20, 6, 40, 8, 50, 5, 60, 5, 60) X.
    @StartRule
    Again --> envelope(normal, 20, 6, 40) comp(f) { isTagged("envelope.top") : envelope(normal, 2, 1, 45) comp(f) {
        isTagged("envelope.side") : Side. | isTagged("envelope.bottom") : Bottom. | isTagged("envelope.top") : Top. } | all : NIL }
    # A published rule: the envelope keeps the axes of its scope, whose z axis is up.
    @StartRule
    Upright --> extrude(3) comp(f) { top : s(8.2, 2.5, '1) Top }
    Top --> envelope(world.up, 0.6, 0.45, 45, 0.45, 45, 0.45, 45) print(scope.sx + " " + scope.sy + " " + scope.sz)
        split(x) { { ~scope.sy : Piece. }* } t(0, 0, 0.6) rotateScope(0, 90, 0) After.
    "##;
}

fn run(rule: &str, shape: &Shape) -> Model {
    let model = Mass::default().generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

fn example(example: &Example) -> Model {
    example.model(&Settings::default())
}

/// The areas of the leaves of a rule, in tenths of square metres.
fn areas(model: &Model, rule: &str) -> Vec<f64> {
    model.leaves_of(rule).map(|leaf| (leaf.area() * 10.0).round() / 10.0).collect()
}

/// "The volume is cut and sealed horizontally."
#[test]
fn an_envelope_is_closed_and_has_a_level_top() {
    let model = example(&mass::envelope_parameters::EXAMPLE);
    let leaf = model.leaves_of("Envelope").next().unwrap();
    assert!((leaf.size().y - 16.0).abs() < 1e-9);
    let (mesh, _) = leaf.mesh();
    assert!(mesh.is_closed());
    assert_eq!(mesh.face_count(), 1 + 4 + 4 + 1);
}

/// Fifteen metres high at the street, higher behind.
#[test]
fn a_slope_faces_the_street() {
    let model = example(&mass::envelope_slope::EXAMPLE);
    assert_eq!((model.count("FrontYard"), areas(&model, "FrontYard")), (1, vec![200.0]));
    let leaf = model.leaves_of("Building").next().unwrap();
    assert!((leaf.size().y - (15.0 + 30.0 / 3f64.sqrt())).abs() < 1e-9);
    assert_eq!(leaf.mesh().0.face_count(), 6);
}

/// Each part has its tag, and faces of holes are no bases.
#[test]
fn parts_of_envelopes_are_tagged() {
    let model = example(&mass::envelope_tags::EXAMPLE);
    let counts = ["Bottom", "Base", "Slope", "Inner", "Top"].map(|rule| model.count(rule));
    assert_eq!(counts, [1, 4, 4, 4, 1]);
    assert_eq!(areas(&model, "Bottom"), [336.0]);
    // The front has no base, and its slope has the notch of the hole.
    let model = example(&mass::envelope_notch::EXAMPLE);
    let counts = ["Bottom", "Base", "Slope", "Inner", "Top"].map(|rule| model.count(rule));
    assert_eq!(counts, [1, 3, 4, 4, 1]);
    let (slope, _) = model.leaves_of("Slope").next().unwrap().mesh();
    assert_eq!(slope.face(0).outer().len(), 10);
}

/// "This allows to e.g. write … as …"; and sides that have no numbers are upright.
#[test]
fn forms_of_envelopes_agree() {
    for shape in [Shape::rectangle(20.0, 30.0), Shape::rectangle(20.0, 30.0).streets([0.0, 8.0, 0.0, 0.0])] {
        let volume = |rule: &str| run(rule, &shape).leaves_of("X").map(|leaf| leaf.mesh().0.volume()).sum::<f64>();
        let mesh = |rule: &str| run(rule, &shape).leaves_of("X").next().unwrap().mesh().0.points().to_vec();
        assert_eq!(mesh("Sides"), mesh("Arrays"));
        assert!(volume("Sides") < volume("Three") && volume("Seven") < volume("Sides"));
        assert_eq!(mesh("Seven"), mesh("Nine"));
    }
}

/// Along the world's y axis the scope keeps its axes, as a published result shows.
#[test]
fn an_envelope_along_the_world_keeps_the_axes_of_its_scope() {
    let model = run("Upright", &Shape::rectangle(20.0, 15.0));
    assert_eq!(model.report().prints()[0].to_string(), "8.2 2.5 0.6");
    assert_eq!(model.count("Piece"), 3);
}

/// Calling the operation again replaces its tags.
#[test]
fn tags_of_an_envelope_are_replaced_by_the_next() {
    let model = run("Again", &Shape::rectangle(20.0, 30.0));
    assert_eq!([model.count("Side"), model.count("Bottom"), model.count("Top")], [5, 1, 1]);
}

#[test]
fn a_concave_lot_has_valleys() {
    let model = example(&mass::envelope_concave::EXAMPLE);
    assert_eq!(["Base", "Slope", "Top", "Bottom"].map(|rule| model.count(rule)), [6, 6, 1, 1]);
}

/// The union of the roofs with their eaves, and of the porch.
#[test]
fn the_footprint_of_a_building_has_its_eaves() {
    let model = mass::footprint::EXAMPLE.model(&assets::settings());
    assert_eq!((model.count("ShowAsset"), model.count("Footprint")), (1, 1));
    let (volume, _) = model.leaves_of("Footprint").next().unwrap().mesh();
    assert!(volume.is_closed());
    // Roofs of 14 by 10 metres and of 6 by 4 in front of them, and the porch, 3 by 1 in front of the eaves.
    assert_eq!(volume.face_count(), 2 + 10);
    assert!((volume.volume() / 6.0 - (14.0 * 10.0 + 6.0 * 4.0 + 3.0)).abs() < 1e-6);
}

/// "Each polygon is a separate shape", or all polygons of the remainder are one.
#[test]
fn the_lot_has_an_inner_rectangle_and_three_parts_besides() {
    let scope = example(&mass::inner_rectangle_scope::EXAMPLE);
    let edge = example(&mass::inner_rectangle_edge::EXAMPLE);
    assert_eq!((scope.count("Color"), edge.count("Color")), (4, 2));
    let largest = |model: &Model| model.leaves().next().unwrap().area();
    assert!(largest(&scope) < largest(&edge));
    let lot: f64 = areas(&scope, "Color").iter().sum();
    assert!((lot - areas(&edge, "Color").iter().sum::<f64>()).abs() < 0.5);
    // The rectangle fills its scope, which has the axes of the lot.
    let leaf = scope.leaves().next().unwrap();
    assert!((leaf.size().x * leaf.size().z - leaf.area()).abs() < 1e-6);
}

/// A rectangle for each lot, and volumes on them.
#[test]
fn rectangles_place_volumes_in_lots() {
    let model = example(&mass::inner_rectangle_lots::EXAMPLE);
    assert_eq!(model.count("Extrude"), 4);
    assert!(model.leaves_of("Extrude").all(|leaf| leaf.mesh().0.face_count() == 6 && leaf.mesh().0.is_closed()));
    for model in [example(&mass::inner_rectangle_faces::EXAMPLE), example(&mass::inner_rectangle_aligned::EXAMPLE)] {
        assert_eq!(model.count("Extrude"), 4);
        assert!(model.leaves_of("Extrude").all(|leaf| leaf.mesh().0.is_closed()));
    }
    // Aligned to the world, the sides are upright and along its axes.
    let model = example(&mass::inner_rectangle_aligned::EXAMPLE);
    for leaf in model.leaves_of("Extrude") {
        let (mesh, _) = leaf.mesh();
        assert!((mesh.volume() / leaf.size().x / leaf.size().z) < leaf.size().y + 1e-9);
    }
    let model = example(&mass::inner_rect::EXAMPLE);
    assert_eq!(model.count("Lot"), 1);
    assert_eq!(model.leaves().next().unwrap().mesh().0.face_count(), 4 * 6);
}

cga! {
    grammar Slopes = r##"
    @StartRule
    Envelope --> envelope(normal, 30, 2, 45, 2, 45, 2, 45) X.
    @StartRule
    Roof --> roofHip(45) X.
    @StartRule
    Parts --> envelope(normal, 4, 2, 60, 2, 60, 2, 60) comp(f) { isTagged("envelope.side.slope") : Slope. | isTagged("envelope.side.base") : Base. }
    @StartRule
    Ground --> envelope(normal, 4, 0, 60, 0, 60, 0, 60) comp(f) { isTagged("envelope.side.slope") : Slope. | isTagged("envelope.side.base") : Base. }
    "##;
}

fn sloped(rule: &str, shape: &Shape) -> Model {
    let model = Slopes::default().generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

/// An L, a U with a slanted wing, and a yard, with z towards the front.
fn concave_lots() -> [Shape; 3] {
    let lot = |ring: &[[f64; 2]], holes: &[Vec<[f64; 2]>]| Shape::footprint(ring, holes).expect("a lot");
    [
        lot(&[[0.0, 0.0], [12.0, 0.0], [12.0, -5.0], [6.0, -5.0], [6.0, -14.0], [0.0, -14.0]], &[]),
        lot(
            &[[0.0, 0.0], [6.0, 1.0], [7.0, -8.0], [14.0, -8.0], [15.0, 0.0], [22.0, 0.0], [24.0, -15.0], [0.0, -15.0]],
            &[],
        ),
        lot(
            &[[0.0, 0.0], [16.0, 0.0], [16.0, -12.0], [0.0, -12.0]],
            &[vec![[6.0, -5.0], [10.0, -5.0], [10.0, -8.0], [6.0, -8.0]]],
        ),
    ]
}

/// Equal sides of a concave lot without a hole: an upright base, and the hip roof of the lot on it.
#[test]
fn equal_slopes_are_the_hip_roof_of_the_lot() {
    for lot in &concave_lots()[..2] {
        let volume = |rule: &str| sloped(rule, lot).leaves().map(|leaf| leaf.mesh().0.volume()).sum::<f64>();
        let expected = 2.0 * lot.to_mesh().area() + volume("Roof");
        assert!((volume("Envelope") - expected).abs() < 1e-6 * expected, "{} {expected}", volume("Envelope"));
    }
}

/// Faces begin with the edge over, or on, the outline of the initial shape, also for concave lots and lots with holes.
#[test]
fn faces_of_envelopes_begin_at_the_outline() {
    for (number, lot) in concave_lots().into_iter().enumerate() {
        let source = lot.to_mesh();
        let flat = |point: u32| {
            let at = lot.scope().frame().to_world(source.points()[point as usize]);
            [at.x, at.z]
        };
        let ring = |ring: &[u32]| -> Vec<[[f64; 2]; 2]> {
            (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]].map(flat)).collect()
        };
        let edges: Vec<[[f64; 2]; 2]> = source.face(0).loops().flat_map(ring).collect();
        for (rule, part, height) in [("Parts", "Slope", 2.0), ("Parts", "Base", 0.0), ("Ground", "Slope", 0.0)] {
            let model = sloped(rule, &lot);
            assert!(0 < model.count(part));
            for leaf in model.leaves_of(part) {
                let (mesh, place) = leaf.mesh();
                let ring = mesh.face(0).outer();
                let [a, b] = [ring[0], ring[1]].map(|point| place.transform_point3(mesh.points()[point as usize]));
                assert!((a.y - height).abs() < 1e-9 && (b.y - height).abs() < 1e-9, "{number} {rule} {part}: {a} {b}");
                let is_on = |[from, to]: [[f64; 2]; 2]| {
                    let (x, z) = (to[0] - from[0], to[1] - from[1]);
                    let off = |at: cga::glam::DVec3| ((at.x - from[0]) * z - (at.z - from[1]) * x).abs() / x.hypot(z);
                    off(a) < 1e-9 && off(b) < 1e-9
                };
                assert!(edges.iter().any(|edge| is_on(*edge)), "{number} {rule} {part}: {a} {b}");
            }
        }
    }
}
