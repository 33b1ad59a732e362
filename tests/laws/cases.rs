//! Differences that the laws found once.

use cga::{DynSession, Grammar, Limits, Model, Repeats, Settings, Shape, cga};

use crate::compare::{Outcome, Tolerance, difference};
use crate::exact;

/// A lot whose places are no round numbers.
fn lot(width: f64, height: f64) -> Shape {
    let [cos, sin] = [0.352, 0.936];
    let outline = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
    let outline = outline.map(|[x, z]| [x * cos - z * sin, x * sin + z * cos]);
    Shape::footprint(&outline, &[]).expect("an outline").at([117.3, 0.313, -1013.7])
}

fn outcome(grammar: &dyn Grammar, settings: &Settings, shape: &Shape) -> Outcome {
    let mut model = Model::new();
    let report = grammar.run(shape, settings, &mut model);
    Outcome { model, report: report.map_err(|error| error.to_string()), replayed: 0 }
}

cga! {
    grammar Mapped;
    Lot  --> split(x) { { 1 : Tile }* }
    Tile --> s(1, 1 + getGeoCoord(lat), 1) Wall.
}

#[test]
fn a_fault_that_is_said_once_is_said_where_no_template_is_made() {
    for repeats in [Repeats::Kept, Repeats::Again, Repeats::Direct] {
        let settings = Settings { repeats, ..Settings::default() };
        let run = outcome(&Mapped::default(), &settings, &lot(5.0, 5.0));
        assert_eq!(run.report.map(|report| report.faults().len()), Ok(1), "{repeats:?}");
    }
}

cga! {
    grammar Full;
    Lot  --> split(y) { ~1 : Fill | 1 : Row }
    Fill --> split(x) { { 0.01 : Small. }* }
    Row  --> split(x) { { 1 : Tile }* }
    Tile --> split(y) { { 0.313 : split(x) { 0.217 : Wall. | ~1 : Lit } }* }
    Lit  --> 40% : Glass. 30% : split(x) { ~1 : Glass. | ~1 : Glass. } else : NIL
}

#[test]
fn a_run_that_a_limit_ends_leaves_no_mark_in_its_session() {
    let full = Full::default();
    for most in 300..330 {
        let settings = Settings { limits: Limits { shapes: most, ..Limits::default() }, ..Settings::default() };
        let mut session = full.session(&settings).expect("a session");
        for width in [3.0, 2.0, 3.0, 1.0] {
            let mut model = Model::new();
            let report = session.run(&lot(width, 4.0), &mut model).map_err(|error| error.to_string());
            let alone = outcome(&full, &settings, &lot(width, 4.0));
            let difference = exact::outcomes(&Outcome { model, report, replayed: 0 }, &alone);
            assert!(difference.is_none(), "{most} shapes, {width} m: {difference:?}");
        }
    }
}

#[test]
fn a_limit_ends_a_run_at_the_same_shape_with_a_template_and_without_one() {
    for most in 100..400 {
        let limits = Limits { shapes: most, ..Limits::default() };
        let run =
            |repeats| outcome(&Full::default(), &Settings { repeats, limits, ..Settings::default() }, &lot(3.0, 4.0));
        let difference = exact::outcomes(&run(Repeats::Kept), &run(Repeats::Again));
        assert!(difference.is_none(), "{most} shapes: {difference:?}");
    }
}

cga! {
    grammar Thick;
    Lot --> s(^1, 2.5, ^1) split(x) { { ~1 : X. }* }
}

#[test]
fn a_piece_of_a_flat_shape_has_no_thickness() {
    let wall = Shape::rectangle(4.0, 3.0);
    for shape in [wall.clone(), wall.held_as_meshes()] {
        let model = Thick::default().generate(&shape).expect("no limit");
        assert_eq!(model.leaves().map(|leaf| leaf.scope().size.min_element()).collect::<Vec<_>>(), [0.0; 4]);
    }
}

cga! {
    grammar Random;
    Lot  --> comp(f) { front : Wall }
    Wall --> split(y) { { ~1 : Row }* }
    Row  --> color(rand(0, 1), rand(0, 1), rand(0, 1)) split(x) { { 1 : Tile }* }
    Tile --> set(material.opacity, 0.5) comp(f) { all : X. }
}

#[test]
fn a_constant_look_on_a_random_colour_keeps_the_colour() {
    let [kept, direct] = [Repeats::Kept, Repeats::Direct].map(|repeats| {
        let settings = Settings { repeats, ..Settings::default() };
        outcome(&Random::default(), &settings, &Shape::cuboid(3.0, 3.0, 3.0))
    });
    assert_eq!(exact::outcomes(&kept, &direct), None);
}

cga! {
    grammar Tiled;
    Lot  --> comp(f) { side : Wall }
    Wall --> split(x) { { 1 : Tile }* }
    Tile --> split(y) { ~1 : Glass. | ~1 : Glass. }
}

#[test]
fn a_session_tells_axes_apart_that_differ_in_the_sign_of_a_zero() {
    let (grammar, settings) = (Tiled::default(), Settings::default());
    let run = |session: &mut dyn DynSession, shape: &Shape| {
        let mut model = Model::new();
        session.run(shape, &mut model).expect("no limit");
        // Text tells -0 and 0 apart.
        model.leaves().map(|leaf| format!("{:?}", leaf.scope())).collect::<Vec<_>>()
    };
    let (solid, flat) = (Shape::cuboid(2.0, 2.0, 2.0), Shape::cuboid(0.0, 2.0, 2.0));
    let alone = run(&mut grammar.session(&settings).expect("a session"), &flat);
    let mut session = grammar.session(&settings).expect("a session");
    run(&mut session, &solid);
    assert_eq!(run(&mut session, &flat), alone);
}

cga! {
    grammar Mixed;
    Lot   --> split(y) { 0.5 : Many | ~1 : color("#808080") Front }
    Many  --> 50% : split(x) { { 0.01 : M1 }* } else : NIL
    M1    --> [ 50% : set(material.opacity, 0.5) M2 else : M2 ]
    M2    --> [ 50% : set(material.metallic, 0.5) M3 else : M3 ]
    M3    --> [ 50% : set(material.roughness, 0.5) M4 else : M4 ]
    M4    --> [ 50% : set(material.name, "m") M5 else : M5 ]
    M5    --> [ 50% : color("#00ff00") M6 else : M6 ]
    M6    --> [ 50% : texture("wall.png") M7 else : M7 ]
    M7    --> [ 50% : set(material.color.rgb, "#0000ff") X. else : X. ]
    Front --> comp(f) { front : split(x) { { ~0.9 : Tile }* } }
    Tile  --> t(0.1, 0.2, 0.3) comp(f) { all : split(x) { ~1 : A. | ~2 : B. } }
}

#[test]
fn many_materials_before_make_no_difference() {
    let (grammar, settings) = (Mixed::default(), Settings::default());
    let mut session = grammar.session(&settings).expect("a session");
    for seed in 0..20 {
        let shape = Shape::cuboid(7.31 + 0.1 * seed as f64, 4.0, 1.0).at([117.3, 0.313, -1013.7]).seed(seed);
        let mut model = Model::new();
        let report = session.run(&shape, &mut model).map_err(|error| error.to_string());
        let alone = outcome(&grammar, &settings, &shape);
        assert_eq!(exact::outcomes(&Outcome { model, report, replayed: 0 }, &alone), None, "seed {seed}");
        let again = outcome(&grammar, &Settings { repeats: Repeats::Again, ..settings.clone() }, &shape);
        assert_eq!(exact::outcomes(&again, &alone), None, "seed {seed}");
    }
}

cga! {
    grammar Halves;
    Lot --> comp(f) { side : split(y) { 0 : Wall. } | top : Roof. split(x) { 0 : Wall. } }
}

#[test]
fn the_leaf_of_a_block_without_pieces_is_a_shape() {
    for shape in [Shape::cuboid(4.0, 3.0, 2.0), Shape::cuboid(4.0, 3.0, 2.0).held_as_meshes()] {
        let run = outcome(&Halves::default(), &Settings::default(), &shape);
        let report = run.report.expect("no limit");
        assert_eq!((report.shapes, report.leaves, report.stopped), (6, 5, false));
        assert_eq!(
            run.model.leaves().map(|leaf| leaf.rule()).collect::<Vec<_>>(),
            ["Lot", "Lot", "Lot", "Lot", "Roof"]
        );
    }
}

cga! {
    grammar Overlapping;
    Lot --> s(^(-1), ^1, ^1) extrude(world.up, 0.2) split(x) { 1.5 : X. }
}

/// The section is two rectangles of one size, one of them a hole: the sum of their areas is rounding.
#[test]
fn the_last_bit_of_a_size_does_not_turn_a_section_inside_out() {
    let loops = |height: f64| {
        let model = Overlapping::default().generate(&Shape::cuboid(4.5151, height, 4.9708)).expect("no limit");
        let leaf = model.leaves().next().expect("a leaf");
        let (mesh, _) = leaf.mesh();
        mesh.faces().map(|face| face.loops().map(<[u32]>::to_vec).collect()).collect::<Vec<Vec<_>>>()
    };
    assert_eq!(loops(0.579_035_589_999_999_9), loops(0.579_035_59));
}

cga! {
    grammar Mitred;
    Lot   --> comp(f) { front : scatter(volume, 1, uniform) { Board } }
    Board --> primitiveQuad(0.672, 2.7585) comp(f) { 0 : Wall. }
}

#[test]
fn geometry_at_points_ends_at_the_planes_of_the_face_below() {
    let size = |shape: &Shape| {
        let run = outcome(&Mitred::default(), &Settings::default(), shape);
        run.model.leaves().map(|leaf| leaf.scope().size).collect::<Vec<_>>()
    };
    let shape = Shape::cuboid(10.0, 10.0, 10.0).seed(3);
    let [own, mesh] = [size(&shape), size(&shape.clone().held_as_meshes())];
    assert_eq!(own.len(), 1);
    assert!((own[0] - mesh[0]).length() < 1e-9, "{own:?} {mesh:?}");
}

cga! {
    grammar Whole;
    Lot --> X.
}

/// A rectangle of 2 x 1 m that ends with a face of some width.
fn divided(width: f64) -> Shape {
    let mut builder = cga::MeshBuilder::new();
    let edge = 2.0 - width;
    let points = [[0.0, 0.0], [edge, 0.0], [2.0, 0.0], [2.0, 1.0], [edge, 1.0], [0.0, 1.0]];
    let points = points.map(|[x, y]| builder.point([x, y, 0.0]));
    if 0.0 < width {
        builder.polygon(&[0, 1, 4, 5].map(|at: usize| points[at]));
        builder.polygon(&[1, 2, 3, 4].map(|at: usize| points[at]));
    } else {
        builder.polygon(&[0, 2, 3, 5].map(|at: usize| points[at]));
    }
    Shape::mesh_axis_aligned(builder.build().expect("a mesh"))
}

/// A cut that follows an edge up to rounding makes such a face or does not.
#[test]
fn faces_that_are_thinner_than_rounding_are_no_difference() {
    let run = |width: f64| outcome(&Whole::default(), &Settings::default(), &divided(width));
    let compared = |width: f64| difference(&run(0.0), &run(width), Tolerance { length: 1e-9 });
    assert_eq!(compared(1e-15), None);
    assert_eq!(compared(0.0), None);
    assert!(compared(1e-6).is_some_and(|text| text.contains("the number of faces: 1 and 2")));
    // Beside a thin face, all else must be alike.
    let turned = outcome(
        &Whole::default(),
        &Settings::default(),
        &Shape::mesh_axis_aligned(divided(1e-15).to_mesh().reversed()),
    );
    let found = difference(&run(0.0), &turned, Tolerance { length: 1e-9 });
    assert!(found.is_some_and(|text| text.contains("the number of faces: 1 and 2")));
    assert!(difference(&run(1e-15), &turned, Tolerance { length: 1e-9 }).is_some());
}

/// A triangle of 1 m², and a triangle without area on one of its sides, which begins at a corner.
fn with_flat_cap(first: usize) -> Shape {
    let mut builder = cga::MeshBuilder::new();
    let points = [[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [-1.0, 0.0]];
    let points: Vec<u32> = points.iter().map(|&[x, y]| builder.point([x, y, 0.0])).collect();
    builder.polygon(&[0, 1, 2].map(|at| points[(at + first) % 3]));
    builder.polygon(&[points[3], points[0], points[2]]);
    Shape::mesh_axis_aligned(builder.build().expect("a mesh"))
}

/// Seed 5493: rounding decides how the cap of flat geometry begins.
#[test]
fn the_first_corner_of_a_face_without_area_is_no_difference() {
    let run = |first: usize| outcome(&Whole::default(), &Settings::default(), &with_flat_cap(first));
    assert_eq!(difference(&run(0), &run(1), Tolerance { length: 1e-9 }), None);
}

cga! {
    grammar Edited;
    Lot  --> extrude(0.8828) comp(f) { side : Wall }
    Wall --> modify(f, noAlign) { top = r(scopeCenter, 0, 0, 10) X. } primitiveDisk(6) Disk.
}

/// The parts that `modify` joins are flat except for rounding.
#[test]
fn rounding_does_not_choose_the_plane_of_a_primitive() {
    for (width, depth) in [(0.0626, 0.0499), (0.0543, 0.0638), (12.7, 4.3), (0.0391, 52.7)] {
        let shape = lot(width, depth);
        for shape in [shape.clone(), shape.held_as_meshes()] {
            let run = outcome(&Edited::default(), &Settings::default(), &shape);
            let sizes: Vec<_> = run.model.leaves().map(|leaf| leaf.scope().size).collect();
            assert_eq!(sizes.len(), 4);
            assert!(sizes.iter().all(|size| size.z == 0.0 && 0.8 < size.y), "{sizes:?}");
        }
    }
}

cga! {
    grammar Textured;
    attr more = 0
    Lot --> setupProjection(0, scope.xy, ^1, ^1) projectUV(0) translateUV(0, more, 0) X.
}

/// A strip of a micrometre, a hundred metres from the origin: its coordinates have the rounding of its place.
#[test]
fn coordinates_differ_by_the_rounding_of_positions_alone() {
    let run = |width: f64, more: f64| {
        let shape = Shape::rectangle(width, 1.0).at([117.3, 0.0, 0.0]);
        outcome(&Textured { more }, &Settings::default(), &shape)
    };
    let compared = |width: f64, more: f64| difference(&run(width, 0.0), &run(width, more), Tolerance { length: 1e-9 });
    assert_eq!(compared(1e-6, 1e-8), None);
    assert!(compared(1e-6, 2e-7).is_some_and(|text| text.contains("the coordinates in set 0")));
    assert!(compared(1.0, 1e-8).is_some_and(|text| text.contains("the coordinates in set 0")));
    // A box: the coordinates of the faces across x change in the other faces alone (seed 5567).
    let run = |width: f64, more: f64| {
        let shape = Shape::cuboid(width, 1.0, 1.0).at([117.3, 0.0, 0.0]);
        outcome(&Textured { more }, &Settings::default(), &shape)
    };
    let compared = |width: f64, more: f64| difference(&run(width, 0.0), &run(width, more), Tolerance { length: 1e-9 });
    assert_eq!(compared(1e-6, 1e-8), None);
    assert!(compared(1.0, 1e-8).is_some_and(|text| text.contains("the coordinates in set 0")));
}
