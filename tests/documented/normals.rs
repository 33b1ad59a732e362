//! *setNormals* and *softenNormals operations*.

use std::sync::Arc;

use cga::{Mesh, Settings, Shape, cga};

use cga_tests::pages::example::Example;
use cga_tests::pages::normals as pages;

/// The mesh of the first leaf.
fn mesh(example: &Example) -> Arc<Mesh> {
    let model = example.model(&Settings::default());
    assert!(model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
    let (mesh, _) = model.leaves().next().expect("a leaf").mesh();
    mesh
}

/// "Use the face normals." "For each vertex, use the average of the adjacent face normals."
#[test]
fn a_sphere_is_faceted_or_smooth() {
    assert!(mesh(&pages::sphere_hard::EXAMPLE).normals().is_empty());
    let soft = mesh(&pages::sphere_soft::EXAMPLE);
    let centre = (soft.bounds().low + soft.bounds().high) * 0.5;
    assert_eq!(soft.normals().len(), soft.corners().len());
    for (point, normal) in soft.corners().iter().zip(soft.normals()) {
        assert!(0.999 < (soft.points()[*point as usize] - centre).normalize().dot(*normal));
    }
}

/// "Edges where face normals meet at an angle greater than or equal as specified are shaded as hard edges."
#[test]
fn the_rim_of_a_hemisphere_is_hard_with_30_and_soft_with_180() {
    let [hard, auto, soft] =
        [pages::hemisphere_0::EXAMPLE, pages::hemisphere_30::EXAMPLE, pages::hemisphere_180::EXAMPLE];
    assert!(mesh(&hard).normals().is_empty());
    for (example, is_soft) in [(auto, false), (soft, true)] {
        let half = mesh(&example);
        let cap = half.faces().max_by(|a, b| a.area().total_cmp(&b.area())).expect("the cap");
        let flat = cap.normal();
        for corner in cap.corner_range() {
            let normal = half.normals()[corner];
            assert_eq!((normal - flat).length() < 1e-9, !is_soft, "{}: {normal}", example.title);
        }
        // The round side is smooth in both.
        let round = half.faces().filter(|face| face.index() != cap.index() && face.normal().dot(flat) < -0.5);
        for face in round {
            let differ = |corner: usize| 1e-3 < (half.normals()[corner] - face.normal()).length();
            assert!(face.corner_range().any(differ));
        }
    }
}

/// "Computes consistent normals using the connectivity and a heuristic that favors the world's up direction."
#[test]
fn a_building_looks_outwards_again() {
    let [before, after] =
        [pages::inconsistent::EXAMPLE, pages::consistent::EXAMPLE].map(|example| example.model(&Settings::default()));
    assert!(before.leaves_of("Down").any(|leaf| leaf.area() != 108.0 && leaf.area() != 36.0 && leaf.area() != 40.0));
    assert!(after.faults().is_empty());
    // Only the floors look down.
    assert_eq!(after.leaves_of("Down").map(|leaf| leaf.area()).collect::<Vec<_>>(), [108.0, 36.0, 40.0]);
    let mesh = run_conform(&(pages::consistent::EXAMPLE.start)());
    assert!(mesh.is_closed() && (mesh.volume() - (108.0 * 7.0 + 36.0 * 5.0 + 40.0 * 5.0)).abs() < 1e-9);
}

fn run_conform(shape: &Shape) -> Arc<Mesh> {
    let rules = cga! { Houses --> setNormals(conform) Houses. };
    let model = rules.generate(shape).expect("a model");
    let (mesh, _) = model.leaves().next().expect("a leaf").mesh();
    mesh
}
