//! `tag`, `deleteTags`, `geometry.tags` and `geometry.hasTags`.

use TaggedComponents::{All, Edges, Faces, Vertices};

use super::*;
use crate::geometry::Axis;
use crate::geometry::extrude::{Extrude, extrude};
use crate::geometry::mesh::{Mesh, TaggedComponents};
use crate::geometry::primitive;
use crate::op::{delete_tags, delete_tags_of};
use crate::query::{geometry_has_tags, geometry_has_tags_of, geometry_tags, geometry_tags_of};

fn tagged(mut shape: Shape, tags: &[(&str, TagTarget)]) -> Shape {
    let env = &mut Env::for_tests();
    let before = shape.scope;
    for (name, target) in tags {
        tag(env, &mut shape, Text::from(*name), *target);
    }
    assert!(env.take_faults().0.is_empty());
    assert_eq!(shape.scope, before);
    assert_eq!(shape.to_mesh().check(), []);
    shape
}

fn names(shape: &Shape, query: &str, components: TaggedComponents) -> Vec<String> {
    let found = geometry_tags_of(&mut Env::for_tests(), shape, query.into(), components);
    assert_eq!(!found.is_empty(), geometry_has_tags_of(shape, query.into(), components));
    found.as_slice().iter().map(ToString::to_string).collect()
}

fn shapes() -> [Shape; 4] {
    [
        Shape::cuboid(1.0, 2.0, 3.0),
        Shape::rectangle(4.0, 5.0),
        Shape::mesh_axis_aligned(primitive::cylinder(7)),
        Shape::mesh_axis_aligned(extrude(&primitive::cube(), Extrude::FaceNormal, 1.0)),
    ]
}

#[test]
fn all_components_of_a_kind_get_the_tag() {
    for shape in shapes() {
        let own: Vec<String> =
            geometry_tags(&mut Env::for_tests(), &shape).as_slice().iter().map(ToString::to_string).collect();
        let shape = tagged(
            shape,
            &[
                ("b.face", TagTarget::Auto),
                ("a", TagTarget::Faces),
                ("b.edge", TagTarget::Edges),
                ("c", TagTarget::Vertices),
            ],
        );
        let mesh = shape.to_mesh();
        assert!(mesh.faces().all(|face| {
            let set = &mesh.tag_sets()[face.tag().tags as usize];
            set.has("a") && set.has("b.face") && !set.has("c")
        }));
        assert!(mesh.face_edges().all(|edge| mesh.edge_tags(edge).unwrap().names() == ["b.edge".into()]));
        let points = 0..mesh.points().len() as u32;
        assert!(points.into_iter().all(|point| mesh.vertex_tags(point).unwrap().names() == ["c".into()]));
        // *geometry.tags function*: in the order of the alphabet.
        let all = geometry_tags(&mut Env::for_tests(), &shape);
        assert!(all.as_slice().is_sorted() && all.as_slice().len() == own.len() + 4);
        assert_eq!(names(&shape, "b", All), ["b.edge", "b.face"]);
        assert_eq!(
            (names(&shape, "b", Faces), names(&shape, "b", Edges)),
            (vec!["b.face".into()], vec!["b.edge".into()])
        );
        assert!(names(&shape, "b", Vertices).is_empty() && names(&shape, "edge", All).is_empty());
        assert_eq!(names(&shape, "?", Vertices), ["c"]);
    }
}

#[test]
fn without_faces_edges_are_the_highest_components_and_then_vertices() {
    let line = || Shape::line([0.0; 3], [3.0, 0.0, 0.0]).unwrap();
    let edge = tagged(line(), &[("t", TagTarget::Auto)]);
    assert_eq!((names(&edge, "t", Edges).len(), names(&edge, "t", Vertices).len()), (1, 0));
    let ends = tagged(line(), &[("t", TagTarget::Vertices)]);
    assert_eq!((names(&ends, "t", Edges).len(), names(&ends, "t", Vertices).len()), (0, 1));
    let point = || Shape::point([1.0, 2.0, 3.0]);
    assert_eq!(names(&tagged(point(), &[("t", TagTarget::Auto)]), "t", Vertices), ["t"]);
    for (shape, target) in [(line(), TagTarget::Faces), (point(), TagTarget::Faces), (point(), TagTarget::Edges)] {
        assert!(!geometry_has_tags(&tagged(shape, &[("t", target)])));
    }
    // A tagged edge is still one.
    let scope = edge.scope;
    assert_eq!((scope.size.x, edge.to_wire().unwrap().points.len()), (3.0, 2));
    let mut bare = edge;
    delete_tags(&mut Env::for_tests(), &mut bare);
    assert!(!geometry_has_tags(&bare) && bare.scope == scope);
}

#[test]
fn wildcards_are_left_out_of_names() {
    let shape = tagged(Shape::rectangle(1.0, 1.0), &[("a?.*b", TagTarget::Auto), ("A*", TagTarget::Auto)]);
    assert_eq!(names(&shape, "*", All), ["A", "a.b"]);
    for name in ["", "*", "?*?"] {
        let (env, mut shape) = (&mut Env::for_tests(), Shape::rectangle(1.0, 1.0));
        tag(env, &mut shape, Text::from(name), TagTarget::Auto);
        assert_eq!(env.take_faults().0.len(), 1);
        assert!(matches!(shape.geometry, Geometry::Rect(Axis::Y, _)));
    }
}

#[test]
fn tags_that_a_query_matches_are_deleted() {
    let all =
        [("x.f", TagTarget::Faces), ("y", TagTarget::Faces), ("x.e", TagTarget::Edges), ("x.v", TagTarget::Vertices)];
    for shape in shapes() {
        let shape = tagged(shape, &all);
        for (query, components, left) in [
            ("x", All, vec!["y"]),
            ("x", Faces, vec!["x.e", "x.v", "y"]),
            ("x", Edges, vec!["x.f", "x.v", "y"]),
            ("x", Vertices, vec!["x.e", "x.f", "y"]),
            ("*", All, vec![]),
            ("*.v", All, vec!["x.e", "x.f", "y"]),
            ("?.?", Edges, vec!["x.f", "x.v", "y"]),
            ("z", All, vec!["x.e", "x.f", "x.v", "y"]),
            ("", All, vec!["x.e", "x.f", "x.v", "y"]),
        ] {
            let (env, mut shape) = (&mut Env::for_tests(), shape.clone());
            delete_tags_of(env, &mut shape, "extrude".into(), All);
            delete_tags_of(env, &mut shape, query.into(), components);
            assert_eq!(names(&shape, "*", All), left, "{query} {components:?}");
            assert_eq!(shape.to_mesh().check(), []);
        }
        let mut shape = shape;
        delete_tags(&mut Env::for_tests(), &mut shape);
        assert!(!geometry_has_tags(&shape) && shape.to_mesh().subcomponent_tags().is_empty());
    }
}

#[test]
fn a_box_stays_a_box_without_its_tags() {
    let (env, mut shape) = (&mut Env::for_tests(), Shape::rectangle(4.0, 5.0));
    crate::op::extrude(env, &mut shape, crate::op::Length::Absolute(3.0));
    assert_eq!(names(&shape, "extrude", Faces), ["extrude.bottom", "extrude.side.outer", "extrude.top"]);
    delete_tags_of(env, &mut shape, "extrude.side".into(), All);
    assert_eq!(names(&shape, "*", All), ["extrude.bottom", "extrude.top"]);
    delete_tags_of(env, &mut shape, "extrude".into(), Edges);
    assert_eq!(names(&shape, "*", All), ["extrude.bottom", "extrude.top"]);
    delete_tags(env, &mut shape);
    assert!(matches!(shape.geometry, Geometry::Box(_)) && !geometry_has_tags(&shape));
}

#[test]
fn a_tagged_asset_is_no_longer_an_instance() {
    let (env, mut shape) = (&mut Env::for_tests(), Shape::cuboid(1.0, 1.0, 1.0));
    crate::op::cylinder(env, &mut shape);
    assert_eq!(shape.geometry.inserted(), Inserted::Asset);
    delete_tags(env, &mut shape);
    assert_eq!(shape.geometry.inserted(), Inserted::Asset);
    tag(env, &mut shape, "t".into(), TagTarget::Auto);
    assert_eq!(shape.geometry.inserted(), Inserted::No);
}

#[test]
fn nothing_has_no_tags() {
    let mut shape = Shape { geometry: Geometry::Empty, ..Shape::rectangle(1.0, 1.0) };
    tag(&mut Env::for_tests(), &mut shape, "t".into(), TagTarget::Auto);
    assert!(!geometry_has_tags(&shape) && matches!(shape.geometry, Geometry::Empty));
    assert!(Mesh::default().without_tags(&|_| true, All).is_empty());
}
