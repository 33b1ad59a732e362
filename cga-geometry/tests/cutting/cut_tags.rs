//! Tags of edges and vertices in cuts.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::cut_support::*;
use cga_geometry::Axis;
use cga_geometry::cut::{Plane, halves, iso_bands, slabs};
use cga_geometry::mesh::{Mesh, TagSet, UvAxis};
use cga_geometry::primitive;
use glam::{DVec2, DVec3};

fn zoo() -> Vec<(&'static str, Mesh)> {
    let l = [(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)];
    let windows: Vec<Vec<(f64, f64)>> =
        (0..16).map(|i| square(0.5 + 2.0 * f64::from(i % 4), 0.5 + 2.0 * f64::from(i / 4), 1.0)).collect();
    vec![
        ("cube", primitive::cube()),
        ("cylinder", primitive::cylinder(17)),
        ("L", prism(&l, &[], 3.0)),
        ("torus", torus(24, 12, 1.0, 0.4)),
        ("star", prism(&ring(14, |i| if i % 2 == 0 { 1.0 } else { 0.3 }), &[], 0.7)),
        ("plate with holes", prism(&square(0.0, 0.0, 8.5), &windows, 1.0)),
        ("diagonal cells", cells(3, |x, y, z| (x + y + z) % 2 == 0)),
        ("open", Mesh::from_polygon(&polygon(&l), &[]).unwrap()),
    ]
}

fn name(tags: Option<&TagSet>) -> Option<&str> {
    tags.map(|set| {
        assert_eq!(set.names().len(), 1);
        &*set.names()[0]
    })
}

/// The distance of a point from a line segment.
fn away(p: DVec3, [a, b]: [DVec3; 2]) -> f64 {
    let share = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    (a + (b - a) * share).distance(p)
}

/// Checks that parts of edges have the tags of their edges, old vertices their own tags, and everything else none.
/// `is_new` returns true for two points that may be the ends of a new edge.
fn check_parts(what: &str, mesh: &Mesh, parts: &[&Mesh], is_new: impl Fn(DVec3, DVec3) -> bool) {
    let own: BTreeMap<String, [DVec3; 2]> =
        edges(mesh).into_iter().map(|edge| (edge_tag(edge), edge.map(|p| mesh.points()[p as usize]))).collect();
    let size = mesh.bounds().size().max_element();
    let mut lengths: BTreeMap<&str, f64> = BTreeMap::new();
    for part in parts {
        assert_eq!(part.check(), [], "{what}");
        for edge in edges(part) {
            let ends = edge.map(|p| part.points()[p as usize]);
            let Some(tag) = name(part.edge_tags(edge)) else {
                assert!(is_new(ends[0], ends[1]), "{what}: {ends:?} has no tag");
                continue;
            };
            let source = own[tag];
            assert!(ends.iter().all(|end| away(*end, source) <= 1e-12 * size), "{what}: {tag}, {ends:?}");
            if !is_new(ends[0], ends[1]) {
                *lengths.entry(tag).or_default() += ends[0].distance(ends[1]);
            }
        }
        for (number, point) in part.points().iter().enumerate() {
            let tag = name(part.vertex_tags(number as u32));
            match mesh.points().iter().position(|own| own == point) {
                // Other points may be at the same place.
                Some(_) => {
                    let number: usize = tag.unwrap()[2..].parse().unwrap();
                    assert_eq!(mesh.points()[number], *point, "{what}");
                }
                None => assert_eq!(tag, None, "{what}: a new vertex"),
            }
        }
    }
    for (tag, ends) in own.iter().filter(|(_, ends)| !is_new(ends[0], ends[1])) {
        let (sum, length) = (lengths[tag.as_str()], ends[0].distance(ends[1]));
        assert!((sum - length).abs() <= 1e-9 * size, "{what}: the parts of {tag} are {sum} of {length}");
    }
}

#[test]
fn cut_edges_keep_their_tags_and_new_ones_have_none() {
    let mut rng = Rng(7);
    for (name, mesh) in zoo() {
        let mesh = Arc::new(tagged(&mesh));
        let bounds = mesh.bounds();
        for axis in AXES {
            let (low, high) = (bounds.low[axis.index()], bounds.high[axis.index()]);
            let mut offsets: Vec<f64> = (0..6).map(|_| low + (high - low) * rng.unit()).collect();
            // Planes through points, too.
            offsets.extend((0..3).map(|_| mesh.points()[rng.below(mesh.points().len())][axis.index()]));
            offsets.sort_by(f64::total_cmp);
            offsets.dedup();
            let cut = slabs(&mesh, axis, &offsets);
            let parts: Vec<&Mesh> = cut.parts.iter().flatten().map(|part| &**part).collect();
            let in_plane =
                |a: DVec3, b: DVec3| a[axis.index()] == b[axis.index()] && offsets.contains(&a[axis.index()]);
            // An edge in a plane may be on both sides of it, and in a cap.
            check_parts(&format!("{name} across {axis:?}"), &mesh, &parts, in_plane);
        }
    }
}

#[test]
fn caps_share_the_tags_of_the_edges_around_them() {
    // The upper edges of the lower cube are edges of the mesh in the plane: two below walls, two at the faces beside it.
    let mesh = Arc::new(tagged(&cells(2, |x, y, z| (x, y, z) == (0, 0, 0) || (y == 1))));
    let cut = slabs(&mesh, Axis::Y, &[1.0]);
    let below = cut.parts[0].as_ref().unwrap();
    let cap = below.faces().find(|face| face.tag().cap).unwrap();
    assert_eq!(cap.tag().tags, cga_geometry::mesh::FaceTag::NONE);
    let ring = cap.outer();
    let tags = |k: usize| below.edge_tags([ring[k], ring[(k + 1) % ring.len()]]);
    assert_eq!((0..4).filter(|k| tags(*k).is_some()).count(), 4);
}

#[test]
fn planes_at_any_angle_keep_tags() {
    let mut rng = Rng(8);
    for (name, mesh) in zoo() {
        let mesh = Arc::new(tagged(&mesh));
        let bounds = mesh.bounds();
        for round in 0..8 {
            let any = |rng: &mut Rng| DVec3::new(rng.unit(), rng.unit(), rng.unit());
            let plane =
                Plane { point: bounds.low + bounds.size() * any(&mut rng), normal: any(&mut rng) - DVec3::splat(0.5) };
            let cut = halves(&mesh, &plane, 0.0);
            let parts: Vec<&Mesh> = cut.parts.iter().flatten().map(|part| &**part).collect();
            let normal = plane.normal.normalize();
            let in_plane = |p: DVec3| (p - plane.point).dot(normal).abs() <= 1e-12 * bounds.size().max_element();
            check_parts(&format!("{name}, plane {round}"), &mesh, &parts, |a, b| in_plane(a) && in_plane(b));
        }
    }
}

#[test]
fn lines_in_texture_space_keep_tags() {
    for (name, mesh) in zoo() {
        let mesh = tagged(&mesh);
        let uvs = mesh.corners().iter().map(|point| {
            let p = mesh.points()[*point as usize];
            DVec2::new(p.x + 0.5 * p.y, p.z)
        });
        let mesh = Arc::new(mesh.with_uv_set(0, uvs.collect()));
        let lines = [0.3, 0.75, 1.9];
        let bands = iso_bands(&mesh, 0, UvAxis::U, &lines, 1 << 20).unwrap();
        let parts: Vec<&Mesh> = bands.iter().flatten().map(|part| &**part).collect();
        let on_line = |p: DVec3| lines.iter().position(|line| (p.x + 0.5 * p.y - line).abs() <= 1e-12);
        check_parts(name, &mesh, &parts, |a, b| on_line(a).is_some() && on_line(a) == on_line(b));
    }
}

#[test]
fn a_mesh_without_tags_has_parts_without_tags() {
    for (_, mesh) in zoo() {
        let mesh = Arc::new(mesh);
        let cut = slabs(&mesh, Axis::X, &[0.3]);
        for part in cut.parts.iter().flatten() {
            assert!(edges(part).into_iter().all(|edge| part.edge_tags(edge).is_none()));
        }
    }
}
