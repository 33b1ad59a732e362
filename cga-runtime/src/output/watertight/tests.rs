use std::cell::Cell;
use std::rc::Rc;

use glam::{DMat3, DVec2, DVec4};

use super::*;
use crate::geometry::each::Each;
use crate::geometry::mesh::MeshBuilder;
use crate::geometry::uv_map::{SetMap, UvMap};
use crate::material::Material;
use crate::output::model::Model;
use crate::run::sink::quad_mesh;
use crate::shape::scope::Scope;
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
    with_leaf(&[SetMap { set: 0, maps: map.into() }], |leaf| {
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

fn block(origin: [f64; 3], size: [f64; 3]) -> Cuboid {
    Cuboid::new(DVec3::from(origin), DMat3::from_diagonal(DVec3::from(size)))
}

/// The model of some boxes, and the units of work between questions: all, and the most.
fn watertight(blocks: &[Cuboid]) -> (Model, [u64; 2]) {
    let counts = Rc::new(Cell::new([0, 0]));
    let own = counts.clone();
    let _supervisor = Supervisor::new(move |units| {
        let [all, most] = own.get();
        own.set([all + units, most.max(units)]);
        true
    });
    let mut sink = Watertight::new(Model::new());
    with_leaf(&[], |leaf| {
        for block in blocks {
            let _ = sink.cuboid(&leaf, block);
        }
    });
    let model = sink.into_inner();
    let _ = work::ask();
    (model, counts.get())
}

/// Shapes that took quadratic time, or would get corners without limit.
#[test]
fn the_work_for_very_many_parts_in_one_place_is_bounded() {
    /// The most units of work between two questions, and for each part.
    const MOST: [u64; 2] = [1 << 18, 20_000];
    let unit = [1.0; 3];
    let kinds: [&dyn Fn(f64, f64) -> Cuboid; 6] = [
        // Many parts in one place, and the last one on a part of an edge.
        &|at, count| if at + 1.0 < count { block([0.0; 3], unit) } else { block([0.0, 1.0, 0.0], [0.5, 1.0, 1.0]) },
        &|at, _| block([0.0; 3], [1.0 + at / 8192.0; 3]),
        // Many parts along an edge of the first one.
        &|at, count| if at == 0.0 { block([0.0; 3], [count, 1.0, 1.0]) } else { block([at, 1.0, 0.0], unit) },
        &|at, count| block([at, 0.0, 0.0], [2.0 * count, 1.0, 1.0]),
        &|at, _| block([at * 1e-4, 0.0, 0.0], [1e-4, 100.0, 1e-4]),
        // Parts at two places far from each other.
        &|at, _| block([if at % 2.0 == 0.0 { 0.0 } else { 1e7 }, at, 0.0], [1.0, 2.0, 1.0]),
    ];
    for (kind, make) in kinds.iter().enumerate() {
        let work = [150, 600].each(|count| {
            let blocks: Vec<Cuboid> = (0..count).map(|at| make(f64::from(at), f64::from(count))).collect();
            let (model, [all, most]) = watertight(&blocks);
            assert!(most <= MOST[0], "{kind}: {most} units of work between two questions");
            assert!(all <= MOST[1] * count as u64, "{kind}: {all} units of work for {count} parts");
            let corners = corners(&model).iter().sum::<usize>();
            assert!(corners <= 9 * 24 * count as usize + MOST_CORNERS.1, "{kind}: {corners} corners of {count} parts");
            all
        });
        // Four times as many parts, and logarithms.
        assert!(work[1] < 7 * work[0] || work[1] < 1 << 21, "{kind}: {work:?} units of work");
    }
}

#[test]
fn the_place_of_a_shape_does_not_matter() {
    let blocks = |origin: [f64; 3]| {
        let at = |x: f64, y: f64| [origin[0] + x, origin[1] + y, origin[2]];
        [block(at(0.0, 0.0), [4.0, 1.0, 1.0]), block(at(0.0, 1.0), [1.0; 3]), block(at(1.0, 1.0), [3.0, 1.0, 1.0])]
    };
    let near = corners(&watertight(&blocks([0.0; 3])).0);
    // The lower block has a point in two edges: its upper side has four triangles, and two other sides have three.
    assert_eq!(near, [4 * 3 + 2 * 3 * 3 + 3 * 4, 24, 24]);
    assert_eq!(corners(&watertight(&blocks([1e7, 0.0, -1e7])).0), near);
    // Parts without a place change nothing.
    let all: Vec<Cuboid> = blocks([0.0; 3])
        .into_iter()
        .chain([f64::NAN, f64::INFINITY, 1e300].map(|x| block([x, 0.0, 0.0], [1.0; 3])))
        .collect();
    assert_eq!(corners(&watertight(&all[..5]).0)[..3], near);
    assert_eq!(corners(&watertight(&all).0)[3..], [24; 3]);
}

#[test]
fn the_order_of_leaves_does_not_matter() {
    let blocks: Vec<Cuboid> = (0..40)
        .map(|at| block([f64::from(at * 7 % 13), f64::from(at % 5), 0.0], [f64::from(1 + at % 4), 1.0, 0.5]))
        .collect();
    let turned: Vec<Cuboid> = blocks.iter().rev().copied().collect();
    let [there, back] = [&blocks, &turned].map(|blocks| watertight(blocks).0);
    let same = there.leaves().zip(back.leaves().collect::<Vec<_>>().into_iter().rev());
    assert!(there.triangle_count() > 12 * 60);
    for (a, b) in same {
        let places = |leaf: crate::output::model::LeafView<'_>| {
            let (mesh, _) = leaf.mesh();
            mesh.corners().iter().map(|point| mesh.points()[*point as usize]).collect::<Vec<_>>()
        };
        assert_eq!(places(a), places(b));
    }
}

/// Sinks would make a triangle without area at the straight corner, and its neighbour would have the corner inside of an edge.
#[test]
fn no_triangle_has_three_points_in_one_line() {
    let mut builder = MeshBuilder::new();
    let outline =
        [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 1.0], [4.0, 3.0], [2.0, 3.0], [2.0, 1.5], [1.0, 1.0], [0.0, 1.0]];
    let corners: Vec<u32> = outline.iter().map(|[x, y]| builder.point([*x, *y, 0.0])).collect();
    builder.polygon(&corners);
    let mesh = Arc::new(builder.build().expect("a mesh"));
    let mut sink = Watertight::new(Model::new());
    with_leaf(&[], |leaf| {
        let _ = sink.mesh(&leaf, &mesh, &DAffine3::IDENTITY);
        let _ = sink.quad(&leaf, &wall([1.0, -1.0], [0.5, 1.0]));
    });
    let model = sink.into_inner();
    let (made, _) = model.leaves().next().expect("the polygon").mesh();
    assert_eq!((made.face_count(), made.area()), (9, mesh.area()));
    assert!(made.check().is_empty() && made.faces().all(|face| face.corner_count() == 3 && 0.01 < face.area()));
}

#[test]
fn a_stopped_watch_ends_the_work() {
    let model = |watch: Watch| {
        let mut sink = Watertight::new(Model::new()).with_watch(watch);
        with_leaf(&[], |leaf| {
            assert!(storeys().iter().all(|quad| sink.quad(&leaf, quad).is_continue()));
            sink.end_building(&|| Building::new("", 0));
            let goes_on = sink.quad(&leaf, &storeys()[0]).is_continue();
            (corners(&sink.into_inner()), goes_on)
        })
    };
    assert_eq!(model(Watch::new()), (vec![9, 4, 4, 4], true));
    let stopped = Watch::new();
    stopped.stop();
    assert_eq!(model(stopped), (vec![4; 3], false));
}
