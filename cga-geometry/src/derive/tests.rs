use glam::{DVec2, DVec3};

use super::*;
use crate::mesh::{FaceTag, MeshBuilder};
use crate::primitive;
use crate::trace::{Trace, TraceLayer, TracedPoint};
use crate::work;

fn tags(names: &[&str]) -> TagSet {
    TagSet::new(names.iter().copied())
}

/// Texture coordinates are an affine map of the place.
fn uv(at: DVec3) -> DVec2 {
    DVec2::new(0.5 * at.x + 1.0, 2.0 - 0.25 * at.y)
}

/// A square with a group, with coordinates in two sets, normals, and tags on its face, on its first edge, and on its first vertex.
fn square() -> Mesh {
    let mut builder = MeshBuilder::new();
    let places = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let points = places.map(|at| builder.point(at));
    builder.groups(vec!["wall".to_owned()]).tag_sets(vec![tags(&["lot", "frame.old"])]);
    builder.face(&points, &[], FaceTag { group: 0, tags: 0, ..FaceTag::PLAIN });
    builder.uvs(&places.map(uv)).uv_set(2, &places.map(|at| uv(at) * 3.0)).normals(&[DVec3::new(0.6, 0.0, 0.8); 4]);
    builder.edge_tags([points[0], points[1]], &tags(&["street"])).vertex_tags(points[0], &tags(&["corner"]));
    let mut mesh = builder.build().expect("a square");
    let traced = (0..4).map(|id| TracedPoint { id: 10 + id, begin: DVec3::ZERO }).collect();
    mesh.trace = Trace::of(vec![TraceLayer { division: 3, points: traced }]);
    mesh
}

/// A toy operation: each face becomes triangles over its edges around a point in its middle. It gives origins and nothing else.
fn fan(mesh: &Mesh) -> Mesh {
    let mut made = Derivation::new(mesh, CornerValues::All, 0);
    for face in mesh.faces() {
        let middle = face.outline().sum::<DVec3>() / face.outer().len() as f64;
        let middle = made.point(middle, PointOrigin::Grown);
        let points: Vec<u32> = face.outer().iter().map(|&point| made.old_point(point)).collect();
        for (k, edge) in face.edges().enumerate() {
            let ring = [points[k], points[(k + 1) % points.len()], middle];
            made.face([ring], FaceOrigin::over_edge(&face, "frame.side", edge));
        }
    }
    made.finish_by_use()
}

/// The values at the middle are a mix of the values at all corners.
#[test]
fn values_at_the_middle_of_a_fan_are_mixed_once_and_can_be_stopped() {
    let count = 70_000;
    let mut builder = MeshBuilder::new();
    let places: Vec<DVec3> = (0..count)
        .map(|at| {
            let (sin, cos) = libm::sincos(f64::from(at) / f64::from(count) * std::f64::consts::TAU);
            DVec3::new(9.0 * cos, 9.0 * sin, 0.0)
        })
        .collect();
    let points: Vec<u32> = places.iter().map(|at| builder.point(*at)).collect();
    builder.polygon(&points).uvs(&places.iter().map(|at| uv(*at)).collect::<Vec<DVec2>>());
    let mesh = builder.build().expect("a disk");
    for goes_on in [true, false] {
        let (units, asked) = (std::rc::Rc::new(std::cell::Cell::new(0)), std::rc::Rc::new(std::cell::Cell::new(0)));
        let (all, questions) = (units.clone(), asked.clone());
        let _supervisor = work::Supervisor::new(move |more| {
            all.set(all.get() + more);
            questions.set(questions.get() + 1);
            goes_on
        });
        let made = fan(&mesh);
        let _ = work::ask();
        // Each corner also counts where points get their numbers.
        assert!((count as u64..20 * count as u64).contains(&units.get()), "{} units", units.get());
        assert!(0 < asked.get());
        if !goes_on {
            assert!(made.is_empty());
            continue;
        }
        let middle = made
            .corners()
            .iter()
            .zip(made.uv_set(0))
            .filter(|(point, _)| made.points()[**point as usize].length() < 1.0);
        let is_mean = |own: &DVec2| (*own - uv(DVec3::ZERO)).length() < 1e-9;
        assert!(middle.clone().all(|(_, own)| is_mean(own)) && middle.count() == count as usize);
    }
}

#[test]
fn an_operation_that_gives_origins_has_everything_that_follows() {
    let mesh = square();
    let made = fan(&mesh);
    assert_eq!((made.face_count(), made.points().len(), made.check()), (4, 5, vec![]));
    for face in made.faces() {
        assert_eq!(made.groups()[face.tag().group as usize], "wall");
        for corner in face.corner_range() {
            let at = face.position(corner);
            assert!((made.uv_set(0)[corner] - uv(at)).length() < 1e-12, "{at}");
            assert!((made.uv_set(2)[corner] - uv(at) * 3.0).length() < 1e-12, "{at}");
            assert!((made.normals()[corner] - DVec3::new(0.6, 0.0, 0.8)).length() < 1e-12);
        }
    }
    // Below the operation's first word its own tag replaces others, and the face at the tagged edge has its tags.
    let names = |face: usize| made.tag_sets()[made.face(face).tag().tags as usize].clone();
    assert_eq!([names(0), names(1)], [tags(&["lot", "frame.side", "street"]), tags(&["lot", "frame.side"])]);
    // The edge keeps its tags, and the edge that grows from the tagged vertex has the tags of the vertex.
    let [a, b, middle] = [0, 1, 2].map(|corner| made.corners()[corner]);
    assert_eq!(made.edge_tags([a, b]), Some(&tags(&["street"])));
    assert_eq!([made.edge_tags([a, middle]), made.edge_tags([b, middle])], [Some(&tags(&["corner"])), None]);
    assert_eq!([made.vertex_tags(a), made.vertex_tags(middle)], [Some(&tags(&["corner"])), None]);
    let traced: Vec<u32> = made.trace.layers()[0].points.iter().map(|point| point.id).collect();
    assert_eq!(traced, [10, 11, u32::MAX, 12, 13]);
}

#[test]
fn points_between_others_divide_edges() {
    let mesh = square();
    let mut made = Derivation::new(&mesh, CornerValues::All, 0).with_old_points();
    let face = mesh.face(0);
    let between = |share| PointOrigin::Between { ends: [0, 1], share };
    let [low, high] = [made.point(DVec3::X, between(0.25)), made.point(DVec3::new(1.0, 4.0, 0.0), PointOrigin::New)];
    made.face([[0, low, high, 3]], FaceOrigin::piece(&face));
    made.face([[low, 1, 2, high]], FaceOrigin::piece(&face));
    let made = made.finish();
    assert_eq!(made.check(), []);
    for (corner, &point) in made.corners().iter().enumerate() {
        assert!((made.uvs()[corner] - uv(made.points()[point as usize])).length() < 1e-12);
    }
    let street = tags(&["street"]);
    assert_eq!(
        [[0, low], [low, 1], [low, high], [3, 0]].map(|ends| made.edge_tags(ends)),
        [Some(&street), Some(&street), None, None]
    );
}

#[test]
fn turned_faces_have_turned_normals_and_fillings_have_no_attributes() {
    let mesh = square();
    let mut made = Derivation::new(&mesh, CornerValues::All, 0).with_old_points().without_trace();
    made.face([[3, 2, 1, 0]], FaceOrigin::piece(&mesh.face(0)).turned());
    made.face([[0, 1, 2, 3]], FaceOrigin::filling(&mesh.face(0)));
    let made = made.finish();
    assert!(made.trace.is_empty());
    assert_eq!(made.normals()[..4], [DVec3::new(-0.6, -0.0, -0.8); 4]);
    assert_eq!((made.face(0).tag().group, made.face(1).tag()), (0, FaceTag::PLAIN));
}

#[test]
fn a_face_that_visits_a_point_twice_has_the_values_of_both_visits() {
    // A square with a slit to a point inside, whose sides have other coordinates.
    let places = [[0.0, 0.0], [4.0, 0.0], [2.0, 2.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let mut builder = MeshBuilder::new();
    let points = places.map(|[x, y]| builder.point([x, y, 0.0]));
    builder.polygon(&points).uvs(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(|u| DVec2::new(u, 0.0)));
    let mesh = builder.build().expect("a face with a slit");
    let mut made = Derivation::new(&mesh, CornerValues::Coordinates, 0).with_old_points();
    made.face([mesh.face(0).outer()], FaceOrigin::piece(&mesh.face(0)));
    assert_eq!(made.finish().uvs(), mesh.uvs());
}

#[test]
fn points_at_other_places_are_the_points_of_a_moved_mesh() {
    let mesh = primitive::cube();
    let places: Vec<DVec3> = mesh.points().iter().map(|point| *point * 2.0 + DVec3::X).collect();
    let moved = mesh.with_points(places.clone());
    let divided = |made: Derivation<'_>| {
        let mut made = made;
        let ends = [mesh.corners()[0], mesh.corners()[1]];
        let middle = (places[ends[0] as usize] + places[ends[1] as usize]) * 0.5;
        let middle = made.point(middle, PointOrigin::Between { ends, share: 0.5 });
        let face = mesh.face(0);
        let [a, b, c, d] = *face.outer() else { panic!("a face with four corners") };
        made.face([[a, middle, d]], FaceOrigin::piece(&face));
        made.face([[middle, b, c, d]], FaceOrigin::piece(&face));
        mesh.faces().skip(1).for_each(|face| made.keep(face.loop_ranges(), FaceOrigin::piece(&face)));
        made.finish()
    };
    let at = divided(Derivation::new(&mesh, CornerValues::All, 0).with_old_points_at(&places, 1, 30));
    assert_eq!(at, divided(Derivation::new(&moved, CornerValues::All, 0).with_old_points()));
    assert_eq!((at.points().len(), at.area()), (9, 24.0));
}
