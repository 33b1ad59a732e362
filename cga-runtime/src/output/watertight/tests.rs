use glam::{DMat3, DVec2, DVec4};

use super::*;
use crate::geometry::uv_map::UvMap;
use crate::output::model::Model;
use crate::value::text::Text;

fn wall([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Quad {
    Quad::new(DVec3::new(x, y, 0.0), DVec3::X * width, DVec3::Y * height)
}

/// A wall of three metres below walls of one and two metres.
fn storeys() -> [Quad; 3] {
    [wall([0.0, 0.0], [3.0, 1.0]), wall([0.0, 1.0], [1.0, 1.0]), wall([1.0, 1.0], [2.0, 1.0])]
}

fn with_leaf<R>(uvs: &[SetMap], then: impl FnOnce(Leaf<'_>) -> R) -> R {
    let (material, scope) =
        (Arc::new(Material::default()), Scope { origin: DVec3::ZERO, axes: glam::DMat3::IDENTITY, size: DVec3::ONE });
    then(Leaf::new(&Text::fixed("Wall"), &material, &scope).with_uvs(uvs))
}

/// The number of corners of each leaf.
fn corners(model: &Model) -> Vec<usize> {
    model.leaves().map(|leaf| leaf.mesh().0.corners().len()).collect()
}

#[test]
fn the_point_in_an_edge_has_values_between_its_ends() {
    let map = UvMap { u: DVec4::new(0.5, 0.0, 0.0, 0.0), v: DVec4::new(0.0, 2.0, 0.0, 0.0) };
    let mut sink = Watertight::new(Model::new());
    with_leaf(&[SetMap { set: 0, map }], |leaf| {
        assert!(storeys().iter().all(|quad| sink.quad(&leaf, quad).is_continue()));
    });
    let model = sink.into_inner();
    // The wall with five corners is three triangles.
    assert_eq!(corners(&model), [9, 4, 4]);
    let (mesh, _) = model.leaves().next().expect("a leaf").mesh();
    let at = (0..9).find(|&corner| mesh.points()[mesh.corners()[corner] as usize] == DVec3::new(1.0, 1.0, 0.0));
    assert_eq!(mesh.uvs()[at.expect("the new corner")], DVec2::new(0.5, 2.0));
    assert_eq!(mesh.area(), 3.0);
}

#[test]
fn initial_shapes_and_instances_keep_their_corners() {
    let mut sink = Watertight::new(Model::new());
    with_leaf(&[], |leaf| {
        for quad in storeys() {
            sink.begin_building("", 0);
            let _ = sink.quad(&leaf, &quad);
            sink.end_building(&|| Building::new("", 0));
        }
        let _ = sink.instance(&leaf, &quad_mesh(&leaf, &storeys()[0]), &DAffine3::IDENTITY);
        let _ = sink.quad(&leaf, &storeys()[1]);
    });
    assert_eq!(corners(&sink.into_inner()), [4, 4, 4, 4, 4]);
}

#[test]
fn a_closed_mesh_at_another_place_stays_closed() {
    let cube = Arc::new(crate::geometry::primitive::cube());
    let place = DAffine3::from_translation(DVec3::new(0.3, 7.1, 2.7));
    let mut sink = Watertight::new(Model::new());
    with_leaf(&[], |leaf| {
        let _ = sink.mesh(&leaf, &cube, &place);
        // Its corners are inside of two edges of the cube.
        let beside = Quad::new(DVec3::new(1.3, 7.4, 3.7), DVec3::X, DVec3::Y * 0.2);
        let _ = sink.quad(&leaf, &beside);
    });
    let model = sink.into_inner();
    let divided = model.leaves().next().expect("the cube");
    // Two faces with six corners each are four triangles each.
    assert_eq!(corners(&model), [4 * 4 + 2 * 4 * 3, 4]);
    assert!(divided.mesh().0.is_closed() && divided.mesh().0.check().is_empty());
    assert!((divided.volume() - 1.0).abs() < 1e-12);
}

/// Takes one leaf.
#[derive(Default)]
struct One(usize);

impl Sink for One {
    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.0 += 1;
        ControlFlow::Break(())
    }
}

#[test]
fn a_sink_that_ends_the_run_ends_it_here_too() {
    let mut sink = Watertight::new(One::default());
    with_leaf(&[], |leaf| {
        assert!(storeys().iter().all(|quad| sink.quad(&leaf, quad).is_continue()));
        sink.end_building(&|| Building::new("", 0));
        assert!(sink.quad(&leaf, &storeys()[0]).is_break());
    });
    assert!(sink.finish().is_break());
    assert_eq!(sink.into_inner().0, 1);
}

/// A bar of a window beside four others: points in two edges of a narrow face.
#[test]
fn a_bar_beside_others_has_all_their_corners() {
    let mut sink = Watertight::new(Model::new());
    with_leaf(&[], |leaf| {
        let bar = |origin: DVec3, size: DVec3| Cuboid::new(origin, DMat3::from_diagonal(size));
        let _ = sink.cuboid(&leaf, &bar(DVec3::new(1.2, 0.8, 10.8), DVec3::new(0.1, 2.85, 0.26)));
        for [y, height] in [[0.8, 0.1], [2.6133, 0.08], [3.55, 0.1]] {
            let _ = sink.cuboid(&leaf, &bar(DVec3::new(1.3, y, 10.8), DVec3::new(1.96, height, 0.26)));
        }
    });
    let model = sink.into_inner();
    let (mesh, _) = model.leaves().next().expect("the bar").mesh();
    assert!(mesh.is_closed() && mesh.check().is_empty());
    assert_eq!(mesh.face_count(), 25);
    let has_long_edge = |face: crate::geometry::mesh::FaceRef<'_>| {
        let inner =
            |point: &DVec3| (point.x - 1.3).abs() < 1e-9 && [0.8, 3.65].iter().any(|y| (point.y - y).abs() < 1e-9);
        let depths: Vec<f64> = face.outline().filter(inner).map(|point| point.z).collect();
        depths.len() == 2 && depths[0] == depths[1]
    };
    assert!(!mesh.faces().any(has_long_edge));
}
