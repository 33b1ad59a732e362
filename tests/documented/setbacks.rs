//! *setback*, *setbackPerEdge*, *setbackToArea* and *splitAndSetbackPerimeter operations*.

use cga::glam::DVec3;
use cga::{Mesh, Model, Settings, Shape, cga};

use cga_tests::pages::example::Example;
use cga_tests::pages::setback;

cga! {
    grammar Setbacks = r##"
    # setback operation
    @StartRule
    Shape --> setback(4) { front : Strip. }
    @StartRule
    Remainder --> setback(4) { front : NIL | remainder : Rest. }

    # "setback vs. setbackPerEdge"
    @StartRule
    Once --> setback(drawn) { front = Red. | back = Blue. | left = Green. }
    @StartRule
    PerEdge --> setbackPerEdge(drawn) { front = Red. | back = Blue. | left = Green. }
    drawn = printed(rand(5))
    printed(x) = print(x)

    # "this means internally an array is constructed by the comp function"
    @StartRule
    Array --> setback(comp(fe) { all : scope.sx / 7.5 }) { all : Strip. | remainder : Rest. }
    @StartRule
    Lengths --> setbackPerEdge(scope.sx / 7.5) { all : Strip. | remainder : Rest. }

    # "debug is evaluated 4 times, once for each edge"
    debug = print(comp.index + 5)
    @StartRule
    Debug --> setbackPerEdge(debug) { front = Strip. }

    # "If dist was an attr or const it would only be evaluated once at rule start with comp.index being -1."
    dists = [3, 2, 1, 0]
    const fixed = comp.index + 2
    @StartRule
    Indexed --> setbackPerEdge(dists[comp.index]) { all = Strip. | remainder = Rest. }
    @StartRule
    Fixed --> setbackPerEdge(fixed) { all = Strip. | remainder = Rest. }

    # Selectors.
    @StartRule
    Words --> setback(1) { world.south = South. | object.left = Left. | street.right = Right. | remainder = Rest. }
    @StartRule
    Turned --> rotateScope(0, 90, 0) setback(1) { front = Front. | object.front = South. | remainder = Rest. }
    @StartRule
    Condition --> setback(1) { scope.sx > 9 && !back = South. | -1 = Left. | remainder = Rest. }
    @StartRule
    Tagged --> extrude(4) setback(1) { isTagged("extrude.side") && top = Strip. | isTagged("extrude.top") = Top. | remainder = Rest. }
    @StartRule
    Each --> extrude(4) comp(f) { side = Walls | all : NIL }
    Walls --> setback(1) { bottom : Strip. | remainder = Rest. }
    # Sections.
    @StartRule
    Sections --> splitAndSetbackPerimeter(0) { ~9 : 1 : print(split.index + " of " + split.total) A. }* { remainder : Rest. }
    @StartRule
    Depths --> splitAndSetbackPerimeter('0.5) { ~9 : print(rand(1, 2)) : A. | ~9 : split.index : print(rand(1, 2)) B. }* { remainder = Rest. }
    @StartRule
    TwoFaces --> splitAndSetbackPerimeter(10) { 4 : 0.5 : A. } { remainder : Rest. }
    @StartRule
    Textured --> setupProjection(0, scope.xz, scope.sx, scope.sz) projectUV(0)
        setback(2, 0) { uv.uMin = Left. | uv.bottom = Bottom. | remainder = Rest. }
    "##;
}

fn run(rule: &str, shape: &Shape) -> Model {
    let model = Setbacks::default().generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

fn lot() -> Shape {
    Shape::rectangle(10.0, 8.0)
}

/// The areas of the leaves of a rule.
fn areas(model: &Model, rule: &str) -> Vec<f64> {
    model.leaves_of(rule).map(|leaf| (leaf.area() * 1e6).round() / 1e6).collect()
}

fn printed(model: &Model) -> Vec<String> {
    model.prints().iter().map(|line| line.value.to_string()).collect()
}

/// A lot with a round front of six edges, as in the pictures of the tags.
fn round() -> Shape {
    let at = |[x, z]: [f64; 2]| DVec3::new(x, 0.0, -z);
    let corners =
        [[8.0, 2.0], [14.0, 0.5], [20.0, 0.0], [60.0, 2.0], [58.0, 30.0], [2.0, 28.0], [0.0, 14.0], [3.0, 5.0]];
    Shape::mesh(Mesh::from_polygon(&corners.map(at), &[]).expect("a polygon"))
}

/// "Selects a number of edges and sets them back": the edges of a round front have one polygon.
#[test]
fn a_front_of_several_edges_has_one_strip() {
    let (strip, rest) = (run("Shape", &round()), run("Remainder", &round()));
    assert_eq!((strip.counts(), rest.counts()), (vec![("Strip", 1)], vec![("Rest", 1)]));
    assert!((strip.area() + rest.area() - round().to_mesh().area()).abs() < 1e-9);
}

/// "While for setback the distance is evaluated once and assigned the same for all edges, setbackPerEdge re-evaluates the
/// distance for each edge."
#[test]
fn a_distance_is_drawn_once_or_for_each_edge() {
    let (once, each) = (run("Once", &lot()), run("PerEdge", &lot()));
    assert_eq!((printed(&once).len(), printed(&each).len()), (1, 4));
    let distance: f64 = printed(&once)[0].parse().expect("a number");
    for (rule, length) in [("Red", 10.0), ("Blue", 10.0)] {
        assert!((areas(&once, rule)[0] - distance.min(4.0) * length).abs() < 1e-3, "{distance}");
    }
    let mut drawn = printed(&each);
    drawn.dedup();
    assert_eq!(drawn.len(), 4);
}

/// "Setbacks are applied relative to edge lengths."
#[test]
fn distances_follow_from_edges() {
    let [a, b] = ["Array", "Lengths"].map(|rule| run(rule, &Shape::rectangle(15.0, 7.5)));
    // 2 from the long edges, 1 from the short ones.
    assert_eq!((areas(&a, "Rest"), areas(&b, "Rest")), (vec![13.0 * 3.5], vec![13.0 * 3.5]));
    assert_eq!(areas(&a, "Strip"), areas(&b, "Strip"));
}

#[test]
fn the_distance_is_evaluated_for_all_edges() {
    let model = run("Debug", &lot());
    assert_eq!(printed(&model), ["5", "6", "7", "8"]);
    assert_eq!(model.counts(), [("Strip", 1)]);
}

#[test]
fn indices_of_edges_choose_distances() {
    let model = run("Indexed", &lot());
    // The edges of a rectangle with their distances of 3, 2, 1 and 0.
    let rest = areas(&model, "Rest")[0];
    assert!(rest == 8.0 * 4.0 || rest == 6.0 * 6.0, "{rest}");
    let model = run("Fixed", &lot());
    assert_eq!(areas(&model, "Rest"), [8.0 * 6.0]);
}

#[test]
fn edges_are_selected_in_all_axes() {
    let all = |rule: &str, names: &[&str], shape: &Shape| -> Vec<f64> {
        let model = run(rule, shape);
        names.iter().flat_map(|name| areas(&model, name)).collect()
    };
    // Without streets their words mean the object's axes. Earlier arms keep the corners.
    assert_eq!(all("Words", &["South", "Left", "Right", "Rest"], &lot()), [10.0, 7.0, 7.0, 56.0]);
    assert_eq!(all("Turned", &["Front", "South", "Rest"], &lot()), [8.0, 9.0, 63.0]);
    // Edge 3 is one of the short ones, or the front.
    let parts = all("Condition", &["South", "Left", "Rest"], &lot());
    assert_eq!((parts[0], parts.iter().sum::<f64>()), (10.0, 80.0));
    assert_eq!(all("Textured", &["Left", "Bottom", "Rest"], &lot()), [16.0, 16.0, 48.0]);
}

/// "Edges can also be selected based on the tags of adjacent faces."
#[test]
fn tags_of_faces_select_edges() {
    let model = run("Tagged", &lot());
    // The upper edges of the walls, where the top has them too, and the edges of the top, which the walls have too.
    assert_eq!(areas(&model, "Strip"), [36.0]);
    assert_eq!(areas(&model, "Top"), [80.0 - 8.0 * 6.0]);
}

/// ": Each polygon is put into a new shape. = All polygons corresponding to the selector are combined into one new shape.
/// This also applies to shapes with more than one face."
#[test]
fn operators_apply_to_all_faces() {
    let model = run("Each", &lot());
    let mut strips = areas(&model, "Strip");
    strips.sort_by(f64::total_cmp);
    assert_eq!((strips, areas(&model, "Rest")), (vec![8.0, 8.0, 10.0, 10.0], vec![108.0]));
}

fn example(example: &Example) -> Model {
    example.model(&Settings::default())
}

fn sum(model: &Model, rule: &str) -> f64 {
    areas(model, rule).iter().sum()
}

/// "A left-handed L shape … a right-handed L shape."
#[test]
fn an_l_is_left_or_right_handed() {
    let [left, right] = [&setback::left_handed::EXAMPLE, &setback::right_handed::EXAMPLE].map(example);
    for rule in ["Garden", "Building"] {
        assert_eq!(areas(&left, rule), areas(&right, rule));
    }
    let x = |model: &Model| model.leaves_of("Building").next().expect("a building").scope().origin.x;
    assert_eq!(x(&left) - x(&right), 5.0);
}

/// "(9)[1,6,1,6,1,6,1,6,1]" and "(9)[4,0,2,0.5,5,0.5,2,2,0]": nine distances on two faces.
#[test]
fn distances_of_two_faces() {
    for page in [&setback::alternating::EXAMPLE, &setback::by_selectors::EXAMPLE] {
        let model = example(page);
        assert_eq!(model.counts(), [("Garden", 1), ("Building", 2)], "{}", page.title);
        let all = (page.start)().to_mesh().area();
        assert!((model.area() - all).abs() < 1e-9 * all);
    }
}

/// The picture of the first array: between distances of 1 and 6, the cut follows the bisector of the blunt corner at the back, and
/// the inner lines meet at the corner on the right.
#[test]
fn distances_that_differ_meet_as_in_the_picture() {
    let model = example(&setback::alternating::EXAMPLE);
    let leaf = model.leaves_of("Building").nth(1).expect("the second building");
    let (mesh, place) = leaf.mesh();
    let corners: Vec<DVec3> =
        mesh.corners().iter().map(|p| place.transform_point3(mesh.points()[*p as usize])).collect();
    assert_eq!((mesh.face_count(), corners.len()), (1, 6));
    let [right, side, back, left] =
        [[27.8, 0.6], [29.1, 6.4], [22.0, 12.2], [16.2, 12.4]].map(|[x, z]| DVec3::new(x, 0.0, -z));
    let toward = |from: DVec3, to: DVec3| (to - from).normalize();
    let bisector = (toward(back, side) + toward(back, left)).normalize();
    let on_bisector = |at: &&DVec3| (**at - back).cross(bisector).length() < 1e-9;
    assert_eq!(corners.iter().filter(on_bisector).count(), 2, "{corners:?}");
    // 6 from the right edge, and 1 from the slanted one.
    let from = |at: DVec3, a: DVec3, b: DVec3| DVec3::Y.cross(toward(a, b)).dot(at - a);
    let is_mitre = |at: &&DVec3| (from(**at, right, side) - 6.0).abs() + (from(**at, side, back) - 1.0).abs() < 1e-9;
    assert_eq!(corners.iter().filter(is_mitre).count(), 1, "{corners:?}");
}

/// "A square shape with an area of 400 is setback to an area of 100." "All setback faces have an area of 300."
#[test]
fn areas_are_those_of_the_page() {
    let near = |model: &Model, rule: &str, area: f64| assert!((sum(model, rule) - area).abs() < 1e-5, "{rule}");
    near(&example(&setback::area_left::EXAMPLE), "Green", 100.0);
    near(&example(&setback::area_right::EXAMPLE), "Green", 300.0);
    near(&example(&setback::area_of_an_l::EXAMPLE), "Green", 100.0);
    near(&example(&setback::area_of_a_larger_lot::EXAMPLE), "Green", 100.0);
}

#[test]
fn sections_are_those_of_the_pages() {
    let counts = |page: &Example| {
        example(page).counts().into_iter().map(|(name, count)| format!("{name} {count}")).collect::<Vec<_>>()
    };
    assert_eq!(counts(&setback::perimeter::EXAMPLE), ["Yellow 1", "Blue 1", "Grey 1"]);
    assert_eq!(counts(&setback::perimeter_fronts::EXAMPLE), ["Yellow 1", "Grey 1"]);
    // The section with the index 0 has no depth.
    let [random, indices] = [&setback::perimeter_random::EXAMPLE, &setback::perimeter_indices::EXAMPLE].map(example);
    assert_eq!(random.count("Yellow"), indices.count("Yellow") + 1);
    // "The overlap belongs to the shape that has been generated with larger depth."
    let [left, right] = [&setback::perimeter_left::EXAMPLE, &setback::perimeter_right::EXAMPLE].map(example);
    assert_eq!((areas(&left, "Yellow"), areas(&right, "Blue")), (vec![12.0], vec![12.0]));
    assert!(areas(&left, "Blue")[0] < 8.0 && areas(&right, "Yellow")[0] < 8.0);
}

/// Depths and operations see the counters of their section, and draw numbers of their own.
#[test]
fn sections_have_counters_and_seeds() {
    let model = run("Sections", &lot());
    assert_eq!(printed(&model), ["0 of 4", "1 of 4", "2 of 4", "3 of 4"]);
    assert_eq!((areas(&model, "A").len(), sum(&model, "A")), (4, 32.0));
    let mut drawn = printed(&run("Depths", &lot()));
    let count = drawn.len();
    drawn.sort();
    drawn.dedup();
    assert_eq!((count, drawn.len()), (4, 4));
}

/// The edges of all faces are one chain, so a section may be on two faces. It is one shape.
#[test]
fn a_section_goes_on_from_face_to_face() {
    let two = setback::faces(&[&[[0.0, 0.0], [3.0, 0.0], [0.0, 4.0]], &[[9.0, 0.0], [9.0, 4.0], [6.0, 4.0]]]);
    let model = run("TwoFaces", &two);
    assert_eq!((model.count("A"), model.count("Rest")), (1, 2));
    assert!((model.area() - 12.0).abs() < 1e-9);
}

cga! {
    grammar Parts = r##"
    attr by = 1

    @StartRule
    Front --> setback(by) { front : Strip. | remainder : Rest. }
    @StartRule
    Left --> setback(by) { left : Strip. | remainder : Rest. }
    @StartRule
    BackAndLeft --> setback(by) { back || left : Strip. | remainder : Rest. }
    @StartRule
    All --> setback(by) { all : Strip. | remainder : Rest. }
    @StartRule
    Arms --> setback(by) { left : Rest. | front : Strip. | remainder : NIL }
    @StartRule
    Mapped --> setupProjection(0, scope.xz, 10, 8) projectUV(0) setback(by) { front : Strip. | remainder : Rest. }

    @StartRule
    Section --> splitAndSetbackPerimeter(2) { 4 : 2 : Strip. } { remainder : Rest. }
    @StartRule
    Corner --> splitAndSetbackPerimeter(7) { 5 : 2 : Strip. } { remainder : Rest. }
    @StartRule
    SectionTags --> splitAndSetbackPerimeter(2) { 4 : 2 : Told("section") } { remainder : Told("rest") }
    Told(name) --> comp(fe) { all : print(name + " " + geometry.tags("*", edges)) NIL }
    "##;
}

fn part_of(rule: &str, shape: &Shape) -> Model {
    let model = Parts::default().generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

/// The first edges of the leaves of a rule, as x and z of their ends in the world.
fn first_edges(model: &Model, rule: &str) -> Vec<[[f64; 2]; 2]> {
    let edge = |leaf: cga::LeafView<'_>| {
        let (mesh, place) = leaf.mesh();
        let ring = mesh.face(0).outer();
        [ring[0], ring[1]].map(|point| {
            let at = place.transform_point3(mesh.points()[point as usize]);
            [at.x, at.z].map(|x| (x * 1e6).round() / 1e6 + 0.0)
        })
    };
    model.leaves_of(rule).map(edge).collect()
}

/// Setbacks begin at the outline with an edge that was set back, and the rest with what is nearest to the first edge of the face;
/// holes do not change this.
#[test]
fn first_edges_are_at_the_outline() {
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, -8.0], [0.0, -8.0]];
    let hole = vec![[4.0, -3.0], [6.0, -3.0], [6.0, -5.0], [4.0, -5.0]];
    for holes in [&[][..], &[hole]] {
        let lot = Shape::footprint(&corners, holes).expect("a lot");
        // The edges of the hole have strips of their own, after the strip of the outline.
        let first = |rule: &str| {
            let model = part_of(rule, &lot);
            assert!(model.count("Strip") <= 1 + holes.len());
            (first_edges(&model, "Strip")[0], first_edges(&model, "Rest"))
        };
        let (front, moved) = ([[0.0, 0.0], [10.0, 0.0]], [[0.0, -1.0], [10.0, -1.0]]);
        assert_eq!(first("Front"), (front, vec![moved]));
        let left = [[0.0, -8.0], [0.0, 0.0]];
        assert_eq!(first("Left"), (left, vec![[[1.0, 0.0], [10.0, 0.0]]]));
        let back = [[10.0, -8.0], [0.0, -8.0]];
        assert_eq!(first("BackAndLeft"), (back, vec![[[1.0, 0.0], [10.0, 0.0]]]));
        assert_eq!(first("All"), (front, vec![[[1.0, -1.0], [9.0, -1.0]]]));
        assert_eq!(first("Section"), ([[2.0, 0.0], [6.0, 0.0]], vec![[[0.0, 0.0], [2.0, 0.0]]]));
        assert_eq!(first("Corner").0, [[7.0, 0.0], [10.0, 0.0]]);
    }
}

/// "The operation automatically applies the tags of the setback operation."
#[test]
fn sections_have_the_tags_of_setbacks() {
    let mut lines = printed(&part_of("SectionTags", &lot()));
    lines.sort();
    let line = |part: &str, kind: &str| format!("{part} (1)[setback.{kind}]");
    let mut expected: Vec<String> =
        ["front", "back", "side", "side"].iter().map(|kind| line("section", kind)).collect();
    let kinds = [["back"; 1].as_slice(), &["side"; 2], &["remainder"; 5]].concat();
    expected.extend(kinds.iter().map(|kind| line("rest", kind)));
    expected.sort();
    assert_eq!(lines, expected);
}

/// Parts of a face that is not planar, and of one with texture coordinates, which are interpolated at the new corners.
#[test]
fn bent_faces_are_set_back_and_texture_coordinates_interpolated() {
    let ring = [[0.0, 0.0, 0.0], [10.0, 0.5, 0.0], [10.0, 0.0, -8.0], [0.0, 0.5, -8.0]].map(DVec3::from_array);
    let bent = Shape::mesh(Mesh::from_polygon(&ring, &[]).expect("a face"));
    for (rule, faces) in [("All", 2), ("Front", 2), ("BackAndLeft", 2), ("Section", 2)] {
        let model = part_of(rule, &bent);
        assert_eq!(model.leaves().len(), faces, "{rule}");
        assert!((model.area() - bent.to_mesh().area()).abs() < 0.5, "{rule}: {}", model.area());
    }
    let model = part_of("Mapped", &lot());
    for leaf in model.leaves() {
        let (mesh, place) = leaf.mesh();
        for (corner, uv) in mesh.corners().iter().zip(mesh.uv_set(0)) {
            let at = place.transform_point3(mesh.points()[*corner as usize]);
            assert!((uv.x - at.x / 10.0).abs() < 1e-9 && (uv.y - at.z / 8.0).abs() < 1e-9, "{at} {uv}");
        }
    }
}

/// At a right angle the end of a setback lies on the edge beside it, and the first arm keeps the corner.
#[test]
fn ends_lie_on_the_edges_beside_them() {
    let model = part_of("Front", &lot());
    let size = |rule: &str| model.leaves_of(rule).next().expect("a part").scope().size.to_array();
    assert_eq!((size("Strip"), size("Rest")), ([10.0, 0.0, 1.0], [10.0, 0.0, 7.0]));
    let model = part_of("Arms", &lot());
    assert_eq!((areas(&model, "Rest"), areas(&model, "Strip")), (vec![8.0], vec![9.0]));
}

/// A corner that is rounded by edges of 5 cm: one strip, and the rest without slivers.
#[test]
fn rounded_corners_leave_no_slivers() {
    let arc = (0..=8).map(|k| {
        let angle = f64::from(k) * std::f64::consts::FRAC_PI_2 / 8.0;
        [9.75 + 0.25 * libm::sin(angle), -0.25 + 0.25 * libm::cos(angle)]
    });
    let ring: Vec<[f64; 2]> = [[0.0, 0.0]].into_iter().chain(arc).chain([[10.0, -8.0], [0.0, -8.0]]).collect();
    let lot = Shape::footprint(&ring, &[]).expect("a lot");
    for (rule, rests) in [("All", 1), ("Front", 1), ("Left", 1)] {
        let model = part_of(rule, &lot);
        assert_eq!((model.count("Strip"), model.count("Rest")), (1, rests), "{rule}");
        let least = model.leaves().map(|leaf| leaf.area()).fold(f64::INFINITY, f64::min);
        assert!(5.0 < least && (model.area() - lot.to_mesh().area()).abs() < 1e-9, "{rule}: {least}");
    }
}
