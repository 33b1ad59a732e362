//! Arguments that a function checks.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use cga_geometry::cleanup::{Parts, cleanup};
use cga_geometry::envelope::{EnvelopeSide, envelopes};
use cga_geometry::extrude::Extrude;
use cga_geometry::extrude_wire::extrude_wire;
use cga_geometry::glam::{DAffine3, DVec2, DVec3, DVec4};
use cga_geometry::hull::hull;
use cga_geometry::mesh::{
    FaceTag, Mesh, MeshBuilder, MeshError, SubcomponentTags, SubcomponentTagsBuilder, TagSet, Variant, flip,
};
use cga_geometry::offset::{OffsetFaces, offset};
use cga_geometry::primitive::PrimitiveKind;
use cga_geometry::scatter::{Bell, Domain};
use cga_geometry::trace::Trace;
use cga_geometry::triangulate::Triangulator;
use cga_geometry::uv_map::{SetMap, UvMap};
use cga_geometry::wire::Wire;
use cga_geometry::{Axis, primitive, reduce};

use crate::inputs::courtyard;

/// The message of the panic of a call.
pub(crate) fn message_of<T>(call: impl FnOnce() -> T) -> String {
    let Err(payload) = catch_unwind(AssertUnwindSafe(call)) else { return "no panic".to_owned() };
    let text = payload.downcast_ref::<String>().cloned();
    text.or_else(|| payload.downcast_ref::<&str>().map(|&text| text.to_owned())).unwrap_or_default()
}

#[test]
fn lists_of_the_wrong_length_are_named_at_once() {
    let (cube, points) = (primitive::cube(), primitive::cube().points().to_vec());
    for count in [0, 7, 9] {
        let other = vec![DVec3::ZERO; count];
        assert!(message_of(|| cube.with_points(other)).contains("one position for each point"), "{count}");
        let corners = vec![0; count];
        assert!(message_of(|| cube.with_corners_at(points.clone(), corners)).contains("one index for each corner"));
        let uvs = vec![DVec2::ZERO; count.max(1)];
        assert!(message_of(|| cube.with_uv_set(0, uvs)).contains("texture coordinates for 24 corners"));
        let sides = vec![EnvelopeSide::UPRIGHT; count];
        assert!(message_of(|| envelopes(&cube, &sides, 1.0, None)).contains("one side for each corner"));
    }
    let mut corners = cube.corners().to_vec();
    corners[5] = 8;
    assert!(message_of(|| cube.with_corners_at(points.clone(), corners)).contains("no point among 8"));
    assert!(message_of(|| cube.with_uv_set(10, Vec::new())).contains("texture set 10"));
    let tags = SubcomponentTags::default();
    let of_points = || Wire::of_points(points.clone(), &tags, &Trace::default(), &[0], Vec::new());
    assert!(message_of(of_points).contains("one number for each point"));
}

#[test]
fn other_corners_have_other_edges() {
    // Three triangles in a row, of which the second one then has no edge with the first one.
    let mut pair = MeshBuilder::new();
    let at = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 2.0]].map(|[x, y]| pair.point([x, y, 0.0]));
    pair.polygon(&at[..3]).polygon(&[at[0], at[2], at[3]]).polygon(&[at[2], at[4], at[3]]);
    let pair = pair.build().unwrap();
    assert_eq!(pair.adjacency().edge_count(), 7);
    let moved = pair.with_corners_at(pair.points().to_vec(), vec![0, 1, 2, 0, 4, 3, 2, 4, 3]);
    assert_eq!(moved.adjacency().edge_count(), 8);
}

#[test]
fn a_changed_mesh_forgets_the_forms_that_were_made_of_it() {
    let low = |mesh: &Arc<Mesh>| mesh.variant(Variant::Raised, |mesh| Some(mesh.raised())).bounds().low;
    let mut cube = Arc::new(primitive::cube());
    let before = low(&cube);
    Arc::get_mut(&mut cube).unwrap().change_points(|point| point.x += 5.0);
    assert_eq!(low(&cube), before + DVec3::X * 5.0);
    let uvs = |mesh: &Arc<Mesh>| mesh.variant(Variant::Raised, |mesh| Some(mesh.raised())).uvs().len();
    assert_eq!(uvs(&cube), 0);
    Arc::get_mut(&mut cube).unwrap().put_uv_set(0, vec![DVec2::ONE; 24]);
    assert_eq!(uvs(&cube), 24);
    let groups = |mesh: &Arc<Mesh>| mesh.variant(Variant::Raised, |mesh| Some(mesh.raised())).groups().len();
    assert_eq!(groups(&cube), 0);
    let cube = Arc::new(Arc::into_inner(cube).unwrap().in_group("walls"));
    assert_eq!(groups(&cube), 1);
}

#[test]
fn numbers_of_materials_and_tags_of_edges_that_do_not_exist_are_dropped() {
    let mesh = courtyard().with_materials(["tile"], |number| if number == 0 { 7 } else { number });
    assert!(mesh.faces().all(|face| face.tag().material == FaceTag::NONE));
    let mut tags = SubcomponentTagsBuilder::default();
    let name = TagSet::new(["edge"]);
    [[0, 1], [0, 6], [3, 99], [5, 5]].into_iter().for_each(|ends| tags.edge(ends, &name));
    let cube = primitive::cube().with_subcomponent_tags(tags);
    assert_eq!(cube.subcomponent_tags().edge_sets().map(|(ends, _)| ends).collect::<Vec<_>>(), [[0, 1]]);
    assert_eq!(cube.check(), []);
}

#[test]
fn texture_coordinates_of_maps_are_finite() {
    let map = UvMap { u: DVec4::splat(1e308), v: DVec4::splat(f64::NAN) };
    let mapped =
        primitive::cube().with_uvs(&[SetMap { set: 2, maps: map.into() }, SetMap { set: 12, maps: map.into() }]);
    assert!(mapped.uv_set(2).iter().all(|uv| uv.is_finite()) && mapped.uv_numbers().eq([2]));
}

#[test]
fn short_rings_are_not_turned() {
    let rings = [vec![], vec![0], vec![0, 1], vec![0, 1, 2], vec![0, 1, 2, 3]];
    let turned = [vec![], vec![0], vec![1, 0], vec![1, 0, 2], vec![1, 0, 3, 2]];
    for (mut ring, turned) in rings.into_iter().zip(turned) {
        flip(&mut ring);
        assert_eq!(ring, turned);
    }
}

#[test]
fn a_number_that_is_nan_changes_nothing() {
    let cube = primitive::cube();
    let (made, refused) = offset(&cube, f64::NAN, OffsetFaces::All);
    assert!(made == cube && refused.is_empty());
    let parts = Parts { vertices: true, edges: true, faces: true };
    assert!(cleanup(&cube, parts, f64::NAN).is_none() && reduce::reduce(&cube, f64::NAN).is_none());
}

#[test]
fn wires_are_checked() {
    let wire = Wire { edges: vec![[0, 1], [1, 2]], normals: vec![DVec3::Z; 2], ..Wire::edge(1.0) };
    for along in [Extrude::FaceNormal, Extrude::VertexNormal, Extrude::Vector(DVec3::Y), Extrude::FlatTop(DVec3::Y)] {
        assert_eq!(extrude_wire(&wire, along, 1.0).unwrap_err(), MeshError::OutOfRange { face: 1, index: 2 });
    }
    let line = Wire::edge(10.0);
    for (low, high) in [(6.0, 3.0), (f64::NAN, 3.0), (3.0, f64::NAN), (f64::INFINITY, f64::NEG_INFINITY)] {
        let (part, origins) = line.between(DVec3::X, low, high);
        assert!(part.points.is_empty() && part.edges.is_empty() && origins.is_empty(), "{low} to {high}");
    }
    assert_eq!(line.between(DVec3::X, 3.0, 6.0).0.ends(0), [DVec3::X * 3.0, DVec3::X * 6.0]);
}

#[test]
fn primitives_with_no_sides_have_three() {
    let kinds = [
        PrimitiveKind::Cylinder { sides: 0 },
        PrimitiveKind::Cone { sides: 2 },
        PrimitiveKind::Disk { sides: 1, across: Axis::X },
        PrimitiveKind::Sphere { sides: 0, divisions: 0 },
        PrimitiveKind::Sphere { sides: 7, divisions: 1 },
    ];
    for kind in kinds {
        let mesh = kind.mesh();
        assert_eq!((mesh.corners().len() as u64, mesh.check()), (kind.corner_count(), vec![]), "{kind:?}");
    }
    let most = PrimitiveKind::Sphere { sides: u32::MAX, divisions: u32::MAX };
    assert!(most.corner_count() > 1 << 60);
}

/// Half of a triangle may vanish while the other one is the triangle itself.
#[test]
fn triangles_are_not_halved_forever() {
    let cube = primitive::cube();
    let meshes = [f64::NAN, 1e308, f64::INFINITY].map(|odd| {
        let mut points = cube.points().to_vec();
        points[7].x = odd;
        cube.with_points(points)
    });
    let tiny = [5e-324, 1e-200, 1e308].map(|by| cube.map(&DAffine3::from_scale(DVec3::splat(by))));
    for mesh in meshes.iter().chain(&tiny) {
        for odd in [1e308, 5e-324, f64::NAN, 1.0] {
            let mut state = 0.0;
            let mut random = || {
                state = (state + 0.618) % 1.0;
                state
            };
            for bell in [
                Bell { mean: DVec3::ZERO, deviation: DVec3::splat(odd) },
                Bell { mean: DVec3::splat(odd), deviation: DVec3::ONE },
            ] {
                assert!(Domain::surface(mesh, bell, 2).draw(&mut random).count() <= 2);
            }
        }
    }
}

#[test]
fn polygons_with_odd_loops_and_numbers_have_no_triangles_or_some() {
    let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    for ends in [&[][..], &[0], &[5], &[4, 4], &[0, 4], &[3, 2], &[1, 4], &[2, 4], &[u32::MAX]] {
        let mut made = Vec::new();
        Triangulator::new().polygon(&square, ends, &mut made);
        assert!(made.iter().flatten().all(|&corner| corner < 4), "{ends:?}");
    }
    for odd in [f64::NAN, f64::INFINITY, 1e308, 5e-324] {
        let mut points = square.to_vec();
        points[2] = DVec2::splat(odd);
        Triangulator::new().polygon(&points, &[4], &mut Vec::new());
        hull(&mut points, |point| *point);
        assert!(points.len() <= 4);
    }
}
