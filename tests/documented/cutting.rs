//! *split operation*, Cutting Geometry, and what the page says of hollow meshes.

use cga::{Model, Shape};

use cga_tests::pages::assets::{settings, settings_with};
use cga_tests::pages::cutting::{SIDES, cylinder, cylinder_cut};
use cga_tests::pages::meshes;

/// Area of the regular polygon with that many corners.
fn section(sides: u32, radius: f64) -> f64 {
    0.5 * f64::from(sides) * radius * radius * libm::sin(std::f64::consts::TAU / f64::from(sides))
}

#[track_caller]
fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found}, not {expected}");
}

/// Of the cylinder that is inserted: 0.5, for a length of 4 that becomes 10.
const RADIUS: f64 = 1.25;

#[test]
fn an_inserted_cylinder_fits_the_line_and_is_lifted_to_the_ground() {
    let model = cylinder::EXAMPLE.model(&settings());
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    let leaf = model.leaves().next().unwrap();
    assert_eq!((model.len(), leaf.rule()), (1, "A"));
    for (found, expected) in
        [(leaf.bounds().low, [0.0, 0.0, -RADIUS]), (leaf.bounds().high, [10.0, 2.0 * RADIUS, RADIUS])]
    {
        assert!((found - cga::glam::DVec3::from_array(expected)).abs().max_element() < 1e-9, "{found}");
    }
    near(leaf.volume(), 10.0 * section(SIDES, RADIUS));
}

#[test]
fn a_cut_cylinder_is_six_closed_pieces_with_gaps() {
    let model = cylinder_cut::EXAMPLE.model(&settings());
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    assert_eq!(model.counts(), [("XX", 6)]);
    // Five times 0.75 and 1, then 0.5, stretched by 10 / 9.25.
    let stretch = 10.0 / 9.25;
    for (at, leaf) in model.leaves().enumerate() {
        let length = stretch * if at < 5 { 0.75 } else { 0.5 };
        near(leaf.scope().origin.x, stretch * 1.75 * at as f64);
        near(leaf.scope().origin.y, 0.0);
        assert!((leaf.size() - leaf.bounds().size()).abs().max_element() < 1e-9);
        near(leaf.size().x, length);
        near(leaf.size().y, 2.0 * RADIUS);
        near(leaf.volume(), length * section(SIDES, RADIUS));
        let (mesh, _) = leaf.mesh();
        assert!(mesh.is_closed() && mesh.check().is_empty());
        assert_eq!(mesh.face_count() as u32, SIDES + 2);
        let caps = mesh.faces().filter(|face| face.tag().cap).count();
        assert_eq!(caps, if at == 0 || at == 5 { 1 } else { 2 }, "the ends of the cylinder are no caps");
    }
}

/// Runs `XX` slices over a mesh that stands for the initial shape.
fn sliced(mesh: cga::Mesh) -> Model {
    cga::cga! { @Allow(undefined_rule) grammar Slices = r#"A--> split(x) { ~1 : XX }*"#; }
    Slices::default().generate(&Shape::mesh_axis_aligned(mesh)).unwrap()
}

#[test]
fn hollow_meshes_are_closed_with_rings() {
    let model = sliced(meshes::lying_tube(SIDES, [0.5, 1.0], 8.0));
    assert_eq!(model.counts(), [("XX", 8)]);
    let ring = section(SIDES, 1.0) - section(SIDES, 0.5);
    let side = 2.0 * f64::from(SIDES) * libm::sin(std::f64::consts::PI / f64::from(SIDES));
    for leaf in model.leaves() {
        let (mesh, _) = leaf.mesh();
        assert!(mesh.is_closed() && mesh.check().is_empty());
        assert_eq!(mesh.face_count() as u32, 2 * SIDES + 2);
        assert_eq!(mesh.faces().map(|face| face.holes().count()).sum::<usize>(), 2, "both ends are rings");
        near(leaf.volume(), ring);
        near(leaf.area(), 2.0 * ring + 1.5 * side);
    }
}

/// A gutter: the lower half of a cylinder's wall. No section of it is closed.
#[test]
fn open_surfaces_get_no_caps() {
    let whole = meshes::lying_cylinder(SIDES, 1.0, 4.0);
    let mut gutter = cga::MeshBuilder::new();
    for point in whole.points() {
        gutter.point(*point);
    }
    for face in whole.faces().filter(|face| face.normal().y < 0.0) {
        gutter.face(face.outer(), &[], face.tag());
    }
    let model = sliced(gutter.build().unwrap());
    assert_eq!(model.counts(), [("XX", 4)]);
    for leaf in model.leaves() {
        let (mesh, _) = leaf.mesh();
        assert!(!mesh.is_closed());
        assert_eq!(mesh.face_count() as u32, SIDES / 2);
        near(leaf.area(), f64::from(SIDES) * libm::sin(std::f64::consts::PI / f64::from(SIDES)));
    }
}

/// The rules of the page on a hollow cylinder.
#[test]
fn a_hollow_cylinder_is_cut_like_a_full_one() {
    let model = cylinder_cut::EXAMPLE.model(&settings_with(meshes::lying_tube(SIDES, [0.25, 0.5], 4.0)));
    assert_eq!(model.counts(), [("XX", 6)]);
    for leaf in model.leaves() {
        assert!(leaf.mesh().0.is_closed());
        near(leaf.volume(), leaf.size().x * (section(SIDES, RADIUS) - section(SIDES, 0.5 * RADIUS)));
    }
}
