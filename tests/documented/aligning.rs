//! Pages about scopes that turn around their geometry, round primitives, and extrusion: *primitiveQuad*, *primitiveDisk*,
//! *primitiveSphere*, *primitiveCone*, *translate*, *rotate*, *alignScopeToAxes*, *alignScopeToGeometry*, *setPivot*,
//! *reverseNormals*, *extrude*.

use cga::glam::DVec3;
use cga::{Model, Settings, Shape, cga};

cga! {
    @Allow(undefined_rule)
    grammar Pages = r##"
    @StartRule
    QuadAcross --> rotateScope(0, 0, 90) primitiveQuad(10,20)
    @StartRule
    DiskAcross --> rotateScope(-90, 0, 0) primitiveDisk(8,10)
    @StartRule
    Sphere --> primitiveSphere(8,4,10)
    @StartRule
    Cone --> primitiveCone(8,10,15)

    # translate operation, along the axes of the world and of the object
    @StartRule
    InWorld --> primitiveCube() X translate(rel, world, 2, 0, 0) color("#ff0000") X
    @StartRule
    InObject --> primitiveCube() X translate(rel, object, 2, 0, 0) color("#ff0000") X

    # rotate operation
    @StartRule
    Init -->
       extrude(10)
       t('0.2, 0, '0.3)
       s('0.5, '1, '0.5)
       rotate(abs, world, 0, 90, 0)

    # alignScopeToAxes operation
    @StartRule
    A-->
       t(5,0,4) s(8,24,8) r(10,20,30)
       primitiveCube()
       alignScopeToAxes()
       print("t " + scope.tx + " r " + scope.rx) A.
    @StartRule
    Upright-->
       t(5,0,4) s(8,24,8) r(10,20,30)
       primitiveCube()
       alignScopeToAxes(y) A.

    # alignScopeToGeometry operation, on each face of a roof: y goes up it.
    @StartRule
    Roof --> s(20, 10, 20) primitiveCone(4) comp(f) { side : Slope }
    Slope --> alignScopeToGeometry(zUp, any, world.lowest) Slope.

    # setPivot operation
    @StartRule
    Corner --> s(2, 3, 4) primitiveCube() setPivot(yzx, 6) print("x " + scope.sx + " y " + scope.sy + " z " + scope.sz) Corner.

    # reverseNormals operation: only what is there changes, so both move the same way.
    @StartRule
    Lot -->
        extrude(world.up,1)
        comp(f){side: Facade}
    Facade -->
        case comp.index == 0:
            t(0,0,0.1)
            reverseNormals
        else:
            t(0,0,0.1)

    # extrude operation, with a flat top
    @StartRule
    Higher --> extrude(world.up.flatTop, 10) print(scope.sy) Flat.
    @StartRule
    Least --> extrude(world.up.flatTop, 0) print(scope.sy) Flat.
    @StartRule
    Down --> extrude(world.up.flatTop, -10) print(scope.sy) Flat.
    "##;
}

fn run(rule: &str, shape: &Shape) -> Model {
    let settings = Settings { start: Some(rule.into()), ..Settings::default() };
    let model = Pages::default().generate_with(shape, &settings).unwrap();
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

fn near(a: DVec3, b: [f64; 3]) -> bool {
    (a - DVec3::from_array(b)).length() < 1e-9
}

#[test]
fn flat_primitives_lie_in_the_plane_of_the_two_sizes() {
    let lot = Shape::rectangle(27.0, 19.0);
    let quad = run("QuadAcross", &lot);
    let bounds = quad.leaves().next().unwrap().bounds();
    // Ten wide and twenty long, in the middle of the lot and lying on it.
    assert!(near(bounds.size(), [10.0, 0.0, 20.0]) && near(bounds.low, [8.5, 0.0, -0.5]), "{bounds:?}");
    let (mesh, placement) = quad.leaves().next().unwrap().mesh();
    assert!(near(placement.transform_vector3(mesh.face(0).normal()), [0.0, 1.0, 0.0]));
    let disk = run("DiskAcross", &lot);
    let bounds = disk.leaves().next().unwrap().bounds();
    let wide = 20.0 * libm::cos(std::f64::consts::PI / 8.0);
    assert!(near(bounds.size(), [wide, 0.0, wide]) && near(bounds.low + bounds.size() * 0.5, [13.5, 0.0, 9.5]));
}

#[test]
fn round_primitives_of_a_radius_have_their_corners_on_the_circle() {
    let lot = Shape::rectangle(27.0, 19.0);
    for (rule, faces, high) in [("Sphere", 32, 20.0), ("Cone", 9, 15.0)] {
        let model = run(rule, &lot);
        let leaf = model.leaves().next().unwrap();
        assert_eq!((leaf.mesh().0.face_count(), leaf.mesh().0.is_closed()), (faces, true));
        let wide = 20.0 * libm::cos(std::f64::consts::PI / 8.0);
        assert!(near(leaf.bounds().size(), [wide, high, wide]), "{rule}: {:?}", leaf.bounds());
    }
    // A third of the base's area times the height.
    let volume = 15.0 / 3.0 * (4.0 * 100.0 * libm::sin(std::f64::consts::PI / 4.0));
    assert!((run("Cone", &lot).volume() - volume).abs() < 1e-9);
}

/// *translate operation*: copies along the axes of the world, and along the axes of a lot that is turned.
#[test]
fn copies_go_along_the_axes_of_the_world_or_of_the_object() {
    let lot = Shape::footprint(&[[0.0, 0.0], [0.0, 10.0], [-5.0, 10.0], [-5.0, 0.0]], &[]).unwrap();
    for (rule, way) in [("InWorld", DVec3::X), ("InObject", lot.pivot().axes.x_axis)] {
        let model = run(rule, &lot);
        let found: Vec<_> = model.leaves().map(|leaf| (leaf.scope().origin, leaf.material().color.is_some())).collect();
        assert_eq!((found.len(), found[0].1, found[1].1), (2, false, true));
        assert!((found[1].0 - found[0].0 - 2.0 * way).length() < 1e-12, "{rule}");
    }
    assert!((lot.pivot().axes.x_axis - DVec3::X).length() > 1.0);
}

#[test]
fn an_orientation_can_be_set() {
    let scope = run("Init", &Shape::rectangle(8.0, 6.0)).leaves().next().unwrap().scope();
    assert!(near(scope.axes.x_axis, [0.0, 0.0, -1.0]) && near(scope.axes.y_axis, [0.0, 1.0, 0.0]));
    assert!(near(scope.origin, [1.6, 0.0, 1.8]) && near(scope.size, [4.0, 10.0, 3.0]));
}

#[test]
fn aligned_scopes_are_boxes_around_what_stays() {
    for (rule, upright) in [("A", false), ("Upright", true)] {
        let model = run(rule, &Shape::cuboid(1.0, 1.0, 1.0));
        let leaf = model.leaves().next().unwrap();
        assert!((model.volume() - 8.0 * 24.0 * 8.0).abs() < 1e-9);
        assert!(near(leaf.scope().axes.y_axis, [0.0, 1.0, 0.0]));
        assert_eq!(near(leaf.scope().axes.x_axis, [1.0, 0.0, 0.0]), !upright);
        assert!((leaf.scope().size.y - leaf.bounds().size().y).abs() < 1e-9);
    }
    assert_eq!(run("A", &Shape::cuboid(1.0, 1.0, 1.0)).prints()[0].to_string(), "t 0 r 0");
}

#[test]
fn the_lowest_edge_of_a_slope_is_its_x_axis() {
    let model = run("Roof", &Shape::rectangle(20.0, 20.0));
    assert_eq!(model.count("Slope"), 4);
    for leaf in model.leaves_of("Slope") {
        let axes = leaf.scope().axes;
        assert!(axes.x_axis.y.abs() < 1e-12 && 0.5 < axes.y_axis.y && 0.5 < axes.z_axis.y, "{axes}");
        assert!(leaf.scope().size.z.abs() < 1e-9 && (leaf.scope().size.x - 20.0).abs() < 1e-9);
    }
}

#[test]
fn a_pivot_at_another_corner_has_other_axes() {
    let model = run("Corner", &Shape::rectangle(1.0, 1.0));
    let leaf = model.leaves().next().unwrap();
    assert_eq!(leaf.scope().origin.to_array(), [2.0, 3.0, 4.0]);
    // At corner 6 `xyz` has -z, -y, -x; `yzx` begins with the last of them.
    assert_eq!(model.prints()[0].to_string(), "x 2 y 4 z 3");
    assert_eq!(leaf.scope().axes.y_axis.to_array(), [0.0, 0.0, -1.0]);
    assert!((model.volume() - 24.0).abs() < 1e-12);
}

#[test]
fn a_face_turned_over_moves_the_same_way() {
    let model = run("Lot", &Shape::rectangle(4.0, 4.0));
    assert_eq!(model.count("Facade"), 4);
    for (number, leaf) in model.leaves_of("Facade").enumerate() {
        let out = leaf.scope().axes.z_axis;
        let (mesh, placement) = leaf.mesh();
        let normal = placement.transform_vector3(mesh.face(0).normal());
        assert!((normal - if number == 0 { -out } else { out }).length() < 1e-12);
        assert!((leaf.scope().centre() - DVec3::new(2.0, 0.5, 2.0)).dot(out) - 2.1 < 1e-12);
    }
}

/// *extrude operation*: `world.up.flatTop` with the distance 0 and with others.
#[test]
fn a_flat_top_on_a_slope() {
    let corners = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [4.0, 3.0, 0.0], [0.0, 3.0, 0.0]].map(DVec3::from_array);
    let slope = Shape::mesh(cga::Mesh::from_polygon(&corners, &[]).unwrap());
    for (rule, high, volume) in [("Higher", "10", 170.0), ("Least", "3", 30.0), ("Down", "-10", 170.0)] {
        let model = run(rule, &slope);
        assert_eq!(model.prints()[0].to_string(), high);
        assert!((model.volume().abs() - volume).abs() < 1e-9, "{rule}: {}", model.volume());
    }
}
